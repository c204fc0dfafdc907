#include "tools/session/analysed_programs.h"

#include "interpreter/runtime/overloaded.h"

namespace g31::session {

std::unique_ptr<analysis::ProgramSet> analysed_programs(const Control& control,
                                                        source::SourceMap& sources,
                                                        const runtime::ControlSetup& setup) {
  return std::visit(
      runtime::Overloaded{
          [&](const FanucControl& chosen) {
            return analysis::fanuc_programs(chosen.profile, sources, setup);
          },
          [&](const SinumerikControl&) { return analysis::sinumerik_programs(sources, setup); },
      },
      control);
}

}  // namespace g31::session

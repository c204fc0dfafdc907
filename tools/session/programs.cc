#include "tools/session/programs.h"

#include "interpreter/runtime/overloaded.h"
#include "tools/session/fanuc_programs.h"
#include "tools/session/sinumerik_programs.h"

namespace g31::session {

Result<std::shared_ptr<Programs>, Refusal> open_programs(const Control& control,
                                                         const ProgramPaths& paths,
                                                         source::FileSystem& files,
                                                         const runtime::ControlSetup& setup) {
  return std::visit(
      runtime::Overloaded{
          [&](const FanucControl& chosen) { return open_fanuc_programs(chosen, paths, files); },
          [&](const SinumerikControl&) { return open_sinumerik_programs(paths, files, setup); },
      },
      control);
}

}  // namespace g31::session

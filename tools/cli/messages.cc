#include "tools/cli/messages.h"

#include <cstdio>

#include "interpreter/source/diagnostic.h"
#include "tools/cli/ended_wait.h"

namespace g31::cli {

void print_diagnostics(const runtime::Outcome& outcome, const source::SourceMap& sources) {
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    std::fputs(render_text(diagnostic, sources).c_str(), stderr);
  }
}

ExitCode refuse(const session::Refusal& wrong) {
  const session::Refusal told = with_ended_wait(wrong);
  std::fputs(session::render(told).c_str(), stderr);
  return exit_code_of(told.ending);
}

}  // namespace g31::cli

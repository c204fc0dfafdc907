#include "tools/cli/messages.h"

#include <cstdio>

#include "interpreter/source/diagnostic.h"

namespace g31::cli {

void print_diagnostics(const runtime::Outcome& outcome, const source::SourceMap& sources) {
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    std::fputs(render_text(diagnostic, sources).c_str(), stderr);
  }
}

ExitCode refuse(const session::Refusal& wrong) {
  std::fputs(session::render(wrong).c_str(), stderr);
  return exit_code_of(wrong.ending);
}

}  // namespace g31::cli

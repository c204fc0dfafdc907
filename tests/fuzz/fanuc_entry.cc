#include <cmath>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/run/session.h"
#include "interpreter/dialects/fanuc/text/parse.h"
#include "machine/base/contract.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/tape_choices.h"
#include "tests/fuzz/world.h"

namespace g31::fuzz {
namespace {

constexpr const char* kPath = "fuzz.nc";

void render_errors(const source::SourceMap& sources, const source::SourceFile& file,
                   const std::vector<syntax::SyntaxError>& errors) {
  for (const syntax::SyntaxError& error : errors) {
    G31_EXPECTS(error.where.begin <= error.where.end && error.where.end <= file.text().size());
    source::Diagnostic diagnostic;
    diagnostic.where = file.at(error.where.widened());
    diagnostic.message = error.message.empty() ? "(the alarm's text)" : error.message;
    render(diagnostic, sources);
  }
}

}  // namespace

void read_fanuc_text(std::string_view bytes) {
  OneFile files(kPath, bytes);
  source::SourceMap sources(files);
  const source::SourceFile& file = sources.whole(kPath, std::string(bytes));
  for (const auto begins : {fanuc::TextBegins::AtFile, fanuc::TextBegins::InProgram}) {
    const syntax::Tree tree = fanuc::parse(file.text(), begins);
    render_errors(sources, file, tree.errors);
    for (std::size_t which = 0; which < tree.programs.size(); ++which) {
      for (const fanuc::Profile& profile : fanuc::profiles()) {
        const auto program = fanuc::compile(file, tree, which, profile);
        render_errors(sources, file, fanuc::reachable_errors(program));
      }
    }
  }
}

void run_fanuc_text(std::string_view bytes) {
  const TapeChoices choices(bytes);
  OneFile files(kPath, bytes);
  source::SourceMap sources(files);
  fanuc::ProgramLibrary library(sources);
  library.add_file(kPath);
  const auto surroundings = choices.surroundings();
  machine::MachiningCentre machine(choices.machine_setup(), surroundings.get());
  Listener listener;
  fanuc::Session session(choices.profile(), library, machine, listener);
  G31_EXPECTS(session.configure(choices.fanuc_setup()).empty());
  judge(session.run({kBlocks, kWallSeconds}), sources, machine);
  for (const char* name : {"#1", "#100", "#500", "#3001", "#4001", "#5001", "#5041", "#5061"}) {
    const auto value = session.variable(name);
    G31_EXPECTS(!value || value.value().is_vacant() || std::isfinite(value.value().raw()));
  }
}

}  // namespace g31::fuzz

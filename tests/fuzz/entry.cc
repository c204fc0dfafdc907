#include "tests/fuzz/entry.h"

#include <cmath>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/compile.h"
#include "interpreter/dialects/fanuc/parse.h"
#include "interpreter/dialects/fanuc/session.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/contract.h"
#include "machine/sim/machining_centre.h"
#include "tests/fuzz/tape_choices.h"

namespace g31::fuzz {
namespace {

constexpr const char* kPath = "fuzz.nc";

/// A run must never be waited for; blocks are limited, what one of them does is limited by this.
constexpr double kWallSeconds = 0.2;

/// The only file of the world.
class OneFile final : public source::FileSystem {
 public:
  explicit OneFile(std::string_view text) : text_(text) {}
  std::optional<std::string> read(const std::string& path) override {
    return path == kPath ? std::optional(text_) : std::nullopt;
  }
  std::vector<std::string> list(const std::string&) override { return {}; }

 private:
  std::string text_;
};

/// Hears everything and holds what every document relies on: its numbers are numbers.
class Listener final : public runtime::Observer {
 public:
  void on_move(const runtime::MoveEvent& event) override {
    G31_EXPECTS(event.q_M_to.allFinite() && std::isfinite(event.feed_mm_min));
    G31_EXPECTS(std::isfinite(event.seconds) && event.seconds >= 0.0);
  }
  void on_touch(const runtime::TouchEvent& event) override {
    G31_EXPECTS(event.q_M_commanded.allFinite() && event.q_M_latched.allFinite());
    G31_EXPECTS(event.q_M_stopped.allFinite());
  }
};

void render(const source::Diagnostic& diagnostic) {
  G31_EXPECTS(!diagnostic.message.empty());
  G31_EXPECTS(!source::render_text(diagnostic).empty());
}

void render_errors(const source::SourceFile& file, const std::vector<syntax::SyntaxError>& errors) {
  for (const syntax::SyntaxError& error : errors) {
    G31_EXPECTS(error.where.begin <= error.where.end && error.where.end <= file.text().size());
    source::Diagnostic diagnostic;
    diagnostic.where = {&file, error.where.widened()};
    diagnostic.message = error.message.empty() ? "(the alarm's text)" : error.message;
    render(diagnostic);
  }
}

}  // namespace

void read_any_text(std::string_view bytes) {
  const source::SourceFile file(kPath, std::string(bytes));
  for (const auto begins : {fanuc::TextBegins::AtFile, fanuc::TextBegins::InProgram}) {
    const syntax::Tree tree = fanuc::parse(file.text(), begins);
    render_errors(file, tree.errors);
    for (std::size_t which = 0; which < tree.programs.size(); ++which) {
      for (const fanuc::Profile& profile : fanuc::profiles()) {
        const auto program = fanuc::compile(file, tree, which, profile);
        render_errors(file, fanuc::reachable_errors(program));
      }
    }
  }
}

void run_any_text(std::string_view bytes) {
  const TapeChoices choices(bytes);
  OneFile files(bytes);
  fanuc::ProgramLibrary library(files);
  library.add_file(kPath);
  const auto surroundings = choices.surroundings();
  machine::MachiningCentre machine(choices.machine_setup(), surroundings.get());
  Listener listener;
  fanuc::Session session(choices.profile(), library, machine, listener);
  G31_EXPECTS(session.configure(choices.control_setup()).empty());
  const runtime::Outcome outcome = session.run({kBlocks, kWallSeconds});
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    render(diagnostic);
  }
  G31_EXPECTS(outcome.status == runtime::Status::Completed || !outcome.diagnostics.empty());
  G31_EXPECTS(machine.position().allFinite() && std::isfinite(machine.time_s()));
  for (const char* name : {"#1", "#100", "#500", "#3001", "#4001", "#5001", "#5041", "#5061"}) {
    const auto value = session.variable(name);
    G31_EXPECTS(!value || value.value().is_vacant() || std::isfinite(value.value().raw()));
  }
}

}  // namespace g31::fuzz

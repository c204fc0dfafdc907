#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/run/session.h"
#include "machine/base/contract.h"
#include "tests/support/files_in_memory.h"
#include "tests/support/recording_machine.h"

namespace g31::testing {

/// A program run on one control over a recording machine, and what can be asked afterwards.
class ControlRun final : public runtime::Observer {
 public:
  /// @param program  the blocks between O0001 and M30
  ControlRun(std::string_view control, const std::string& program,
             const runtime::ControlSetup& setup = {}, std::vector<AxisPositions> touches = {})
      : files_({{"case.nc", "O0001\n" + program + "\nM30\n"}}),
        sources_(files_),
        library_(sources_),
        machine_(std::move(touches)) {
    const fanuc::Profile* const profile = fanuc::find_profile(control);
    G31_EXPECTS(profile != nullptr);
    library_.add_file("case.nc");
    session_ = std::make_unique<fanuc::Session>(*profile, library_, machine_, *this);
    refused_ = session_->configure(setup);
    outcome_ = session_->run({});
  }

  /// The value of "#100"; nullopt when vacant or not readable.
  [[nodiscard]] std::optional<double> value(const std::string& name) {
    const auto cell = session_->variable(name);
    return cell && !cell.value().is_vacant() ? std::optional(cell.value().raw()) : std::nullopt;
  }
  /// The alarm's number, or that of the first refusal before the run; 0: none.
  [[nodiscard]] int alarm() const {
    if (outcome_.status == runtime::Status::SyntaxError) {
      return std::stoi(outcome_.diagnostics.front().code);
    }
    return outcome_.alarm ? outcome_.alarm->number : 0;
  }
  [[nodiscard]] const runtime::Outcome& outcome() const { return outcome_; }
  [[nodiscard]] int line_of(const source::Location& where) const {
    return sources_.show(where).line;
  }
  [[nodiscard]] const std::string& output() const { return output_; }
  [[nodiscard]] const std::vector<runtime::RefusedSetting>& refused() const { return refused_; }
  [[nodiscard]] const RecordingMachine& machine() const { return machine_; }

  void on_output(const runtime::OutputEvent& event) override { output_ += event.text; }

 private:
  FilesInMemory files_;
  source::SourceMap sources_;
  fanuc::ProgramLibrary library_;
  RecordingMachine machine_;
  std::unique_ptr<fanuc::Session> session_;
  std::vector<runtime::RefusedSetting> refused_;
  runtime::Outcome outcome_;
  std::string output_;
};

}  // namespace g31::testing

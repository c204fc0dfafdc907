#include "tools/cli/run_recorder.h"

#include "interpreter/source/latin_1.h"

namespace g31::cli {
namespace {

using Keep = report::RecordWhat::Keep;

Keep keep_if(bool is_asked) {
  return is_asked ? Keep::Yes : Keep::No;
}

}  // namespace

EchoingRecorder::EchoingRecorder(const RunOptions& options, Printouts& printouts,
                                 const machine::MachinePort& machine, const Tables& tables,
                                 runtime::OutputBudget& budget)
    : RunRecorder({keep_if(options.moves), keep_if(options.touches)}, budget),
      printouts_(printouts),
      keeps_(!options.json.empty()),
      keeps_output_(keeps_),
      machine_(machine),
      readings_(tables.readings.get()) {}

void EchoingRecorder::on_move(const runtime::MoveEvent& event) {
  constexpr int kDwell = 4;
  RunRecorder::on_move(event);
  if (event.g == kDwell) {
    read_sensors();
  }
}

void EchoingRecorder::on_standstill(source::Location /*where*/) {
  read_sensors();
}

void EchoingRecorder::on_output(const runtime::OutputEvent& event) {
  print(event, [](std::string_view text) { return text; });
}

void EchoingRecorder::on_message(const runtime::OutputEvent& event) {
  print(event, [](std::string_view text) { return source::as_utf8(text); });
}

void EchoingRecorder::on_stop(const runtime::StopEvent& event) {
  if (keeps_) {
    RunRecorder::on_stop(event);
  }
  read_sensors();
}

/// What is kept is charged as it will be in the document, else as it is printed.
template <typename Form>
void EchoingRecorder::print(const runtime::OutputEvent& event, const Form& form) {
  if (keeps_output_) {
    RunRecorder::on_output(event);
  } else {
    budget().charge(runtime::Output::Printouts, event.text.size());
  }
  if (!budget().is_spent()) {
    printouts_.write(form(event.text));
  }
}

void EchoingRecorder::read_sensors() {
  if (readings_ != nullptr) {
    readings_->add_row(machine_);
  }
}

}  // namespace g31::cli

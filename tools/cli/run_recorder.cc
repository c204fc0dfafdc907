#include "tools/cli/run_recorder.h"

#include <string>

#include "tools/cli/run_page.h"

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
    : RunRecorder({keep_if(options.moves || wants_page(options)),
                   keep_if(options.touches || wants_page(options))},
                  budget, options.blocks || wants_page(options) ? &machine : nullptr),
      printouts_(printouts),
      keeps_(!options.json.empty() || wants_page(options)),
      keeps_output_(keeps_),
      machine_(machine),
      readings_(tables.readings.get()),
      watch_(options.watch) {}

void EchoingRecorder::tell(Desk& desk, report::EventLog* events) {
  desk_ = &desk;
  events_ = events;
}

void EchoingRecorder::on_move(const runtime::MoveEvent& event) {
  constexpr int kDwell = 4;
  RunRecorder::on_move(event);
  if (events_ != nullptr) {
    events_->add(event);
  }
  if (event.g == kDwell) {
    read_sensors();
  }
}

void EchoingRecorder::on_moves_undone(std::uint64_t count) {
  RunRecorder::on_moves_undone(count);
  if (events_ != nullptr && count > 0) {
    events_->add_undone(count);
  }
}

void EchoingRecorder::on_touch(const runtime::TouchEvent& event) {
  RunRecorder::on_touch(event);
  desk_->touch(event);
  if (watch_ != nullptr) {
    watch_->touched();
  }
  if (events_ != nullptr) {
    events_->add(event);
  }
}

void EchoingRecorder::on_fault(const runtime::FaultEvent& event) {
  RunRecorder::on_fault(event);
  if (events_ != nullptr) {
    events_->add(event);
  }
}

void EchoingRecorder::on_standstill(source::Location /*where*/) {
  read_sensors();
}

void EchoingRecorder::on_output(const runtime::OutputEvent& event) {
  print(event, event.text);
  if (events_ != nullptr) {
    events_->add_text("output", event.as_utf8(event.text));
  }
}

void EchoingRecorder::on_message(const runtime::OutputEvent& event) {
  const std::string text = event.as_utf8(event.text);
  print(event, text);
  if (!printouts_.go_to_standard_output()) {
    desk_->message(text);
  }
  if (events_ != nullptr) {
    events_->add_text("message", text);
  }
}

void EchoingRecorder::on_stop(const runtime::StopEvent& event) {
  if (keeps_) {
    RunRecorder::on_stop(event);
  }
  desk_->stop(event);
  if (events_ != nullptr) {
    events_->add(event);
  }
  read_sensors();
}

void EchoingRecorder::on_event(const runtime::RecordedEvent& event) {
  if (keeps_) {
    RunRecorder::on_event(event);
  }
  if (events_ != nullptr) {
    events_->add(event);
  }
}

/// What is kept is charged as it will be in the document, else as it is printed.
void EchoingRecorder::print(const runtime::OutputEvent& event, std::string_view shown) {
  if (keeps_output_) {
    RunRecorder::on_output(event);
  } else {
    budget().charge(runtime::Output::Printouts, event.text.size());
  }
  if (!budget().is_spent()) {
    desk_->give_way();
    printouts_.write(shown);
  }
}

void EchoingRecorder::read_sensors() {
  if (readings_ != nullptr) {
    readings_->add_row(machine_);
  }
}

}  // namespace g31::cli

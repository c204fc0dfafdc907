#include "tools/plan/prove.h"

#include <utility>

#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/time_budget.h"
#include "machine/sim/machining_centre.h"
#include "tools/disk/disk.h"
#include "tools/session/programs.h"
#include "tools/session/run.h"

namespace g31::plan {
namespace {

using session::Refusal;

/// Keeps what a program prints, and counts its touches.
class Listener final : public runtime::Observer {
 public:
  explicit Listener(const std::function<void()>& touched) : touched_(touched) {}
  void on_output(const runtime::OutputEvent& event) override { printed_ += event.text; }
  void on_message(const runtime::OutputEvent& /*event*/) override {}
  void on_touch(const runtime::TouchEvent& event) override {
    touches_ += event.triggered ? 1 : 0;
    touched_();
  }

  [[nodiscard]] const std::string& printed() const { return printed_; }
  [[nodiscard]] std::size_t touches() const { return touches_; }

 private:
  const std::function<void()>& touched_;
  std::string printed_;
  std::size_t touches_ = 0;
};

std::optional<double> number_of(session::Session& session, const std::string& name) {
  const auto value = session.variable(name);
  const auto* const cell = value ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
  return cell != nullptr && !cell->is_vacant() ? std::optional(cell->raw()) : std::nullopt;
}

}  // namespace

Result<Proof, Refusal> prove(const ProofRequest& request) {
  disk::Disk disk;
  const auto read = session::prepare(request.run, disk);
  if (!read) {
    return read.error();
  }
  session::Prepared prepared = read.value();
  setup::Job& job = prepared.job;
  if (!request.other_product.empty() && !job.parts.empty()) {
    job.parts.back().file = request.other_product;
  }
  runtime::Budget budget;
  budget.interruption = request.interruption;
  runtime::OutputBudget output(runtime::OutputBudget::kUsualBytes);
  budget.output = &output;
  runtime::TimeBudget time(budget.wall_seconds, budget.interruption);
  const auto made = request.parts == nullptr
                        ? session::build_parts(job, &time)
                        : Result<session::BuiltParts, Refusal>(session::BuiltParts());
  if (!made) {
    return made.error();
  }
  const session::BuiltParts& built = request.parts == nullptr ? made.value() : *request.parts;
  const auto sensed = session::sensed_parts(job, built.parts, &time);
  if (!sensed) {
    return sensed.error();
  }
  const auto surroundings = session::surroundings_of(job, sensed.value(), request.run.seed);
  machine::MachiningCentre machine(job.machine, surroundings.get());
  machine.watch(time);
  const auto programs = session::open_programs(prepared.control, request.run, disk, job.control);
  if (!programs) {
    return programs.error();
  }
  Listener listener(request.touched);
  const auto run = session::Run::open(job, *programs.value(), machine, listener);
  if (!run) {
    return run.error();
  }
  session::Session& session = run.value()->session();
  const runtime::Outcome ran = session.run(budget);
  Proof proof;
  // What is to be said of the part's mesh makes no program wrong.
  proof.ending = session::ending_of(ran);
  const runtime::Outcome outcome = session::with_findings(built.findings, ran);
  for (const source::Diagnostic& message : outcome.diagnostics) {
    proof.messages += render_text(message, programs.value()->sources());
  }
  proof.printed = listener.printed();
  for (const auto& [name, text] : run.value()->changed_files()) {
    proof.printed += text;
  }
  proof.touches = listener.touches();
  proof.machine_time_s = machine.time_s();
  for (const std::string& name : request.variables) {
    proof.values.push_back(number_of(session, name));
  }
  return proof;
}

}  // namespace g31::plan

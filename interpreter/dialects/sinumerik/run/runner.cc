#include "interpreter/dialects/sinumerik/run/runner.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/stop_report.h"
#include "interpreter/source/latin_1.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {

Runner::Runner(CallablePrograms& programs, machine::MachinePort& port, runtime::Observer& observer)
    : programs_(programs),
      channel_(port, observer, programs.globals()),
      machine_(stack_, channel_),
      operands_(machine_.operands()),
      missed_(stack_, operands_, channel_),
      called_(programs, stack_, channel_),
      calls_(stack_, operands_, channel_, called_, missed_),
      words_(operands_, channel_),
      actions_(programs, stack_, operands_, channel_, words_.words(), among()),
      functions_(operands_, channel_, called_, programs.globals()),
      procedures_(operands_, channel_, calls_, actions_),
      system_(operands_, channel_, stack_, missed_),
      written_(operands_, channel_, system_, stack_, programs.globals()) {
  channel_.here = [this] { return stack_.here(); };
  channel_.shown_block = [this] { return stack_.place_of(stack_.shown_level()); };
  channel_.outlet.show_by([this](const AxisPositions& q_M, const AxisPositions& q_M_commanded) {
    return runtime::ProgramView{channel_.to_work(q_M), channel_.to_work(q_M_commanded),
                                channel_.tool, runtime::calls_behind(stack_.call_levels())};
  });
  channel_.outlet.show_levels_by([this] { return stack_.call_levels(); });
}

void Runner::start(const CompiledProgram& program) {
  stack_.reset();
  actions_.clear();
  channel_.couplings.clear();
  words_.words().clear();
  level().program = &program;
  level().make_locals();
  operands_.use_level();
}

MaybeFailure Runner::loop() {
  while (!stack_.has_ended() && !is_paused_) {
    if (missed_.any()) [[unlikely]] {
      if (MaybeFailure reason = any_step(machine_.take_step())) {
        return reason;
      }
      continue;
    }
    const Op& op = machine_.number_steps();
    if (machine_.fault().is_there()) {
      return machine_.fault().taken();
    }
    if (MaybeFailure reason = other_step(op)) {
      return reason;
    }
  }
  return std::nullopt;
}

/// The same while somebody hears what steps write.
MaybeFailure Runner::heard_loop(runtime::BlockListener& listener) {
  while (!stack_.has_ended() && !is_paused_) {
    const Op& op = machine_.take_step();
    const source::Location where = stack_.here();
    const std::vector<WrittenValue> written = written_.before(op);
    if (op.code == OpCode::JumpIfNot) {
      listener.on_condition(where, operands_.number(op.a) != 0.0);
    }
    if (MaybeFailure reason = any_step(op)) {
      return reason;
    }
    written_.tell(written, op, where, listener);
  }
  return std::nullopt;
}

/// A step of number_steps(), or another one.
MaybeFailure Runner::any_step(const Op& op) {
  if (missed_.any() && !channel_.is_inspected()) {
    missed_.follow(op);
  }
  if (is_number_step(op.code)) {
    return machine_.number_step(op) ? std::nullopt : machine_.fault().taken();
  }
  if (op.code == OpCode::Jump) {
    level().step = op.a.place;
    return std::nullopt;
  }
  if (op.code == OpCode::JumpIfNot) {
    level().step = operands_.number(op.a) == 0.0 ? op.b.place : level().step;
    return std::nullopt;
  }
  return other_step(op);
}

MaybeFailure Runner::other_step(const Op& op) {
  switch (op.code) {
#define NUMBER_STEP(name) case OpCode::name:
#define RARE_NUMBER_STEP(name) case OpCode::name:
#define JUMP_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    break;
#define ARRAY_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return machine_.array_step(op) ? std::nullopt : machine_.fault().taken();
#define TEXT_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return machine_.text_step(op) ? std::nullopt : machine_.fault().taken();
#define FRAME_STEP(name) case OpCode::name:
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
    return machine_.frame_step(op) ? std::nullopt : machine_.fault().taken();
#define RUNNER_STEP(name, handler, reach) \
  case OpCode::name:                      \
    return handler(op);
#include "interpreter/dialects/sinumerik/vocabulary/op_codes.def"
  }
  contract_violated("number_steps() does steps on numbers and jumps", __FILE__, __LINE__);
}

/// A late failure, or one of the machine, may be of a block at another level.
std::vector<runtime::CallLevel> Runner::levels_of(const Failure& failure) const {
  const path::Outlet& outlet = channel_.outlet;
  auto of_block = failure.status == runtime::Status::Collision ? outlet.fault_levels()
                                                               : outlet.levels_of(failure.calls);
  std::vector<runtime::CallLevel> levels = of_block ? *std::move(of_block) : stack_.call_levels();
  levels.front().where = failure.where.value_or(stack_.here());
  return levels;
}

runtime::Outcome Runner::outcome_of(const Failure& failure) {
  const AlarmInfo& row = info(failure.id);
  runtime::StopReason reason;
  reason.status = failure.status;
  reason.is_alarm = failure.is_alarm;
  reason.number = failure.number != 0 ? failure.number : row.number;
  reason.text = failure.text.empty() ? std::string(row.text) : source::text_as_utf8(failure.text);
  reason.detail = failure.detail;
  reason.remedy = row.remedy;
  reason.levels = levels_of(failure);
  runtime::Outcome outcome = runtime::outcome_of(std::move(reason));
  channel_.diagnostics.push_back(std::move(outcome.diagnostics.back()));
  outcome.diagnostics.clear();
  return outcome;
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/calls.h"
#include "interpreter/dialects/sinumerik/run/file_name.h"
#include "interpreter/dialects/sinumerik/state/call_arguments.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

using Form = Argument::Form;

/// Groups that SAVE restores: all but those of one block.
bool is_saved(Group group) {
  return std::ranges::find(kOneBlockGroups, group) == std::end(kOneBlockGroups);
}

/// The step of a label of the program to which RET leads, or of the block behind it.
std::optional<std::int32_t> step_of(const Level& level, const std::string& label, bool behind) {
  const auto [program, from] = level.own_place();
  const auto step = find_label(*program, label, from, Direction::Both);
  if (!step || !behind) {
    return step;
  }
  // The block of the label itself begins at its step.
  const auto& ops = program->ops;
  auto next = static_cast<std::size_t>(*step) + 1;
  while (next < ops.size() && ops[next].code != OpCode::Block) {
    ++next;
  }
  return static_cast<std::int32_t>(std::min(next, ops.size() - 1));
}

}  // namespace

/// What the call gives, taken before the level changes.
std::vector<BoundValue> Calls::bound(const CallSite& site) {
  std::vector<BoundValue> values(site.argument_count);
  for (std::uint32_t i = 0; i < site.argument_count; ++i) {
    const Argument& argument = level().program->arguments[site.first_argument + i];
    BoundValue& value = values[i];
    value.form = argument.form;
    value.type = argument.type;
    if (argument.form == Form::Element || argument.form == Form::Whole) {
      value.reference = operands_.variable(argument.variable);
    }
    if (argument.form == Form::Element) {
      const auto element = static_cast<std::size_t>(operands_.number(argument.element));
      value.reference.first += element;
      value.reference.shape = {};
    }
    if (argument.form == Form::Omitted || argument.form == Form::Whole) {
      continue;
    }
    if (argument.type == Type::String) {
      value.text = operands_.text(argument.value);
    } else if (argument.type == Type::Frame) {
      value.frame = std::make_shared<const Frame>(operands_.frame(argument.value));
    } else {
      value.number = operands_.number(argument);
    }
  }
  return values;
}

MaybeFailure Calls::find_called(const Op& op) {
  const CallSite& site = level().program->calls[static_cast<std::size_t>(op.a.place)];
  if (site.name.empty() || find_unsimulated_cycle(site.name) != nullptr) {
    return std::nullopt;
  }
  const auto program = programs_.called(site, site.name);
  return program ? std::nullopt : MaybeFailure(program.error());
}

MaybeFailure Calls::call(const Op& op) {
  const CallSite& site = level().program->calls[static_cast<std::size_t>(op.a.place)];
  if (site.is_modal && site.name.empty()) {
    stack_.modal_call.reset();
    return std::nullopt;
  }
  const auto program =
      programs_.called(site, site.name.empty() ? operands_.text(site.text) : site.name);
  if (!program) {
    return passes_over(site) ? std::nullopt : MaybeFailure(program.error());
  }
  if (site.is_part) {
    return enter_part(site, *program.value());
  }
  std::vector<BoundValue> values = bound(site);
  if (site.is_modal) {
    missed_.keep_for_modal_call(missed_.holders_given(site, values));
    stack_.modal_call = ModalCall{program.value(), std::move(values), stack_.depth()};
    return std::nullopt;
  }
  const double passes = operands_.number(site.passes);
  if (MaybeFailure wrong = failure(wrong_passes(passes))) {
    return wrong;
  }
  if (passes == 0.0) {
    return std::nullopt;
  }
  if (!program.value()->has_proc && site.argument_count > 0) {
    return failure(AlarmId::ProcMissing, program.value()->name);
  }
  const auto given = missed_.holders_given(site, values);
  if (MaybeFailure wrong = enter(*program.value(), values)) {
    return wrong;
  }
  missed_.follow_arguments(given);
  level().passes_left = static_cast<std::int32_t>(passes) - 1;
  if (level().passes_left > 0) {
    level().arguments = std::move(values);
  }
  return std::nullopt;
}

/// CALL text BLOCK first TO last: a level that begins at one label and ends behind the block of the
/// other.
MaybeFailure Calls::enter_part(const CallSite& site, const CompiledProgram& program) {
  constexpr std::int32_t kBeforeAll = -1;
  const std::string first = upper(operands_.text(site.first_label));
  const std::string last = upper(operands_.text(site.last_label));
  const auto part = find_part(program, first, last, kBeforeAll);
  if (!part) {
    return failure(AlarmId::SectionMissing,
                   fmt::format("{} to {} of {}", first, last, program.name));
  }
  if (MaybeFailure wrong = enter(program, {})) {
    return wrong;
  }
  level().step = part->first;
  level().parts.assign(1, {RunningPart::kWholeLevel, part->end, 0, 1});
  return std::nullopt;
}

/// A machining cycle that nobody has a program for is told and passed over.
bool Calls::passes_over(const CallSite& site) {
  const CycleInfo* const cycle = find_unsimulated_cycle(site.name);
  if (cycle == nullptr) {
    return false;
  }
  if (told_cycles_.insert(&site).second) {
    channel_.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::NotSimulated, stack_.here(),
                        fmt::format("{}, {}", cycle->name, cycle->text)));
  }
  if (site.is_modal) {
    stack_.modal_call.reset();
  }
  return true;
}

void Calls::tell_level() {
  channel_.outlet.calls_changed();
  channel_.watch.level_changed(stack_.depth(), [&] { return level().program->name; });
}

MaybeFailure Calls::enter(const CompiledProgram& program, const std::vector<BoundValue>& values) {
  if (stack_.is_full()) {
    return failure(AlarmId::TooManyLevels, program.name);
  }
  if (MaybeFailure missing = stack_.missing_of_main(program)) {
    return missing;
  }
  Level& into = stack_.next();
  into.program = &program;
  into.step = 0;
  into.passes_left = 0;
  into.is_modal_call = false;
  into.parts.clear();
  into.waiting.clear();
  if (MaybeFailure wrong = take_arguments(into, values)) {
    return wrong;
  }
  begin_level(into);
  return std::nullopt;
}

/// The level that was made ready runs from here on.
void Calls::begin_level(Level& into) {
  if (into.program->saves_codes) {
    save_codes(into);
  }
  stack_.enter();
  tell_level();
  operands_.use_level();
}

void Calls::save_codes(Level& into) {
  into.saved_group = channel_.group;
  into.saved_frame = channel_.program_frame;
  into.saved_settable.reset();
  if (channel_.keeps_settable_frame()) {
    into.saved_settable = channel_.settable_now;
  }
}

void Calls::restore_codes(const Level& from) {
  if (!from.program->saves_codes) {
    return;
  }
  const int settable_before = channel_.settable_number();
  for (int i = 0; i < kGroupCount; ++i) {
    const auto at = static_cast<std::size_t>(i);
    if (is_saved(static_cast<Group>(i))) {
      channel_.group.at(at) = from.saved_group.at(at);
    }
  }
  if (channel_.settable_number() != settable_before) {
    channel_.take_stored_frames();
  }
  channel_.program_frame = from.saved_frame;
  if (from.saved_settable) {
    channel_.settable_now = *from.saved_settable;
  }
  channel_.frames_changed();
}

/// What RET(target, behind, levels) says.
Result<Calls::ReturnTarget, Failure> Calls::return_target(const Op& op) {
  ReturnTarget target;
  std::string label;
  const Arguments list = operands_.arguments_of(op);
  const auto given = [&](std::size_t i) {
    return i < list.size() && list[i].form != Argument::Form::Omitted;
  };
  if (given(0)) {
    label = list[0].type == Type::String
                ? upper(operands_.text(list[0].value))
                : fmt::format("N{:.0f}", rounded(operands_.number(list[0])));
  }
  const bool behind = given(1) && operands_.number(list[1]) != 0.0;
  const double levels = given(2) ? rounded(operands_.number(list[2])) : 1.0;
  if (levels < 1.0 || levels > static_cast<double>(std::max<std::size_t>(stack_.depth(), 1))) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("RET over {:.0f} levels", levels));
  }
  target.levels = static_cast<std::size_t>(levels);
  if (!label.empty() && stack_.depth() > 0) {
    target.step = step_of(stack_.level(stack_.depth() - target.levels), label, behind);
    if (!target.step) {
      return failure(AlarmId::JumpTargetMissing, label);
    }
  }
  return target;
}

MaybeFailure Calls::return_from(const Op& op) {
  const auto target = return_target(op);
  if (!target) {
    return target.error();
  }
  if (stack_.depth() == 0) {
    stack_.end();
    return std::nullopt;
  }
  Level& done = level();
  done.leave_texts();
  if (done.passes_left > 0 && !target.value().step && target.value().levels == 1) {
    restore_codes(done);
    --done.passes_left;
    done.step = 0;
    done.parts.clear();
    const std::vector<BoundValue> values = done.arguments;
    MaybeFailure wrong = take_arguments(done, values);
    operands_.use_level();
    // A call of its own, as it were: up and down again.
    channel_.watch.level_changed(stack_.depth() - 1, [] { return std::string(); });
    tell_level();
    return wrong;
  }
  for (std::size_t i = 0; i < target.value().levels; ++i) {
    leave_level();
  }
  if (target.value().step) {
    level().leave_texts();
    level().step = *target.value().step;
  }
  operands_.use_level();
  return std::nullopt;
}

/// A modal call that refers to variables of the level ends with it.
void Calls::leave_level() {
  level().leave_texts();
  missed_.forget(level().numbers);
  restore_codes(level());
  const auto refers = [](const BoundValue& value) {
    return value.form == Form::Element || value.form == Form::Whole;
  };
  if (stack_.modal_call && stack_.modal_call->depth == stack_.depth() &&
      std::ranges::any_of(stack_.modal_call->values, refers)) {
    stack_.modal_call.reset();
  }
  stack_.leave();
  tell_level();
}

MaybeFailure Calls::end_text() {
  if (level().waiting.empty()) {
    stack_.end();
    return std::nullopt;
  }
  WaitingProgram& before = level().waiting.back();
  level().program = before.program;
  level().step = before.step;
  level().parts = std::move(before.parts);
  level().waiting.pop_back();
  channel_.outlet.calls_changed();
  operands_.use_level();
  return std::nullopt;
}

MaybeFailure Calls::begin_window() {
  const ProgramWindows::Place place = programs_.next_window();
  level().program = place.program;
  level().step = place.step;
  return take_no_arguments();
}

MaybeFailure Calls::take_no_arguments() {
  MaybeFailure wrong = take_arguments(level(), {});
  operands_.use_level();
  return wrong;
}

MaybeFailure Calls::execute_text(const std::string& source) {
  Level& now = level();
  if (stack_.is_full()) {
    return failure(AlarmId::TooManyLevels, "EXECSTRING");
  }
  const auto made = programs_.text_of(*now.own_place().first, source);
  if (!made) {
    return made.error();
  }
  if (made.value()->layout.numbers.size() != now.numbers.size() || !made.value()->repeats.empty()) {
    return failure(AlarmId::BadArguments, "EXECSTRING: no definitions and no repetitions");
  }
  now.waiting.push_back({now.program, now.step, std::move(now.parts)});
  now.parts.clear();
  now.program = made.value();
  now.step = 0;
  channel_.outlet.calls_changed();
  operands_.use_level();
  return std::nullopt;
}

bool Calls::is_given_program(const std::string& path) {
  return !programs_.is_written(path) && programs_.find(path) != nullptr;
}

MaybeFailure Calls::expect_no_program(const std::string& path, const char* procedure) {
  return is_given_program(path)
             ? failure(AlarmId::NotImplemented, fmt::format("{} of a program: {}", procedure, path))
             : MaybeFailure();
}

MaybeFailure Calls::modal_call() {
  for (std::size_t i = 0; i <= stack_.depth(); ++i) {
    if (stack_.level(i).is_modal_call) {
      return std::nullopt;
    }
  }
  if (MaybeFailure wrong = enter(*stack_.modal_call->program, stack_.modal_call->values)) {
    return wrong;
  }
  level().is_modal_call = true;
  missed_.follow_modal_call(stack_.modal_call->values.size());
  return std::nullopt;
}

}  // namespace g31::sinumerik

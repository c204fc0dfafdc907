#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/runner.h"
#include "interpreter/dialects/sinumerik/state/call_arguments.h"

namespace g31::sinumerik {
namespace {

using Form = Argument::Form;

constexpr std::size_t kDeepestLevel = 16;  // main program included
constexpr double kMostPasses = 9999.0;
constexpr std::size_t kMostWritten = 10'000;  // programs that a run writes and calls: all are kept
constexpr std::size_t kMostWrittenBytes = 16 << 20;  // of their texts: the code is larger

/// Groups that SAVE restores: all but those of one block.
bool is_saved(Group group) {
  return std::ranges::find(kOneBlockGroups, group) == std::end(kOneBlockGroups);
}

}  // namespace

CallablePrograms::Near Runner::near() const {
  return {levels_[depth_]->program->folder, folder_name(channel_.call_path)};
}

/// The program of a call: alarm 12550 where a name is unknown, 14011 where a text names a file.
Result<const CompiledProgram*, Failure> Runner::called(const CallSite& site) {
  if (const auto found = found_calls_.find(&site); found != found_calls_.end()) {
    return found->second;
  }
  const std::string name = site.name.empty() ? text(site.text) : site.name;
  if (const CompiledProgram* const program = programs_.find(name, near())) {
    if (!site.name.empty()) {
      found_calls_.emplace(&site, program);
    }
    return program;
  }
  const auto written = written_program(name);
  if (!written || written.value() != nullptr) {
    return written;
  }
  const bool is_l_number = name.size() > 1 && upper(name.front()) == 'L' && is_digit(name[1]);
  return failure(site.name.empty() || is_l_number ? AlarmId::ProgramNotFound : AlarmId::NotDefined,
                 name);
}

/// A program that WRITE has made, as it is now; nullptr: there is none.
Result<const CompiledProgram*, Failure> Runner::written_program(std::string_view name) {
  const ProgramName wanted = program_name(name);
  for (const auto& [file, content] : channel_.files) {
    const ProgramName parts = program_name(file);
    const bool fits = parts.stem == wanted.stem && (wanted.suffix.empty() || parts.suffix.empty() ||
                                                    wanted.suffix == parts.suffix);
    if (!fits) {
      continue;
    }
    if (const auto known = written_.find({file, content}); known != written_.end()) {
      return known->second;
    }
    if (written_.size() >= kMostWritten || content.size() > kMostWrittenBytes - written_bytes_) {
      return failure(AlarmId::TooComplex, fmt::format("{}: too many programs are written", name));
    }
    const CompiledProgram* const made = programs_.written(file, content);
    written_.emplace(std::pair(file, content), made);
    written_bytes_ += content.size();
    return made;
  }
  return static_cast<const CompiledProgram*>(nullptr);
}

/// What the call gives, taken before the level changes.
std::vector<BoundValue> Runner::bound(const CallSite& site) {
  std::vector<BoundValue> values(site.argument_count);
  for (std::uint32_t i = 0; i < site.argument_count; ++i) {
    const Argument& argument = level().program->arguments[site.first_argument + i];
    BoundValue& value = values[i];
    value.form = argument.form;
    value.type = argument.type;
    if (argument.form == Form::Element || argument.form == Form::Whole) {
      value.reference = variable(argument.variable);
    }
    if (argument.form == Form::Element) {
      const auto element = static_cast<std::size_t>(number(argument.element));
      Reference& reference = value.reference;
      reference.numbers = reference.numbers != nullptr ? reference.numbers + element : nullptr;
      reference.texts = reference.texts != nullptr ? reference.texts + element : nullptr;
      reference.frames = reference.frames != nullptr ? reference.frames + element : nullptr;
      reference.first += element;
      reference.shape = {};
    }
    if (argument.form == Form::Omitted || argument.form == Form::Whole) {
      continue;
    }
    if (argument.type == Type::String) {
      value.text = text(argument.value);
    } else if (argument.type == Type::Frame) {
      value.frame = std::make_shared<const Frame>(frame(argument.value));
    } else {
      value.number = number(argument.value);
    }
  }
  return values;
}

MaybeFailure Runner::call(const Op& op) {
  const CallSite& site = level().program->calls[static_cast<std::size_t>(op.a.place)];
  if (site.is_modal && site.name.empty()) {
    modal_call_.reset();
    return std::nullopt;
  }
  const auto program = called(site);
  if (!program) {
    return passes_over(site) ? std::nullopt : std::optional(program.error());
  }
  std::vector<BoundValue> values = bound(site);
  if (site.is_modal) {
    modal_call_ = ModalCall{program.value(), std::move(values), depth_};
    return std::nullopt;
  }
  const double passes = number(site.passes);
  if (passes < 0.0 || passes > kMostPasses) {
    return failure(AlarmId::BadRepeats, fmt::format("P{:.0f}", passes));
  }
  if (passes == 0.0) {
    return std::nullopt;
  }
  if (!program.value()->has_proc && site.argument_count > 0) {
    return failure(AlarmId::ProcMissing, program.value()->name);
  }
  const auto given = holders_given(site, values);
  if (MaybeFailure wrong = enter(*program.value(), values)) {
    return wrong;
  }
  follow_arguments(given);
  level().passes_left = static_cast<std::int32_t>(passes) - 1;
  if (level().passes_left > 0) {
    level().arguments = std::move(values);
  }
  return std::nullopt;
}

/// A machining cycle that nobody has a program for is told and passed over.
bool Runner::passes_over(const CallSite& site) {
  const CycleInfo* const cycle = find_unsimulated_cycle(site.name);
  if (cycle == nullptr) {
    return false;
  }
  if (told_cycles_.insert(&site).second) {
    channel_.diagnostics.push_back(
        make_diagnostic(source::DiagnosticId::NotSimulated, here(),
                        fmt::format("{}, {}", cycle->name, cycle->text)));
  }
  if (site.is_modal) {
    modal_call_.reset();
  }
  return true;
}

MaybeFailure Runner::enter(const CompiledProgram& program, const std::vector<BoundValue>& values) {
  if (depth_ + 1 >= kDeepestLevel) {
    return failure(AlarmId::TooManyLevels, program.name);
  }
  if (levels_.size() <= depth_ + 1) {
    levels_.push_back(std::make_unique<Level>());
  }
  Level& into = *levels_[depth_ + 1];
  into.program = &program;
  into.step = 0;
  into.passes_left = 0;
  into.is_modal_call = false;
  into.parts.clear();
  into.waiting.clear();
  if (MaybeFailure wrong = take_arguments(into, values)) {
    return wrong;
  }
  if (program.saves_codes) {
    save_codes(into);
  }
  ++depth_;
  channel_.watch.level_changed(depth_, [&] { return levels_[depth_]->program->name; });
  use_level();
  return std::nullopt;
}

void Runner::save_codes(Level& into) {
  into.saved_group = channel_.group;
  into.saved_frame = channel_.program_frame;
  into.saved_settable.reset();
  if (channel_.keeps_settable_frame()) {
    into.saved_settable = channel_.settable_now;
  }
}

void Runner::restore_codes(const Level& from) {
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
Result<Runner::ReturnTarget, Failure> Runner::return_target(const Op& op) {
  ReturnTarget target;
  const Arguments list = arguments_of(op);
  const auto given = [&](std::size_t i) {
    return i < list.size() && list[i].form != Argument::Form::Omitted;
  };
  if (given(0)) {
    target.label = list[0].type == Type::String
                       ? upper(text(list[0].value))
                       : fmt::format("N{:.0f}", rounded(number(list[0].value)));
  }
  target.behind = given(1) && number(list[1].value) != 0.0;
  const double levels = given(2) ? rounded(number(list[2].value)) : 1.0;
  if (levels < 1.0 || levels > static_cast<double>(std::max<std::size_t>(depth_, 1))) {
    return failure(AlarmId::ValueOutOfLimits, fmt::format("RET over {:.0f} levels", levels));
  }
  target.levels = static_cast<std::size_t>(levels);
  return target;
}

/// Behind the call, or once more; RET(target) goes on at a label there.
MaybeFailure Runner::return_from(const Op& op) {
  const auto target = return_target(op);
  if (!target) {
    return target.error();
  }
  if (depth_ == 0) {
    ended_ = true;
    return std::nullopt;
  }
  Level& done = level();
  done.leave_texts();
  if (done.passes_left > 0 && target.value().label.empty() && target.value().levels == 1) {
    restore_codes(done);
    --done.passes_left;
    done.step = 0;
    done.parts.clear();
    const std::vector<BoundValue> values = done.arguments;
    MaybeFailure wrong = take_arguments(done, values);
    use_level();
    return wrong;
  }
  for (std::size_t i = 0; i < target.value().levels; ++i) {
    leave_level();
  }
  use_level();
  return target.value().label.empty() ? std::nullopt : go_on_at(target.value());
}

/// A modal call that refers to variables of the level ends with it.
void Runner::leave_level() {
  level().leave_texts();
  forget(level().numbers);
  restore_codes(level());
  const auto refers = [](const BoundValue& value) {
    return value.form == Form::Element || value.form == Form::Whole;
  };
  if (modal_call_ && modal_call_->depth == depth_ &&
      std::ranges::any_of(modal_call_->values, refers)) {
    modal_call_.reset();
  }
  --depth_;
  channel_.watch.level_changed(depth_, [&] { return levels_[depth_]->program->name; });
}

MaybeFailure Runner::go_on_at(const ReturnTarget& target) {
  level().leave_texts();
  use_level();
  const CompiledProgram& program = *level().program;
  const auto step = find_label(program, target.label, level().step, Direction::Both);
  if (!step) {
    return failure(AlarmId::JumpTargetMissing, target.label);
  }
  level().step = *step;
  if (target.behind) {
    // The block of the label itself begins at its step; the one behind it is wanted.
    const auto& ops = program.ops;
    auto next = static_cast<std::size_t>(*step) + 1;
    while (next < ops.size() && ops[next].code != OpCode::Block) {
      ++next;
    }
    level().step = static_cast<std::int32_t>(std::min(next, ops.size() - 1));
  }
  return std::nullopt;
}

/// M2, M30 and the last block: of a called program they are its end only.
MaybeFailure Runner::end_program(const Op& /*op*/) {
  if (!level().parts.empty() && at_end_of_part(current_)) {
    return std::nullopt;
  }
  return return_from(Op());
}

/// The end of what EXECSTRING or the command line brought.
MaybeFailure Runner::end_text(const Op& /*op*/) {
  if (level().waiting.empty()) {
    ended_ = true;
    return std::nullopt;
  }
  WaitingProgram& before = level().waiting.back();
  level().program = before.program;
  level().step = before.step;
  level().parts = std::move(before.parts);
  level().waiting.pop_back();
  use_level();
  return std::nullopt;
}

/// MCALL: behind a block that moves.
MaybeFailure Runner::modal_call() {
  for (std::size_t i = 0; i <= depth_; ++i) {
    if (levels_[i]->is_modal_call) {
      return std::nullopt;
    }
  }
  if (MaybeFailure wrong = enter(*modal_call_->program, modal_call_->values)) {
    return wrong;
  }
  level().is_modal_call = true;
  return std::nullopt;
}

}  // namespace g31::sinumerik

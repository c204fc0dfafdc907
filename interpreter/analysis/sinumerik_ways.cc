#include "interpreter/analysis/sinumerik_ways.h"

#include <algorithm>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/analysis/sinumerik_repeats.h"
#include "interpreter/analysis/sinumerik_words.h"
#include "interpreter/dialects/sinumerik/code/program_name.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::analysis {
namespace {

using StepIndex = std::int32_t;

bool has_effect(const sinumerik::Op& op, sinumerik::ProcedureEffect effect) {
  return op.code == sinumerik::OpCode::Procedure &&
         sinumerik::effect_of(static_cast<sinumerik::ProcedureId>(op.detail)) == effect;
}

class WayFinder {
 public:
  using AlarmId = sinumerik::AlarmId;
  using Bank = sinumerik::Bank;
  using Op = sinumerik::Op;
  using OpCode = sinumerik::OpCode;

  explicit WayFinder(const sinumerik::CompiledProgram& program)
      : program_(program), wrong_(wrong_steps(program)) {}

  SinumerikWays run();

 private:
  /// A text that is known without a run; nullptr: only a run knows it.
  [[nodiscard]] const std::string* known_text(sinumerik::Operand text) const {
    return text.bank == Bank::Constants
               ? &program_.text_constants[static_cast<std::size_t>(text.place)]
               : nullptr;
  }
  [[nodiscard]] const std::string* known_argument(const Op& of, std::size_t index) const {
    return known_text(program_.arguments[static_cast<std::size_t>(of.b.place) + index].value);
  }
  void find_names_asked_for();
  void find_written_files();
  void cut_into_blocks();
  void follow_block(BlockIndex index);
  void follow(StepIndex step);
  void go(StepIndex step, EdgeKind kind);
  void next(StepIndex step) { go(step + 1, EdgeKind::Next); }
  void jump_if_not(StepIndex step);
  void jump_to_text(StepIndex step);
  [[nodiscard]] std::optional<Repair> other_direction(const std::string& name,
                                                      syntax::ShortSpan where) const;
  void repeat_part(StepIndex step);
  void repeat_text(StepIndex step);
  void repeat(const sinumerik::RepeatSite& site, StepIndex step);
  void tell_not_simulated(StepIndex step);
  void call(const sinumerik::CallSite& site, syntax::ShortSpan where);
  void stop(AlarmId id, syntax::ShortSpan where, const std::string& detail);
  void stop_for_constant(StepIndex step);
  void add_edge(Edge edge);
  [[nodiscard]] const Op& op(StepIndex step) const {
    return program_.ops[static_cast<std::size_t>(step)];
  }
  [[nodiscard]] syntax::ShortSpan span(StepIndex step) const {
    return program_.spans[static_cast<std::size_t>(step)];
  }
  [[nodiscard]] BlockIndex block_of(StepIndex step) const {
    return ways_.block_of[static_cast<std::size_t>(step)];
  }
  SinumerikBlock& now() { return ways_.blocks[now_]; }

  const sinumerik::CompiledProgram& program_;
  WrongSteps wrong_;
  SinumerikWays ways_;
  std::vector<RepeatedPart> parts_;
  BlockIndex now_ = 0;
  StepIndex now_step_ = 0;
  std::vector<StepIndex> open_;  ///< steps of the present block that are still to be followed
  std::vector<bool> followed_;   ///< per step
  std::set<std::string> asked_for_;
};

void WayFinder::cut_into_blocks() {
  const auto last = static_cast<StepIndex>(program_.ops.size()) - 1;
  for (StepIndex step = 0; step <= last; ++step) {
    const OpCode code = op(step).code;
    if (code == OpCode::Block || code == OpCode::NcBlock || step == last || ways_.blocks.empty()) {
      SinumerikBlock& block = ways_.blocks.emplace_back();
      block.first_step = step;
      block.span = span(step);
    }
    ways_.block_of.push_back(static_cast<BlockIndex>(ways_.blocks.size() - 1));
  }
}

void WayFinder::add_edge(Edge edge) {
  if (std::ranges::find(now().edges, edge.to, &Edge::to) == now().edges.end()) {
    now().edges.push_back(edge);
  }
}

/// The present block may go on at a step: its own, or the one where another block is entered.
void WayFinder::go(StepIndex step, EdgeKind kind) {
  const bool is_inside = block_of(step) == now_ && step != now().first_step;
  if (!is_inside) {
    const bool is_behind = block_of(step) == now_ + 1 && kind == EdgeKind::Next;
    add_edge({block_of(step), is_behind ? EdgeKind::Next : kind});
  } else if (!followed_[static_cast<std::size_t>(step)]) {
    open_.push_back(step);
  }
}

void WayFinder::follow_block(BlockIndex index) {
  now_ = index;
  open_.assign(1, now().first_step);
  while (!open_.empty()) {
    const StepIndex step = open_.back();
    open_.pop_back();
    if (!followed_[static_cast<std::size_t>(step)]) {
      followed_[static_cast<std::size_t>(step)] = true;
      follow(step);
    }
  }
  SinumerikBlock& block = now();
  block.leaves.by_alarm = !block.faults.empty() && block.edges.empty() && !block.to_any_label &&
                          !block.leaves.by_end && !block.leaves.by_return;
}

/// Where a step goes on; one that computes goes on behind itself.
void WayFinder::follow(StepIndex step) {
  const Op& here = op(step);
  const OpCode code = here.code;
  now_step_ = step;
  if (code == OpCode::Jump || code == OpCode::JumpInto) {
    go(here.a.place, here.a.place == step + 1 ? EdgeKind::Next : EdgeKind::Jump);
  } else if (code == OpCode::JumpIfNot) {
    jump_if_not(step);
  } else if (code == OpCode::JumpText) {
    jump_to_text(step);
  } else if (code == OpCode::RepeatPart) {
    repeat_part(step);
  } else if (code == OpCode::RepeatText) {
    repeat_text(step);
  } else if (code == OpCode::TellNotSimulated) {
    tell_not_simulated(step);
  } else if (code == OpCode::Raise) {
    const auto& error = program_.errors[static_cast<std::size_t>(here.a.place)];
    const bool is_asked_for =
        error.id == AlarmId::NotDefined && asked_for_.contains(sinumerik::upper(error.detail));
    if (is_asked_for || error.follows) {
      next(step);
    } else {
      stop(error.id, span(step), error.detail);
    }
  } else if (wrong_.contains(step)) {
    if (code == OpCode::Call) {
      call(program_.calls[static_cast<std::size_t>(here.a.place)], span(step));
    }
    stop_for_constant(step);
  } else if (code == OpCode::EndProgram) {
    const bool is_end_of_text = step + 1 == static_cast<StepIndex>(program_.ops.size());
    (is_end_of_text ? now().leaves.by_return : now().leaves.by_end) = true;
  } else if (code == OpCode::Return || code == OpCode::EndText || code == OpCode::EndWindow) {
    now().leaves.by_return = true;
  } else {
    if (code == OpCode::Call) {
      call(program_.calls[static_cast<std::size_t>(here.a.place)], span(step));
    }
    const bool runs_text = has_effect(here, sinumerik::ProcedureEffect::RunsText);
    now().leaves.by_end = now().leaves.by_end || runs_text;
    now().leaves.by_return = now().leaves.by_return || runs_text;
    const bool may_be_skipped =
        (code == OpCode::Block || code == OpCode::NcBlock) && here.detail != 0;
    if (may_be_skipped) {
      go(here.a.place, EdgeKind::Next);
    }
    next(step);
  }
}

void WayFinder::stop(AlarmId id, syntax::ShortSpan where, const std::string& detail) {
  const sinumerik::AlarmInfo& row = sinumerik::info(id);
  const bool of_target = id == AlarmId::JumpTargetMissing || id == AlarmId::SectionMissing;
  now().faults.push_back(
      {of_target                       ? Fault::Kind::Target
       : id == AlarmId::NotImplemented ? Fault::Kind::NotSimulated
                                       : Fault::Kind::Block,
       row.number, where,
       detail.empty() ? std::string(row.text) : fmt::format("{}: {}", row.text, detail),
       std::string(row.remedy),
       id == AlarmId::JumpTargetMissing ? other_direction(detail, where) : std::nullopt});
}

void WayFinder::stop_for_constant(StepIndex step) {
  const sinumerik::WrongValue& wrong = wrong_.at(step);
  stop(wrong.id, span(step), wrong.detail);
}

void WayFinder::jump_if_not(StepIndex step) {
  const Op& here = op(step);
  const bool is_constant = here.a.bank == Bank::Constants;
  const double value =
      is_constant ? program_.constants[static_cast<std::size_t>(here.a.place)] : 0.0;
  if (!is_constant || value != 0.0) {
    next(step);
  }
  if (!is_constant || value == 0.0) {
    const bool is_behind = block_of(here.b.place) == now_ + 1;
    go(here.b.place, is_behind ? EdgeKind::Next : EdgeKind::Jump);
  }
}

void WayFinder::jump_to_text(StepIndex step) {
  const Op& here = op(step);
  const auto direction = static_cast<sinumerik::Direction>(here.detail);
  const bool is_quiet = direction == sinumerik::Direction::BothQuiet;
  if (here.a.bank != Bank::Constants) {
    now().to_any_label = true;
    if (is_quiet) {
      next(step);
    }
    return;
  }
  const std::string name =
      sinumerik::upper(program_.text_constants[static_cast<std::size_t>(here.a.place)]);
  if (const auto target = find_label(program_, name, step, direction)) {
    go(*target, EdgeKind::Jump);
  } else if (is_quiet) {
    next(step);
  } else {
    stop(AlarmId::JumpTargetMissing, span(step), name);
  }
}

/// The letter of GOTOF or GOTOB, where the label that is missing there lies the other way.
std::optional<Repair> WayFinder::other_direction(const std::string& name,
                                                 syntax::ShortSpan where) const {
  if (!find_label(program_, name, now_step_, sinumerik::Direction::Both)) {
    return std::nullopt;
  }
  constexpr std::size_t kLength = 5;
  const std::string_view before = program_.file->text().substr(0, where.begin);
  const std::size_t end = before.find_last_not_of(" \t") + 1;  // npos + 1 is 0
  const std::string word =
      end < kLength ? std::string() : sinumerik::upper(before.substr(end - kLength, kLength));
  if (word != "GOTOF" && word != "GOTOB") {
    return std::nullopt;
  }
  const std::string other = word == "GOTOF" ? "B" : "F";
  const auto letter = static_cast<std::uint32_t>(end - 1);
  return Repair{"write GOTO" + other, {letter, letter + 1}, other};
}

void WayFinder::repeat_part(StepIndex step) {
  const auto& site = program_.repeats[static_cast<std::size_t>(op(step).a.place)];
  if (site.first < 0) {
    stop(AlarmId::SectionMissing, span(step), site.missing);
    return;
  }
  if (wrong_.contains(step)) {
    stop_for_constant(step);
    return;
  }
  repeat(site, step);
}

void WayFinder::repeat(const sinumerik::RepeatSite& site, StepIndex step) {
  go(site.first, EdgeKind::Part);
  next(step);
  // What ends at this very step ends without a further block.
  if (ways_.blocks[block_of(site.end)].first_step == site.end) {
    parts_.push_back({block_of(site.first), block_of(site.end), block_of(step + 1)});
  }
}

/// CALL BLOCK with texts: where they are no constants, to any label, and back from behind any.
void WayFinder::repeat_text(StepIndex step) {
  const Op& here = op(step);
  if (here.a.bank == Bank::Constants && here.b.bank == Bank::Constants) {
    const auto text = [&](sinumerik::Operand operand) {
      return sinumerik::upper(program_.text_constants[static_cast<std::size_t>(operand.place)]);
    };
    const auto part = find_part(program_, text(here.a), text(here.b), step);
    if (!part) {
      stop(AlarmId::SectionMissing, span(step),
           fmt::format("{} to {}", text(here.a), text(here.b)));
      return;
    }
    repeat({part->first, part->first < step ? std::min(part->end, step) : part->end}, step);
    return;
  }
  now().to_any_label = true;
  next(step);
  std::set<StepIndex> labels;  // their map has no order of its own
  for (const auto& [name, steps] : program_.labels) {
    labels.insert(steps.begin(), steps.end());
  }
  for (const sinumerik::BlockNumber& block : program_.block_numbers) {
    labels.insert(block.step);
  }
  for (const StepIndex label : labels) {
    const StepIndex end = op(label).a.place;
    if (ways_.blocks[block_of(end)].first_step == end) {
      parts_.push_back({block_of(label), block_of(end), block_of(step + 1)});
    }
  }
}

/// A run tells it and goes on.
void WayFinder::tell_not_simulated(StepIndex step) {
  const auto place = static_cast<std::size_t>(op(step).a.place);
  now().faults.push_back({Fault::Kind::NotSimulated, 0, span(step),
                          program_.text_constants[place] + ": a run tells it and goes on", "",
                          std::nullopt});
  next(step);
}

void WayFinder::call(const sinumerik::CallSite& site, syntax::ShortSpan where) {
  if (site.is_modal && site.name.empty()) {
    return;  // MCALL alone ends modal calls
  }
  Call made;
  made.kind = site.is_modal ? Call::Kind::Modal : Call::Kind::Subprogram;
  made.where = where;
  made.target = site.name;
  made.by_text = site.name.empty();
  if (const std::string* const text = made.by_text ? known_text(site.text) : nullptr) {
    made.target = *text;
  }
  now().calls.push_back(std::move(made));
}

/// Names whose presence the program asks for with ISVAR: where they are missing it knows its way.
void WayFinder::find_names_asked_for() {
  for (const Op& op : program_.ops) {
    const bool asks = op.code == OpCode::Function &&
                      static_cast<sinumerik::FunctionId>(op.detail) == sinumerik::FunctionId::ISVAR;
    if (!asks) {
      continue;
    }
    if (const std::string* const text = known_argument(op, 0)) {
      asked_for_.insert(sinumerik::upper(text->substr(0, text->find('['))));
    }
  }
}

void WayFinder::find_written_files() {
  constexpr std::size_t kName = 1;  // of WRITE(error,file,text)
  for (const Op& op : program_.ops) {
    if (!has_effect(op, sinumerik::ProcedureEffect::WritesFiles)) {
      continue;
    }
    if (const std::string* const name = known_argument(op, kName)) {
      ways_.written.names.push_back(sinumerik::program_name(*name).stem);
    } else {
      ways_.written.has_unknown = true;
    }
  }
}

SinumerikWays WayFinder::run() {
  find_names_asked_for();
  cut_into_blocks();
  followed_.assign(program_.ops.size(), false);
  for (BlockIndex i = 0; i < ways_.blocks.size(); ++i) {
    follow_block(i);
  }
  close_parts(parts_, ways_.blocks);
  find_written_files();
  return std::move(ways_);
}

}  // namespace

SinumerikWays ways_of(const sinumerik::CompiledProgram& program) {
  return WayFinder(program).run();
}

}  // namespace g31::analysis

#include "interpreter/dialects/sinumerik/code/label_jumps.h"

#include <algorithm>
#include <charconv>

namespace g31::sinumerik {

void LabelJumps::take_back(std::size_t first_step) {
  while (!jumps_.empty() && static_cast<std::size_t>(jumps_.back().step) >= first_step) {
    jumps_.pop_back();  // they are in the order of their steps
  }
}

/// Where a part begins and ends.  One that begins before its REPEAT ends there at the latest: an
/// end that stands further on is that of another part (programming manual, fundamentals, program
/// section repetition).
RepeatSite LabelJumps::site_of(const Part& part, const CompiledProgram& program) {
  const auto first = find_label(program, part.first, part.step, Direction::Both);
  if (!first) {
    return {.missing = part.first};
  }
  const auto last = part.one_block     ? first
                    : part.end.empty() ? std::nullopt
                                       : find_label(program, part.end, *first, Direction::Forward);
  if (!last) {
    return part.end == kEndOfPart ? RepeatSite{*first, part.step} : RepeatSite{.missing = part.end};
  }
  const std::int32_t behind = program.ops[static_cast<std::size_t>(*last)].a.place;
  return {*first, *first < part.step ? std::min(behind, part.step) : behind};
}

void LabelJumps::resolve(CompiledProgram& program, CodeWriter& code) const {
  std::ranges::stable_sort(program.block_numbers, {}, &BlockNumber::number);
  for (const Jump& jump : jumps_) {
    Op& op = program.ops[static_cast<std::size_t>(jump.step)];
    const auto target = find_label(program, jump.label, jump.step, jump.direction);
    if (target) {
      op.a.place = *target;
      op.code = program.bodies.enters(jump.step, *target) ? OpCode::JumpInto : op.code;
    } else if (jump.direction == Direction::BothQuiet) {
      op.a.place = jump.step + 1;
    } else {
      op = {OpCode::Raise,
            0,
            0,
            {},
            code.error_constant({AlarmId::JumpTargetMissing, jump.label}),
            {}};
    }
  }
  for (const Part& part : parts_) {
    program.repeats[part.site] = site_of(part, program);
  }
}

namespace {

/// The steps of a label, rising.
std::vector<std::int32_t> steps_of(const CompiledProgram& program, std::string_view name) {
  if (const auto found = program.labels.find(name); found != program.labels.end()) {
    return found->second;
  }
  std::vector<std::int32_t> steps;
  std::int32_t number = 0;
  const bool numbered = name.size() > 1 && name.front() == 'N' &&
                        std::from_chars(name.data() + 1, name.data() + name.size(), number).ptr ==
                            name.data() + name.size();
  if (numbered) {
    for (const BlockNumber& block :
         std::ranges::equal_range(program.block_numbers, number, {}, &BlockNumber::number)) {
      steps.push_back(block.step);
    }
  }
  return steps;
}

}  // namespace

std::optional<RepeatSite> find_part(const CompiledProgram& program, std::string_view first,
                                    std::string_view last, std::int32_t from) {
  const auto begin = find_label(program, first, from, Direction::Both);
  const auto end = begin ? find_label(program, last, *begin, Direction::Forward) : std::nullopt;
  return end ? std::optional(
                   RepeatSite{*begin, program.ops[static_cast<std::size_t>(*end)].a.place})
             : std::nullopt;
}

std::optional<std::int32_t> find_label(const CompiledProgram& program, std::string_view name,
                                       std::int32_t from, Direction direction) {
  const std::vector<std::int32_t> steps = steps_of(program, name);
  const auto behind = std::ranges::upper_bound(steps, from);
  if (direction != Direction::Backward && behind != steps.end()) {
    return *behind;
  }
  const bool looks_back = direction != Direction::Forward && behind != steps.begin();
  return looks_back ? std::optional(*(behind - 1)) : std::nullopt;
}

}  // namespace g31::sinumerik

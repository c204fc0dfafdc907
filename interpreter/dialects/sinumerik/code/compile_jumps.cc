#include <algorithm>
#include <charconv>

#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {

void Compiler::end_structures() {
  program_->bodies.finish();
  for (const Structure& open : structures_) {
    if (open.head >= 0) {
      Op& head = program_->ops[static_cast<std::size_t>(open.head)];
      head = {OpCode::Raise,
              0,
              0,
              {},
              code_.error_constant({AlarmId::BadNesting, "its end is missing"}),
              {}};
      program_->spans[static_cast<std::size_t>(open.head)] = open.where;
    }
  }
}

void Compiler::resolve_jumps() {
  for (const JumpToLabel& jump : jumps_) {
    Op& op = program_->ops[static_cast<std::size_t>(jump.step)];
    const auto target = find_label(*program_, jump.label, jump.step, jump.direction);
    if (target) {
      op.a.place = *target;
      op.code = program_->bodies.enters(jump.step, *target) ? OpCode::JumpInto : op.code;
    } else if (jump.direction == Direction::BothQuiet) {
      op.a.place = jump.step + 1;
    } else {
      op = {OpCode::Raise,
            0,
            0,
            {},
            code_.error_constant({AlarmId::JumpTargetMissing, jump.label}),
            {}};
    }
  }
  for (const PartToRepeat& part : parts_) {
    RepeatSite& site = program_->repeats[part.site];
    const auto first = find_label(*program_, part.first, part.step, Direction::Both);
    site.first = first.value_or(-1);
    if (part.one_block && first) {
      site.end = program_->ops[static_cast<std::size_t>(*first)].a.place;
    } else if (first) {
      const auto end = part.end.empty()
                           ? std::nullopt
                           : find_label(*program_, part.end, *first, Direction::Forward);
      const std::size_t last = static_cast<std::size_t>(end.value_or(part.step));
      site.end = end ? program_->ops[last].a.place : part.end == "ENDLABEL" ? part.step : -1;
      site.first = site.end < 0 ? -1 : site.first;
    }
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
    for (const BlockNumber& block : program.block_numbers) {
      if (block.number == number) {
        steps.push_back(block.step);
      }
    }
  }
  return steps;
}

}  // namespace

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

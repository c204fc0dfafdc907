#include "interpreter/dialects/sinumerik/code/structures.h"

#include <algorithm>
#include <utility>

namespace g31::sinumerik {
namespace {

bool is_branch(StructureKind kind) {
  return kind == StructureKind::If || kind == StructureKind::Else;
}

}  // namespace

bool Structures::are_too_deep() const {
  constexpr std::size_t kDeepest = 16;
  return open_.size() == kDeepest;
}

bool Structures::are_in(StructureKind kind) const {
  return !open_.empty() && open_.back().kind == kind;
}

bool Structures::are_in_branch() const {
  return std::ranges::any_of(open_,
                             [](const Structure& structure) { return is_branch(structure.kind); });
}

void Structures::open(Structure structure, std::size_t step) {
  open_.push_back(std::move(structure));
  program_.bodies.open(static_cast<std::int32_t>(step));
}

std::optional<Structure> Structures::close(StructureKind kind, std::size_t step) {
  if (!are_in(kind)) {
    return std::nullopt;
  }
  Structure structure = std::move(open_.back());
  open_.pop_back();
  // Who jumps to the end of a loop is in it; the end of a branch is where all ways meet.
  program_.bodies.close(static_cast<std::int32_t>(step) + (is_branch(kind) ? 0 : 1));
  return structure;
}

void Structures::end(CodeWriter& code) {
  program_.bodies.finish();
  for (const Structure& open : open_) {
    if (open.head >= 0) {
      const Operand alarm = code.error_constant({AlarmId::BadNesting, "its end is missing"});
      code.step(open.head) = {OpCode::Raise, 0, 0, {}, alarm, {}};
      program_.spans[static_cast<std::size_t>(open.head)] = open.where;
    }
  }
}

}  // namespace g31::sinumerik

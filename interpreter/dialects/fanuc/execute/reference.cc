#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

Result<int, Failure> which_reference(const NcBlock& block) {
  if (block.one_shot->number.whole == 28) {
    return 1;
  }
  const EvaluatedWord* const p = block.words.find('P');
  if (p == nullptr) {
    return 2;
  }
  const auto number = integer_of(*p);
  if (number && (number.value() < 2 || number.value() > 4)) {
    return at_word(AlarmId::IllegalAddress, *p, "P of G30 is 2, 3 or 4");
  }
  return number;
}

}  // namespace

/// G28, G30: the named axes go through the intermediate point to the reference point, at rapid
/// (MB-287 to MB-289).
MaybeFailure execute_reference(Control& control, const NcBlock& block) {
  const auto which = which_reference(block);
  if (!which) {
    return which.error();
  }
  if (!block.has_axis_word) {
    return std::nullopt;
  }
  const AxisPositions q_M_via = control.coordinates.to_machine(programmed_end(control, block));
  if (auto failure = move_to(control, q_M_via, machine::Traverse::Rapid, 0)) {
    return failure;
  }
  control.q_M_intermediate = q_M_via;
  AxisPositions q_M_home = q_M_via;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[axis])) {
      q_M_home[static_cast<Eigen::Index>(axis)] =
          control.parameters.get(ParameterId::ReferencePoint, which.value() - 1);
    }
  }
  auto failure = move_to(control, q_M_home, machine::Traverse::Rapid, 0);
  control.coordinates.arrived_at_machine(control.port.position());
  return failure;
}

}  // namespace g31::fanuc

#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"

namespace g31::fanuc {
namespace {

/// The one linear axis that the block names, as a storage index.
Result<int, Failure> measured_axis(const Control& control, const NcBlock& block) {
  int found = -1;
  int named = 0;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[axis])) {
      found = static_cast<int>(axis);
      ++named;
    }
  }
  if (named != 1 || found > 2) {
    return block_failure(AlarmId::AxisInMeasurement, "one of X Y Z is needed");
  }
  if (control.modal.incremental()) {
    return block_failure(AlarmId::AxisInMeasurement, "G37 takes an absolute position");
  }
  return found;
}

Result<int, Failure> measured_offset(Control& control, const NcBlock& block) {
  if (const EvaluatedWord* const h = block.words.find('H')) {
    return at_word(AlarmId::OffsetInMeasurement, *h, "");
  }
  const int number = static_cast<int>(control.modal.word('H'));
  if (number < 1 || number > OffsetTable::kLargest) {
    return block_failure(AlarmId::NoOffsetInMeasurement);
  }
  return number;
}

/// A word of the block that a control takes in the place of a parameter; null: the parameter
/// counts.
const EvaluatedWord* measuring_word(const Control& control, const NcBlock& block, char letter) {
  return control.profile.tool_measurement == ToolMeasurement::NearPositionByWords
             ? block.words.find(letter)
             : nullptr;
}

/// The feed near the measuring position, mm/min.
Result<double, Failure> measuring_feed(Control& control, const NcBlock& block) {
  const bool is_given = measuring_word(control, block, 'F') != nullptr;
  const double feed = is_given ? 0.0 : control.parameters.get(ParameterId::MeasuringFeed);
  return feed > 0.0 ? Result<double, Failure>(feed) : feed_in_force(control);
}

/// A distance from the measuring position, mm; its sign says nothing.
double measuring_length(const Control& control, const NcBlock& block, char letter,
                        ParameterId parameter) {
  const EvaluatedWord* const word = measuring_word(control, block, letter);
  return word != nullptr ? std::abs(control.scale.length_mm(*word))
                         : control.parameters.get(parameter);
}

/// A way along one axis to the measuring position and past it.
struct Approach {
  int axis;
  AxisPositions q_M_nominal;
  double sign;  ///< of the travel
  double zone;  ///< mm, either side of the nominal position
  double feed_mm_min;

  [[nodiscard]] AxisPositions at(double behind_mm) const {
    AxisPositions q_M = q_M_nominal;
    q_M[axis] += sign * behind_mm;
    return q_M;
  }
};

/// The latched position; alarm 080 when no signal comes, or one outside the zone.
Result<AxisPositions, Failure> touch(Control& control, const NcBlock& block,
                                     const Approach& approach) {
  machine::LinearMove move;
  move.q_M_end = approach.at(approach.zone);
  move.traverse = machine::Traverse::Feed;
  move.feed_mm_min = approach.feed_mm_min;
  const auto q_M_latched = move_and_latch(control, block, move);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  if (!q_M_latched.value()) {
    control.coordinates.arrived_at_machine(control.port.position());
    return block_failure(AlarmId::NoArrivalSignal, "no signal came");
  }
  const AxisPositions& q_M = *q_M_latched.value();
  const double off = q_M[approach.axis] - approach.q_M_nominal[approach.axis];
  if (std::abs(off) > approach.zone) {
    return block_failure(
        AlarmId::NoArrivalSignal,
        fmt::format("the signal came {:.4f} mm before the position", std::abs(off)));
  }
  return q_M;
}

}  // namespace

/// G37: at rapid up to the approach distance, then at the measuring feed to the signal; what the
/// axis stands beyond the programmed position is added to the wear of tool offset H, with memory A
/// to its one value.  #5061.. stay as they are (MB-282).  The offset in force changes with the next
/// H, G43 or G44.
MaybeFailure execute_tool_measurement(Control& control, const NcBlock& block) {
  if (control.profile.tool_measurement == ToolMeasurement::ToTravelEnd) {
    return execute_tool_touch(control, block);
  }
  const auto offset = measured_offset(control, block);
  if (!offset) {
    return offset.error();
  }
  const auto axis = measured_axis(control, block);
  if (!axis) {
    return axis.error();
  }
  const auto feed = measuring_feed(control, block);
  if (!feed) {
    return feed.error();
  }
  Approach approach;
  approach.axis = axis.value();
  approach.q_M_nominal = control.coordinates.to_path(programmed_end(control, block));
  const double way = approach.q_M_nominal[approach.axis] - control.port.position()[approach.axis];
  approach.sign = way < 0.0 ? -1.0 : 1.0;
  approach.zone = measuring_length(control, block, 'D', ParameterId::MeasuringZone);
  approach.feed_mm_min = feed.value();
  const double slow = measuring_length(control, block, 'R', ParameterId::MeasuringApproach);
  if (std::abs(way) > slow) {
    if (auto failure = rapid_to(control, approach.at(-slow), control.rapid_path())) {
      return failure;
    }
  }
  const auto q_M_latched = touch(control, block, approach);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  const double more = q_M_latched.value()[approach.axis] - approach.q_M_nominal[approach.axis];
  // Memory A has one value, which is the whole length.
  const runtime::ToolEntry entry = control.offsets.get(offset.value());
  const bool has_wear = control.offsets.memory() != OffsetMemory::A;
  const double length = has_wear ? 0.0 : entry.length_mm;
  control.offsets.set_field(offset.value(), &runtime::ToolEntry::length_wear_mm,
                            length + entry.length_wear_mm + more);
  return std::nullopt;
}

}  // namespace g31::fanuc

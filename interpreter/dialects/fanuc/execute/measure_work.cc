#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/execute/feed.h"

// G35, G36, G37, G136 and M75 of a Haas: mill operator's manual 96-8000, pages 169 and 170.

namespace g31::fanuc {
namespace {

constexpr int kKeepPoint = 75;
constexpr std::size_t kX = 0;
constexpr std::size_t kZ = 2;

// Settings that place the stylus about the point where it gives its signal, and the tool probe.
constexpr std::int32_t kStylusSettings = 20059;  // X+, X-, Y+, Y-
constexpr std::int32_t kWidthOfToolProbe = 20063;

/// A setting that is a length, mm; 0 where the sheet says none.
double setting_mm(const Control& control, std::int32_t variable) {
  const auto found = control.data.find(variable);
  return found != control.data.end() ? control.to_mm(found->second) : 0.0;
}

/// Whether some of the axes are named.
bool names_any(const BlockWords& words, std::size_t first, std::size_t last) {
  for (std::size_t axis = first; axis <= last; ++axis) {
    if (words.has(kAxisLetters[axis])) {
      return true;
    }
  }
  return false;
}

/// The skip move to a machine position.
Result<std::optional<AxisPositions>, Failure> touch_on_way_to(Control& control,
                                                              const NcBlock& block,
                                                              const AxisPositions& q_M_end) {
  const auto feed = feed_in_force(control);
  if (!feed) {
    return feed.error();
  }
  machine::LinearMove way;
  way.q_M_end = q_M_end;
  way.traverse = machine::Traverse::Feed;
  way.feed_mm_min = feed.value();
  way.mm_per_degree = control.scale.mm_per_unit();
  auto q_M_latched = move_and_latch(control, block, way);
  control.coordinates.arrived_at_machine(control.port.position());
  return q_M_latched;
}

/// Settings 59 to 62: from where the signal comes to the surface, by the direction of travel.
AxisPositions surface(const Control& control, const SkipPoint& skip) {
  AxisPositions q_M = skip.q_M_latched;
  for (Eigen::Index axis = 0; axis < static_cast<Eigen::Index>(kZ); ++axis) {
    const double way = skip.q_M_latched[axis] - skip.q_M_from[axis];
    if (way != 0.0) {
      const auto setting = static_cast<std::int32_t>(2 * axis + (way > 0.0 ? 0 : 1));
      q_M[axis] += setting_mm(control, kStylusSettings + setting);
    }
  }
  return q_M;
}

/// The named axes of the work system in force: this point reads 0 there, shifted by I J K.
void set_work_zero(Control& control, const NcBlock& block, const AxisPositions& q_M_zero) {
  constexpr char kShifts[] = {'I', 'J', 'K'};
  const int system = control.coordinates.selected();
  const AxisPositions q_W = control.coordinates.to_work(q_M_zero);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (!block.words.has(kAxisLetters[axis])) {
      continue;
    }
    const EvaluatedWord* const shift = axis <= kZ ? block.words.find(kShifts[axis]) : nullptr;
    const auto place = static_cast<Eigen::Index>(axis);
    const double value = control.coordinates.system(system)[place] + q_W[place] +
                         (shift != nullptr ? axis_value(control, *shift, axis) : 0.0);
    control.coordinates.set_system(system, static_cast<int>(axis), value);
  }
  control.coordinates.arrived_at_machine(control.port.position());
}

/// The point of M75.
SkipPoint marked_point(Control& control, const NcBlock& block) {
  if (!control.marked_skip) {
    control.warn_once(source::DiagnosticId::NoMarkedPoint, block.where,
                      to_text(block.code->number));
  }
  return control.marked_skip.value_or(SkipPoint{});
}

}  // namespace

void keep_marked_point(Control& control, const BlockWords& words) {
  if (!control.profile.marks_latched_point || !words.has('M')) {
    return;
  }
  const auto& all = words.all();
  const bool keeps = std::ranges::any_of(all, [](const EvaluatedWord& word) {
    return word.letter == 'M' && nearest_integer(word.number) == kKeepPoint;
  });
  if (keeps) {
    control.marked_skip = control.last_skip;
  }
}

/// G36 and G136: moves to the signal; the point, or the one half way to that of M75, becomes the
/// zero of the named axes.  Without a signal nothing changes.
MaybeFailure execute_work_measurement(Control& control, const NcBlock& block) {
  if (control.modal.group[Group::ToolLength].whole != 49) {
    return block_failure(
        AlarmId::LengthInMeasurement,
        fmt::format("{} measures without a tool length offset", to_text(block.code->number)));
  }
  const AxisPositions q_M_end = control.coordinates.to_path(programmed_end(control, block));
  const auto q_M_latched = touch_on_way_to(control, block, q_M_end);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  if (q_M_latched.value()) {
    AxisPositions q_M_zero = surface(control, control.last_skip);
    if (block.code->action == GAction::MeasureCentre) {
      q_M_zero = (q_M_zero + surface(control, marked_point(control, block))) / 2.0;
    }
    set_work_zero(control, block, q_M_zero);
  }
  return std::nullopt;
}

/// G35: the diameter of D is the distance between the point of M75 and the one that this move
/// finds, less the width of the tool probe (setting 63).
MaybeFailure execute_diameter_measurement(Control& control, const NcBlock& block) {
  const int number = nearest_integer(control.modal.word('D'));
  if (number < 1 || number > OffsetTable::kLargest) {
    return block_failure(AlarmId::IllegalOffsetNumber, "G35 sets the offset D");
  }
  if (names_any(block.words, kZ, kZ) || !names_any(block.words, kX, kX + 1)) {
    return block_failure(AlarmId::AxisInMeasurement, "G35 moves X or Y");
  }
  const AxisPositions q_M_end = control.coordinates.to_path(programmed_end(control, block));
  const auto q_M_latched = touch_on_way_to(control, block, q_M_end);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  if (q_M_latched.value()) {
    const AxisPositions apart = *q_M_latched.value() - marked_point(control, block).q_M_latched;
    const double diameter = std::hypot(apart[0], apart[1]) - setting_mm(control, kWidthOfToolProbe);
    control.offsets.set_field(number, &runtime::ToolEntry::radius_mm, diameter / 2.0);
  }
  return std::nullopt;
}

/// G37: Z goes down until the signal; then H is so long that a move to the Z of this block ends
/// where the signal came.
MaybeFailure execute_tool_touch(Control& control, const NcBlock& block) {
  const EvaluatedWord* const z = block.words.find('Z');
  if (z == nullptr || names_any(block.words, kX, kX + 1) ||
      names_any(block.words, kZ + 1, kAxisCount - 1)) {
    return block_failure(AlarmId::AxisInMeasurement, "G37 takes Z");
  }
  const int code = control.modal.group[Group::ToolLength].whole;
  const int number = control.modal.length_offset;
  if (code == 49 || number == 0) {
    return block_failure(AlarmId::NoOffsetInMeasurement, "G43 or G44 with H must be in force");
  }
  constexpr double kFurthestMm = 2000.0;  // an axis without limits goes no further
  constexpr auto kPlace = static_cast<Eigen::Index>(kZ);
  AxisPositions q_M_end = control.port.position();
  const auto travel = control.port.travel(static_cast<int>(kZ));
  const double lowest = q_M_end[kPlace] - kFurthestMm;
  q_M_end[kPlace] = travel ? std::max(travel->min, lowest) : lowest;
  const auto q_M_latched = touch_on_way_to(control, block, q_M_end);
  if (!q_M_latched) {
    return q_M_latched.error();
  }
  if (q_M_latched.value()) {
    const double above =
        control.coordinates.to_work(*q_M_latched.value())[kPlace] - axis_value(control, *z, kZ);
    const double wear = control.offsets.get(number).length_wear_mm;
    control.offsets.set_field(number, &runtime::ToolEntry::length_mm,
                              (code == 43 ? above : -above) - wear);
  }
  return std::nullopt;
}

}  // namespace g31::fanuc

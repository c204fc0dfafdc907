#include "interpreter/dialects/fanuc/execute/spindle.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/compensation.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/runtime/turn_time.h"

namespace g31::fanuc {
namespace {

constexpr double kNoLimit = std::numeric_limits<double>::infinity();

/// Parameter 3772, of G96 and G97.
double highest_speed(const Control& control) {
  const double highest = control.parameters.get(ParameterId::HighestSpeed);
  return highest > 0.0 ? highest : kNoLimit;
}

/// @pre S of G96 has been given
runtime::TurnTime turn_time(const Control& control) {
  const SpindleSpeeds& speeds = control.spindle;
  return {speeds.surface_mm_min,
          std::max(speeds.lowest, control.parameters.get(ParameterId::LowestSurfaceSpeed)),
          std::min(speeds.highest, highest_speed(control))};
}

/// Work coordinate of the axis of G96.
double place_of(const Control& control, const AxisPositions& q_B) {
  return control.coordinates.path_to_work(q_B)[control.spindle.axis];
}

double mean_over_arc(const Control& control, const FeedWay& way, const runtime::TurnTime& time) {
  const path::OffsetPlane axes = offset_plane(control);
  const path::PlaneWay flat = flat_way(control, way);
  const double sweep = path::sweep_rad(flat);
  const double turn = flat.arc->turn == machine::Turn::Counterclockwise ? sweep : -sweep;
  const path::PlanePoint from = flat.from - flat.arc->centre;
  const double growth =
      from.norm() > 0.0 ? (flat.to - flat.arc->centre).norm() / from.norm() - 1.0 : 0.0;
  return runtime::mean_over_arc(time, sweep, [&](double fraction) {
    const Eigen::Rotation2Dd turned(fraction * turn);
    const AxisPositions q_B =
        axes.moved(way.q_from + fraction * (way.q_end - way.q_from),
                   flat.arc->centre + (1.0 + fraction * growth) * (turned * from));
    return place_of(control, q_B);
  });
}

}  // namespace

double spindle_speed(const Control& control) {
  const SpindleSpeeds& speeds = control.spindle;
  if (!control.modal.surface_speed()) {
    return std::min(speeds.turns, highest_speed(control));
  }
  return speeds.surface_mm_min > 0.0
             ? 1.0 / turn_time(control).at(place_of(control, control.path_position()))
             : 0.0;
}

double mean_turn(const Control& control, const FeedWay& way) {
  if (control.spindle.surface_mm_min <= 0.0) {
    return 0.0;
  }
  const runtime::TurnTime time = turn_time(control);
  return way.arc ? mean_over_arc(control, way, time)
                 : time.mean(place_of(control, way.q_from), place_of(control, way.q_end));
}

void take_speed(Control& control, int number, const Codes& codes) {
  constexpr double kMmPerMetre = 1000.0;
  constexpr double kMmPerFoot = 304.8;
  SpindleSpeeds& speeds = control.spindle;
  if (codes.one_shot != nullptr && codes.one_shot->action == GAction::SetPosition) {
    speeds.highest = number > 0 ? number : kNoLimit;
  } else if (control.modal.surface_speed()) {
    const bool is_inch = control.scale.unit == LengthUnit::Inch;
    speeds.surface_mm_min = number * (is_inch ? kMmPerFoot : kMmPerMetre);
  } else {
    speeds.turns = number;
  }
}

MaybeFailure take_lowest_speed(Control& control, const BlockWords& words) {
  const char letter = control.profile.lowest_speed_word;
  const EvaluatedWord* const word = words.has('S') && letter != '\0' ? words.find(letter) : nullptr;
  if (word == nullptr) {
    return std::nullopt;
  }
  const auto number = integer_within(*word, control.profile, [letter](int speed) {
    return speed < 0 ? MaybeWrong(WrongValue{AlarmId::IllegalMinus,
                                             fmt::format("{} counts from 0", letter)})
                     : std::nullopt;
  });
  if (!number) {
    return number.error();
  }
  control.spindle.lowest = number.value();
  return std::nullopt;
}

MaybeFailure take_surface_axis(Control& control, const BlockWords& words) {
  const int preset = nearest_integer(control.parameters.get(control.profile.surface_axis));
  const EvaluatedWord* const p = words.find('P');
  int number = preset;
  if (p != nullptr && preset == 0) {
    control.warn_once(source::DiagnosticId::WordWithoutEffect, control.block,
                      fmt::format("P of G96 counts where parameter {} is not 0",
                                  info(control.profile.surface_axis).first));
  } else if (p != nullptr) {
    const auto given = integer_of(*p, control.profile);
    if (!given) {
      return given.error();
    }
    number = given.value() != 0 ? given.value() : preset;
  }
  const auto axis =
      number == 0 ? std::optional(axis_index('X')) : control.controlled_axis(number - 1);
  if (!axis || !is_linear_axis(*axis)) {
    return block_failure(AlarmId::IllegalSurfaceAxis, fmt::format("axis {}", number));
  }
  control.spindle.axis = *axis;
  return std::nullopt;
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/state/roll_over.h"

#include <cmath>

#include "machine/units/within_turn.h"

namespace g31::fanuc {
namespace {

using machine::within_turn;

constexpr double kWholeTurn = 360.0;
/// Places are the same within it: what is left of sums of degrees.
constexpr double kSamePlace = 1e-9;

}  // namespace

RollOver::RollOver(const Parameters& parameters) {
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    Way& way = ways_[static_cast<std::size_t>(axis)];
    if (parameters.is_on_for_axis(ParameterId::RollsOver, axis)) {
      way = parameters.is_on_for_axis(ParameterId::TurnsBySign, axis) ? Way::BySign : Way::Shorter;
      is_on_ = true;
    }
  }
}

double RollOver::end(int axis, double value, double now) const {
  if (way(axis) != Way::BySign) {
    return nearest(axis, value, now);
  }
  const double place = std::abs(value);
  return std::signbit(value) ? now - within_turn(now - place) : now + within_turn(place - now);
}

double RollOver::nearest(int axis, double value, double now) const {
  if (way(axis) == Way::Plain) {
    return value;
  }
  const double forward = within_turn(value - now);
  if (forward < kSamePlace) {
    return now;
  }
  return forward > kWholeTurn / 2 + kSamePlace ? now + forward - kWholeTurn : now + forward;
}

double RollOver::shown(int axis, double value) const {
  return way(axis) == Way::Plain ? value : within_turn(value);
}

}  // namespace g31::fanuc

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {
namespace {

/// What AP and RP say, from what was there before.
struct Polar {
  double radius = 0.0;
  double degrees = 0.0;
};

MaybeFailure take_words(const Channel& channel, const Block& block, Polar& polar) {
  if (const auto& word = block.words[Address::PolarRadius]; word.present) {
    const double value = word.value * channel.mm_per_length();
    polar.radius = word.modification == Modification::Incremental ? polar.radius + value : value;
  }
  if (const auto& word = block.words[Address::PolarAngle]; word.present) {
    if (MaybeFailure wrong = failure(wrong_polar_angle(word.value))) {
      return wrong;
    }
    polar.degrees =
        word.modification == Modification::Incremental ? polar.degrees + word.value : word.value;
  }
  return failure(wrong_polar_radius(polar.radius));
}

void add(const Polar& polar, const Plane& plane, AxisPositions& q) {
  q[plane.first] += polar.radius * mathematics(FunctionId::COS, polar.degrees, 0.0).value_or(0.0);
  q[plane.second] += polar.radius * mathematics(FunctionId::SIN, polar.degrees, 0.0).value_or(0.0);
}

}  // namespace

bool is_polar(const Block& block) {
  return block.words.has(Address::PolarAngle) || block.words.has(Address::PolarRadius);
}

MaybeFailure take_polar(Channel& channel, const Block& block, AxisPositions& q_W_end) {
  if (plane_words(channel, block) > 0) {
    return failure(AlarmId::PolarMixed, "AP and RP with an axis of the plane");
  }
  Pole& pole = channel.pole;
  const Plane plane = channel.plane();
  const AxisPositions out = q_W_end - pole.q_W;
  const double angle = std::atan2(out[plane.second], out[plane.first]) * 180.0 / std::numbers::pi;
  Polar polar{pole.radius.value_or(std::hypot(out[plane.first], out[plane.second])),
              pole.angle.value_or(angle)};
  if (MaybeFailure wrong = take_words(channel, block, polar)) {
    return wrong;
  }
  pole.radius = polar.radius;
  pole.angle = polar.degrees;
  q_W_end[plane.first] = pole.q_W[plane.first];
  q_W_end[plane.second] = pole.q_W[plane.second];
  add(polar, plane, q_W_end);
  return std::nullopt;
}

MaybeFailure set_pole(Channel& channel, const Block& block, const GCode& code) {
  AxisPositions q_W = code.name == "G110"   ? channel.programmed()
                      : code.name == "G112" ? channel.pole.q_W
                                            : AxisPositions::Zero();
  if (is_polar(block)) {
    if (plane_words(channel, block) > 0) {
      return failure(AlarmId::PolarMixed, std::string(code.name));
    }
    Polar polar;
    if (MaybeFailure wrong = take_words(channel, block, polar)) {
      return wrong;
    }
    add(polar, channel.plane(), q_W);
  }
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const BlockWords::Word& word = block.words.axis(axis);
    if (word.present) {
      q_W[axis] +=
          channel.stored_place(axis, word.value, Channel::Counts::Absolute, word.modification);
    }
  }
  channel.pole = {q_W, std::nullopt, std::nullopt};
  return std::nullopt;
}

}  // namespace g31::sinumerik

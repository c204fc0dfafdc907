#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"
#include "interpreter/dialects/sinumerik/system/system.h"

namespace g31::sinumerik::system {
namespace {

/// mm for one unit of $TC_CARRn: vectors, their fine offsets and retraction positions are lengths.
double unit_of(const Channel& channel, int n) {
  const bool is_direction = n >= 7 && n <= 12;
  const bool is_length =
      (n >= 1 && n <= 6) || (n >= 15 && n <= 20) || (n >= 38 && n <= 46) || (n >= 55 && n <= 60);
  return is_length && !is_direction ? channel.mm_per_datum() : 1.0;
}

MaybeFailure no_carrier(const Channel& channel, const SystemAccess& access) {
  const int number = access.indices[0];
  return number >= 1 && number <= channel.most_carriers()
             ? std::nullopt
             : MaybeFailure(failure(AlarmId::IndexOne, fmt::format("tool carrier {}", number)));
}

/// What a program reads: as nobody has written it where there is none; transformations on chains
/// are there, too.
Result<ToolCarrier, Failure> carrier_at(const Channel& channel, const SystemAccess& access) {
  const int number = access.indices[0];
  if (number <= kFirstOnChain) {
    if (MaybeFailure wrong = no_carrier(channel, access)) {
      return *wrong;
    }
  }
  auto found = carrier_in_force(channel, number);
  if (!found) {
    return found.error();
  }
  return found.value().value_or(ToolCarrier());
}

/// A chain says what the vectors of a carrier on it are.
MaybeFailure is_of_chain(const Channel& channel, const SystemAccess& access) {
  return is_on_chain(channel, access.indices[0])
             ? MaybeFailure(failure(AlarmId::WriteProtected,
                                    "the elements of its kinematic chain, $NK_, say what it is"))
             : std::nullopt;
}

/// $TC_CARR1 to 12, 15 to 20 and 24, 25.
bool is_of_vectors(int n) {
  return n <= 12 || (n >= 15 && n <= 20) || n == 24 || n == 25;
}

/// Which of the two axes, or of the three names, a variable is of.
std::size_t place_of(const SystemAccess& access) {
  const bool is_second =
      access.id == SystemId::CarrierAxis2 || access.id == SystemId::CarrierAxisName1;
  return is_second ? 1 : access.id == SystemId::CarrierAxisName2 ? 2 : 0;
}

}  // namespace

Number carrier_datum(Channel& channel, const SystemAccess& access) {
  const auto carrier = carrier_at(channel, access);
  if (!carrier) {
    return carrier.error();
  }
  return carrier.value().numbers.at(static_cast<std::size_t>(access.parameter)) /
         unit_of(channel, access.parameter);
}

MaybeFailure set_carrier_datum(Channel& channel, const SystemAccess& access, double value) {
  if (access.parameter == 1 && access.indices[0] == 0 && value == 0.0) {
    channel.carriers.clear();
    return std::nullopt;
  }
  if (MaybeFailure wrong = no_carrier(channel, access)) {
    return wrong;
  }
  if (is_of_vectors(access.parameter)) {
    if (MaybeFailure wrong = is_of_chain(channel, access)) {
      return wrong;
    }
  }
  constexpr double kFar = 1e9;
  if (!(std::abs(value) <= kFar)) {
    return failure(AlarmId::ValueOutOfLimits,
                   fmt::format("$TC_CARR{}[{}]", access.parameter, access.indices[0]));
  }
  channel.carriers[access.indices[0]].numbers.at(static_cast<std::size_t>(access.parameter)) =
      value * unit_of(channel, access.parameter);
  return std::nullopt;
}

Number carrier_axis(Channel& channel, const SystemAccess& access) {
  const auto carrier = carrier_at(channel, access);
  return carrier ? Number(carrier.value().axes.at(place_of(access))) : Number(carrier.error());
}

MaybeFailure set_carrier_axis(Channel& channel, const SystemAccess& access, double value) {
  if (MaybeFailure wrong = no_carrier(channel, access)) {
    return wrong;
  }
  if (MaybeFailure wrong = is_of_chain(channel, access)) {
    return wrong;
  }
  const int axis = static_cast<int>(value);
  if (axis >= 0 && !is_machine_axis(axis)) {
    return failure(AlarmId::BadAxisIndex, "an axis of a tool carrier");
  }
  channel.carriers[access.indices[0]].axes.at(place_of(access)) = axis;
  return std::nullopt;
}

Text carrier_kind(Channel& channel, const SystemAccess& access) {
  const auto carrier = carrier_at(channel, access);
  return carrier ? Text(carrier.value().kind) : Text(carrier.error());
}

MaybeFailure set_carrier_kind(Channel& channel, const SystemAccess& access,
                              const std::string& text) {
  if (MaybeFailure wrong = no_carrier(channel, access)) {
    return wrong;
  }
  if (MaybeFailure wrong = is_of_chain(channel, access)) {
    return wrong;
  }
  channel.carriers[access.indices[0]].kind = text;
  return std::nullopt;
}

Text carrier_name(Channel& channel, const SystemAccess& access) {
  const auto carrier = carrier_at(channel, access);
  return carrier ? Text(carrier.value().names.at(place_of(access))) : Text(carrier.error());
}

MaybeFailure set_carrier_name(Channel& channel, const SystemAccess& access,
                              const std::string& text) {
  if (MaybeFailure wrong = no_carrier(channel, access)) {
    return wrong;
  }
  channel.carriers[access.indices[0]].names.at(place_of(access)) = text;
  return std::nullopt;
}

Number active_carrier(Channel& channel, const SystemAccess& /*access*/) {
  return channel.orientation.carrier;
}

Number active_transformation(Channel& channel, const SystemAccess& /*access*/) {
  constexpr double kTool = 24;
  constexpr double kPart = 40;
  constexpr double kMixed = 56;
  const Orientation& orientation = channel.orientation;
  if (!orientation.chain) {
    return 0.0;
  }
  switch (orientation.traori_vectors.type) {
    case machine::KinematicType::Tool:
      return kTool;
    case machine::KinematicType::Part:
      return kPart;
    case machine::KinematicType::Mixed:
      break;
  }
  return kMixed;
}

Number transformation_number(Channel& channel, const SystemAccess& /*access*/) {
  return channel.orientation.transformation;
}

Number carrier_angle(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 1 || which > 4) {
    return failure(AlarmId::IndexOne, fmt::format("$P_TCANG[{}]", which));
  }
  return channel.orientation.found_deg.at(static_cast<std::size_t>(which - 1));
}

Number carrier_solutions(Channel& channel, const SystemAccess& /*access*/) {
  return channel.orientation.solutions;
}

Number carrier_status(Channel& channel, const SystemAccess& /*access*/) {
  return channel.orientation.free_axes;
}

Number tool_direction(Channel& channel, const SystemAccess& access) {
  const int which = access.indices[0];
  if (which < 1 || which > 3) {
    return failure(AlarmId::IndexOne, fmt::format("$P_TOOLO[{}]", which));
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return channel.tool_direction(channel.port.position())[which - 1];
}

Number tool_rotation(Channel& channel, const SystemAccess& access) {
  const int which = access.indices.empty() ? 0 : access.indices[0];
  if (which == 0) {
    return 0.0;
  }
  if (which < 0 || which > 3) {
    return failure(AlarmId::IndexOne, fmt::format("$P_TOOLROT[{}]", which));
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  return channel.tool_side(channel.port.position())[which - 1];
}

Number basic_now(Channel& channel, const SystemAccess& access) {
  if (channel.transformation() == nullptr) {
    return machine_now(channel, access);
  }
  if (MaybeFailure wrong = finish_motion(channel)) {
    return *wrong;
  }
  const int axis = access.indices[0];
  if (!is_machine_axis(axis)) {
    return machine_now(channel, access);
  }
  channel.touches.looks();
  const AxisPositions q = channel.to_basic(channel.port.position());
  return channel.within_turn(axis, channel.shown_datum(axis, q[axis]));
}

}  // namespace g31::sinumerik::system

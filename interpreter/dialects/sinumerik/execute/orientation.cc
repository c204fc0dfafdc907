// TRAORI: places are those of the part, and the tool's direction may be programmed.

#include <algorithm>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/execute/execute.h"
#include "interpreter/dialects/sinumerik/execute/travel.h"
#include "interpreter/dialects/sinumerik/state/kinematic_chain.h"
#include "machine/kinematics/plane_rotation.h"

namespace g31::sinumerik {
namespace {

using Vector3 = Eigen::Vector3d;

constexpr Address kVector[] = {Address::DirectionX, Address::DirectionY, Address::DirectionZ};
constexpr Address kAngles[] = {Address::OrientationA, Address::OrientationB, Address::OrientationC};
constexpr int kMachine = number_in_group("ORIMKS");
constexpr int kRollPitchYaw = number_in_group("ORIRPY");
constexpr int kTurnedByAxes = number_in_group("ORIAXES");
constexpr int kPointToPoint = number_in_group("PTP");
constexpr int kPointToPointOfRapids = number_in_group("PTPG0");

/// Between two pieces of a great circle the axes go straight.
constexpr double kPieceDeg = 1.0;

Vector3 words_of(const Block& block, std::span<const Address> addresses) {
  Vector3 values = Vector3::Zero();
  for (std::size_t i = 0; i < addresses.size(); ++i) {
    values[static_cast<int>(i)] = block.words[addresses[i]].value;
  }
  return values;
}

bool has_any(const Block& block, std::span<const Address> addresses) {
  return std::ranges::any_of(addresses, [&](Address a) { return block.words.has(a); });
}

/// Source: SINUMERIK job planning, orientation: Euler angles turn about Z, then the new X; roll,
/// pitch and yaw about X, Y and Z.
Vector3 by_angles(const Vector3& degrees, int definition) {
  using machine::AxisTurn;
  const Eigen::Matrix3d turn =
      definition == kRollPitchYaw
          ? machine::about_fixed_axes(
                {AxisTurn{0, degrees[0]}, AxisTurn{1, degrees[1]}, AxisTurn{2, degrees[2]}})
          : machine::about_turned_axes(
                {AxisTurn{2, degrees[0]}, AxisTurn{0, degrees[1]}, AxisTurn{2, degrees[2]}});
  return turn.col(2);
}

/// What STAT and TU ask for.  Source: Job Planning 07/2010, 6FC5398-2BP40-0BA0, page 377 (STAT 1:
/// the positions further from where the axes stand), and NC programming 12/2019,
/// 6FC5398-2EP40-0BA0, page 714 (TU).
struct Stance {
  bool is_other = false;                 ///< STAT=1
  std::optional<unsigned> below_zero{};  ///< TU, by storage indices
};

/// The pair that is not the nearest; the nearest where there is no other.
std::optional<machine::RotaryPair> other_pair(const machine::RotaryPairs& pairs,
                                              const std::array<double, 2>& from,
                                              const std::array<machine::RotaryTravel, 2>& travel) {
  std::array<std::optional<machine::RotaryPair>, 2> each;
  for (std::size_t i = 0; i < pairs.count; ++i) {
    machine::RotaryPairs one;
    one.all[0] = pairs.all.at(i);
    one.count = 1;
    each.at(i) = machine::least_motion(one, from, travel, 0);
  }
  const auto nearest = machine::least_motion(pairs, from, travel, 0);
  for (const auto& pair : each) {
    if (pair && nearest && pair->deg != nearest->deg) {
      return pair;
    }
  }
  return nearest;
}

/// By whole turns to the side of 0 that TU asks for, where the axis goes no further than 360
/// degrees and gets there.
double on_side(double deg, bool is_below, const machine::RotaryTravel& travel) {
  constexpr double kWholeTurn = 360.0;
  if (travel.lower < -kWholeTurn || travel.upper > kWholeTurn || (deg < 0.0) == is_below) {
    return deg;
  }
  const double turned = deg + (is_below ? -kWholeTurn : kWholeTurn);
  return turned >= travel.lower && turned <= travel.upper && (turned < 0.0) == is_below ? turned
                                                                                        : deg;
}

/// Positions of the rotary axes for a direction in the basic coordinates; nullopt: out of reach.
/// @param q_M_near  from where they go
std::optional<AxisPositions> axes_for(const Channel& channel, const Vector3& direction,
                                      const AxisPositions& q_M_near, const Stance& stance = {}) {
  const Orientation& orientation = channel.orientation;
  std::array<double, 2> from = {};
  std::array<machine::RotaryTravel, 2> travel;
  for (std::size_t i = 0; i < orientation.axes->count(); ++i) {
    const int axis = orientation.traori_vectors.axes.at(i);
    const double basic = orientation.traori_basic_deg.at(i);
    from.at(i) = q_M_near[axis] - basic;
    if (const auto goes = channel.port.travel(axis)) {
      travel.at(i) = {goes->min - basic, goes->max - basic};
    }
  }
  const Vector3 upright = orientation.upright(channel.plane().normal);
  const machine::RotaryPairs pairs = orientation.axes->pairs_for(direction, upright);
  const auto pair = stance.is_other ? other_pair(pairs, from, travel)
                                    : machine::least_motion(pairs, from, travel, 0);
  if (!pair) {
    return std::nullopt;
  }
  AxisPositions q_M = q_M_near;
  for (std::size_t i = 0; i < orientation.axes->count(); ++i) {
    const int axis = orientation.traori_vectors.axes.at(i);
    const double basic = orientation.traori_basic_deg.at(i);
    q_M[axis] = pair->deg.at(i) + basic;
    if (stance.below_zero) {
      const machine::RotaryTravel whole = {travel.at(i).lower + basic, travel.at(i).upper + basic};
      q_M[axis] = on_side(q_M[axis],
                          ((*stance.below_zero >> static_cast<unsigned>(axis)) & 1U) != 0, whole);
    }
  }
  return q_M;
}

bool moves_rotary_axes(const Block& block) {
  for (int axis = kLinearAxisCount; axis < static_cast<int>(kAxisCount); ++axis) {
    if (block.words.axis(axis).present) {
      return true;
    }
  }
  return false;
}

/// The rotary axes of one position, in work coordinates, with the linear ones of another.
AxisPositions with_turn(const Channel& channel, AxisPositions q_W, const AxisPositions& q_M) {
  q_W.tail<kRotaryAxisCount>() = rotary_axes(channel.active_frame().undo(q_M));
  return q_W;
}

double angle_between(const Vector3& from, const Vector3& to) {
  return std::atan2(from.cross(to).norm(), from.dot(to));
}

/// By how much of a great circle from one direction to another, both of length 1.
Vector3 between(const Vector3& from, const Vector3& to, double fraction) {
  const double angle = angle_between(from, to);
  return angle > 0.0 ? Vector3((std::sin((1.0 - fraction) * angle) * from +
                                std::sin(fraction * angle) * to) /
                               std::sin(angle))
                     : to;
}

/// In how many pieces the tool turns along a great circle, at least so many; 1: its axes go
/// straight.
int pieces_between(const Channel& channel, const Vector3& from, const Vector3& to, int least) {
  constexpr double kOppositeDeg = 179.999;  // many great circles lead there
  const double angle_deg = angle_between(from, to) * 180.0 / std::numbers::pi;
  return channel.group[Group::OrientationPath] == kTurnedByAxes || goes_by_axes(channel) ||
                 angle_deg > kOppositeDeg
             ? 1
             : std::max(least, static_cast<int>(std::ceil(angle_deg / kPieceDeg)));
}

/// Where the axes that turn the tool come to on the way from where they stand, at the end of each
/// piece: from piece to piece the nearer of their positions, so that none jumps to the other.
Result<std::vector<AxisPositions>, Failure> turned_in_pieces(const Channel& channel,
                                                             const Vector3& to, int pieces) {
  AxisPositions q_M = channel.machine_position();
  const Vector3 from = channel.tool_direction(q_M);
  std::vector<AxisPositions> ends;
  for (int i = 1; i <= pieces; ++i) {
    const auto turned = axes_for(
        channel, i == pieces ? to : between(from, to, static_cast<double>(i) / pieces), q_M);
    if (!turned) {
      return failure(AlarmId::CarrierNotReached, "on the way of the orientation");
    }
    q_M.tail<kRotaryAxisCount>() = rotary_axes(*turned);
    ends.push_back(q_M);
  }
  return ends;
}

/// Those of a block that goes point to point.
Stance stance_of(const Channel& channel, const Block& block) {
  Stance stance;
  if (goes_by_axes(channel)) {
    stance.is_other = channel.joint_position == 1;
    const double signs = block.words[Address::TurnSigns].value;
    constexpr double kAllAxes = 64.0;
    if (block.words.has(Address::TurnSigns) && signs >= 0.0 && signs < kAllAxes) {
      stance.below_zero = static_cast<unsigned>(signs);
    }
  }
  return stance;
}

}  // namespace

bool goes_by_axes(const Channel& channel) {
  const int code = channel.group[Group::PointToPoint];
  const bool is_asked_for =
      code == kPointToPoint ||
      (code == kPointToPointOfRapids && channel.group[Group::Motion] == number_in_group("G0"));
  return is_asked_for && channel.orientation.chain && !is_compensation_on(channel);
}

MaybeFailure take_joint_position(Channel& channel, const Block& block) {
  if (block.words.has(Address::JointPosition)) {
    const double value = block.words[Address::JointPosition].value;
    if (value != 0.0 && value != 1.0) {
      return failure(AlarmId::ValueOutOfLimits, "STAT is 0 or 1");
    }
    channel.joint_position = static_cast<int>(value);
  }
  const double signs = block.words[Address::TurnSigns].value;
  if (block.words.has(Address::TurnSigns) &&
      !(signs >= 0.0 && signs < 64.0 && signs == std::floor(signs))) {
    return failure(AlarmId::ValueOutOfLimits, "TU has six bits, one for each axis");
  }
  return std::nullopt;
}

MaybeFailure travel_by_axes(Channel& channel, const path::PathBlock& path,
                            const AxisPositions& q_W_end) {
  if (MaybeFailure wrong = finish_motion(channel)) {
    return wrong;
  }
  const AxisPositions q_P_end = channel.to_path(q_W_end);
  if (MaybeFailure outside = out_of_reach(channel, q_P_end)) {
    return outside;
  }
  path::PathBlock of_axes = path;
  of_axes.q_M_end = channel.to_machine(q_W_end);
  of_axes.of_axes = true;
  const Plane plane = channel.plane();
  if (const auto fault = channel.outlet.move(of_axes, {plane.first, plane.second})) {
    return from_fault(*fault);
  }
  channel.arrived_at_programmed(q_W_end, q_P_end);
  return std::nullopt;
}

bool has_direction(const Block& block) {
  return has_any(block, kVector) || has_any(block, kAngles);
}

MaybeFailure take_direction(const Channel& channel, const Block& block, AxisPositions& q_W_end) {
  if (!channel.orientation.chain || !channel.orientation.axes) {
    return failure(AlarmId::NoTransformation, "A2, B2, C2, A3, B3 and C3 need TRAORI");
  }
  const bool by_vector = has_any(block, kVector);
  if ((by_vector && has_any(block, kAngles)) || moves_rotary_axes(block)) {
    return failure(AlarmId::OrientationMixed);
  }
  Vector3 direction =
      by_vector ? words_of(block, kVector)
                : by_angles(words_of(block, kAngles), channel.group[Group::OrientationAngles]);
  if (!(direction.norm() > 0.0)) {
    return failure(AlarmId::OrientationMixed, "A3, B3 and C3 are all 0");
  }
  if (channel.group[Group::Orientation] != kMachine) {
    direction = channel.active_frame().directions() * direction;
  }
  const AxisPositions q_M_from = channel.machine_position();
  const auto q_M = axes_for(channel, direction, q_M_from, stance_of(channel, block));
  if (!q_M) {
    return failure(AlarmId::CarrierNotReached, "the programmed orientation");
  }
  const Vector3 to = direction.normalized();
  const int pieces = pieces_between(channel, channel.tool_direction(q_M_from), to, 1);
  AxisPositions q_M_end = *q_M;
  if (pieces > 1) {
    const auto ends = turned_in_pieces(channel, to, pieces);
    if (!ends) {
      return ends.error();
    }
    q_M_end = ends.value().back();
  }
  q_W_end = with_turn(channel, q_W_end, q_M_end);
  return std::nullopt;
}

bool turns_along_circle(const Channel& channel, const AxisPositions& q_M_end) {
  return pieces_between(channel, channel.tool_direction(channel.machine_position()),
                        channel.tool_direction(q_M_end), 1) > 1;
}

Result<std::vector<AxisPositions>, Failure> pieces_of_turn(Channel& channel,
                                                           const AxisPositions& q_M_end,
                                                           const AxisPositions& q_W_end,
                                                           int least) {
  const Vector3 to = channel.tool_direction(q_M_end);
  const int pieces =
      pieces_between(channel, channel.tool_direction(channel.machine_position()), to, least);
  if (pieces == 1) {
    return std::vector<AxisPositions>{q_W_end};
  }
  const auto turned = turned_in_pieces(channel, to, pieces);
  if (!turned) {
    return turned.error();
  }
  const AxisPositions q_W_from = channel.present();
  std::vector<AxisPositions> ends;
  for (int i = 1; i < pieces; ++i) {
    const double fraction = static_cast<double>(i) / pieces;
    ends.push_back(with_turn(channel, q_W_from + fraction * (q_W_end - q_W_from),
                             turned.value()[static_cast<std::size_t>(i - 1)]));
  }
  ends.push_back(q_W_end);
  return ends;
}

MaybeFailure travel_with_direction(Channel& channel, const path::PathBlock& path,
                                   const AxisPositions& q_W_end) {
  const auto ends = pieces_of_turn(channel, path.q_M_end, q_W_end);
  if (!ends) {
    return ends.error();
  }
  for (std::size_t i = 0; i + 1 < ends.value().size(); ++i) {
    path::PathBlock piece = path;
    piece.q_M_end = channel.to_path(ends.value()[i]);
    piece.ends = machine::BlockEnd::PassOn;
    piece.goes_on = i > 0;
    if (MaybeFailure wrong = travel_to(channel, piece, ends.value()[i])) {
      return wrong;
    }
  }
  path::PathBlock last = path;
  last.goes_on = ends.value().size() > 1;
  return travel_to(channel, last, q_W_end);
}

MaybeFailure turn_back(Channel& channel, const std::array<std::optional<double>, 2>& deg,
                       source::Location where) {
  const Orientation& orientation = channel.orientation;
  if (!orientation.chain) {
    return failure(AlarmId::NoTransformation, "ORIRESET");
  }
  AxisPositions q_M = channel.machine_position();
  for (std::size_t i = 0; i < orientation.axes->count(); ++i) {
    q_M[orientation.traori_vectors.axes.at(i)] =
        deg.at(i).value_or(orientation.traori_basic_deg.at(i));
  }
  const AxisPositions q_W_end = with_turn(channel, channel.present(), q_M);
  path::PathBlock path;
  path.g = 0;
  path.q_M_end = channel.to_path(q_W_end);
  path.where = where;
  return travel_to(channel, path, q_W_end);
}

namespace {

/// Paths have other coordinates behind it.
MaybeFailure finish_for_transformation(Channel& channel) {
  if (is_compensation_on(channel)) {
    return failure(AlarmId::CompensationAtTransformation);
  }
  MaybeFailure wrong = finish_motion(channel);
  channel.cutter.compensation.disengage();
  return wrong;
}

/// How the tool lies with all angles at 0: as the call has it, else the machine data; 0: square to
/// the plane in force, and so where the data say Z, with which they begin.
Vector3 basic_direction(const Channel& channel, int number, const BasicPosition& basic) {
  if (number <= kFirstOfData || !basic.direction.isZero(0.0)) {
    return basic.direction;
  }
  const auto told = transformation_of_data(channel, number - kFirstOfData);
  const bool is_own =
      told && told.value() && told.value()->basic_direction != Vector3(Vector3::UnitZ());
  return is_own ? told.value()->basic_direction : Vector3(Vector3::Zero());
}

/// What leads the axes by the vectors of TRAORI.
void lead_by_chain(Orientation& orientation) {
  const machine::KinematicVectors& vectors = orientation.traori_vectors;
  orientation.axes = orientation_of(vectors);
  orientation.chain = machine::chain_of(vectors, machine::AxisChainSetup());
  // Places of the part count from where it is with the axes at 0, as with a tool carrier.
  orientation.chain->tool_shift -= orientation.chain->part_shift;
  for (std::size_t i = 0; i < 2; ++i) {
    if (vectors.axes.at(i) >= 0) {
      orientation.chain->q_M_basic[vectors.axes.at(i)] = orientation.traori_basic_deg.at(i);
    }
  }
}

}  // namespace

MaybeFailure switch_transformation_on(Channel& channel, int number, const BasicPosition& basic) {
  const auto found = carrier_in_force(channel, number);
  if (!found) {
    return found.error();
  }
  if (!found.value()) {
    return failure(AlarmId::TransformationMissing, fmt::format("TRAORI({})", number));
  }
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    if (!channel.port.travel(axis)) {
      return failure(AlarmId::TransformationMissing,
                     fmt::format("TRAORI: there is no axis {}", kAxisLetters[axis]));
    }
  }
  const ToolCarrier& carrier = *found.value();
  const bool with_fine = channel.carriers_have_fine_offsets();
  const auto vectors = carrier.vectors(with_fine);
  if (!vectors) {
    return vectors.error();
  }
  const std::array<int, 2>& axes = vectors.value().axes;
  const bool has_second = !vectors.value().v2.isZero(0.0);
  if (!is_rotary_axis(axes[0]) || (has_second && !is_rotary_axis(axes[1])) || axes[0] == axes[1] ||
      !orientation_of(vectors.value())) {
    return failure(AlarmId::BadFiveAxisData, fmt::format("TRAORI({})", number));
  }
  if (MaybeFailure wrong = finish_for_transformation(channel)) {
    return wrong;
  }
  Orientation& orientation = channel.orientation;
  orientation.transformation = number;
  orientation.traori_vectors = vectors.value();
  for (std::size_t i = 0; i < 2; ++i) {
    orientation.traori_basic_deg.at(i) =
        carrier.basic_position(i, with_fine) + basic.offsets_deg.at(i);
  }
  orientation.traori_offsets_deg = basic.offsets_deg;
  const Vector3 direction = basic_direction(channel, number, basic);
  orientation.basic_direction =
      direction.isZero(0.0) ? std::nullopt : std::optional<Vector3>(direction.normalized());
  lead_by_chain(orientation);
  follow_table(channel);
  return std::nullopt;
}

MaybeFailure switch_transformation_off(Channel& channel) {
  if (!channel.orientation.chain) {
    return std::nullopt;
  }
  if (MaybeFailure wrong = finish_for_transformation(channel)) {
    return wrong;
  }
  channel.orientation.transformation = 0;
  channel.orientation.chain.reset();
  channel.orientation.axes.reset();
  follow_table(channel);
  return std::nullopt;
}

MaybeFailure transformation_is_unchanged(const Channel& channel) {
  const Orientation& orientation = channel.orientation;
  const int n = orientation.transformation - kFirstOfData;
  if (!orientation.chain || n <= 0) {
    return std::nullopt;
  }
  const Failure changed = failure(AlarmId::FiveAxisDataChanged, fmt::format("TRAORI({})", n));
  const auto told = transformation_of_data(channel, n);
  if (!told || !told.value()) {
    return changed;
  }
  const ToolCarrier& carrier = told.value()->carrier;
  const auto vectors = carrier.vectors(false);
  bool is_same = vectors && vectors.value() == orientation.traori_vectors;
  for (std::size_t i = 0; i < 2; ++i) {
    is_same = is_same && carrier.basic_position(i, false) + orientation.traori_offsets_deg.at(i) ==
                             orientation.traori_basic_deg.at(i);
  }
  return is_same ? std::nullopt : MaybeFailure(changed);
}

}  // namespace g31::sinumerik

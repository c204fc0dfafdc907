// G68.2, G68.3, G68.4: planes that are tilted in the work coordinate system.  Sources: FANUC
// B-63942EN/02 p. 248 (P0), A-79976E pp. 2, 4 (G68.3); Mazak Vortex i p. 4-25 (P1); LinuxCNC's
// tilted work plane, which follows FANUC's codes (P2, P3, G68.4).

#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/execute.h"
#include "machine/kinematics/plane_rotation.h"

namespace g31::fanuc {
namespace {

using Plane3 = Eigen::Isometry3d;
using MaybePlane = Result<Plane3, Failure>;

constexpr char kAngles[] = {'I', 'J', 'K'};

Failure format(std::string detail) {
  return block_failure(AlarmId::TiltedPlaneFormat, std::move(detail));
}

Point lengths(const Control& control, const BlockWords& words) {
  Point p = Point::Zero();
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const EvaluatedWord* const word = words.find(kAxisLetters[axis]);
    p[axis] = word != nullptr ? control.scale.length_mm(*word) : 0.0;
  }
  return p;
}

double angle(const Control& control, const BlockWords& words, char letter) {
  const EvaluatedWord* const word = words.find(letter);
  return word != nullptr ? control.scale.angle_deg(*word) : 0.0;
}

Point angles(const Control& control, const BlockWords& words) {
  return {angle(control, words, 'I'), angle(control, words, 'J'), angle(control, words, 'K')};
}

Point vector(const Control& control, const BlockWords& words) {
  Point along = Point::Zero();
  for (int i = 0; i < kLinearAxisCount; ++i) {
    const EvaluatedWord* const word = words.find(kAngles[i]);
    along[i] = word != nullptr ? control.scale.length_mm(*word) : 0.0;
  }
  return along;
}

int linear_words(const BlockWords& words) {
  int count = 0;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    count += words.has(kAxisLetters[axis]) ? 1 : 0;
  }
  return count;
}

Plane3 placed(const Point& origin, const Eigen::Matrix3d& turn) {
  Plane3 plane = Plane3::Identity();
  plane.translate(origin);
  plane.rotate(turn);
  return plane;
}

/// The number of a word that may be left out.
Result<int, Failure> number_of(const Control& control, const BlockWords& words, char letter,
                               int otherwise) {
  const EvaluatedWord* const word = words.find(letter);
  return word != nullptr ? integer_of(*word, control.profile) : Result<int, Failure>(otherwise);
}

/// P4: I is the angle of the plane's X in the old ZX plane, J that of the line in the old YZ plane,
/// K turns in the plane.
MaybePlane by_projections(const Control& control, const BlockWords& words) {
  const Point ijk = angles(control, words);
  const auto turn = machine::by_projection_angles({ijk.y(), ijk.x(), ijk.z()}, 2);
  if (!turn) {
    return format("the two lines of I and J are parallel");
  }
  return placed(lengths(control, words), *turn);
}

/// The axes, 0 to 2, that three digits name.
Result<std::array<int, 3>, Failure> axes_of_order(const Control& control, const BlockWords& words,
                                                  int usual) {
  const auto order = number_of(control, words, 'Q', usual);
  if (!order) {
    return order.error();
  }
  std::array<int, 3> axes{};
  int digits = order.value();
  for (auto axis = axes.rbegin(); axis != axes.rend(); ++axis, digits /= 10) {
    *axis = digits % 10 - 1;
    if (*axis < 0 || *axis >= kLinearAxisCount) {
      digits = -1;
      break;
    }
  }
  return digits == 0
             ? Result<std::array<int, 3>, Failure>(axes)
             : at_word(AlarmId::TiltedPlaneFormat, *words.find('Q'),
                       fmt::format("Q{} is not three of the digits 1, 2 and 3", order.value()));
}

/// P0: I about Z, J about the new X, K about the new Z; Q names other axes.
MaybePlane by_euler_angles(const Control& control, const BlockWords& words) {
  constexpr int kUsualOrder = 313;
  const auto axes = axes_of_order(control, words, kUsualOrder);
  if (!axes) {
    return axes.error();
  }
  const auto [first, second, third] = axes.value();
  if (first == second || second == third) {
    return at_word(AlarmId::TiltedPlaneFormat, *words.find('Q'), "two turns about one axis");
  }
  const Point ijk = angles(control, words);
  return placed(
      lengths(control, words),
      machine::about_turned_axes({{{first, ijk.x()}, {second, ijk.y()}, {third, ijk.z()}}}));
}

/// P1: roll I about X, pitch J about Y, yaw K about Z of the work system, in the order of Q.
MaybePlane by_roll_pitch_yaw(const Control& control, const BlockWords& words) {
  constexpr int kUsualOrder = 123;
  const auto axes = axes_of_order(control, words, kUsualOrder);
  if (!axes) {
    return axes.error();
  }
  const auto [first, second, third] = axes.value();
  if (first == second || second == third || first == third) {
    return at_word(AlarmId::TiltedPlaneFormat, *words.find('Q'), "two turns about one axis");
  }
  const Point ijk = angles(control, words);
  return placed(lengths(control, words),
                machine::about_fixed_axes(
                    {{{first, ijk[first]}, {second, ijk[second]}, {third, ijk[third]}}}));
}

/// P2: Q1 is the origin, X points to Q2, Q3 lies on the side of Y; Q0 shifts and turns in the
/// plane.
MaybePlane by_points(const PlanePoints& given) {
  const Point origin = *given.at_q[1];
  const auto turn = machine::by_three_points(origin, *given.at_q[2], *given.at_q[3]);
  if (!turn) {
    return format("the three points of P2 lie on one line");
  }
  const Point shift = given.at_q[0].value_or(Point::Zero());
  return placed(origin + *turn * shift, *turn * machine::turn_about({2, given.turned_deg}));
}

/// P3: the direction of Z counts, that of X is made perpendicular to it.
MaybePlane by_vectors(const PlanePoints& given) {
  constexpr double kMostOffDeg = 5.0;
  const Point x = *given.at_q[1];
  const Point z = *given.at_q[2];
  const auto turn = machine::by_x_and_z(x, z);
  if (!turn) {
    return format("the two directions of P3 are parallel, or one of them is 0");
  }
  const double off_deg = std::asin(std::min(1.0, std::abs(x.normalized().dot(z.normalized())))) *
                         180.0 / std::numbers::pi;
  if (off_deg > kMostOffDeg) {
    return format(
        fmt::format("the two directions of P3 are {:.3f} degrees off a right angle; 5 "
                    "are allowed",
                    off_deg));
  }
  return placed(given.origin, *turn);
}

/// A block of P2 or P3.  @returns the plane, once all of it has come
Result<std::optional<Plane3>, Failure> take_point(Control& control, const BlockWords& words,
                                                  int form) {
  const auto q = number_of(control, words, 'Q', 0);
  if (!q) {
    return q.error();
  }
  const int first = form == 2 ? 0 : 1;
  const int last = form == 2 ? 3 : 2;
  if (q.value() < first || q.value() > last) {
    return format(fmt::format("P{} takes Q{} to Q{}", form, first, last));
  }
  PlanePoints& given = control.plane_points;
  if (given.form != form) {
    given = {};
    given.form = form;
  }
  const bool is_point = form == 2 && q.value() > 0;
  if (is_point && linear_words(words) == 0) {
    return format(fmt::format("P2 Q{} takes X, Y and Z", q.value()));
  }
  given.at_q.at(static_cast<std::size_t>(q.value())) =
      form == 2 ? lengths(control, words) : vector(control, words);
  if (form == 3 && q.value() == 1) {
    given.origin = lengths(control, words);
  }
  if (form == 2 && q.value() == 0) {
    given.turned_deg = angle(control, words, 'R');
  }
  if (!given.is_whole()) {
    return std::optional<Plane3>();
  }
  const MaybePlane plane = form == 2 ? by_points(given) : by_vectors(given);
  given = {};
  return plane ? Result<std::optional<Plane3>, Failure>(std::optional(plane.value()))
               : plane.error();
}

/// G68.3: Z along the tool as it stands, X perpendicular to the vertical of parameter 12321 (0: as
/// the rotary axes carry it), then turned by R.
MaybePlane along_tool(const Control& control, const BlockWords& words) {
  const int named = linear_words(words);
  if (named != 0 && named != kLinearAxisCount) {
    return format("G68.3 takes all of X, Y and Z, or none of them");
  }
  const Coordinates& coordinates = control.coordinates;
  const AxisPositions q_M = control.port.position();
  const ToolInWork tool = coordinates.tool_in_work(q_M);
  const int vertical = nearest_integer(control.parameters.get(ParameterId::VerticalDirection));
  Eigen::Matrix3d turn = tool.turn;
  if (vertical >= 1 && vertical <= kLinearAxisCount) {
    // Parallel to the vertical the tool leaves X open: it is carried along.
    turn =
        machine::by_z_and_upright(tool.turn.col(2), Point::Unit(vertical - 1)).value_or(tool.turn);
  }
  return placed(named != 0 ? lengths(control, words) : tool.p_W_tip,
                turn * machine::turn_about({2, angle(control, words, 'R')}));
}

/// What G68.2 and G68.4 say; none: P2 and P3 go on in the next block.
Result<std::optional<Plane3>, Failure> described(Control& control, const NcBlock& block) {
  const auto form = number_of(control, block.words, 'P', 0);
  if (!form) {
    return form.error();
  }
  MaybePlane plane = Plane3::Identity();
  switch (form.value()) {
    case 0:
      plane = by_euler_angles(control, block.words);
      break;
    case 1:
      plane = by_roll_pitch_yaw(control, block.words);
      break;
    case 2:
    case 3:
      return take_point(control, block.words, form.value());
    case 4:
      plane = by_projections(control, block.words);
      break;
    default:
      return at_word(*wrong_plane_form(form.value()), *block.words.find('P'));
  }
  return plane ? Result<std::optional<Plane3>, Failure>(std::optional(plane.value()))
               : plane.error();
}

MaybeFailure refuse_plane(const Control& control, bool adds) {
  const auto refused = [](std::string why) {
    return block_failure(AlarmId::TiltedPlaneNotAllowed, std::move(why));
  };
  if (!control.coordinates.transform().is_identity() || control.transforms.rotation ||
      control.transforms.space_centre) {
    return refused("mirror, scaling or rotation is in force");
  }
  if (control.cutter.compensation.engaged() ||
      control.modal.group[Group::CutterCompensation].whole != 40) {
    return refused("cutter compensation is in force");
  }
  if (adds && !control.coordinates.plane()) {
    return refused("G68.4 without a tilted plane that it could be in");
  }
  return std::nullopt;
}

/// A, B and C, and an R where nothing turns by it.
void tell_idle_words(Control& control, const NcBlock& block, bool turns_by_r) {
  for (const char letter : {'A', 'B', 'C', 'R'}) {
    if (block.words.has(letter) && !(letter == 'R' && turns_by_r)) {
      control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where,
                        fmt::format("{} of {}", letter, to_text(block.code->number)));
    }
  }
}

}  // namespace

MaybeFailure execute_tilted_plane(Control& control, const NcBlock& block) {
  constexpr int kAlongTool = 3;
  constexpr int kAdds = 4;
  const int which = block.code->number.tenth;
  const EvaluatedWord* const form = block.words.find('P');
  tell_idle_words(control, block, which == kAlongTool || (form != nullptr && form->number == 2.0));
  if (auto failure = refuse_plane(control, which == kAdds)) {
    return failure;
  }
  std::optional<Plane3> plane;
  if (which == kAlongTool) {
    const MaybePlane given = along_tool(control, block.words);
    if (!given) {
      return given.error();
    }
    plane = given.value();
  } else {
    const auto given = described(control, block);
    if (!given) {
      return given.error();
    }
    plane = given.value();
  }
  if (plane) {
    control.coordinates.set_plane(which == kAdds ? *control.coordinates.plane() * *plane : *plane);
  }
  return std::nullopt;
}

/// About the axis I J K through X Y Z by R, counterclockwise.  What it turns are coordinates, as of
/// a tilted plane.  A second one turns in the first, and has its centre where it names none.
/// Source: FANUC B-62764EN/01 p. 243; that the first without X Y Z turns about where the tool is is
/// ours, as of G68 in a plane.
MaybeFailure rotate_in_space(Control& control, const NcBlock& block) {
  const auto first = control.transforms.space_centre;
  if (auto failure = first ? std::nullopt : refuse_plane(control, false)) {
    return failure;
  }
  for (const char letter : {'I', 'J', 'K', 'R'}) {
    if (!block.words.has(letter)) {
      return block_failure(AlarmId::RotationFormat, fmt::format("{} is missing", letter));
    }
  }
  const Point axis = vector(control, block.words);
  if (!(axis.norm() > 0.0)) {
    return block_failure(AlarmId::RotationFormat, "I, J and K are all 0");
  }
  Point centre = first.value_or(linear_axes(control.coordinates.programmed()));
  const Point named = lengths(control, block.words);
  for (int i = 0; i < kLinearAxisCount; ++i) {
    centre[i] = block.words.has(kAxisLetters[i]) ? named[i] : centre[i];
  }
  const double radians = angle(control, block.words, 'R') * std::numbers::pi / 180.0;
  const Eigen::Matrix3d turn = Eigen::AngleAxisd(radians, axis.normalized()).toRotationMatrix();
  const Plane3 turned = placed(centre - turn * centre, turn);
  control.coordinates.set_plane(first ? *control.coordinates.plane() * turned : turned);
  control.transforms.space_centre = first.value_or(centre);
  return std::nullopt;
}

MaybeFailure refuse_unfinished_plane(const Control& control, const Codes& codes) {
  const PlanePoints& given = control.plane_points;
  const bool goes_on = codes.frame != nullptr && codes.frame->action == GAction::TiltedPlane;
  if (!given.has_begun() || goes_on) {
    return std::nullopt;
  }
  return format(fmt::format("G68.2 P{} lacks {}", given.form,
                            !given.at_q[1]   ? "Q1"
                            : !given.at_q[2] ? "Q2"
                                             : "Q3"));
}

}  // namespace g31::fanuc

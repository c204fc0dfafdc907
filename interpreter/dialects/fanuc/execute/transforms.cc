#include <iterator>
#include <utility>

#include "interpreter/dialects/fanuc/execute/codes.h"
#include "interpreter/dialects/fanuc/execute/execute.h"

namespace g31::fanuc {
namespace {

/// What the program counts from is as good as an offset.
void apply(Control& control) {
  control.use_measured();
  control.coordinates.set_transform(control.transforms.all());
}

/// P, I, J, K of G51.
Result<double, Failure> given_factor(const Control& control, const EvaluatedWord& word) {
  return is_scale_factor(word, control.profile) || is_integer(word, control.profile)
             ? Result<double, Failure>(scale_factor(word, control.profile))
             : at_word(point_in(word), word);
}

Result<Point, Failure> scale_factors(Control& control, const NcBlock& block) {
  constexpr char kAxisFactors[] = {'I', 'J', 'K'};
  const BlockWords& words = block.words;
  const bool has_axis_factor = words.has_any(letters_of({kAxisFactors, std::size(kAxisFactors)}));
  const bool scales_named = control.profile.scale.of_named_axes;
  const bool by_axis =
      has_axis_factor && (scales_named || control.parameters.is_on(ParameterId::ScaleByAxis));
  if (has_axis_factor && !by_axis) {
    control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where,
                      "G51 scales by P; by I J K with parameter 5400.6");
  }
  Point factors;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    const ParameterId usual = by_axis ? ParameterId::UsualAxisScale : ParameterId::UsualScale;
    double& factor = factors[axis];
    if (scales_named && block.has_axis_word &&
        !words.has(kAxisLetters[static_cast<std::size_t>(axis)])) {
      factor = 1.0;
      continue;
    }
    factor = control.parameters.get_for_axis(usual, 0, axis) * kThousandth;
    if (const EvaluatedWord* const word = words.find(by_axis ? kAxisFactors[axis] : 'P')) {
      const auto given = given_factor(control, *word);
      if (!given) {
        return given.error();
      }
      factor = given.value();
    }
    if (auto wrong = wrong_scale(factor, by_axis)) {
      return block_failure(wrong->id, std::move(wrong->detail));
    }
  }
  return factors;
}

/// The centre of a stage in the coordinates that the stage acts on: the named axes go through the
/// stages before it, as any point of the program does, and of the others it is where the tool is.
/// The 30i operator's manual B-63944EN-2 takes the centre of G68 through G51 so (page 211), and
/// mirror, scaling and rotation act in this order (so also SINUMERIK 802D sl ISO Milling, 3-65); of
/// the centre of G51 under a mirror they say nothing.
/// @param q_present  where the tool is, in those coordinates
AxisPositions stage_centre(const Control& control, const NcBlock& block,
                           const WorkTransform& before, const AxisPositions& q_present) {
  const AxisPositions q_named = before.apply(named_point(control, block));
  AxisPositions q_centre = q_present;
  for (int axis = 0; axis < kLinearAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[static_cast<std::size_t>(axis)])) {
      q_centre[axis] = q_named[axis];
    }
  }
  return q_centre;
}

/// deg: how far G68 turns, as the program has it.
double rotation_angle(const Control& control, const NcBlock& block) {
  const bool keeps = control.profile.keeps_rotation_angle;
  const double last = control.transforms.angle_deg;
  const EvaluatedWord* const r = block.words.find('R');
  if (r == nullptr && keeps) {
    return last;
  }
  const double given = r != nullptr ? control.scale.angle_deg(*r)
                                    : control.parameters.get(ParameterId::UsualRotation);
  const bool adds = keeps || (control.transforms.rotation &&
                              control.parameters.is_on(ParameterId::IncrementalAngle));
  return adds && control.modal.incremental() ? last + given : given;
}

}  // namespace

/// G51.1: the named axes are mirrored at these coordinates (MB-300).
MaybeFailure execute_mirror(Control& control, const NcBlock& block) {
  const AxisPositions q_L_at = cartesian_end(control, block);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    if (block.words.has(kAxisLetters[axis])) {
      control.transforms.mirrored_at[axis] = q_L_at[static_cast<Eigen::Index>(axis)];
    }
  }
  apply(control);
  return std::nullopt;
}

/// G50.1: the named axes are mirrored no longer; without names none is.
MaybeFailure execute_mirror_off(Control& control, const NcBlock& block) {
  bool still_mirrored = false;
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    std::optional<double>& at = control.transforms.mirrored_at[axis];
    if (!block.has_axis_word || block.words.has(kAxisLetters[axis])) {
      at.reset();
    }
    still_mirrored = still_mirrored || at;
  }
  control.modal.group[Group::Mirror] = still_mirrored ? GNumber{51, 1} : GNumber{50, 1};
  apply(control);
  return std::nullopt;
}

/// G51: enlarges about X Y Z, by default the present point, by P or by I J K (MB-299).  The point
/// is absolute under G91, too, as that of G68 (FANUC 30i operator's manual B-63944EN, M700V 13.21).
/// The mirror takes the centre along.
MaybeFailure execute_scaling(Control& control, const NcBlock& block) {
  const auto factors = scale_factors(control, block);
  if (!factors) {
    return factors.error();
  }
  const TransformStages& stages = control.transforms;
  const AxisPositions q_present = stages.before_rotation().apply(control.coordinates.programmed());
  const AxisPositions q_centre = stage_centre(control, block, stages.before_scaling(), q_present);
  control.transforms.scaling = Scaling{linear_axes(q_centre), factors.value()};
  apply(control);
  return std::nullopt;
}

void cancel_scaling(Control& control) {
  control.transforms.scaling.reset();
  apply(control);
}

/// G68: turns the plane about a point, by default the present one, by R counterclockwise (MB-298).
/// Mirror and scaling take the centre along, and a mirrored plane turns the other way.
MaybeFailure execute_rotation(Control& control, const NcBlock& block) {
  const bool names_axis = block.words.has_any(letters_of("IJK"));
  if (control.profile.rotates_in_space && (names_axis || control.transforms.space_centre)) {
    return rotate_in_space(control, block);
  }
  if (names_axis) {
    control.warn_once(source::DiagnosticId::WordWithoutEffect, block.where, "I, J or K of G68");
  }
  const Plane plane = control.modal.plane();
  const Coordinates& coordinates = control.coordinates;
  const WorkTransform before = control.transforms.before_rotation();
  const AxisPositions q_W_centre =
      stage_centre(control, block, before, coordinates.transform().apply(coordinates.programmed()));
  const AxisPositions q_L_unturned = coordinates.unturned().value_or(coordinates.programmed());
  const double angle_deg = rotation_angle(control, block);
  control.transforms.angle_deg = angle_deg;
  control.transforms.rotation =
      Rotation{plane, Eigen::Vector2d(q_W_centre[plane.first], q_W_centre[plane.second]),
               before.reverses_turns(plane) ? -angle_deg : angle_deg};
  apply(control);
  if (control.profile.omits_before_rotation &&
      !control.parameters.is_on(ParameterId::OneAxisInTurnedPlane)) {
    control.coordinates.set_unturned(q_L_unturned);
  }
  return std::nullopt;
}

std::optional<EvaluatedWord> word_before_rotation(Control& control, const BlockWords& words,
                                                  const Codes& codes) {
  auto q_L = control.coordinates.unturned();
  const bool moves = codes.frame == nullptr && codes.work_offset == nullptr &&
                     (codes.one_shot == nullptr || codes.one_shot->action == GAction::Skip);
  const Plane& plane = control.transforms.rotation->plane;
  const bool counts_on = control.modal.incremental() && !control.polar;
  std::optional<int> omitted;
  int named = 0;
  for (const int axis : {plane.first, plane.second}) {
    const EvaluatedWord* const word = words.find(kAxisLetters[static_cast<std::size_t>(axis)]);
    if (word == nullptr) {
      omitted = axis;
    } else if (q_L) {
      (*q_L)[axis] += counts_on ? axis_value(control, *word, static_cast<std::size_t>(axis)) : 0.0;
      ++named;
    }
  }
  if (!moves || named == 0) {
    return std::nullopt;
  }
  control.coordinates.set_unturned(counts_on ? q_L : std::nullopt);
  if (control.modal.incremental() || control.polar || !omitted) {
    return std::nullopt;
  }
  EvaluatedWord word;
  word.letter = kAxisLetters[static_cast<std::size_t>(*omitted)];
  word.form = syntax::ValueForm::Decimal;
  word.number = control.from_mm((*q_L)[*omitted]);
  return word;
}

void cancel_rotation(Control& control) {
  control.transforms.rotation.reset();
  control.transforms.space_centre.reset();
  apply(control);
  control.plane_points = {};
  if (control.coordinates.plane()) {
    control.coordinates.set_plane(std::nullopt);
  }
}

/// G16: under G90 about the work origin, under G91 about the present point (MB-301).
void start_polar(Control& control) {
  const Plane plane = control.modal.plane();
  const AxisPositions& q_L = control.coordinates.programmed();
  const Eigen::Vector2d p_L_present(q_L[plane.first], q_L[plane.second]);
  control.polar = control.modal.incremental() ? PolarCoordinates::about(p_L_present)
                                              : PolarCoordinates::about_origin(p_L_present);
}

}  // namespace g31::fanuc

#pragma once

#include <array>
#include <map>
#include <memory>
#include <optional>

#include <Eigen/Geometry>

#include "interpreter/dialects/fanuc/state/part_errors.h"
#include "interpreter/dialects/fanuc/state/work_transform.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"
#include "interpreter/path/tip_transform.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/kinematics/orientation.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

/// In which system a program under tool centre point control is written (parameter 19696.5).
enum class TipSystem {
  None,       ///< no tool centre point control
  OnTable,    ///< fixed on the table, turning with it
  Workpiece,  ///< the work coordinate system, which does not turn
};

/// The tool as it stands for the work coordinate system on the table as it lies with the rotary
/// axes at 0.
struct ToolInWork {
  Point p_W_tip;         ///< mm
  Eigen::Matrix3d turn;  ///< its third column points from the tip to the holder
};

/// Work coordinates of the control: transform, offsets, shifts and the programmed point; mm and deg
/// throughout.  Four frames:
///
///   L  as the program writes it; what #5001.. show (MB-139)
///   W  behind mirror, scaling and rotation; in a tilted plane (G68.2) the coordinates of the plane
///   B  what motion is made of, path coordinates: M, or, where a transformation leads the axes, its
///      base coordinates
///   M  the axes; without a transformation W + shift + tool offset, where shift = external +
///      selected system + G52 + G92 (MB-145)
///
/// Changing a shift or the transform moves nothing: the programmed point is re-read behind the new
/// one.  Changing the tool offset moves nothing either; the next move takes it along (MB-295).
class Coordinates {
 public:
  static constexpr int kSystems = kWorkSystems;  ///< G54..G59
  static constexpr int kAdditional = kAdditionalSystems;

  Coordinates() { systems_.fill(AxisPositions::Zero()); }

  /// Which system: 0 external, 1..6 G54..G59, 6+P for G54.1 P.
  [[nodiscard]] const AxisPositions& system(int which) const;
  void set_system(int which, int axis, double value);

  void select(int which);
  [[nodiscard]] int selected() const { return selected_; }

  /// Each system has a G52 of its own from now on.
  void shift_each_system() { shifts_each_system_ = true; }
  /// G52: of all systems, or of the selected one.
  void set_local_shift(int axis, double value);
  [[nodiscard]] const AxisPositions& local_shift() const;
  /// G92: from now on the programmed point reads `value` on this axis.  @pre nothing leads the axes
  void declare(int axis, double value);
  /// G92.1: the axis has no G52 and no G92 any more, in any system.
  void clear_shifts(int axis);
  /// G51.1, G51, G68
  void set_transform(const WorkTransform& transform);
  /// Behind G68, where the program has the axes that it does not name, as it had them before the
  /// rotation (L); nullopt: where they are.  Whatever takes the axes or the coordinates elsewhere
  /// ends it.
  [[nodiscard]] const std::optional<AxisPositions>& unturned() const { return q_L_unturned_; }
  void set_unturned(const std::optional<AxisPositions>& q_L) { q_L_unturned_ = q_L; }
  [[nodiscard]] const WorkTransform& transform() const { return transform_; }

  /// What the control takes the machine for.
  /// @param tool_at_rest  how the tool is held with all rotary axes at 0, from an upright one
  void set_kinematics(const machine::AxisChainSetup& believed,
                      const Eigen::Isometry3d& tool_at_rest);
  [[nodiscard]] const machine::AxisChainSetup& kinematics() const { return believed_; }
  [[nodiscard]] const Eigen::Isometry3d& tool_at_rest() const { return tool_at_rest_; }
  /// G68.2: where the feature coordinate system lies in the work coordinate system.  nullopt: G69.
  void set_plane(const std::optional<Eigen::Isometry3d>& work_from_plane);
  [[nodiscard]] const std::optional<Eigen::Isometry3d>& plane() const { return work_from_plane_; }
  /// G54.2 and G54.4: the axes go where the part truly is, and the numbers stay as programmed.
  /// @param turns_tool  under tool centre point control the tool is turned along (11200.0)
  void set_part_errors(const PartErrors& errors, bool turns_tool);
  [[nodiscard]] const PartErrors& part_errors() const { return part_errors_; }
  /// G254: the work origin goes where the table has carried it.
  void shift_with_table(const AxisPositions& q_M);
  /// G255
  void end_shift_with_table();
  /// G43.4, G43.5 and G49.
  void set_tip_system(TipSystem system);
  [[nodiscard]] TipSystem tip_system() const { return tip_system_; }
  /// What leads the axes; null: nothing.  The place stays the same, for the outlet to look at.
  [[nodiscard]] const machine::AxisTransformPtr& leader() const { return leader_; }

  /// The axes are to move by the change.  @return whether there is one
  bool set_tool_offset(const AxisPositions& offset);
  /// The same for a control whose axis does not follow: the programmed point is re-read.
  void shift_tool_offset(const AxisPositions& offset);
  /// An axis has been brought to a machine position without its tool offset, which is over with it.
  void end_tool_offset(int axis);
  [[nodiscard]] const AxisPositions& tool_offset() const { return tool_offset_; }
  /// The tool offset as it acts along the axes of W, the axes standing there (#5081).
  [[nodiscard]] AxisPositions tool_offset_at(const AxisPositions& q_M) const;

  /// How the table, its axes standing there, has turned the frame of the machine against the part.
  [[nodiscard]] Eigen::Matrix3d table_turn(const AxisPositions& q_M) const;
  [[nodiscard]] ToolInWork tool_in_work(const AxisPositions& q_M) const;

  [[nodiscard]] const AxisPositions& shift() const { return shift_; }
  [[nodiscard]] const AxisPositions& programmed() const { return q_L_programmed_; }

  /// Path coordinates of a programmed point.
  [[nodiscard]] AxisPositions to_path(const AxisPositions& q_L) const {
    return work_to_path(transform_.apply(q_L));
  }
  /// Path coordinates of a point behind the transform.
  [[nodiscard]] AxisPositions work_to_path(const AxisPositions& q_W) const {
    return is_plain_ ? AxisPositions(q_W + shift_ + tool_offset_) : led_path_of(q_W);
  }
  /// The axes for path coordinates.  nullopt: as the rotary axes stand, the linear ones do not lead
  /// there.
  [[nodiscard]] std::optional<AxisPositions> axes_at(const AxisPositions& q_B) const {
    return tip_ ? tip_->axes_at(q_B) : std::optional(q_B);
  }
  /// Path coordinates where the axes stand.
  [[nodiscard]] AxisPositions path_at(const AxisPositions& q_M) const {
    return tip_ ? tip_->base_at(q_M) : q_M;
  }
  /// Whether errors of the part (G54.4) tilt the plane across an axis of the work system where
  /// nothing leads the axes: straight ways follow it there, and only they.
  [[nodiscard]] bool tilts_unled(int across) const {
    constexpr double kSeen = 1e-6;  // 0.1 um at 100 mm
    return !is_plain_ && !tip_ &&
           (error_.linear().col(across) - Point::Unit(across)).norm() > kSeen;
  }
  /// Work coordinates with the tool offset still in them (#5041, #5061).
  [[nodiscard]] AxisPositions to_work(const AxisPositions& q_M) const {
    return is_plain_ ? AxisPositions(q_M - shift_)
                     : AxisPositions(led_work_of(path_at(q_M)) + tool_offset_at(q_M));
  }

  /// The same without it: work coordinates of the tool's tip, before G51.1, G51 and G68.
  [[nodiscard]] AxisPositions tip_to_work(const AxisPositions& q_M) const {
    return path_to_work(path_at(q_M));
  }

  /// The way back of work_to_path().
  [[nodiscard]] AxisPositions path_to_work(const AxisPositions& q_B) const {
    return is_plain_ ? AxisPositions(q_B - shift_ - tool_offset_) : led_work_of(q_B);
  }

  /// Machine coordinates as a program would write them: the way back of to_path() and axes_at().
  [[nodiscard]] AxisPositions to_program(const AxisPositions& q_M) const {
    return transform_.undo(tip_to_work(q_M));
  }

  /// A programmed move has ended at its end point.
  void arrived_at_programmed(const AxisPositions& q_L) { q_L_programmed_ = q_L; }
  /// The axes stand at a machine position that no block programmed (skip, reference point).
  void arrived_at_machine(const AxisPositions& q_M) {
    q_L_programmed_ = to_program(q_M);
    q_L_unturned_.reset();
  }

  /// What leads the axes, and the parts of the chain, are made of the rest and not compared.
  friend bool operator==(const Coordinates& a, const Coordinates& b);

 private:
  [[nodiscard]] int locally_shifted() const { return shifts_each_system_ ? selected_ : 0; }
  void refresh();
  void take_shift();
  void lead();
  /// Changes what leads the axes; they stay where the programmed point has them.
  template <typename Change>
  void keep_axes(Change change);
  /// What G54.2 adds by groups of its own, mm.
  [[nodiscard]] Point offset_by_groups(const AxisPositions& q_M) const;
  [[nodiscard]] AxisPositions led_path_of(const AxisPositions& q_W) const;
  [[nodiscard]] AxisPositions led_work_of(const AxisPositions& q_B) const;
  /// mm: the tip from the gauge point with all rotary axes at 0.
  [[nodiscard]] Point tip_at_rest() const { return tool_at_rest_ * -linear_axes(tool_offset_); }
  /// The rotary axes for a tool turned against where it is.
  void turn_tool(AxisPositions& q_B, const Eigen::Matrix3d& turn) const;

  std::array<AxisPositions, kSystems + 1> systems_;
  std::map<int, AxisPositions> additional_;
  int selected_ = 1;
  bool shifts_each_system_ = false;
  std::map<int, AxisPositions> local_shifts_;  // by system; under 0 that of all
  AxisPositions declared_shift_ = AxisPositions::Zero();
  AxisPositions table_shift_ = AxisPositions::Zero();  // G254
  AxisPositions tool_offset_ = AxisPositions::Zero();
  AxisPositions shift_ = AxisPositions::Zero();
  WorkTransform transform_;
  AxisPositions q_L_programmed_ = AxisPositions::Zero();
  std::optional<AxisPositions> q_L_unturned_;
  machine::AxisChainSetup believed_;
  Eigen::Isometry3d tool_at_rest_ = Eigen::Isometry3d::Identity();
  machine::AxisChain table_{believed_, Point::Zero()};   // that chain, for what turns the part
  std::optional<machine::OrientationAxes> orientation_;  // that of the chain
  PartErrors part_errors_;
  Eigen::Isometry3d error_ = Eigen::Isometry3d::Identity();  // they, on the table
  bool turns_tool_ = false;
  bool is_plain_ = true;  // nothing leads the axes, and the part is where it should be
  std::optional<Eigen::Isometry3d> work_from_plane_;
  TipSystem tip_system_ = TipSystem::None;
  std::shared_ptr<const path::TipTransform> tip_;
  machine::AxisTransformPtr leader_;  // the same
};

}  // namespace g31::fanuc

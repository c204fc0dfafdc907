#pragma once

#include <array>
#include <map>

#include "interpreter/dialects/fanuc/state/work_transform.h"
#include "interpreter/dialects/fanuc/vocabulary/g_codes.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

/// Work coordinates of the control: transform, offsets, shifts and the programmed point; mm and deg
/// throughout.  Three frames:
///
///   L  as the program writes it; what #5001.. show (MB-139)
///   W  behind mirror, scaling and rotation
///   M  machine = W + shift + tool offset, where shift = external + selected system + G52 + G92
///      (MB-145)
///
/// Changing a shift or the transform moves nothing: the programmed point is re-read behind the new
/// one.  Changing the tool offset moves nothing either; the next move takes it along (MB-295).
class Coordinates {
 public:
  static constexpr int kSystems = kWorkSystems;  ///< G54..G59
  static constexpr int kAdditional = 300;        ///< G54.1 P1..P300

  Coordinates() { systems_.fill(AxisPositions::Zero()); }

  /// Which system: 0 external, 1..6 G54..G59, 6+P for G54.1 P.
  [[nodiscard]] const AxisPositions& system(int which) const;
  void set_system(int which, int axis, double value);

  void select(int which);
  [[nodiscard]] int selected() const { return selected_; }

  /// G52
  void set_local_shift(int axis, double value);
  [[nodiscard]] const AxisPositions& local_shift() const { return local_shift_; }
  /// G92: from now on the programmed point reads `value` on this axis.
  void declare(int axis, double value);
  /// G92.1: the axis has no G52 and no G92 any more.
  void clear_shifts(int axis);
  /// G51.1, G51, G68
  void set_transform(const WorkTransform& transform);
  [[nodiscard]] const WorkTransform& transform() const { return transform_; }

  void set_tool_offset(const AxisPositions& offset) { tool_offset_ = offset; }
  /// The same for a control whose axis does not follow: the programmed point is re-read.
  void shift_tool_offset(const AxisPositions& offset);
  /// An axis has been brought to a machine position without its tool offset, which is over with it.
  void end_tool_offset(int axis) { tool_offset_[axis] = 0.0; }
  [[nodiscard]] const AxisPositions& tool_offset() const { return tool_offset_; }

  [[nodiscard]] const AxisPositions& shift() const { return shift_; }
  [[nodiscard]] const AxisPositions& programmed() const { return q_L_programmed_; }

  /// Machine coordinates of a programmed point.
  [[nodiscard]] AxisPositions to_machine(const AxisPositions& q_L) const {
    return work_to_machine(transform_.apply(q_L));
  }
  /// Machine coordinates of a point behind the transform.
  [[nodiscard]] AxisPositions work_to_machine(const AxisPositions& q_W) const {
    return q_W + shift_ + tool_offset_;
  }
  /// Work coordinates with the tool offset still in them (#5041, #5061).
  [[nodiscard]] AxisPositions to_work(const AxisPositions& q_M) const { return q_M - shift_; }

  /// Machine coordinates as a program would write them: the way back of to_machine().
  [[nodiscard]] AxisPositions to_program(const AxisPositions& q_M) const {
    return transform_.undo(q_M - shift_ - tool_offset_);
  }

  /// A programmed move has ended at its end point.
  void arrived_at_programmed(const AxisPositions& q_L) { q_L_programmed_ = q_L; }
  /// The axes stand at a machine position that no block programmed (skip, reference point).
  void arrived_at_machine(const AxisPositions& q_M) { q_L_programmed_ = to_program(q_M); }

 private:
  void refresh();

  std::array<AxisPositions, kSystems + 1> systems_;
  std::map<int, AxisPositions> additional_;
  int selected_ = 1;
  AxisPositions local_shift_ = AxisPositions::Zero();
  AxisPositions declared_shift_ = AxisPositions::Zero();
  AxisPositions tool_offset_ = AxisPositions::Zero();
  AxisPositions shift_ = AxisPositions::Zero();
  WorkTransform transform_;
  AxisPositions q_L_programmed_ = AxisPositions::Zero();
};

}  // namespace g31::fanuc

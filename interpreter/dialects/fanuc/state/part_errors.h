#pragma once

#include <array>
#include <optional>

#include <Eigen/Geometry>

#include "interpreter/dialects/fanuc/vocabulary/offset_numbers.h"
#include "machine/kinematics/axis_chain.h"
#include "machine/units/axis_positions.h"

namespace g31::fanuc {

/// How a part lies on the table otherwise than it should (G54.4): found with the table at some
/// position.
struct SettingError {
  Point shift = Point::Zero();               ///< mm, along the axes of the machine
  Point turn_deg = Point::Zero();            ///< about X, then Y, then Z of the work system
  std::array<double, 2> table_deg = {0, 0};  ///< positions of the table's axes it was found at

  bool operator==(const SettingError&) const = default;
};

/// A rotary axis and how the offset of G54.2 turns with it: a positive angle takes it from the
/// first linear axis to the second.
struct TableGroup {
  int rotary = -1;  ///< storage indices; -1: there is no such group
  int first = 0;
  int second = 1;

  bool operator==(const TableGroup&) const = default;
};

/// Where the part truly is on the table, by what was entered of it (G54.2, G54.4).
///
/// Sources: FANUC A-79634E pp. 10, 19; groups of G54.2 (parameters 7580 to 7588): B-63944EN-2/02
/// p. 221, the first group's rotary axis turns the offset first.
class PartErrors {
 public:
  PartErrors() { table_offsets_.fill(AxisPositions::Zero()); }

  static constexpr int kTableOffsets = fanuc::kTableOffsets;
  static constexpr int kSettingErrors = fanuc::kSettingErrors;  ///< number 0 is added to each
  static constexpr std::size_t kTableGroups = 3;
  using TableGroups = std::array<TableGroup, kTableGroups>;

  /// G54.2: mm, and the positions of rotary axes that it was found at, deg.  @param n  1..8
  [[nodiscard]] const AxisPositions& table_offset(int n) const;
  void set_table_offset(int n, const AxisPositions& q_offset);
  /// @param n  0..7
  [[nodiscard]] const SettingError& setting_error(int n) const;
  void set_setting_error(int n, const SettingError& error);

  /// 0: none.
  void select_table_offset(int n) { table_offset_selected_ = n; }
  void select_setting_error(int n) { setting_error_selected_ = n; }
  [[nodiscard]] bool is_any_selected() const {
    return table_offset_selected_ != 0 || setting_error_selected_ != 0;
  }
  [[nodiscard]] bool has_setting_error() const { return setting_error_selected_ != 0; }

  /// By which axes G54.2 turns; none: as the table is believed to turn.
  void set_table_groups(const TableGroups& groups) { table_groups_ = groups; }
  [[nodiscard]] const TableGroups& table_groups() const { return table_groups_; }
  [[nodiscard]] bool turns_by_groups() const { return table_groups_.front().rotary >= 0; }

  /// From where a point of the work system should be to where it is: on the table as it lies with
  /// its axes at 0, the work origin at (0, 0, 0).
  /// @param with_offset  that of G54.2 is part of it
  [[nodiscard]] Eigen::Isometry3d on_table(const machine::AxisChainSetup& believed,
                                           bool with_offset) const;
  /// The offset of G54.2 as its groups have turned it, mm along the axes of the machine.
  [[nodiscard]] Point offset_by_groups(const AxisPositions& q_M) const;

  bool operator==(const PartErrors&) const = default;

 private:
  std::array<AxisPositions, kTableOffsets + 1> table_offsets_{};
  std::array<SettingError, kSettingErrors + 1> setting_errors_{};
  TableGroups table_groups_;
  int table_offset_selected_ = 0;
  int setting_error_selected_ = 0;
};

}  // namespace g31::fanuc

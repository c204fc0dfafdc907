#pragma once

#include <array>
#include <deque>
#include <vector>

#include "machine/port/axis_data.h"

namespace g31::machine {

/// A piece of the command of all axes: a cubic of the time since its beginning, by powers.
struct CommandPiece {
  std::array<AxisPositions, 4> command;
  double duration_s = 0.0;

  [[nodiscard]] AxisPositions at(double t) const {
    return command[0] + t * (command[1] + t * (command[2] + t * command[3]));
  }
};

/// One mean over a time, or one first-order lag, of each axis.
class FilterStage {
 public:
  enum class Shape { Mean, Lag };
  /// @param time_s  >= 0; 0: the axis goes through
  FilterStage(Shape shape, const AxisPositions& time_s) : shape_(shape), time_s_(time_s) {}

  /// What comes out while a piece goes in.
  void take(const CommandPiece& in, std::vector<CommandPiece>& out);

  /// How long something comes out once nothing goes in.
  [[nodiscard]] double rest_s() const;

 private:
  void take_mean(const CommandPiece& in, std::vector<CommandPiece>& out);
  void take_lag(const CommandPiece& in, std::vector<CommandPiece>& out);
  void remember(const CommandPiece& in);
  [[nodiscard]] std::vector<double> boundaries(double duration_s) const;

  Shape shape_;
  AxisPositions time_s_;
  std::deque<CommandPiece> past_;  // of a mean: the last one has just ended
  AxisPositions out_ = AxisPositions::Zero();
  bool has_begun_ = false;
  AxisPositions behind_ = AxisPositions::Zero();  // of a lag: what went in less what came out
};

/// What smooths the command of the axes behind the interpolation.  A value: it holds what of the
/// command is still on its way.
///
/// Accuracy: of means of straight commands at a steady speed exact; else within kFilterErrorMm, but
/// for the last half increment of a lag, which comes at once.
class CommandFilter {
 public:
  CommandFilter() = default;
  CommandFilter(FeedFilter shape, const AxisPositions& time_s);

  [[nodiscard]] bool is_there() const { return !stages_.empty(); }

  /// What comes out while a piece goes in, behind what is there.
  void take(const CommandPiece& in, std::vector<CommandPiece>& out);

  /// How long something comes out once nothing goes in, s.
  [[nodiscard]] double rest_s() const;

 private:
  std::vector<FilterStage> stages_;
};

/// mm or deg, of each piece.
inline constexpr double kFilterErrorMm = 1e-10;

}  // namespace g31::machine

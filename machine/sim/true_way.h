#pragma once

#include <optional>
#include <span>
#include <vector>

#include "machine/port/surroundings.h"
#include "machine/sim/servo_motion.h"
#include "machine/sim/true_position.h"

namespace g31::machine {

/// How true the straight pieces of a way are to be.
struct WayTolerance {
  double error_mm = 0.0;  ///< > 0
  double reach_mm = 0.0;  ///< >= 0: of what turns with the tool, from the tip
};

/// What the tool tip truly does for the part during a move: points so close that the straight
/// pieces between them stay within a tolerance of its way, and that nothing within the reach of the
/// tip leaves such a piece by more when it turns.
///
/// The fractions of the points are of the time: where a piece is passed, time_s() says when.
class TrueWay {
 public:
  /// @param start         where everything is when the move begins
  /// @param until_s       > 0: how much of the motion counts
  TrueWay(const TruePosition& start, const ServoMotion& motion, double until_s,
          const WayTolerance& tolerance);

  [[nodiscard]] std::span<const Waypoint> points() const { return points_; }

  /// When the tip is at a fraction as the world gives it: that far along a straight piece.
  [[nodiscard]] double time_s(double fraction) const;

  /// Where the axes truly are then: before tables and heads turn anything.
  [[nodiscard]] AxisPositions axes_at(double fraction) const;

 private:
  struct Piece {
    double from_s = 0.0;
    double to_s = 0.0;
    ToolPlace from;
    ToolPlace to;
  };

  /// As the last mark up to a time has left it.
  [[nodiscard]] TruePosition truth_at(double time_s) const;
  [[nodiscard]] ToolPlace tip_at(const TruePosition& truth, double time_s) const;
  [[nodiscard]] std::vector<double> marks() const;
  [[nodiscard]] bool is_straight(const TruePosition& truth, const Piece& piece) const;
  void add(const TruePosition& truth, const Piece& piece, int halvings);

  TruePosition start_;
  const ServoMotion& motion_;
  double until_s_;
  WayTolerance tolerance_;
  std::vector<double> marks_;
  std::vector<Waypoint> points_;
};

/// For touches: a nanometre.
inline constexpr double kTouchWayErrorMm = 1e-6;
/// For what must not be touched.
inline constexpr double kMoveWayErrorMm = 1e-4;

}  // namespace g31::machine

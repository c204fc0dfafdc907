#pragma once

#include <functional>
#include <vector>

#include "machine/units/point.h"

namespace g31::picture {

/// Where a point is at one time, and how fast it goes.
struct TrackKnot {
  double time_s = 0.0;        ///< simulated time
  Point p_M = Point::Zero();  ///< mm, as those of ways
  Point v_M = Point::Zero();  ///< mm/s
};

/// Where a point is at every time of a run: between two knots it goes along the cubic with their
/// places and speeds, before the first and behind the last one it stands.
///
/// So a move with constant acceleration needs a knot where each of its phases ends and is exact; an
/// arc, or axes that lag, have as many as kTrackErrorMm asks for.
class Track {
 public:
  /// In the order of time; two of one time are a step of speed or place.
  [[nodiscard]] const std::vector<TrackKnot>& knots() const { return knots_; }

  /// @pre there are knots
  [[nodiscard]] Point at(double time_s) const;

  /// The point goes on until a time as a function tells for the times between.
  /// @param ends_s  rising: where its motion may bend, the first and the last one the ends of all
  void go(const std::vector<double>& ends_s, const std::function<Point(double time_s)>& place_at);

  /// From then on it stands somewhere.
  void stand(double time_s, const Point& p_M);

 private:
  void go_between(double from_s, double to_s, const std::function<Point(double)>& place_at);
  void rest_until(double time_s);
  /// @param piece_s  how long the piece is that it is an end of
  void put(const TrackKnot& knot, double piece_s);

  std::vector<TrackKnot> knots_;
};

/// How far a track is at most beside the true way in time, at the places where it was compared;
/// tests/tools/track_test.cc holds it.
inline constexpr double kTrackErrorMm = 2e-4;

}  // namespace g31::picture

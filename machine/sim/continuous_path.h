#pragma once

#include <cstddef>
#include <deque>
#include <span>
#include <utility>
#include <vector>

#include "machine/sim/path_planner.h"
#include "machine/sim/servo_motion.h"

namespace g31::machine {

/// How a move at feed goes over into the next one.
struct Passing {
  BlockEnd ends = BlockEnd::ExactStop;
  ContourControl contour_control = ContourControl::Off;
  MoveTag tag = {};
  double corner_tolerance = 0.0;  ///< mm: see Smoothness
};

/// A piece of a path as it is travelled, from somewhere in its speed to somewhere.
struct Travelled {
  CommandedPath path;
  MotionPhases phases;  ///< distances count from the beginning of the path
  double duration_s = 0.0;
  Passing passing;
};

/// Moves at feed that pass on into each other, until the machine stops: how long they take, and on
/// request how they go.
///
/// What nothing that may come changes any more is given out; duration_s() is the rest, were the
/// machine to stop at the end of the last move.
class ContinuousPath {
 public:
  /// From now on what is travelled is known, not only the times.  @pre empty
  void keep_ways() { keeps_ways_ = true; }
  /// The same, and of a long way without corners what is behind is given out, so that little is
  /// kept.
  void keep_few_ways() { keeps_ways_ = keeps_few_ = true; }

  [[nodiscard]] bool is_empty() const { return planner_.is_empty(); }

  struct Move {
    double length = 0.0;  ///< > 0, path units
    PathLimits limits;
    double corner_speed = 0.0;  ///< at its beginning
    AxisPositions along_end;    ///< what each axis goes in a unit of the path at its end
    double corner_tolerance = 0.0;
  };
  /// The last one.  @pre not empty
  [[nodiscard]] const Move& last() const { return last_; }
  void add(const Move& move);

  /// Whether ways are kept: then keep() follows each add().
  [[nodiscard]] bool keeps_ways() const { return keeps_ways_; }
  void keep(CommandedPath path, const Passing& passing) {
    ways_.push_back({std::move(path), last_.length, passing});
  }

  /// s, until standstill.
  [[nodiscard]] double duration_s() const { return planner_.duration_s(); }

  /// A time and, where ways are kept, what is travelled in it.
  struct Passed {
    double seconds = 0.0;
    std::vector<Travelled> ways;
  };
  /// What nothing that may come changes any more.
  Passed release();
  /// All of it, to standstill.
  Passed finish();
  /// All of it, but of the last move only some distance, path units.
  Passed finish_at(double distance);
  /// What is open is not travelled.
  void drop();

 private:
  struct Way {
    CommandedPath path;
    double length = 0.0;
    Passing passing;
  };
  void give_out_beginning(Passed& passed);
  Passed all_of(std::span<const SpanMotion> spans);
  void pass(const SpanMotion& span, double until_s, Passed& passed);

  bool keeps_ways_ = false;
  bool keeps_few_ = false;
  std::size_t next_look_ = kManyWays;
  PathPlanner planner_;
  Move last_;
  std::deque<Way> ways_;

  static constexpr std::size_t kManyWays = 256;
};

}  // namespace g31::machine

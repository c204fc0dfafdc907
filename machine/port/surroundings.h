#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>

#include "machine/port/contact.h"
#include "machine/port/way.h"
#include "machine/units/axis_positions.h"

namespace g31::machine {

/// A straight sweep of all axes; fractions 0..1 of it are what the answers below speak of.
///
/// Where rotary axes turn tool and part against each other, the sweep is told in the frame of the
/// part: the linear axes bring the tool tip where it is, the tilt says how the tool is turned about
/// the tip.
struct Sweep {
  AxisPositions q_M_from;
  AxisPositions q_M_to;  ///< not equal to q_M_from, unless the tilt changes
  Eigen::Quaterniond tilt_from = Eigen::Quaterniond::Identity();
  Eigen::Quaterniond tilt_to = Eigen::Quaterniond::Identity();
};

/// How far what the tool carries reaches from the tool tip, mm: what turns must be asked about in
/// steps so fine that this makes no difference.
struct Reach {
  double signal = 0.0;  ///< what a skip signal may come from
  double body = 0.0;    ///< all of it
};

/// A sweep of all axes along a curve, like an arc; fractions 0..1 of it are what the answers speak
/// of.
struct CurvedSweep {
  std::function<AxisPositions(double)> q_M_at;  ///< at a fraction
  /// mm: the second derivative of the linear axes by the fraction is nowhere longer.  So the linear
  /// axes are never farther than bend h^2 / 8 from the chord over a fraction h.
  double bend = 0.0;
  int chords = 1;  ///< equal pieces for a world that knows straight sweeps only, >= 1
};

/// The skip signal: where on the sweep it is caused, and how late the control sees it.
struct SkipTrigger {
  double fraction = 0.0;           ///< 0..1 of the sweep, where the probe's contact opens
  bool on_at_start = false;        ///< the signal is already there before the move
  double delay_s = 0.0;            ///< from the opening to the latch; the axes go on meanwhile
  std::optional<Contact> contact;  ///< none for a signal that no part caused
  int signals = 1;                 ///< how many the probe gives; the first one counts
};

/// Something touches that must not.
struct Obstacle {
  double fraction = 0.0;  ///< 0..1 of the sweep
  std::string what;       ///< "stylus ball touches ring": for people
  Contact contact;
};

/// The world around the tool, as the machine asks about it: *what does this sweep meet first?*
///
/// `probe/sensor` answers with the stylus ball and the part meshes; a test answers from a script.
class Surroundings {
 public:
  Surroundings() = default;
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;
  virtual ~Surroundings() = default;

  /// The skip signal of a skip move along the sweep; nullopt: no signal on the whole way.
  /// Called once per skip move, in order: random models and scripts count these calls.
  virtual std::optional<SkipTrigger> first_trigger(const Sweep& sweep) = 0;

  /// The spindle stands at this angle from now on; 0 at the start.
  virtual void turn_spindle_to(double /*angle_deg*/) {}

  [[nodiscard]] virtual Reach reach() const { return {}; }

  /// The first forbidden touch of an ordinary move; nullopt: the way is free.  A sweep that leaves
  /// a contact in which the last skip move ended is free.
  virtual std::optional<Obstacle> first_collision(const Sweep& sweep) = 0;

  /// The same on a curve.  A world that has nothing better is asked chord by chord.
  virtual std::optional<Obstacle> first_collision_on_curve(const CurvedSweep& sweep) {
    for (int i = 0; i < sweep.chords; ++i) {
      const Sweep chord{sweep.q_M_at((i + 0.0) / sweep.chords),
                        sweep.q_M_at((i + 1.0) / sweep.chords)};
      // Far from the origin a chord may be shorter than the spacing of doubles.
      if (chord.q_M_from == chord.q_M_to) {
        continue;
      }
      if (auto obstacle = first_collision(chord)) {
        obstacle->fraction = (i + obstacle->fraction) / sweep.chords;
        return obstacle;
      }
    }
    return std::nullopt;
  }

  /// What breaks on the way that a skip move has taken, signal or not: anything but a stylus ball
  /// touches, or a ball is pushed in further than it gives way.
  virtual std::optional<Obstacle> first_damage(const Sweep& /*sweep*/) { return std::nullopt; }

  /// The skip signal of one skip move that goes through these points in straight pieces; its
  /// fraction is one of theirs.  A world without shape looks at the ends only.
  virtual std::optional<SkipTrigger> first_trigger_along(std::span<const Waypoint> way) {
    const Waypoint& from = way.front();
    const Waypoint& to = way.back();
    if (!differ(from, to)) {
      return std::nullopt;
    }
    auto trigger = first_trigger({from.q_M, to.q_M, from.tilt, to.tilt});
    if (trigger) {
      trigger->fraction = fraction_after(way, trigger->fraction * length_of(way));
    }
    return trigger;
  }

  /// Whether the skip signal is on while the tool stands there.
  [[nodiscard]] virtual bool signals_at(const Waypoint& /*at*/) const { return false; }

  /// Where on a way through these points the skip signal goes off, as one that is on at the start;
  /// `on_at_start` tells that it is not.  Counted as first_trigger is.
  virtual std::optional<SkipTrigger> first_release_along(std::span<const Waypoint> /*way*/) {
    return SkipTrigger{0.0, true, 0.0, std::nullopt};
  }

  /// The first forbidden touch of an ordinary move through these points.
  virtual std::optional<Obstacle> first_collision_along(std::span<const Waypoint> way) {
    for (std::size_t i = 1; i < way.size(); ++i) {
      const Waypoint& from = way[i - 1];
      const Waypoint& to = way[i];
      if (!differ(from, to)) {
        continue;
      }
      if (auto obstacle = first_collision({from.q_M, to.q_M, from.tilt, to.tilt})) {
        obstacle->fraction = from.fraction + obstacle->fraction * (to.fraction - from.fraction);
        return obstacle;
      }
    }
    return std::nullopt;
  }
};

}  // namespace g31::machine

#pragma once

#include <cstddef>
#include <cstdint>
#include <functional>
#include <memory>
#include <optional>
#include <set>
#include <span>
#include <string>
#include <vector>

#include <Eigen/Core>

#include "machine/port/surroundings.h"
#include "probe/collision/rigid_touch.h"
#include "probe/contact/sweep_mesh.h"
#include "probe/sensor/pressed_surfaces.h"
#include "probe/sensor/probe_setup.h"
#include "probe/sensor/touchable_parts.h"
#include "probe/tooling/spindle.h"

namespace g31::probe {

/// A touch probe in the spindle among parts: answers the machine with its stylus balls.
///
/// The main ball's centre stands at the linear axes + (eccentricity X, eccentricity Y, -length),
/// further balls and the rigid sections where they are from there; all of it turns about the
/// spindle axis, and with the tilt of a sweep about the tool tip.  In a turret no spindle turns it.
///
/// The signal comes when the ball is pushed into one of the surfaces that it meets
/// (pressed_surfaces.h) by the deflection that pre_travel.h says for its normal; the earliest
/// counts. It is shifted along the move by a normal random number of standard deviation
/// `repeatability_mm`, but never out of the move.  A move that ends before the deflection is
/// reached gives no signal.  The n-th question for a trigger takes the n-th random number, whether
/// it touches or not: the same seed and program give the same touches.
///
/// Accuracy: the contact as MeshSweeper finds it, kContactErrorMm.  The deflection is taken on the
/// tangent planes of what is met.  Where one surface holds the ball and is not as deep as these say
/// within 1 nm, over an edge or along what curves, the place is looked for step by step
/// (touch_probe_pressing.cc); a signal that comes and goes within one piece of the way, of which
/// tangent planes say nothing, is not found.
class TouchProbe final : public machine::Surroundings {
 public:
  /// @param seed  of every random model; with repeatability 0 it does not matter
  TouchProbe(const ProbeSetup& setup, const std::vector<ProbedPart>& parts, std::uint64_t seed);

  /// The same among parts that are made already, for balls of these sizes.
  TouchProbe(std::shared_ptr<const TouchableParts> parts, const ProbeSetup& setup,
             std::uint64_t seed);

  /// Rising: the contact in the answer is the true one; `fraction` carries deflection and random
  /// shift.  Falling: where every ball has come out as far as the signal needs, shifted at random
  /// as a touch is, be it that the straight way ends in another touch; the contact is the one that
  /// held the signal on.
  std::optional<machine::SkipTrigger> first_signal(const machine::Way& way,
                                                   const machine::Listening& to) override;

  /// Whether a ball is pushed in as far as the signal needs.
  [[nodiscard]] bool signals_at(const machine::Waypoint& at,
                                const machine::Listening& to) const override;

  /// By the winding number of the meshes of solids: no direction counts, and neither do small
  /// holes.
  [[nodiscard]] std::string stands_inside(const machine::Waypoint& at) const override;

  /// On a skip move a rigid section touching, or a ball pushed deeper than the deflection limit,
  /// measured along the normal of any surface that it meets; on others the ball touching a part, or
  /// a rigid section. Leaving a contact of the ball is free, pushing deeper into it is not.
  ///
  /// Accuracy on a curve: kCurveErrorMm for the ball, kSectionTouchErrorMm for a rigid section.
  std::optional<machine::Obstacle> first_obstacle(const machine::Way& way,
                                                  machine::Travel travel) override;

  [[nodiscard]] std::optional<machine::SensorState> sensor_state(int input) const override;

  [[nodiscard]] machine::ToolExtent tool_extent() const override;

  /// A tool change brings the probe or takes it away, M codes and outputs switch it; an angle of
  /// the spindle turns it, positive from +X towards +Y.  A spindle that has turned and stops
  /// without one stands anywhere: the seed draws the angle, evenly.
  void take(const machine::MachineEvent& event) override;

  void time_is(double now_s) override { now_s_ = now_s; }

 private:
  struct Tip {
    Point p_S = Point::Zero();  ///< from the gauge point, at spindle angle 0
    double radius = 0.0;
    std::size_t size = 0;  ///< which of the sweepers of each part
  };
  using Part = TouchableParts::Part;
  /// The straight way of one ball during a sweep.
  struct BallWay {
    Point p_M_from = Point::Zero();
    Point p_M_to = Point::Zero();
    double length = 0.0;

    [[nodiscard]] Point along() const { return p_M_to - p_M_from; }
  };
  struct PartHit {
    SweepHit hit;
    const Part* part = nullptr;  ///< none: no part was met
    const Tip* ball = nullptr;
    BallWay way;         ///< of that ball
    double depth = 0.0;  ///< mm: how deep the ball is in, along the normal, the tool standing still

    [[nodiscard]] double fraction() const { return way.length > 0.0 ? hit.s / way.length : 0.0; }
  };
  using Question = SweepHit (MeshSweeper::*)(const Point&, const Point&) const;
  /// Which parts are asked about: those whose touch means this.
  struct Asked {
    Encounter Part::*when = nullptr;
    Encounter encounter = Encounter::Free;

    [[nodiscard]] bool is_of(const Part& part) const { return part.*when == encounter; }
  };
  static constexpr Asked kSensed{&Part::on_skip_moves, Encounter::Signal};
  static constexpr Asked kBarred{&Part::on_moves, Encounter::Obstacle};
  static constexpr Asked kBarredOnSkip{&Part::on_skip_moves, Encounter::Obstacle};

  struct Signal {
    PartHit touch;
    double distance = 0.0;  ///< mm of the ball's way from the start of the move
    bool on_at_start = false;
  };
  /// The way of one ball in a move, as far as it has been looked at.
  struct Search {
    const Tip& ball;
    double gone = 0.0;            ///< mm: where the piece begins
    std::optional<Signal> first;  ///< be it behind the piece
  };
  /// How much deflection is missing somewhere, and the touch of which it is.
  struct Pressing {
    double s = 0.0;        ///< mm of the way of the ball
    double missing = 0.0;  ///< mm, negative where it is deeper in
    bool is_alone = true;  ///< nothing else presses the ball
    PartHit touch;
  };
  struct FirstPressing {
    bool is_decided = true;  ///< false: several surfaces press it on the way
    std::optional<Pressing> at;
  };
  /// mm: the deflection wanted along a normal; nullopt: what is met there does not count.
  using Need = std::function<std::optional<double>(const Point& n_M)>;
  using Points = std::span<const machine::Waypoint>;
  [[nodiscard]] bool is_wired(int input) const;
  std::optional<machine::SkipTrigger> first_touch_along(Points way);
  std::optional<machine::SkipTrigger> first_release_along(Points way);
  [[nodiscard]] std::optional<machine::Obstacle> collision_on(const machine::Sweep& sweep) const;
  [[nodiscard]] std::optional<machine::Obstacle> collision_on(
      const machine::CurvedWay& curve) const;
  [[nodiscard]] std::optional<machine::Obstacle> damage_on(const machine::Sweep& sweep) const;
  using Sections = std::span<const ProbeSection>;
  [[nodiscard]] std::optional<machine::Obstacle> touch_of(Sections sections,
                                                          const machine::Sweep& sweep,
                                                          double margin = 0.0) const;
  /// Stem and bodies; the stem once the ball is out of a contact in which it begins.
  [[nodiscard]] std::optional<machine::Obstacle> rigid_touch(const machine::Sweep& sweep) const;
  /// Between two fractions of the curve.  Certified: chords are swept with the bulge of the curve
  /// as a margin, and halved until they are free or as good as the curve, kSectionTouchErrorMm.
  [[nodiscard]] std::optional<machine::Obstacle> rigid_touch_on_curve(
      const machine::CurvedWay& curve, double begin, double end) const;
  /// The fraction of the sweep at which a ball that begins pushed in has come out; 0: it does not
  /// begin so.
  [[nodiscard]] double out_of_contact(const machine::Sweep& sweep) const;
  /// mm: the deflection that breaks the stylus.
  [[nodiscard]] double limit_of(const Tip& ball) const;
  [[nodiscard]] std::optional<machine::Obstacle> over_deflection(const Pressed& surface,
                                                                 const Tip& ball,
                                                                 const BallWay& way) const;
  /// Asks the surfaces whether the deflection limit is reached where tangent planes say.
  /// @param broken  what these say; what holds, behind it
  /// @param from    mm of the way of the ball, where something presses it first
  void settle_limit(std::optional<machine::Obstacle>& broken, const Tip& ball,
                    const machine::Sweep& sweep, double from) const;
  void add(const ToolBody& body);
  void note(const machine::ToolChange& change);
  void note(const machine::SpindleTurn& turn);
  void note(const machine::AuxiliaryCode& code);
  void note(const machine::DigitalOutput& output);
  void switch_on();
  [[nodiscard]] bool is_on() const;
  [[nodiscard]] bool is_round() const;
  /// Whether no touch can give a signal.
  [[nodiscard]] bool is_silent() const;
  [[nodiscard]] Point centre_of(const Tip& ball, const machine::Waypoint& at) const;
  [[nodiscard]] BallWay way_of(const Tip& ball, const machine::Sweep& sweep) const;
  /// The centres of a ball along a way, as linear axes.
  [[nodiscard]] std::vector<machine::Waypoint> way_of(const Tip& ball, Points way) const;
  [[nodiscard]] PartHit first_hit(const machine::Sweep& sweep, Question question,
                                  const Asked& asked) const;
  [[nodiscard]] PressedSurfaces surfaces_on(const Tip& ball, const BallWay& way) const;
  /// The first signal that a ball gives on a way.  @param until  fraction, not to be looked behind
  [[nodiscard]] std::optional<Signal> first_signal(const Tip& ball, Points way, double until) const;
  /// Looks at one more piece.
  void look_on(Search& search, const machine::Sweep& sweep) const;
  /// The same by tangent planes.  @returns what is met first
  std::optional<Pressed> look_on_planes(Search& search, const machine::Sweep& sweep,
                                        const BallWay& way) const;
  /// Asks the surfaces of a piece whether the signal comes where tangent planes say.
  /// @param pressed  what the ball meets first in it
  void settle(Search& search, const machine::Sweep& sweep, const Pressed& pressed) const;
  /// Of what presses a ball somewhere, the tool standing still, that of which least is missing.
  [[nodiscard]] std::optional<Pressing> pressing_at(const Tip& ball, const machine::Waypoint& at,
                                                    const Need& need) const;
  /// Where first nothing is missing any more.  @param from  mm of the way of the ball
  [[nodiscard]] FirstPressing first_pressing(const Tip& ball, const machine::Sweep& sweep,
                                             double from, const Need& need) const;
  /// mm of the way: where a ball that is free at `s` touches; infinity: nowhere.
  [[nodiscard]] double next_contact(const Tip& ball, const BallWay& way, double s) const;
  /// Contact and number of signals.
  [[nodiscard]] machine::SkipTrigger trigger_of(const PartHit& touch) const;
  /// The random shift of a trigger along the move, mm.
  [[nodiscard]] double trigger_shift(std::uint64_t event) const;
  /// What deflects a ball, the tool standing still.  A ball that is put out of where it is deepest
  /// and so comes free of another surface is not pressed into that one.
  [[nodiscard]] std::vector<PartHit> touches_of(const Tip& ball, const machine::Waypoint& at) const;
  /// A touch that the signal comes from, the tool standing still; none: it is off.
  [[nodiscard]] std::optional<PartHit> signalling_touch(const machine::Waypoint& at) const;
  /// The share of a piece after which a signal that is on at its start goes off, whatever comes
  /// behind.  @param touch  at its start, then the last one from which the signal came
  [[nodiscard]] std::optional<double> release_on(const machine::Waypoint& from,
                                                 const machine::Waypoint& to, PartHit& touch) const;
  /// After which share of a piece this touch, at its start, is off: on the tangent plane, or where
  /// the ball comes free of the part.
  [[nodiscard]] double share_to_off(const PartHit& touch, const machine::Waypoint& at,
                                    const machine::Waypoint& to) const;
  /// mm: how deep a ball that begins in contact is in.
  static double depth_of(const PartHit& touch);
  /// mm along this normal; nullopt: a touch from there never gives a signal.
  [[nodiscard]] std::optional<double> deflection_wanted(const Point& n_M,
                                                        const Eigen::Quaterniond& tilt) const;
  /// mm from where it begins to the signal, negative where the ball is deeper in than that already;
  /// nullopt: no signal from this surface.
  [[nodiscard]] std::optional<double> way_to_signal(const Pressed& surface, const BallWay& way,
                                                    const Eigen::Quaterniond& tilt) const;

  ProbeSetup setup_;
  std::vector<Tip> balls_;
  std::vector<ProbeSection> stem_;  // gives way with the balls
  std::vector<ProbeSection> rigid_;
  std::shared_ptr<const TouchableParts> parts_;
  std::uint64_t seed_;
  std::uint64_t triggers_asked_ = 0;
  Eigen::Matrix3d R_MS_ = Eigen::Matrix3d::Identity();
  bool is_in_place_ = true;
  double now_s_ = 0.0;
  std::optional<double> ready_at_s_ = 0.0;  // none: switched off
  Spindle spindle_;
  std::set<int> turning_parts_;  // of a probe in a turret: spindles, by their numbers
};

}  // namespace g31::probe

#pragma once

#include <optional>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/runtime/observer.h"
#include "interpreter/source/diagnostic.h"
#include "machine/port/skip_signal.h"

namespace g31::runtime {

/// What touch whose reading is used is wrong by, though the program cannot know: notes with a
/// number, each block once.  A touch counts when the program reads what it latched, so that the
/// fast touch before a slow one says nothing.
///
/// * Off the normal: a correction by the ball's radius r along the move errs by r (1 / cos a - 1)
/// on
///   a plane whose normal is at an angle a to the move.
/// * Grazing: a hair further to the side there would have been no touch.
/// * At another feed than calibrated: the signal's delay shifts the reading by delay x difference.
/// * Two touches along one line, to and fro, in a bore or on a boss beside its middle: what is
///   between the ball's centres, l, is a chord; the diameter is l (1 / cos a - 1) more.  The normal
///   is that of the cylinder that the facets stand for (probe/contact/smooth_normal.h).
class TouchNotes {
 public:
  /// @param state  of what touched
  void touched(const TouchEvent& event, const std::optional<machine::SensorState>& state);
  /// The program reads what the last touch latched.
  void read(std::vector<source::Diagnostic>& diagnostics);

  bool operator==(const TouchNotes&) const = default;

 private:
  struct Touch {
    source::Location where;
    std::string part;
    Point q_M_latched;
    Point along;   ///< unit vector of the move
    Point normal;  ///< out of the material
    Point smooth;  ///< the same of the surface that facets stand for
    double feed_mm_min = 0.0;
    machine::SensorState state;

    bool operator==(const Touch&) const = default;

    /// Of the angle between the move and the normal.
    [[nodiscard]] double cosine() const { return -along.dot(normal); }
    [[nodiscard]] double smooth_cosine() const { return -along.dot(smooth); }
  };

  [[nodiscard]] static std::optional<Touch> touch_from(
      const TouchEvent& event, const std::optional<machine::SensorState>& state);
  [[nodiscard]] static std::optional<std::string> oblique(const Touch& touch);
  [[nodiscard]] static std::optional<std::string> glancing(const Touch& touch);
  [[nodiscard]] static std::optional<std::string> other_feed(const Touch& touch);
  [[nodiscard]] static std::optional<std::string> chord(const Touch& first, const Touch& second);
  void note(std::vector<source::Diagnostic>& diagnostics, source::DiagnosticId id,
            source::Location where, const std::optional<std::string>& text);

  std::optional<Touch> unread_;
  std::optional<Touch> before_;  // the last that was read
  std::set<std::pair<source::DiagnosticId, std::uint64_t>> told_;
};

}  // namespace g31::runtime

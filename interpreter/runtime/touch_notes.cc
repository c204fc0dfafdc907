#include "interpreter/runtime/touch_notes.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <utility>

#include <fmt/format.h>

namespace g31::runtime {
namespace {

constexpr double kDegrees = 180.0 / std::numbers::pi;
constexpr double kSecondsPerMinute = 60.0;
/// Facets of a mesh and a bore that stands a little off its place are nothing to speak of.
constexpr double kLeastAngleDeg = 5.0;
constexpr double kLeastErrorMm = 0.001;
/// Of 89 degrees between the move and the normal.
constexpr double kGlancingCosine = 0.01745240643728351;
/// A way shorter than this has no direction.
constexpr double kLeastWayMm = 1e-6;
/// Two directions are one line, two angles the same.
constexpr double kSameDirection = 1e-3;

Point linear(const AxisPositions& q) {
  return q.head<kLinearAxisCount>();
}

}  // namespace

void TouchNotes::touched(const TouchEvent& event,
                         const std::optional<machine::SensorState>& state) {
  unread_ = touch_from(event, state);
}

std::optional<TouchNotes::Touch> TouchNotes::touch_from(
    const TouchEvent& event, const std::optional<machine::SensorState>& state) {
  const Point left = linear(event.q_M_commanded) - linear(event.q_M_latched);
  if (!event.triggered || !event.contact || !state || left.norm() < kLeastWayMm) {
    return std::nullopt;
  }
  return Touch{
      event.where,
      event.contact->part,
      linear(event.q_M_latched),
      left.normalized(),
      event.contact->n_M,
      event.contact->n_M_smooth.isZero(0.0) ? event.contact->n_M : event.contact->n_M_smooth,
      event.feed_mm_min,
      *state};
}

void TouchNotes::read(std::vector<source::Diagnostic>& diagnostics) {
  if (!unread_) {
    return;
  }
  const Touch touch = *std::exchange(unread_, std::nullopt);
  using source::DiagnosticId;
  const auto beside_middle = before_ ? chord(*before_, touch) : std::nullopt;
  note(diagnostics, DiagnosticId::Chord, touch.where, beside_middle);
  const bool by_a_ball = touch.state.ball_radius_mm > 0.0;  // a tool probe has none
  if (!beside_middle && by_a_ball) {
    note(diagnostics, DiagnosticId::ObliqueTouch, touch.where, oblique(touch));
    note(diagnostics, DiagnosticId::GlancingTouch, touch.where, glancing(touch));
  }
  note(diagnostics, DiagnosticId::OtherFeed, touch.where, other_feed(touch));
  before_ = touch;
}

std::optional<std::string> TouchNotes::oblique(const Touch& touch) {
  const double angle = std::acos(std::clamp(touch.cosine(), -1.0, 1.0)) * kDegrees;
  if (angle < kLeastAngleDeg || touch.cosine() < kGlancingCosine) {
    return std::nullopt;
  }
  return fmt::format(
      ": {:.1f} degrees off the surface normal, a correction by the ball radius along the move is "
      "wrong by {:.3f} mm",
      angle, touch.state.ball_radius_mm * (1.0 / touch.cosine() - 1.0));
}

/// The ball reaches r (1 - sin a) into the surface's way: whether it touches at all hangs on that.
std::optional<std::string> TouchNotes::glancing(const Touch& touch) {
  const double cosine = touch.cosine();  // below 0: the ball leaves the surface
  if (cosine < 0.0 || cosine >= kGlancingCosine) {
    return std::nullopt;
  }
  return fmt::format(": {:.4f} mm further to the side it would miss",
                     touch.state.ball_radius_mm * (1.0 - std::sqrt(1.0 - cosine * cosine)));
}

std::optional<std::string> TouchNotes::other_feed(const Touch& touch) {
  const auto calibrated = touch.state.calibrated_feed_mm_min;
  const double shift =
      calibrated ? touch.state.delay_s * (touch.feed_mm_min - *calibrated) / kSecondsPerMinute
                 : 0.0;
  if (std::abs(shift) < kLeastErrorMm) {
    return std::nullopt;
  }
  return fmt::format(
      ": at {:g} mm/min, calibrated at {:g}, the signal delay shifts it by {:+.4f} mm",
      touch.feed_mm_min, *calibrated, shift);
}

std::optional<std::string> TouchNotes::chord(const Touch& first, const Touch& second) {
  const Point between = second.q_M_latched - first.q_M_latched;
  const double length = between.norm();
  const auto beside = [](const Touch& touch) {
    return Point(touch.smooth + touch.smooth_cosine() * touch.along);
  };
  const bool is_one_line =
      first.along.dot(second.along) < -1.0 + kSameDirection && length > kLeastWayMm &&
      std::abs(std::abs(between.dot(second.along)) - length) < kSameDirection * length;
  const bool curves_alike = (beside(first) - beside(second)).norm() < kSameDirection;
  if (first.part != second.part || !is_one_line || !curves_alike || second.smooth_cosine() <= 0.0) {
    return std::nullopt;
  }
  const double less = length * (1.0 / second.smooth_cosine() - 1.0);
  if (less < kLeastErrorMm) {
    return std::nullopt;
  }
  return fmt::format(
      ": {:.3f} mm off centre, the chord is {:.3f} mm shorter than the "
      "diameter",
      0.5 * length * beside(second).norm() / second.smooth_cosine(), less);
}

void TouchNotes::note(std::vector<source::Diagnostic>& diagnostics, source::DiagnosticId id,
                      source::Location where, const std::optional<std::string>& text) {
  const auto place = (static_cast<std::uint64_t>(where.file) << 40U) ^ where.begin;
  if (text && told_.insert({id, place}).second) {
    diagnostics.push_back(make_diagnostic(id, where, *text));
  }
}

}  // namespace g31::runtime

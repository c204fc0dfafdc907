#include "machine/sim/true_way.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// Between the places of an error table nothing is finer than this without showing at a quarter;
/// cyclic errors say their own.
constexpr double kFirstPieceMm = 5.0;
/// After a reversal an axis sticks and comes free again within hundredths of a millimetre.
constexpr double kFinestPieceMm = 0.01;
/// Of a way; a finer pitch would take long and is no longer seen in full.
constexpr double kMostCyclicPieces = 1e6;
constexpr int kMostHalvings = 24;
/// Less is rounding: of a tip, say, on the line that its table turns about.
constexpr double kStandsMm = 1e-10;

Point linear(const AxisPositions& q) {
  return linear_axes(q);
}

/// rad; exactly 0 between equals.
double angle_between(const Eigen::Quaterniond& a, const Eigen::Quaterniond& b) {
  return a.coeffs() == b.coeffs() ? 0.0 : a.angularDistance(b);
}

}  // namespace

TrueWay::TrueWay(const TruePosition& start, const ServoMotion& motion, double until_s,
                 const WayTolerance& tolerance)
    : start_(start), motion_(motion), until_s_(until_s), tolerance_(tolerance), marks_(marks()) {
  G31_EXPECTS(until_s > 0.0 && tolerance.error_mm > 0.0 && tolerance.reach_mm >= 0.0);
  TruePosition truth = start;
  Piece piece{0.0, 0.0, tip_at(truth, 0.0), {}};
  points_.push_back({0.0, piece.from.q, piece.from.tilt, piece.from.lean_rad});
  for (const double mark_s : marks_) {
    piece.to_s = mark_s;
    piece.to = tip_at(truth, mark_s);
    add(truth, piece, kMostHalvings);
    truth.go_to(motion_.encoder_at(mark_s));
    piece.from_s = mark_s;
    piece.from = piece.to;
  }
}

ToolPlace TrueWay::tip_at(const TruePosition& truth, double time_s) const {
  return truth.place_after(motion_.encoder_at(time_s));
}

std::vector<double> TrueWay::marks() const {
  std::vector<double> marks = motion_.steps_until(until_s_);
  for (const MotionPhases& drive : motion_.drives()) {
    const double piece_mm =
        std::min(kFirstPieceMm, std::max(start_.smooth_way(), drive.length() / kMostCyclicPieces));
    for (double distance = std::min(kFinestPieceMm, piece_mm); distance < drive.length();
         distance += std::min(distance, piece_mm)) {
      motion_.look();
      marks.push_back(std::min(until_s_, drive.time_at(distance)));
    }
  }
  std::ranges::sort(marks);
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  std::erase(marks, 0.0);
  return marks;
}

bool TrueWay::is_straight(const TruePosition& truth, const Piece& piece) const {
  const double most = 0.5 * tolerance_.error_mm;
  const Point chord = linear(piece.to.q) - linear(piece.from.q);
  const double length = chord.norm();
  const Point along = length > 0.0 ? Point(chord / length) : Point::Zero();
  const double turned_rad = angle_between(piece.from.tilt, piece.to.tilt);
  if (tolerance_.reach_mm * turned_rad * turned_rad / 8.0 > most) {
    return false;
  }
  for (const double part : {0.25, 0.5, 0.75}) {
    const double time_s = piece.from_s + part * (piece.to_s - piece.from_s);
    const ToolPlace place = tip_at(truth, time_s);
    const Point off = linear(place.q) - linear(piece.from.q);
    const double gone = off.dot(along);
    if ((off - gone * along).norm() > most || gone < -most || gone > length + most) {
      return false;
    }
    // Tip, tilt and lean must come along at the same rate.
    const double share = length > most ? std::clamp(gone / length, 0.0, 1.0) : part;
    const Point lean_rad = piece.from.lean_rad + share * (piece.to.lean_rad - piece.from.lean_rad);
    const double tilted_rad =
        turned_rad > 0.0 ? angle_between(piece.from.tilt.slerp(share, piece.to.tilt), place.tilt)
                         : 0.0;
    if (tolerance_.reach_mm * (tilted_rad + (place.lean_rad - lean_rad).norm()) > most) {
      return false;
    }
  }
  return true;
}

void TrueWay::add(const TruePosition& truth, const Piece& piece, int halvings) {
  motion_.look();
  if (halvings == 0 || is_straight(truth, piece)) {
    points_.push_back({piece.to_s / until_s_, piece.to.q, piece.to.tilt, piece.to.lean_rad});
    return;
  }
  const double middle_s = 0.5 * (piece.from_s + piece.to_s);
  const ToolPlace middle = tip_at(truth, middle_s);
  add(truth, {piece.from_s, middle_s, piece.from, middle}, halvings - 1);
  add(truth, {middle_s, piece.to_s, middle, piece.to}, halvings - 1);
}

TruePosition TrueWay::truth_at(double time_s) const {
  TruePosition truth = start_;
  if (!truth.has_play()) {
    return truth;
  }
  for (const double mark_s : marks_) {
    if (mark_s > time_s) {
      break;
    }
    truth.go_to(motion_.encoder_at(mark_s));
  }
  return truth;
}

AxisPositions TrueWay::axes_at(double fraction) const {
  const double at_s = time_s(fraction);
  return truth_at(at_s).after(motion_.encoder_at(at_s));
}

double TrueWay::time_s(double fraction) const {
  G31_EXPECTS(fraction >= 0.0 && fraction <= 1.0);
  const auto after = std::ranges::upper_bound(points_, fraction, {}, &Waypoint::fraction);
  if (after == points_.end()) {
    return until_s_;
  }
  const Waypoint& from = *(after - 1);
  const Waypoint& to = *after;
  const TruePosition truth = truth_at(from.fraction * until_s_);
  const Point chord = linear(to.q_M) - linear(from.q_M);
  const double part = (fraction - from.fraction) / (to.fraction - from.fraction);
  const double wanted = part * chord.squaredNorm();
  double low = from.fraction * until_s_;
  double high = to.fraction * until_s_;
  if (wanted == 0.0 || chord.norm() < kStandsMm) {
    return low + part * (high - low);  // at the start, or the tip stays where it is
  }
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    const Point off = linear(tip_at(truth, middle).q) - linear(from.q_M);
    (off.dot(chord) < wanted ? low : high) = middle;
  }
  return high;
}

}  // namespace g31::machine

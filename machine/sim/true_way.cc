#include "machine/sim/true_way.h"

#include <algorithm>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::machine {
namespace {

/// Between the places of an error table nothing is finer than this without showing at a quarter.
constexpr double kFirstPieceMm = 5.0;
/// After a reversal an axis sticks and comes free again within hundredths of a millimetre.
constexpr double kFinestPieceMm = 0.01;
constexpr int kMostHalvings = 24;

Point linear(const AxisPositions& q) {
  return linear_axes(q);
}

}  // namespace

TrueWay::TrueWay(const TruePosition& start, const AxisChain& chain, const ServoMotion& motion,
                 double until_s, double tolerance_mm)
    : start_(start),
      chain_(chain),
      motion_(motion),
      until_s_(until_s),
      tolerance_mm_(tolerance_mm),
      marks_(marks()) {
  G31_EXPECTS(until_s > 0.0 && tolerance_mm > 0.0);
  TruePosition truth = start;
  Piece piece{0.0, 0.0, tip_at(truth, 0.0), {}};
  points_.push_back({0.0, piece.q_from});
  for (const double mark_s : marks_) {
    piece.to_s = mark_s;
    piece.q_to = tip_at(truth, mark_s);
    add(truth, piece, kMostHalvings);
    truth.go_to(motion_.encoder_at(mark_s));
    piece.from_s = mark_s;
    piece.q_from = piece.q_to;
  }
}

AxisPositions TrueWay::tip_at(const TruePosition& truth, double time_s) const {
  return chain_.for_part(truth.after(motion_.encoder_at(time_s)));
}

std::vector<double> TrueWay::marks() const {
  std::vector<double> marks = motion_.steps_until(until_s_);
  for (double distance = kFinestPieceMm; distance < motion_.phases().length();
       distance += std::min(distance, kFirstPieceMm)) {
    marks.push_back(std::min(until_s_, motion_.phases().time_at(distance)));
  }
  std::ranges::sort(marks);
  marks.erase(std::unique(marks.begin(), marks.end()), marks.end());
  std::erase(marks, 0.0);
  return marks;
}

bool TrueWay::is_straight(const TruePosition& truth, const Piece& piece) const {
  const Point chord = linear(piece.q_to) - linear(piece.q_from);
  const double length = chord.norm();
  const Point along = length > 0.0 ? Point(chord / length) : Point::Zero();
  for (const double part : {0.25, 0.5, 0.75}) {
    const double time_s = piece.from_s + part * (piece.to_s - piece.from_s);
    const Point off = linear(tip_at(truth, time_s)) - linear(piece.q_from);
    const double gone = off.dot(along);
    if ((off - gone * along).norm() > 0.5 * tolerance_mm_ || gone < -0.5 * tolerance_mm_ ||
        gone > length + 0.5 * tolerance_mm_) {
      return false;
    }
  }
  return true;
}

void TrueWay::add(const TruePosition& truth, const Piece& piece, int halvings) {
  if (halvings == 0 || is_straight(truth, piece)) {
    points_.push_back({piece.to_s / until_s_, piece.q_to});
    return;
  }
  const double middle_s = 0.5 * (piece.from_s + piece.to_s);
  const AxisPositions q_middle = tip_at(truth, middle_s);
  add(truth, {piece.from_s, middle_s, piece.q_from, q_middle}, halvings - 1);
  add(truth, {middle_s, piece.to_s, q_middle, piece.q_to}, halvings - 1);
}

double TrueWay::time_s(double fraction) const {
  G31_EXPECTS(fraction >= 0.0 && fraction <= 1.0);
  const auto after = std::ranges::upper_bound(points_, fraction, {}, &Waypoint::fraction);
  if (after == points_.end()) {
    return until_s_;
  }
  const Waypoint& from = *(after - 1);
  const Waypoint& to = *after;
  TruePosition truth = start_;
  for (const double mark_s : marks_) {
    if (mark_s > from.fraction * until_s_) {
      break;
    }
    truth.go_to(motion_.encoder_at(mark_s));
  }
  const Point chord = linear(to.q_M) - linear(from.q_M);
  const double part = (fraction - from.fraction) / (to.fraction - from.fraction);
  const double wanted = part * chord.squaredNorm();
  double low = from.fraction * until_s_;
  double high = to.fraction * until_s_;
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    const Point off = linear(tip_at(truth, middle)) - linear(from.q_M);
    (off.dot(chord) < wanted ? low : high) = middle;
  }
  return part == 0.0 ? low : high;
}

}  // namespace g31::machine

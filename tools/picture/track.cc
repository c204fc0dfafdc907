#include "tools/picture/track.h"

#include <algorithm>
#include <array>

#include "machine/base/contract.h"

namespace g31::picture {
namespace {

/// In less than that no axis goes a way that a page shows.
constexpr double kShortest_s = 1e-7;

/// Times nearer than that are one, as places are.
constexpr double kSameTime_s = 1e-9;

/// Places nearer than that are one: they differ by rounding.
constexpr double kSamePlaceMm = 1e-9;

Point between(const TrackKnot& a, const TrackKnot& b, double time_s) {
  const double h = b.time_s - a.time_s;
  const double u = (time_s - a.time_s) / h;
  const double w = 1.0 - u;
  return w * w * (1.0 + 2.0 * u) * a.p_M + u * u * (1.0 + 2.0 * w) * b.p_M +
         h * u * w * (w * a.v_M - u * b.v_M);
}

/// The cubic through four places at equal times, by its ends.
std::array<TrackKnot, 2> through_four(double from_s, double to_s,
                                      const std::function<Point(double)>& place_at) {
  const double h = to_s - from_s;
  const Point p0 = place_at(from_s);
  const Point p1 = place_at(from_s + h / 3.0);
  const Point p2 = place_at(from_s + 2.0 * h / 3.0);
  const Point p3 = place_at(to_s);
  return {{{from_s, p0, (-5.5 * p0 + 9.0 * p1 - 4.5 * p2 + p3) / h},
           {to_s, p3, (5.5 * p3 - 9.0 * p2 + 4.5 * p1 - p0) / h}}};
}

bool is_close(const std::array<TrackKnot, 2>& ends, const std::function<Point(double)>& place_at) {
  // The outer two are where a cubic through four places is farthest from a quartic.
  constexpr double kParts[] = {0.127, 0.25, 0.5, 0.75, 0.873};
  return std::ranges::all_of(kParts, [&](double part) {
    const double time_s = ends[0].time_s + part * (ends[1].time_s - ends[0].time_s);
    return (between(ends[0], ends[1], time_s) - place_at(time_s)).norm() <= 0.5 * kTrackErrorMm;
  });
}

bool is_same(const TrackKnot& a, const TrackKnot& b) {
  return (a.p_M - b.p_M).norm() <= kSamePlaceMm;
}

bool stands(const TrackKnot& knot) {
  return knot.v_M == Point::Zero();
}

}  // namespace

Point Track::at(double time_s) const {
  G31_EXPECTS(!knots_.empty());
  const auto after = std::ranges::upper_bound(knots_, time_s, {}, &TrackKnot::time_s);
  if (after == knots_.begin() || after == knots_.end()) {
    return after == knots_.begin() ? after->p_M : knots_.back().p_M;
  }
  return between(*(after - 1), *after, time_s);
}

void Track::go(const std::vector<double>& ends_s,
               const std::function<Point(double time_s)>& place_at) {
  rest_until(ends_s.front());
  for (std::size_t i = 1; i < ends_s.size(); ++i) {
    if (ends_s[i] > ends_s[i - 1]) {
      go_between(ends_s[i - 1], ends_s[i], place_at);
    }
  }
}

void Track::go_between(double from_s, double to_s, const std::function<Point(double)>& place_at) {
  auto ends = through_four(from_s, to_s, place_at);
  if (to_s - from_s > kShortest_s && !is_close(ends, place_at)) {
    const double middle_s = 0.5 * (from_s + to_s);
    go_between(from_s, middle_s, place_at);
    go_between(middle_s, to_s, place_at);
    return;
  }
  for (TrackKnot& end : ends) {
    // What rounding makes of rest, it is none.
    if (end.v_M.norm() * (to_s - from_s) <= kSamePlaceMm) {
      end.v_M = Point::Zero();
    }
    put(end, to_s - from_s);
  }
}

void Track::stand(double time_s, const Point& p_M) {
  rest_until(time_s);
  put({time_s, p_M, Point::Zero()}, 0.0);
}

void Track::rest_until(double time_s) {
  if (!knots_.empty() && time_s - knots_.back().time_s > kSameTime_s) {
    const TrackKnot last = knots_.back();
    stand(last.time_s, last.p_M);
    put({time_s, last.p_M, Point::Zero()}, 0.0);
  }
}

void Track::put(const TrackKnot& knot, double piece_s) {
  if (knots_.empty()) {
    knots_.push_back(knot);
    return;
  }
  const TrackKnot last = knots_.back();
  const double passed_s = knot.time_s - last.time_s;
  if (passed_s > kSameTime_s) {
    const bool goes_on_standing = knots_.size() > 1 && stands(knot) && stands(last) &&
                                  stands(*(knots_.end() - 2)) && is_same(knot, last) &&
                                  is_same(*(knots_.end() - 2), last);
    if (goes_on_standing) {
      knots_.back().time_s = knot.time_s;
    } else {
      knots_.push_back(knot);
    }
    return;
  }
  // Another speed at its end bends a cubic by 4/27 of what it goes in the time.
  if (is_same(knot, last) &&
      4.0 / 27.0 * piece_s * (knot.v_M - last.v_M).norm() <= 0.25 * kTrackErrorMm) {
    return;
  }
  knots_.push_back({last.time_s, knot.p_M, knot.v_M});
}

}  // namespace g31::picture

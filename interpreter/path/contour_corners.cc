#include "interpreter/path/contour_corners.h"

#include <algorithm>
#include <cmath>
#include <utility>

#include "interpreter/path/corner.h"

namespace g31::path {
namespace {

/// A corner that is made: where it begins and ends, and its arc.
struct Cut {
  PlanePoint begin;
  PlanePoint end;
  bool is_round = false;
  ArcShape arc;  ///< of a round one
};

constexpr int kHalvings = 60;

/// The point of a way where a circle about `centre` touches it.
PlanePoint touch(const PlaneWay& way, const PlanePoint& centre) {
  if (way.arc) {
    const double radius = (way.from - way.arc->centre).norm();
    return way.arc->centre + radius * (centre - way.arc->centre).normalized();
  }
  const PlanePoint along = direction_at_start(way);
  return way.from + along * along.dot(centre - way.from);
}

/// Whether a point of a way, endless, lies between its ends, or `slack_mm` beyond one of a line.
bool lies_on(const PlaneWay& way, const PlanePoint& p, double slack_mm) {
  if (!way.arc) {
    const double at = direction_at_start(way).dot(p - way.from);
    return at >= -slack_mm && at <= (way.to - way.from).norm() + slack_mm;
  }
  const bool at_end = (p - way.from).norm() < kOnePointMm || (p - way.to).norm() < kOnePointMm;
  return at_end || sweep_rad({way.from, p, way.arc}) <= sweep_rad(way);
}

using MaybeCut = std::optional<Cut>;
using CutResult = Result<MaybeCut, CornerError>;

/// @returns which of the ways is too short for this radius; the first where none will do
CutResult rounding_of(const PlaneWay& before, const PlaneWay& behind, double radius,
                      double slack_mm) {
  const bool to_left = cross(direction_at_end(before), direction_at_start(behind)) > 0.0;
  const double offset = to_left ? radius : -radius;
  const auto centre = corner_points({before, behind, offset, offset});
  if (!centre || centre->size() != 1) {
    return CornerError::WayTooShort;
  }
  const PlanePoint begin = touch(before, centre->front());
  const PlanePoint end = touch(behind, centre->front());
  if (!lies_on(before, begin, slack_mm)) {
    return CornerError::WayTooShort;
  }
  if (!lies_on(behind, end, slack_mm)) {
    return CornerError::BehindTooShort;
  }
  const auto turn = to_left ? machine::Turn::Counterclockwise : machine::Turn::Clockwise;
  return MaybeCut(Cut{begin, end, true, ArcShape{centre->front(), turn}});
}

/// As large as the ways allow, `radius` at most.
MaybeCut largest_rounding(const PlaneWay& before, const PlaneWay& behind, double radius) {
  if (auto cut = rounding_of(before, behind, radius, 0.0)) {
    return cut.value();
  }
  MaybeCut best;
  double fits = 0.0;
  double fails = radius;
  for (int i = 0; i < kHalvings; ++i) {
    const double middle = (fits + fails) / 2.0;
    if (auto cut = rounding_of(before, behind, middle, 0.0)) {
      best = cut.value();
      fits = middle;
    } else {
      fails = middle;
    }
  }
  return best;
}

/// The point of a way whose distance from its end, or from its start, is `leg`.
/// nullopt: an arc has none.
std::optional<PlanePoint> point_off(const PlaneWay& way, bool at_end, double leg) {
  const PlanePoint corner = at_end ? way.to : way.from;
  const PlanePoint along = at_end ? PlanePoint(-direction_at_end(way)) : direction_at_start(way);
  if (!way.arc) {
    const bool is_on = leg <= (way.to - way.from).norm() + kOnePointMm;
    return is_on ? std::optional<PlanePoint>(corner + leg * along) : std::nullopt;
  }
  // The chord of length `leg` turns from the tangent by half the angle that it spans.
  const PlanePoint to_centre = way.arc->centre - corner;
  const double sine = leg / (2.0 * to_centre.norm());
  if (sine > 1.0) {
    return std::nullopt;
  }
  const PlanePoint p =
      corner + leg * (std::sqrt(1.0 - sine * sine) * along + sine * to_centre.normalized());
  return lies_on(way, p, 0.0) ? std::optional(p) : std::nullopt;
}

/// A chamfer that begins and ends `leg` from the corner, whatever the ways are.
CutResult chamfer_by_distance(const PlaneWay& before, const PlaneWay& behind, double leg) {
  const auto begin = point_off(before, true, leg);
  const auto end = point_off(behind, false, leg);
  if (!begin || !end) {
    return begin ? CornerError::BehindTooShort : CornerError::WayTooShort;
  }
  return MaybeCut(Cut{*begin, *end, false, ArcShape()});
}

/// A turn less than this needs no rounding: the axes hardly change their speed, rad.
constexpr double kLeastTurnToPass = 1e-3;

/// As the control rounds of itself.  The arc leaves the corner along its bisector.
MaybeCut passing_by(const PlaneWay& before, const PlaneWay& behind, const CornerWish& wish,
                    double longest_leg) {
  const PlanePoint in = direction_at_end(before);
  const PlanePoint out = direction_at_start(behind);
  const double half_turn = std::atan2(std::abs(cross(in, out)), in.dot(out)) / 2.0;
  if (before.arc || behind.arc || half_turn < 0.5 * kLeastTurnToPass) {
    return std::nullopt;
  }
  double leg = std::min(wish.size_mm, longest_leg);
  // The arc leaves the corner by leg tan(half_turn / 2).
  const PlanePoint away = (out - in).normalized() * std::tan(half_turn / 2.0);
  for (const Eigen::Index axis : {0, 1}) {
    if (leg * std::abs(away[axis]) > wish.tolerance_mm[axis]) {
      leg = wish.tolerance_mm[axis] / std::abs(away[axis]);
    }
  }
  const double radius = leg / std::tan(half_turn);
  if (!(leg > kOnePointMm) || !(radius > kOnePointMm)) {
    return std::nullopt;  // too little to round, or straight back
  }
  const bool to_left = cross(in, out) > 0.0;
  const PlanePoint inwards = to_left ? PlanePoint(-in.y(), in.x()) : PlanePoint(in.y(), -in.x());
  const PlanePoint begin = before.to - leg * in;
  const auto turn = to_left ? machine::Turn::Counterclockwise : machine::Turn::Clockwise;
  const PlanePoint centre = begin + radius * inwards;
  return Cut{begin, before.to + leg * out, true, ArcShape{centre, turn}};
}

Cut chamfer_of(const PlaneWay& before, const PlaneWay& behind, const CornerWish& wish) {
  const PlanePoint in = direction_at_end(before);
  const PlanePoint out = direction_at_start(behind);
  const double half_turn = std::atan2(std::abs(cross(in, out)), in.dot(out)) / 2.0;
  const double wanted = wish.kind == CornerWish::Kind::ChamferWidth
                            ? wish.size_mm
                            : wish.size_mm / (2.0 * std::cos(half_turn));
  const double leg =
      std::min({wanted, (before.to - before.from).norm(), (behind.to - behind.from).norm()});
  return {before.to - leg * in, before.to + leg * out, false, ArcShape()};
}

/// Neither straight on nor straight back.
bool is_corner(const PlaneWay& before, const PlaneWay& behind, double straight_on_rad) {
  const PlanePoint in = direction_at_end(before);
  const PlanePoint out = direction_at_start(behind);
  return std::abs(cross(in, out)) > std::sin(straight_on_rad);
}

/// @param rotary_go_along  those do not count
bool is_flat(const AxisPositions& q_from, const AxisPositions& q_to, OffsetPlane plane,
             bool rotary_go_along) {
  const AxisPositions out = plane.moved(q_from, plane.of(q_to)) - q_to;
  return (rotary_go_along ? linear_axes(out).norm() : out.norm()) < kOnePointMm;
}

/// The position at a point of a way, other axes being there in proportion.
AxisPositions place_on(const PlaneWay& way, const std::pair<AxisPositions, AxisPositions>& ends,
                       OffsetPlane plane, const PlanePoint& p) {
  const double share = (p - way.from).norm() < kOnePointMm ? 0.0
                       : way.arc ? sweep_rad({way.from, p, way.arc}) / sweep_rad(way)
                                 : (p - way.from).norm() / (way.to - way.from).norm();
  return plane.moved(ends.first + share * (ends.second - ends.first), p);
}

/// What a block becomes at its corner: shortened to one place, and the corner itself to another.
PathItems cut_blocks(const PathBlock& block, const PlanePoint& from,
                     const std::pair<AxisPositions, AxisPositions>& q_M_cut, const Cut& cut,
                     double feed_mm_min) {
  PathItems items;
  PathBlock corner = block;
  corner.q_M_end = q_M_cut.second;
  corner.arc.reset();
  corner.g = 1;
  if (cut.is_round) {
    corner.arc = cut.arc;
    corner.g = cut.arc.turn == machine::Turn::Clockwise ? 2 : 3;
  }
  corner.feed_mm_min = feed_mm_min > 0.0 ? feed_mm_min : block.feed_mm_min;
  if ((cut.begin - from).norm() > kOnePointMm) {
    PathBlock shortened = block;
    shortened.q_M_end = q_M_cut.first;
    items.emplace_back(shortened);
  }
  items.emplace_back(corner);
  return items;
}

PlaneWay way_of(const PathBlock& block, const AxisPositions& q_M_from, OffsetPlane plane) {
  return {plane.of(q_M_from), plane.of(block.q_M_end), block.arc};
}

/// @param flat  nothing but the axes of the plane moves along either way
CutResult cut_between(const PlaneWay& before, const PlaneWay& behind, const CornerWish& wish,
                      bool flat, const CornerRules& rules) {
  if (!is_corner(before, behind, rules.straight_on_rad)) {
    return MaybeCut();
  }
  if (!flat) {
    return CornerError::NotFlat;
  }
  const bool shrinks = rules.too_large == CornerRules::TooLarge::Shrinks;
  if (wish.kind == CornerWish::Kind::Rounding) {
    return shrinks ? CutResult(largest_rounding(before, behind, wish.size_mm))
                   : rounding_of(before, behind, wish.size_mm, kOnePointMm);
  }
  if (rules.chamfer_at_arc == CornerRules::ChamferAtArc::ByDistance) {
    return chamfer_by_distance(before, behind, wish.size_mm);
  }
  if (before.arc || behind.arc) {
    return CornerError::ChamferAtArc;
  }
  return MaybeCut(chamfer_of(before, behind, wish));
}

}  // namespace

PathItems ContourCorners::flush() {
  PathItems items;
  if (held_) {
    items.emplace_back(held_->block);
    held_.reset();
  }
  return items;
}

Result<ContourCorners::Given, CornerFault> ContourCorners::take(const PathBlock& block,
                                                                const AxisPositions& q_M_from,
                                                                OffsetPlane plane,
                                                                const CornerWish& wish) {
  Given given;
  const bool passes_by = held_ && held_->wish.kind == CornerWish::Kind::PassBy;
  const bool has_way = (plane.of(block.q_M_end) - plane.of(q_M_from)).norm() > 0.0;
  const bool moves = has_way && (block.g != 0 || passes_by);
  if (passes_by && (held_->block.g == 0) != (block.g == 0)) {
    held_->wish.size_mm = held_->wish.mixed_size_mm;
  }
  AxisPositions q_M_begin = q_M_from;
  if (held_ && moves && plane == held_->plane) {
    const PlaneWay before = way_of(held_->block, held_->q_M_from, plane);
    const bool flat =
        is_flat(held_->q_M_from, held_->block.q_M_end, plane, rules_.rotary_go_along) &&
        is_flat(q_M_from, block.q_M_end, plane, rules_.rotary_go_along);
    const PlaneWay behind = way_of(block, q_M_from, plane);
    const double longest_leg = 0.5 * std::min(held_->length_mm, (behind.to - behind.from).norm());
    const auto cut =
        held_->wish.kind == CornerWish::Kind::PassBy
            ? CutResult(flat ? passing_by(before, behind, held_->wish, longest_leg) : MaybeCut())
            : cut_between(before, behind, held_->wish, flat, rules_);
    if (!cut) {
      return CornerFault{cut.error(), held_->block.where, held_->block.calls};
    }
    if (cut.value()) {
      const AxisPositions q_M_cut =
          place_on(before, {held_->q_M_from, held_->block.q_M_end}, plane, cut.value()->begin);
      q_M_begin = place_on(behind, {q_M_from, block.q_M_end}, plane, cut.value()->end);
      given.before = cut_blocks(held_->block, before.from, {q_M_cut, q_M_begin}, *cut.value(),
                                held_->wish.feed_mm_min);
      held_.reset();
    }
  }
  for (PathItem& item : flush()) {
    given.before.push_back(std::move(item));
  }
  const bool is_cut_away =
      q_M_begin != q_M_from && (q_M_begin - block.q_M_end).norm() < kOnePointMm;
  const bool waits = wish.kind == CornerWish::Kind::PassBy ||
                     (wish.kind != CornerWish::Kind::Sharp && block.g != 0);
  if (waits && has_way && !is_cut_away) {
    const double length_mm = (plane.of(block.q_M_end) - plane.of(q_M_from)).norm();
    held_ = Held{block, q_M_begin, plane, wish, length_mm};
  } else if (!is_cut_away) {
    given.now.emplace_back(block);
  }
  return given;
}

}  // namespace g31::path

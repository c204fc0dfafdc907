#include "parts/features/faceted_walls.h"

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <deque>
#include <numbers>
#include <numeric>
#include <optional>
#include <utility>
#include <vector>

#include <Eigen/LU>

#include "parts/features/recognise.h"

namespace g31::parts {
namespace {

using Place = Eigen::Vector2d;

constexpr double kWidestFacet = 30.5 * std::numbers::pi / 180.0;
constexpr std::size_t kLeastFacets = 3;

/// An upright plane wall from above: a line, the removed volume at its left.
struct Facet {
  std::size_t face = 0;
  Place from;
  Place to;

  [[nodiscard]] Place along() const { return (to - from).normalized(); }
};

struct Circle {
  Place centre = Place::Zero();
  double radius = 0.0;

  [[nodiscard]] double off(const Place& p) const { return std::abs((p - centre).norm() - radius); }
  /// The angle that a chord spans, rad.
  [[nodiscard]] double angle_of(const Facet& facet) const {
    return 2.0 * std::asin(std::min(1.0, (facet.to - facet.from).norm() / (2.0 * radius)));
  }
};

Circle rounded(const Circle& circle) {
  constexpr double kPerMm = 1e4;
  const auto on_grid = [](double mm) { return std::round(mm * kPerMm) / kPerMm + 0.0; };
  return {{on_grid(circle.centre.x()), on_grid(circle.centre.y())}, on_grid(circle.radius)};
}

/// The circle of least squares (Kasa) through places, where all of them are on it.
std::optional<Circle> circle_through(const std::vector<Place>& places) {
  Place middle = Place::Zero();
  for (const Place& p : places) {
    middle += p / static_cast<double>(places.size());
  }
  Eigen::Matrix3d normal = Eigen::Matrix3d::Zero();
  Eigen::Vector3d right = Eigen::Vector3d::Zero();
  for (const Place& place : places) {
    const Place p = place - middle;
    const Eigen::Vector3d row(2.0 * p.x(), 2.0 * p.y(), 1.0);
    normal += row * row.transpose();
    right += row * p.squaredNorm();
  }
  const Eigen::Vector3d found = normal.inverse() * right;
  const Circle circle =
      rounded({middle + found.head<2>(), std::sqrt(found[2] + found.head<2>().squaredNorm())});
  const auto is_on = [&](const Place& p) { return circle.off(p) < kSameCircleMm; };
  const bool is_one = circle.radius > 0.0 && std::ranges::all_of(places, is_on);
  return is_one ? std::optional(circle) : std::nullopt;
}

class WallFinder {
 public:
  explicit WallFinder(RemovedVolume& volume) : volume_(volume) {
    for (std::size_t i = 0; i < volume.faces.size(); ++i) {
      add(i);
    }
    next_.assign(facets_.size(), kNone);
    previous_ = next_;
    for (std::size_t i = 0; i < facets_.size(); ++i) {
      join(i);
    }
  }

  void find() {
    std::vector<bool> is_taken(facets_.size(), false);
    std::vector<RemovedFace> walls;
    std::vector<bool> goes(volume_.faces.size(), false);
    std::vector<std::size_t> seeds(facets_.size());
    std::iota(seeds.begin(), seeds.end(), 0U);
    std::ranges::stable_sort(seeds, {}, [this](std::size_t facet) { return length(facet); });
    for (const std::size_t seed : seeds) {
      Circle circle;
      const std::deque<std::size_t> run =
          is_taken[seed] ? std::deque<std::size_t>() : run_around(seed, is_taken, circle);
      if (!is_round(run, circle)) {
        continue;
      }
      walls.push_back(wall_of(run, circle));
      for (const std::size_t facet : run) {
        is_taken[facet] = true;
        goes[facets_[facet].face] = true;
      }
    }
    for (std::size_t i = 0; i < volume_.faces.size(); ++i) {
      if (!goes[i]) {
        walls.push_back(std::move(volume_.faces[i]));
      }
    }
    volume_.faces = std::move(walls);
  }

 private:
  static constexpr auto kNone = static_cast<std::size_t>(-1);

  void add(std::size_t index) {
    const RemovedFace& face = volume_.faces[index];
    if (face.is_open || face.surface != FaceSurface::Plane || face.border_P.empty() ||
        std::abs(face.normal_P.z()) > kSameDirection) {
      return;
    }
    const Place along(-face.normal_P.y(), face.normal_P.x());
    const auto how_far = [&](const Point& p) { return along.dot(p.head<2>()); };
    const auto [first, last] = std::ranges::minmax_element(face.border_P, {}, how_far);
    facets_.push_back({index, first->head<2>(), last->head<2>()});
  }

  /// Notes the facet that goes on where another one ends.
  void join(std::size_t facet) {
    for (std::size_t other = 0; other < facets_.size(); ++other) {
      if (other != facet && (facets_[other].from - facets_[facet].to).norm() < kSameCircleMm &&
          turn(facet, other) != 0.0) {
        next_[facet] = other;
        previous_[other] = facet;
      }
    }
  }

  /// By how much the second facet turns from the first, left is plus; 0: too much or not at all.
  [[nodiscard]] double turn(std::size_t first, std::size_t second) const {
    const Place a = facets_[first].along();
    const Place b = facets_[second].along();
    const double angle = std::atan2(a.x() * b.y() - a.y() * b.x(), a.dot(b));
    constexpr double kLeast = 1e-4;
    return std::abs(angle) < kWidestFacet && std::abs(angle) > kLeast ? angle : 0.0;
  }

  /// The facets side by side with one that are of one circle.  Short ones come first: a straight
  /// wall goes on in an arc, and is beside a piece of it what a circle may look like.
  std::deque<std::size_t> run_around(std::size_t facet, const std::vector<bool>& is_taken,
                                     Circle& circle) const {
    std::deque<std::size_t> run = {facet};
    const auto is_free = [&](std::size_t more) {
      return more != kNone && !is_taken[more] && std::ranges::find(run, more) == run.end();
    };
    bool goes_on = true;
    bool goes_back = true;
    for (;;) {
      const std::size_t after = next_[run.back()];
      const std::size_t before = previous_[run.front()];
      goes_on = goes_on && is_free(after);
      goes_back = goes_back && is_free(before);
      if (!goes_on && !goes_back) {
        return run;
      }
      const bool is_forward = goes_on && (!goes_back || length(after) <= length(before));
      std::deque<std::size_t> longer = run;
      longer.insert(is_forward ? longer.end() : longer.begin(), is_forward ? after : before);
      if (const auto found = circle_of(longer)) {
        circle = *found;
        run = std::move(longer);
      } else {
        (is_forward ? goes_on : goes_back) = false;
      }
    }
  }

  [[nodiscard]] double length(std::size_t facet) const {
    return (facets_[facet].to - facets_[facet].from).norm();
  }

  /// The circle of facets side by side; without a radius where they turn too little to tell.
  [[nodiscard]] std::optional<Circle> circle_of(const std::deque<std::size_t>& run) const {
    constexpr double kLeastTurn = 0.05;
    std::vector<Place> places = {facets_[run.front()].from};
    const double way = turn(run[0], run[1]);
    double turned = 0.0;
    for (std::size_t i = 0; i < run.size(); ++i) {
      places.push_back(facets_[run[i]].to);
      const double next = i > 0 ? turn(run[i - 1], run[i]) : way;
      if (next * way <= 0.0) {
        return std::nullopt;
      }
      turned += i > 0 ? std::abs(next) : 0.0;
    }
    return turned < kLeastTurn ? Circle() : circle_through(places);
  }

  [[nodiscard]] bool is_round(const std::deque<std::size_t>& run, const Circle& circle) const {
    const auto is_narrow = [&](std::size_t facet) {
      return circle.angle_of(facets_[facet]) < kWidestFacet;
    };
    return run.size() >= kLeastFacets && circle.radius > 0.0 && std::ranges::all_of(run, is_narrow);
  }

  [[nodiscard]] RemovedFace wall_of(const std::deque<std::size_t>& run,
                                    const Circle& circle) const {
    RemovedFace wall = volume_.faces[facets_[run[run.size() / 2]].face];
    wall.surface = FaceSurface::Cylinder;
    wall.radius_mm = circle.radius;
    wall.axis_at_P << circle.centre, wall.at_P.z();
    const Place out = (wall.at_P.head<2>() - circle.centre).normalized();
    const double sign = out.dot(wall.normal_P.head<2>()) > 0.0 ? 1.0 : -1.0;
    wall.at_P.head<2>() = circle.centre + circle.radius * out;
    wall.normal_P << sign * out, 0.0;
    wall.area_mm2 = 0.0;
    wall.border_P.clear();
    double spanned = 0.0;
    for (const std::size_t facet : run) {
      const RemovedFace& face = volume_.faces[facets_[facet].face];
      const double angle = circle.angle_of(facets_[facet]);
      spanned += angle;
      wall.area_mm2 += face.area_mm2 * (angle / 2) / std::sin(angle / 2);
      wall.facet_error_mm =
          std::max(wall.facet_error_mm, circle.radius * (1.0 - std::cos(angle / 2)));
      wall.border_P.insert(wall.border_P.end(), face.border_P.begin(), face.border_P.end());
    }
    add_arcs(facets_[run.front()].from - circle.centre, sign * spanned, wall);
    return wall;
  }

  /// Points of the arc at both heights, as curved edges have them.
  static void add_arcs(const Place& first, double spanned, RemovedFace& wall) {
    constexpr int kPieces = 16;  // even: the middle is among the points
    const auto [low, high] =
        std::ranges::minmax(wall.border_P, {}, [](const Point& p) { return p.z(); });
    const Point lowest = low;
    const Point highest = high;
    const double begin = std::atan2(first.y(), first.x());
    for (int i = 0; i <= kPieces; ++i) {
      const double angle = begin + spanned * i / kPieces;
      const Point out(std::cos(angle), std::sin(angle), 0.0);
      for (const double z : {lowest.z(), highest.z()}) {
        Point p = wall.axis_at_P + wall.radius_mm * out;
        p.z() = z;
        wall.border_P.push_back(p);
      }
    }
  }

  RemovedVolume& volume_;
  std::vector<Facet> facets_;
  std::vector<std::size_t> next_;
  std::vector<std::size_t> previous_;
};

}  // namespace

void find_round_walls(RemovedVolume& volume) {
  WallFinder(volume).find();
}

}  // namespace g31::parts

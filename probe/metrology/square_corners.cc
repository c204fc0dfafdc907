#include "probe/metrology/square_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <span>
#include <utility>
#include <vector>

namespace g31::metrology {
namespace {

/// So near the diagonal a path that ends there is taken to be on it, in half sides.
constexpr double kOnDiagonal = 0.002;

constexpr std::array<std::array<double, 2>, 4> kCorners = {
    {{1.0, 1.0}, {-1.0, 1.0}, {-1.0, -1.0}, {1.0, -1.0}}};

double cross(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return a.x() * b.y() - a.y() * b.x();
}

double turning(const Eigen::Vector2d& a, const Eigen::Vector2d& b) {
  return std::abs(std::atan2(cross(a, b), a.dot(b)));
}

/// From the centre of a square, the corner looked at in the first quadrant.
using Path = std::vector<Eigen::Vector2d>;

Path path_at(const PlaneSamples& samples, const Square& square, std::size_t corner) {
  const Eigen::Vector2d sign(kCorners.at(corner)[0], kCorners.at(corner)[1]);
  Path path;
  path.reserve(samples.size());
  for (std::size_t i = 0; i < samples.size(); ++i) {
    path.emplace_back((samples.at(i) - square.centre).cwiseProduct(sign));
  }
  return path;
}

double length_of(std::span<const Eigen::Vector2d> way) {
  double length = 0.0;
  for (std::size_t i = 1; i < way.size(); ++i) {
    length += (way[i] - way[i - 1]).norm();
  }
  return length;
}

/// A record that begins and ends about a corner, from its range once round to its range, some
/// samples further at both ends: what it says of the corner does not depend on where it begins.
/// nullopt: its ends do not meet there, or ways to the square and away from it lie between them.
/// @param whole  of the record
std::optional<Path> closed_about_corner(const Path& whole, const SampleRange& range,
                                        double half_side) {
  constexpr std::size_t kFurther = 8;
  constexpr double kGap = 0.006;   // in half sides: where a range ends is known no better
  constexpr double kDetour = 1.5;  // a quarter of a circle is 1.11 times its chord
  const double gap = kGap * half_side;
  const std::size_t fewest = range.begin + 2 * kFurther;
  const Eigen::Vector2d first = whole.front();
  if (whole.size() < fewest || first.minCoeff() < 0.5 * half_side) {
    return std::nullopt;
  }
  Path path = whole;
  const auto to_first = [&] { return Eigen::Vector2d(first - path.back()); };
  // A sample at the place of the first one or beyond it has been there already.
  while (path.size() > fewest && to_first().norm() <= gap &&
         to_first().dot(path.back() - path[path.size() - 2]) <= 0.0) {
    path.pop_back();
  }
  if (to_first().norm() > gap) {
    return std::nullopt;
  }
  const std::size_t end = std::min(range.end, path.size()) - range.begin;
  std::ranges::rotate(path, path.begin() + static_cast<std::ptrdiff_t>(range.begin));
  const double way =
      length_of(std::span(path).subspan(end - 1)) + (path.front() - path.back()).norm();
  if (way > kDetour * (path.front() - path[end - 1]).norm() + gap) {
    return std::nullopt;
  }
  const Path before(path.end() - kFurther, path.end());
  const Path behind(path.begin(), path.begin() + kFurther);
  path.insert(path.end(), behind.begin(), behind.end());
  path.insert(path.begin(), before.begin(), before.end());
  return path;
}

/// The path at one corner, seen along its diagonal.
class CornerView {
 public:
  CornerView(Path path, const Square& square, double resolution)
      : path_(std::move(path)), square_(square), resolution_(resolution) {}

  [[nodiscard]] std::optional<CornerCrossing> furthest() const {
    std::optional<CornerCrossing> largest;
    std::optional<std::size_t> nearest;
    for (std::size_t i = 0; i < path_.size(); ++i) {
      const Eigen::Vector2d& q = path_[i];
      if (q.minCoeff() < 0.5 * square_.half_side) {
        continue;
      }
      if (std::abs(side_of(q)) <= kOnDiagonal * square_.half_side &&
          (!nearest || distance(q) < distance(path_[*nearest]))) {
        nearest = i;
      }
      if (i + 1 < path_.size() && crosses(q, path_[i + 1])) {
        const CornerCrossing here = crossing(i);
        largest = !largest || std::abs(here.error) > std::abs(largest->error) ? here : *largest;
      }
    }
    if (!largest && nearest) {
      largest = {square_.ray_error(square_.centre + path_[*nearest]), 0.0};
    }
    return largest;
  }

 private:
  [[nodiscard]] Eigen::Vector2d step(std::size_t i) const { return path_[i + 1] - path_[i]; }
  static double side_of(const Eigen::Vector2d& q) { return q.x() - q.y(); }
  [[nodiscard]] double distance(const Eigen::Vector2d& q) const {
    return (q - Eigen::Vector2d::Constant(square_.half_side)).norm();
  }

  /// Across the diagonal rather than along it.
  static bool crosses(const Eigen::Vector2d& q, const Eigen::Vector2d& next) {
    const Eigen::Vector2d way = next - q;
    const bool changes_side = (side_of(q) < 0.0) != (side_of(next) < 0.0);
    return changes_side && std::abs(side_of(way)) >= 0.5 * std::abs(way.sum());
  }

  /// How far beyond the corner the line through two points meets the diagonal.
  [[nodiscard]] double beyond(const Eigen::Vector2d& p, const Eigen::Vector2d& q) const {
    const double share = side_of(p) / (side_of(p) - side_of(q));
    const Eigen::Vector2d meets = p + share * (q - p);
    return std::numbers::sqrt2 * (0.5 * meets.sum() - square_.half_side);
  }

  /// Where the ways before and behind samples i and i + 1 meet, prolonged between them.
  [[nodiscard]] std::optional<Eigen::Vector2d> prolonged(std::size_t i) const {
    const Eigen::Vector2d before = step(i - 1);
    const Eigen::Vector2d behind = step(i + 1);
    const bool leads_there =
        side_of(before) * side_of(path_[i]) < 0.0 && side_of(behind) * side_of(path_[i + 1]) > 0.0;
    const double between = cross(before, behind);
    if (!leads_there || between == 0.0) {
      return std::nullopt;
    }
    const double ahead = cross(step(i), behind) / between;
    const double back = cross(before, step(i)) / between;
    if (ahead < 0.0 || back < 0.0) {
      return std::nullopt;
    }
    return Eigen::Vector2d(path_[i] + ahead * before);
  }

  /// How far a sample lies beside the straight way through the two beyond it, mm.
  /// @param towards  the sample's step from them; @param beyond  the step between those two
  static double bend(const Eigen::Vector2d& towards, const Eigen::Vector2d& beyond) {
    const double length = beyond.norm();
    return length > 0.0 ? std::abs(cross(beyond, towards)) / length : towards.norm();
  }

  /// Whether the last sample before the turn and the first one behind it still lie on straight
  /// ways, by what the samples next to them scatter and the digits they are written with: one that
  /// does not is already on a rounding.
  [[nodiscard]] bool comes_and_goes_straight(std::size_t i) const {
    constexpr double kBesideScatter = 3.0;
    constexpr double kDigits = 2.0;      // of each of the samples that a bend is made of
    constexpr double kRounding = 1e-15;  // of the numbers themselves, to their size
    double scatter = 0.0;
    for (const std::size_t further : {1U, 2U}) {
      if (i >= 2 + further) {
        scatter = std::max(scatter, bend(step(i - 1 - further), step(i - 2 - further)));
      }
      if (i + 3 + further < path_.size()) {
        scatter = std::max(scatter, bend(step(i + 1 + further), step(i + 2 + further)));
      }
    }
    const double written = std::max(
        resolution_, kRounding * (square_.centre.norm() + path_[i].norm() + square_.half_side));
    const auto is_straight = [&](const Eigen::Vector2d& towards, const Eigen::Vector2d& beyond) {
      const double length = beyond.norm();
      const double lever = length > 0.0 ? 1.0 + towards.norm() / length : 1.0;
      return bend(towards, beyond) <= kDigits * lever * written + kBesideScatter * scatter;
    };
    return is_straight(step(i - 1), step(i - 2)) && is_straight(step(i + 1), step(i + 2));
  }

  /// The path turns at once between samples i and i + 1, as far as those about them tell.
  [[nodiscard]] bool is_sharp(std::size_t i) const {
    const double around = turning(step(i - 2), step(i - 1)) + turning(step(i + 1), step(i + 2));
    return turning(step(i - 1), step(i + 1)) > 0.2 + 3.0 * around && comes_and_goes_straight(i);
  }

  /// The diagonal lies between samples i and i + 1.
  [[nodiscard]] CornerCrossing crossing(std::size_t i) const {
    const double chord = beyond(path_[i], path_[i + 1]);
    if (i < 2 || i + 3 >= path_.size()) {
      return {chord, 0.0};
    }
    const auto tip = prolonged(i);
    if (!tip) {
      return {chord, 0.0};
    }
    // The tip need not lie on the diagonal: the path crosses that on its way there or from there.
    const bool is_beyond = (side_of(path_[i]) < 0.0) != (side_of(*tip) < 0.0);
    const double sharp = is_beyond ? beyond(path_[i], *tip) : beyond(*tip, path_[i + 1]);
    return is_sharp(i) ? CornerCrossing{sharp, chord - sharp}
                       : CornerCrossing{chord, sharp - chord};
  }

  Path path_;
  const Square& square_;
  double resolution_;
};

}  // namespace

std::optional<CornerCrossing> corner_crossing(const CornerRecord& record, const Square& square,
                                              std::size_t corner) {
  Path path = path_at(record.samples, square, corner);
  if (auto closed = closed_about_corner(path, record.range, square.half_side)) {
    path = *std::move(closed);
  } else {
    path.resize(record.range.end);
    path.erase(path.begin(), path.begin() + static_cast<std::ptrdiff_t>(record.range.begin));
  }
  return CornerView(std::move(path), square, record.resolution).furthest();
}

}  // namespace g31::metrology

#include "probe/metrology/square_corners.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

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

/// The path at one corner, seen along its diagonal.
class CornerView {
 public:
  CornerView(const CornerRecord& record, const Square& square, std::size_t corner)
      : samples_(record.samples),
        range_(record.range),
        resolution_(record.resolution),
        square_(square),
        sign_(kCorners.at(corner)[0], kCorners.at(corner)[1]) {}

  [[nodiscard]] std::optional<CornerCrossing> furthest() const {
    std::optional<CornerCrossing> largest;
    std::optional<std::size_t> nearest;
    for (std::size_t i = range_.begin; i < range_.end; ++i) {
      const Eigen::Vector2d q = at(i);
      if (q.minCoeff() < 0.5 * square_.half_side) {
        continue;
      }
      if (std::abs(side_of(q)) <= kOnDiagonal * square_.half_side &&
          (!nearest || distance(q) < distance(at(*nearest)))) {
        nearest = i;
      }
      if (i + 1 < range_.end && crosses(q, at(i + 1))) {
        const CornerCrossing here = crossing(i);
        largest = !largest || std::abs(here.error) > std::abs(largest->error) ? here : *largest;
      }
    }
    if (!largest && nearest) {
      largest = {square_.ray_error(samples_.at(*nearest)), 0.0};
    }
    return largest;
  }

 private:
  [[nodiscard]] Eigen::Vector2d at(std::size_t i) const {
    return (samples_.at(i) - square_.centre).cwiseProduct(sign_);
  }
  [[nodiscard]] Eigen::Vector2d step(std::size_t i) const { return at(i + 1) - at(i); }
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
        side_of(before) * side_of(at(i)) < 0.0 && side_of(behind) * side_of(at(i + 1)) > 0.0;
    const double between = cross(before, behind);
    if (!leads_there || between == 0.0) {
      return std::nullopt;
    }
    const double ahead = cross(step(i), behind) / between;
    const double back = cross(before, step(i)) / between;
    if (ahead < 0.0 || back < 0.0) {
      return std::nullopt;
    }
    return Eigen::Vector2d(at(i) + ahead * before);
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
      if (i >= range_.begin + 2 + further) {
        scatter = std::max(scatter, bend(step(i - 1 - further), step(i - 2 - further)));
      }
      if (i + 3 + further < range_.end) {
        scatter = std::max(scatter, bend(step(i + 1 + further), step(i + 2 + further)));
      }
    }
    const double written =
        std::max(resolution_, kRounding * (samples_.at(i).norm() + square_.half_side));
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
    const double chord = beyond(at(i), at(i + 1));
    if (i < range_.begin + 2 || i + 3 >= range_.end) {
      return {chord, 0.0};
    }
    const auto tip = prolonged(i);
    if (!tip) {
      return {chord, 0.0};
    }
    // The tip need not lie on the diagonal: the path crosses that on its way there or from there.
    const bool is_beyond = (side_of(at(i)) < 0.0) != (side_of(*tip) < 0.0);
    const double sharp = is_beyond ? beyond(at(i), *tip) : beyond(*tip, at(i + 1));
    return is_sharp(i) ? CornerCrossing{sharp, chord - sharp}
                       : CornerCrossing{chord, sharp - chord};
  }

  PlaneSamples samples_;
  SampleRange range_;
  double resolution_;
  const Square& square_;
  Eigen::Vector2d sign_;
};

}  // namespace

std::optional<CornerCrossing> corner_crossing(const CornerRecord& record, const Square& square,
                                              std::size_t corner) {
  return CornerView(record, square, corner).furthest();
}

}  // namespace g31::metrology

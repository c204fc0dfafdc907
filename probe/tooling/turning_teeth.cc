#include "probe/tooling/turning_teeth.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <utility>
#include <vector>

#include "machine/base/contract.h"
#include "probe/tooling/spindle.h"
#include "probe/tooling/tool_shape.h"

namespace g31::probe {
namespace {

/// What the touch of all teeth has in common.
struct Facing {
  Facing(const OutlineTouch& touch, const Turning& turning)
      : across(touch.n_T.head<2>().norm()),
        inwards_mm_s(-turning.speed_mm_s * touch.n_T.dot(touch.way_T)) {
    if (across > 0.0) {
      direction = -touch.n_T.head<2>() / across;
      direction_deg = std::atan2(direction.y(), direction.x()) / kRadPerDeg;
    }
  }

  /// Of the normal, across the tool's axis: on an edge of the target anything between 0 and 1.
  double across;
  double inwards_mm_s;
  Blade::Radial direction = Blade::Radial::UnitX();  ///< in which a tooth faces the target
  double direction_deg = 0.0;
};

/// Steeper than this from the axis a touch comes from the side, less steep from above; in between
/// is an edge of the target.
constexpr double kFromTheSide = 0.99;
constexpr double kFromAbove = 0.01;

/// One tooth against the tangent plane.
class PassingTooth {
 public:
  PassingTooth(const Tooth& tooth, const Blade& profile, const OutlineTouch& touch,
               const Turning& turning, const Facing& facing)
      : tooth_(tooth), blade_(profile), touch_(touch), turning_(turning), facing_(facing) {
    const Blade::Radial asked(facing.across, -touch.n_T.z());
    // Square from the side it is as wide as it is, without a look at its edge.
    const Blade::Radial furthest =
        asked.y() == 0.0 ? Blade::Radial(tooth.radius_mm, 0.0) : furthest_of(profile, asked);
    radius_ = furthest.x();
    furthest_ = asked.dot(furthest);
  }

  /// How far it reaches towards the target where it faces it.
  [[nodiscard]] double furthest() const { return furthest_; }

  /// Whether the spindle brings it to the target within a turn, once it is deep enough.
  [[nodiscard]] bool comes_within_a_turn() const { return !is_from_above() && !passes_above(); }

  /// Seconds after it is deep enough to touch, where the spindle has brought it.
  /// @param from_s  when it is so, after the touch of the outline
  [[nodiscard]] std::optional<double> wait_s(double from_s) const {
    if (is_from_above()) {
      return wait_above_s(from_s);
    }
    return passes_above() ? std::nullopt : std::optional(wait_at_side_s(from_s));
  }

  /// It cannot touch sooner than so many seconds after it is deep enough.
  [[nodiscard]] double soonest_s(double from_s) const {
    return is_from_above() ? 0.0 : sight_s(from_s).first;
  }

 private:
  [[nodiscard]] double angle_deg(double time_s) const {
    return turning_.angle_deg + tooth_.angle_deg + turning_.rate_deg_s * time_s;
  }

  /// Degrees, 0 to 360, that the spindle turns until the tooth points in a direction.
  [[nodiscard]] double degrees_to(double direction_deg, double from_s) const {
    const double gap = direction_deg - angle_deg(from_s);
    const double ahead = turning_.rate_deg_s > 0.0 ? gap : -gap;
    return ahead - kFullTurnDeg * std::floor(ahead / kFullTurnDeg);
  }

  [[nodiscard]] bool is_from_above() const { return facing_.across <= kFromAbove; }

  [[nodiscard]] bool passes_above() const {
    return facing_.across > kFromTheSide && -tooth_.length_mm >= touch_.z_T_top;
  }

  /// From when to when it may touch a side: until it points to the face, for as the feed deepens
  /// its circle it meets the face earlier.
  [[nodiscard]] std::pair<double, double> sight_s(double from_s) const {
    const double rate = std::abs(turning_.rate_deg_s);
    const double passes_s = degrees_to(facing_.direction_deg, from_s) / rate;
    // How long before it faces the plate a shallow cut begins; a deep one may take half the turn.
    const double turn = kRadPerDeg * rate;
    const double shallow_s =
        std::sqrt(2.0 * facing_.inwards_mm_s * passes_s / (radius_ * facing_.across)) / turn;
    constexpr double kMargin = 1.5;
    constexpr double kShallow = 2.0;  // rad: 1 - cos is a third of the square at least
    const bool is_shallow = kMargin * shallow_s * turn < kShallow;
    const double before_s = is_shallow ? kMargin * shallow_s : 0.5 * kFullTurnDeg / rate;
    return {std::max(0.0, passes_s - before_s), passes_s};
  }

  [[nodiscard]] double wait_at_side_s(double from_s) const {
    auto [early, late] = sight_s(from_s);
    const double passes_s = late;
    const double turn = kRadPerDeg * std::abs(turning_.rate_deg_s);
    const double reach = radius_ * facing_.across;
    constexpr double kExact_s = 1e-13;
    while (late - early > kExact_s + 1e-15 * late) {
      const double middle = 0.5 * (early + late);
      const double missing = reach * (1.0 - std::cos(turn * (passes_s - middle)));
      (facing_.inwards_mm_s * middle < missing ? early : late) = middle;
    }
    return late;
  }

  /// Until its lowest point, or as much of its edge as is deep enough by then, is above the face.
  [[nodiscard]] std::optional<double> wait_above_s(double from_s) const {
    constexpr int kSteps = 360;
    constexpr double kBesideDeg = 1e-7;
    const double turn_s = kFullTurnDeg / std::abs(turning_.rate_deg_s);
    std::optional<double> first;
    const auto look = [&](double comes_s) {
      if (const auto rise = rise_above_face(angle_deg(from_s + comes_s))) {
        const double late_s = std::max(0.0, *rise / facing_.inwards_mm_s - comes_s);
        const double wait_s = comes_s + turn_s * std::ceil(late_s / turn_s);
        first = first ? std::min(*first, wait_s) : wait_s;
      }
    };
    // A beam of light is narrower than the steps.
    for (const double degrees : turning_points_deg()) {
      for (const double beside : {-kBesideDeg, kBesideDeg}) {
        look(degrees_to(degrees + beside, from_s) * turn_s / kFullTurnDeg);
      }
    }
    for (int i = 0; i < kSteps && (!first || i * turn_s < *first * kSteps); ++i) {
      look(i * turn_s / kSteps);
    }
    return first;
  }

  /// How far from the axis its lowest point is, or where its edge begins to rise outwards.
  [[nodiscard]] double lowest_mm() const {
    return cone_mm() > 0.0 ? 0.0 : blade_.rounded_centre.x();
  }

  /// How much a cone rises from the axis to its edge; 0: it is flat, or rounded.
  [[nodiscard]] double cone_mm() const {
    return blade_.rounded_centre.y() - blade_.rounded_radius + tooth_.length_mm;
  }

  /// Where a ray from the axis points to corners of the face, square to its sides, or to where its
  /// lowest point or its end crosses them: from one of these to the next it is above the face in
  /// one way.
  [[nodiscard]] std::vector<double> turning_points_deg() const {
    std::vector<double> degrees;
    const auto add = [&](const Eigen::Vector2d& to) {
      degrees.push_back(std::atan2(to.y(), to.x()) / kRadPerDeg);
    };
    const auto add_both = [&](double ahead, const Eigen::Vector2d& along, double aside,
                              const Eigen::Vector2d& across) {
      add(ahead * along + aside * across);
      add(ahead * along - aside * across);
    };
    const auto aside_at = [](double radius, double ahead) {
      return std::sqrt(std::max(0.0, radius * radius - ahead * ahead));
    };
    const Eigen::Vector2d& p = touch_.p_T_face;
    const std::array<double, 2> radii = {lowest_mm(), tooth_.radius_mm};
    if (touch_.is_face_round) {
      const double radius_of_face = touch_.face_half.x();
      const double middle = p.norm();
      const Eigen::Vector2d along = middle > 0.0 ? Eigen::Vector2d(p / middle) : touch_.face_side;
      add(along);
      for (const double radius : radii) {
        const double power = radius * radius + middle * middle - radius_of_face * radius_of_face;
        const double ahead = middle > 0.0 ? power / (2.0 * middle) : 0.0;
        add_both(ahead, along, aside_at(radius, ahead), square_to(along));
      }
      return degrees;
    }
    const std::array<FaceAxis, 2> axes = face_axes();
    for (std::size_t i = 0; i < axes.size(); ++i) {
      const auto& [along, to_side] = axes.at(i);
      const auto& [across, to_end] = axes.at(1 - i);
      for (const double ahead : {p.dot(along) - to_side, p.dot(along) + to_side}) {
        add(ahead * along);
        add(ahead * along + (p.dot(across) - to_end) * across);
        add(ahead * along + (p.dot(across) + to_end) * across);
        for (const double radius : radii) {
          add_both(ahead, along, aside_at(radius, ahead), across);
        }
      }
    }
    return degrees;
  }

  /// A direction of the face's sides, and how far the face reaches along it to either side.
  using FaceAxis = std::pair<Eigen::Vector2d, double>;

  [[nodiscard]] std::array<FaceAxis, 2> face_axes() const {
    return {FaceAxis(touch_.face_side, touch_.face_half.x()),
            FaceAxis(square_to(touch_.face_side), touch_.face_half.y())};
  }

  static Eigen::Vector2d square_to(const Eigen::Vector2d& v) { return {-v.y(), v.x()}; }

  /// How much higher than its lowest point the edge is where it is above the face; nullopt:
  /// nowhere.
  [[nodiscard]] std::optional<double> rise_above_face(double degrees) const {
    const Eigen::Vector2d along(std::cos(kRadPerDeg * degrees), std::sin(kRadPerDeg * degrees));
    const auto [near, far] = across_face(along);
    if (near > far) {
      return std::nullopt;
    }
    if (touch_.n_T.z() < 0.0) {
      return 0.0;  // from below: rear edges are flat
    }
    const double rounding = blade_.rounded_radius;
    const double cone = cone_mm();
    const double lowest = lowest_mm();
    if (far < lowest) {
      return (lowest - far) * std::tan(kRadPerDeg * kDishDeg);
    }
    const double off = std::max(0.0, near - lowest);
    return cone > 0.0 ? cone * off / tooth_.radius_mm
                      : rounding - std::sqrt(std::max(0.0, rounding * rounding - off * off));
  }

  /// From where to where a ray from the axis is above the face, mm within the tool's radius; from
  /// behind to: nowhere.
  [[nodiscard]] std::pair<double, double> across_face(const Eigen::Vector2d& along) const {
    double near = 0.0;
    double far = tooth_.radius_mm;
    const auto clip = [&](double low, double high) {
      near = std::max(near, low);
      far = std::min(far, high);
    };
    const Eigen::Vector2d& p = touch_.p_T_face;
    if (touch_.is_face_round) {
      const double ahead = along.dot(p);
      const double squared =
          ahead * ahead - p.squaredNorm() + touch_.face_half.x() * touch_.face_half.x();
      const double half = std::sqrt(std::max(0.0, squared));
      return squared < 0.0 ? std::pair(1.0, 0.0)
                           : (clip(ahead - half, ahead + half), std::pair(near, far));
    }
    for (const auto& [side, half] : face_axes()) {
      const double rate = along.dot(side);
      const double middle = p.dot(side);
      if (rate == 0.0) {
        if (std::abs(middle) > half) {
          return {1.0, 0.0};
        }
        continue;
      }
      const double reach = half / std::abs(rate);
      clip(middle / rate - reach, middle / rate + reach);
    }
    return {near, far};
  }

  const Tooth& tooth_;
  const Blade& blade_;
  const OutlineTouch& touch_;
  const Turning& turning_;
  const Facing& facing_;
  double radius_ = 0.0;  // of its point that is furthest towards the target
  double furthest_ = 0.0;
};

/// A tooth that may touch, and after what way of the tool at the soonest.
struct Candidate {
  std::size_t tooth = 0;
  double from_s = 0.0;
  double soonest_mm = 0.0;
};

/// The teeth of a tool that turns against one tangent plane.
class TeethInTurn {
 public:
  TeethInTurn(const std::vector<Tooth>& teeth, const TeethProfiles& profiles,
              const OutlineTouch& touch, const Turning& turning)
      : teeth_(teeth),
        profiles_(profiles),
        touch_(touch),
        turning_(turning),
        facing_(touch, turning) {}

  std::optional<double> way_to_first() {
    find_candidates();
    // The likely one goes first: most of the others then cannot be.
    const auto likely = std::ranges::min_element(candidates_, {}, &Candidate::soonest_mm);
    if (likely == candidates_.end()) {
      return std::nullopt;
    }
    take(*likely);
    for (const Candidate& candidate : candidates_) {
      if (&candidate != &*likely) {
        take(candidate);
      }
    }
    return first_;
  }

 private:
  [[nodiscard]] PassingTooth passing(std::size_t i) const {
    return {teeth_[i], profiles_.of_teeth[i], touch_, turning_, facing_};
  }

  /// All that the first tooth may be: what is deep enough only when another one has surely come is
  /// none of them.
  void find_candidates() {
    const double turn_s = kFullTurnDeg / std::abs(turning_.rate_deg_s);
    const double inwards = -touch_.n_T.dot(touch_.way_T);
    const Blade::Radial asked(facing_.across, -touch_.n_T.z());
    const double outline = asked.dot(furthest_of(profiles_.outline, asked));
    candidates_.reserve(teeth_.size());
    double surely_s = std::numeric_limits<double>::infinity();
    for (std::size_t i = 0; i < teeth_.size(); ++i) {
      const PassingTooth tooth = passing(i);
      const double from_s = (outline - tooth.furthest()) / inwards / turning_.speed_mm_s;
      candidates_.push_back({i, from_s, 0.0});
      if (tooth.comes_within_a_turn()) {
        surely_s = std::min(surely_s, from_s + turn_s);
      }
    }
    std::erase_if(candidates_, [&](const Candidate& one) { return one.from_s > surely_s; });
    for (Candidate& one : candidates_) {
      one.soonest_mm =
          turning_.speed_mm_s * (one.from_s + passing(one.tooth).soonest_s(one.from_s));
    }
  }

  void take(const Candidate& candidate) {
    if (first_ && candidate.soonest_mm >= *first_) {
      return;
    }
    if (const auto wait = passing(candidate.tooth).wait_s(candidate.from_s)) {
      const double way = turning_.speed_mm_s * (candidate.from_s + *wait);
      first_ = first_ ? std::min(*first_, way) : way;
    }
  }

  const std::vector<Tooth>& teeth_;
  const TeethProfiles& profiles_;
  const OutlineTouch& touch_;
  const Turning& turning_;
  Facing facing_;
  std::vector<Candidate> candidates_;
  std::optional<double> first_;  // mm of the tool's way
};

}  // namespace

std::optional<double> way_to_first_tooth(const std::vector<Tooth>& teeth,
                                         const TeethProfiles& profiles, const OutlineTouch& touch,
                                         const Turning& turning) {
  G31_EXPECTS(turning.rate_deg_s != 0.0 && turning.speed_mm_s > 0.0);
  G31_EXPECTS(!teeth.empty() && teeth.size() == profiles.of_teeth.size());
  return TeethInTurn(teeth, profiles, touch, turning).way_to_first();
}

}  // namespace g31::probe

#include "probe/metrology/minimum_zone_circle.h"

#include <algorithm>
#include <cmath>
#include <iterator>
#include <limits>
#include <numbers>
#include <vector>

#include "probe/metrology/minimax_fit.h"

namespace g31::metrology {
namespace {

/// The samples that are nearest to a centre and farthest from it, of all and of each piece of the
/// circle.
class Outermost {
 public:
  Outermost(const PlaneSamples& samples, std::span<const CircleTurn> turns,
            const Eigen::Vector2d& centre)
      : nearest_(kPieces, kNone), farthest_(kPieces, kNone) {
    std::vector<double> least(kPieces, std::numeric_limits<double>::infinity());
    std::vector<double> most(kPieces, -std::numeric_limits<double>::infinity());
    for (const CircleTurn& turn : turns) {
      for (std::size_t i = turn.begin; i < turn.end; ++i) {
        samples.look();
        const Eigen::Vector2d q = samples.at(i) - centre;
        const double distance = q.norm();
        const std::size_t piece = piece_of(q);
        if (distance < least[piece]) {
          least[piece] = distance;
          nearest_[piece] = i;
        }
        if (distance > most[piece]) {
          most[piece] = distance;
          farthest_[piece] = i;
        }
      }
    }
    width_ = *std::ranges::max_element(most) - *std::ranges::min_element(least);
  }

  [[nodiscard]] double width() const { return width_; }

  void add_to(std::vector<std::size_t>& chosen) const {
    for (const auto* const all : {&nearest_, &farthest_}) {
      std::ranges::copy_if(*all, std::back_inserter(chosen),
                           [](std::size_t i) { return i != kNone; });
    }
    std::ranges::sort(chosen);
    chosen.erase(std::unique(chosen.begin(), chosen.end()), chosen.end());
  }

 private:
  static constexpr std::size_t kPieces = 72;
  static constexpr std::size_t kNone = std::numeric_limits<std::size_t>::max();

  static std::size_t piece_of(const Eigen::Vector2d& q) {
    const double share = std::atan2(q.y(), q.x()) / (2.0 * std::numbers::pi) + 0.5;
    return std::min(kPieces - 1, static_cast<std::size_t>(share * kPieces));
  }

  std::vector<std::size_t> nearest_;
  std::vector<std::size_t> farthest_;
  double width_ = 0.0;
};

/// How far to move the centre so that the zone of the chosen samples becomes smallest.
std::optional<Eigen::Vector2d> step_from(const PlaneSamples& samples,
                                         const std::vector<std::size_t>& chosen,
                                         const Eigen::Vector2d& centre, double radius) {
  const auto rows = static_cast<Eigen::Index>(chosen.size());
  Eigen::MatrixXd columns(rows, 3);
  Eigen::VectorXd errors(rows);
  for (Eigen::Index row = 0; row < rows; ++row) {
    const Eigen::Vector2d q = samples.at(chosen[static_cast<std::size_t>(row)]) - centre;
    const double distance = q.norm();
    columns.row(row) << q.x() / distance, q.y() / distance, 1.0;
    errors[row] = distance - radius;
  }
  const auto fit = minimax_fit(columns, errors);
  return fit ? std::optional<Eigen::Vector2d>(fit->parameters.head<2>()) : std::nullopt;
}

}  // namespace

std::optional<double> minimum_zone_of(const PlaneSamples& samples,
                                      std::span<const CircleTurn> turns, const Circle& near) {
  constexpr int kMostSteps = 40;
  constexpr int kPatience = 3;  // steps that find nothing better: rounding alone goes on
  constexpr double kStillMm = 1e-10;
  Eigen::Vector2d centre = near.centre;
  std::vector<std::size_t> chosen;
  double least = std::numeric_limits<double>::infinity();
  int idle = 0;
  for (int i = 0; i < kMostSteps && idle < kPatience; ++i) {
    const Outermost outermost(samples, turns, centre);
    const std::size_t before = chosen.size();
    idle = outermost.width() < least - kStillMm ? 0 : idle + 1;
    least = std::min(least, outermost.width());
    outermost.add_to(chosen);
    const auto step = step_from(samples, chosen, centre, near.radius);
    if (!step) {
      return std::nullopt;
    }
    centre += *step;
    if (step->norm() < kStillMm && chosen.size() == before) {
      break;
    }
  }
  return least;
}

}  // namespace g31::metrology

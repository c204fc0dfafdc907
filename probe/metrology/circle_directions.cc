#include "probe/metrology/circle_directions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

namespace g31::metrology {
namespace {

constexpr std::size_t kMostSectors = 3600;
constexpr std::size_t kFewestSectors = 36;
constexpr std::size_t kSamplesOfSector = 16;

/// Radial errors of one direction within one angle.
struct Mean {
  double sum = 0.0;
  double count = 0.0;

  [[nodiscard]] double value() const { return sum / count; }
};

/// Clockwise and counter-clockwise.
using Sector = std::array<Mean, 2>;

std::vector<Sector> sectors_of(const PlaneSamples& samples, const std::vector<CircleTurn>& turns,
                               const Circle& reference) {
  std::size_t recorded = 0;
  for (const CircleTurn& turn : turns) {
    recorded += turn.end - turn.begin;
  }
  const std::size_t count = std::clamp(recorded / kSamplesOfSector, kFewestSectors, kMostSectors);
  std::vector<Sector> sectors(count);
  for (const CircleTurn& turn : turns) {
    for (std::size_t i = turn.begin; i < turn.end; ++i) {
      const Eigen::Vector2d q = samples.at(i) - reference.centre;
      const double part = std::atan2(q.y(), q.x()) / (2.0 * std::numbers::pi) + 0.5;
      const auto sector = static_cast<std::size_t>(part * static_cast<double>(count));
      Mean& mean = sectors[std::min(sector, count - 1)].at(turn.direction > 0 ? 1 : 0);
      mean.sum += q.norm() - reference.radius;
      mean.count += 1.0;
    }
  }
  return sectors;
}

}  // namespace

std::optional<CircleDirections> compare_directions(const PlaneSamples& samples,
                                                   const std::vector<CircleTurn>& turns,
                                                   const Circle& reference) {
  CircleDirections both;
  double passed = 0.0;
  for (const auto& [cw, ccw] : sectors_of(samples, turns, reference)) {
    if (cw.count > 0.0 && ccw.count > 0.0) {
      both.hysteresis = std::max(both.hysteresis, std::abs(cw.value() - ccw.value()));
      both.mean += 0.5 * (cw.value() + ccw.value());
      passed += 1.0;
    }
  }
  if (passed == 0.0) {
    return std::nullopt;
  }
  both.mean /= passed;
  return both;
}

}  // namespace g31::metrology

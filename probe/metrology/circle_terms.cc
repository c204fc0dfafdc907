#include "probe/metrology/circle_terms.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>

namespace g31::metrology {
namespace {

CircleTerm after(CircleTerm term, int steps) {
  return static_cast<CircleTerm>(static_cast<int>(term) + steps);
}

constexpr int kFirstTerms = 7;  // that every fit has

}  // namespace

CircleColumns::CircleColumns(const CircleTermChoice& choice) : choice_(choice) {
  for (int i = 0; i < kFirstTerms; ++i) {
    terms_.push_back(after(CircleTerm::CentreX, i));
  }
  if (choice.has_mismatch) {
    terms_.push_back(CircleTerm::Mismatch);
  }
  for (const int axis : {0, 1}) {
    if (choice.pitches.at(static_cast<std::size_t>(axis))) {
      terms_.push_back(after(CircleTerm::SineX, 2 * axis));
      terms_.push_back(after(CircleTerm::CosineX, 2 * axis));
    }
  }
  for (int i = 0; choice.has_lobes && i < 2 * (kLastLobe - kFirstLobe + 1); ++i) {
    terms_.push_back(after(CircleTerm::FirstLobe, i));
  }
}

void CircleColumns::fill(CircleRow& row, const Eigen::Vector2d& axes, const Eigen::Vector2d& n,
                         const CircleTurn& turn) const {
  const double both = n.x() * n.y();
  const double xx = n.x() * n.x();
  const double yy = n.y() * n.y();
  const double half = 0.5 * turn.direction;
  row.resize(count());
  row.head<kFirstTerms>() << n.x(), n.y(), choice_.has_radius ? xx : 1.0,
      choice_.has_radius ? yy : xx - yy, both, half * sign_of(n.y()) * n.x(),
      -half * sign_of(n.x()) * n.y();
  Eigen::Index next = kFirstTerms;
  if (choice_.has_mismatch) {
    row[next++] = turn.omega * kSecondsPerUnit * both;
  }
  for (const Eigen::Index axis : {0, 1}) {
    if (const auto& pitch = choice_.pitches.at(static_cast<std::size_t>(axis))) {
      const double turned = 2.0 * std::numbers::pi * axes[axis] / *pitch;
      row[next++] = n[axis] * std::sin(turned);
      row[next++] = n[axis] * std::cos(turned);
    }
  }
  if (choice_.has_lobes) {
    const std::complex<double> once(n.x(), n.y());
    std::complex<double> lobe = once * once;
    while (next < count()) {
      lobe *= once;
      row[next++] = lobe.real();
      row[next++] = lobe.imag();
    }
  }
}

Eigen::Index CircleColumns::column_of(CircleTerm term) const {
  return std::ranges::find(terms_, term) - terms_.begin();
}

CircleErrors CircleColumns::as_errors(const CircleRow& row, double radius) const {
  const auto of = [&](CircleTerm term) {
    const Eigen::Index column = column_of(term);
    return column < count() ? row[column] : 0.0;
  };
  const double size = of(CircleTerm::Size);
  const double shape = of(CircleTerm::Shape);
  CircleErrors errors;
  errors.centre = radius * row.head<2>();
  errors.radius = choice_.has_radius ? 0.0 : radius * size;
  errors.scale = choice_.has_radius ? std::array{size, shape} : std::array{shape, -shape};
  errors.squareness = of(CircleTerm::Squareness);
  errors.mismatch = of(CircleTerm::Mismatch) * kSecondsPerUnit;
  errors.backlash = {radius * of(CircleTerm::BacklashX), radius * of(CircleTerm::BacklashY)};
  errors.cyclic[0] = {radius * of(CircleTerm::SineX), radius * of(CircleTerm::CosineX)};
  errors.cyclic[1] = {radius * of(CircleTerm::SineY), radius * of(CircleTerm::CosineY)};
  for (std::size_t i = 0; i < errors.lobes.size(); ++i) {
    const int step = 2 * static_cast<int>(i);
    errors.lobes.at(i).cosine = radius * of(after(CircleTerm::FirstLobe, step));
    errors.lobes.at(i).sine = radius * of(after(CircleTerm::FirstLobe, step + 1));
  }
  return errors;
}

}  // namespace g31::metrology

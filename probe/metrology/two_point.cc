#include "probe/metrology/two_point.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::metrology {

SeparatedShapes separate_two_points(std::span<const double> a, std::span<const double> b) {
  G31_EXPECTS(a.size() == b.size() && a.size() >= 2);
  const std::size_t n = a.size() - 1;
  SeparatedShapes shapes;
  shapes.motion.assign(a.size(), 0.0);
  for (std::size_t k = 1; k <= n; ++k) {
    shapes.motion[k] = shapes.motion[k - 1] + b[k - 1] - a[k];
  }
  shapes.delta = shapes.motion[n] / static_cast<double>(n);
  for (std::size_t k = 0; k <= n; ++k) {
    shapes.motion[k] -= static_cast<double>(k) * shapes.delta;
    shapes.work.push_back(shapes.motion[k] + a[k] - a[0]);
  }
  shapes.motion[n] = 0.0;
  return shapes;
}

double tip_offset_over_two(std::span<const double> a, std::span<const double> c,
                           std::span<const double> motion) {
  G31_EXPECTS(a.size() == c.size() && a.size() == motion.size() && a.size() >= 3);
  double sum = 0.0;
  std::size_t k = 2;
  for (; k < a.size(); k += 2) {
    sum += c[k - 2] - a[k];
  }
  const std::size_t last = k - 2;
  return (sum - motion[last]) / (0.5 * static_cast<double>(last));
}

double tip_offset_over_two_uncertainty(std::size_t n) {
  G31_EXPECTS(n >= 2);
  const double half = std::floor(0.5 * static_cast<double>(n));
  if (n % 2 == 0) {
    return std::sqrt(2.0 / half);
  }
  const double share = 1.0 / static_cast<double>(n);
  const double rest = 1.0 - share;
  // c of every second row, then a and b of all rows but the last, then a and b of the last step.
  const double variance = half + half * (rest * rest + share * share) +
                          static_cast<double>(n - 1) * share * share + 2.0 * rest * rest;
  return std::sqrt(variance) / half;
}

double motion_uncertainty(std::size_t k, std::size_t n) {
  G31_EXPECTS(k <= n && n > 0);
  return std::sqrt(2.0 * static_cast<double>(k) * static_cast<double>(n - k) /
                   static_cast<double>(n));
}

double work_uncertainty(std::size_t k, std::size_t n) {
  G31_EXPECTS(k <= n && n > 0);
  return std::sqrt(2.0 * static_cast<double>(k) * static_cast<double>(n - k + 1) /
                   static_cast<double>(n));
}

double radius_at(double diameter, double g_0, double g_180, double g_theta) {
  return 0.5 * (diameter - g_0 - g_180 + 2.0 * g_theta);
}

}  // namespace g31::metrology

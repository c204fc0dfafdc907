#pragma once

#include <cstddef>
#include <span>
#include <vector>

namespace g31::metrology {

/// Motion and work, told apart.
struct SeparatedShapes {
  std::vector<double> motion;  ///< X_K, mm, positive towards the sensors; both ends are 0
  std::vector<double> work;    ///< Y_K, mm, positive towards the sensors; Y_0 is 0
  double delta = 0.0;          ///< mm: what the second sensor reads more at the same surface
};

/// The sequential two-point method (Sato, equations 5 to 9).
///
/// Two sensors a step apart ride along the work; at step K the first stands at place K, the second
/// at K + 1.  A reading rises as the work comes nearer: a_K = Y_K - X_K + const and
/// b_K = Y_(K+1) - X_K + const + delta.  So b_(K-1) - a_K = X_K - X_(K-1) + delta, which sums up to
/// X*_K = X_K + K delta; taking both ends of the motion as 0 gives delta = X*_N / N.
///
/// @param a, b  readings of both sensors, mm, as many of each and two at least
SeparatedShapes separate_two_points(std::span<const double> a, std::span<const double> b);

/// What a third sensor, two steps from the first, reads more than it at the same surface, mm, from
/// the steps that are two long; where their number is not even, as far as they go, with the motion
/// that the first two sensors found.
/// @param motion  X_K of `separate_two_points`, of the same rows, three at least
double tip_offset_over_two(std::span<const double> a, std::span<const double> c,
                           std::span<const double> motion);

/// Its standard uncertainty from n + 1 rows, two steps at least, for readings of standard
/// uncertainty 1 that know nothing of each other.
///
/// Of an even n it is the mean of n / 2 differences of two readings each.  Of an odd one the motion
/// at n - 1 comes off their sum: 1/n of each difference before, and (n - 1)/n of the last.
double tip_offset_over_two_uncertainty(std::size_t n);

/// Standard uncertainty of X_K and Y_K of n + 1 rows, for readings of standard uncertainty 1 that
/// know nothing of each other.
///
/// X*_K is a sum of 2 K readings, and taking K/N of X*_N off makes a bridge of the walk: the
/// variances are 2 K (N - K) / N, and 2 K (N - K + 1) / N for the work, whose last step shares the
/// reading a_K with it.  The largest is about sqrt(N / 2), in the middle.
double motion_uncertainty(std::size_t k, std::size_t n);
double work_uncertainty(std::size_t k, std::size_t n);

/// The radius of a work on a lathe where the first sensor stands at angle theta (Sato, equation
/// 11).
///
/// The sensor stands at distance s from the axis and reads how far it is from the surface, the gap
/// g: l_theta = s - g_theta.  The diameter between 0 and 180 degrees is what lies between both
/// readings, d = l_0 + l_180 = 2 s - g_0 - g_180, which gives s, and so
///
///     l_theta = (d + g_0 + g_180 - 2 g_theta) / 2.
///
/// A reading that rises as the work comes nearer is -g: l_theta = (d - g_0 - g_180 + 2 g_theta) /
/// 2, which is what this returns.  As printed, with + at all three, the equation fits neither.
double radius_at(double diameter, double g_0, double g_180, double g_theta);

}  // namespace g31::metrology

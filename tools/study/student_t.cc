#include "tools/study/student_t.h"

#include <cmath>
#include <limits>

#include "machine/base/contract.h"

namespace g31::study {
namespace {

/// The continued fraction of the incomplete beta function by Lentz's method; converges quickly for
/// x < (a + 1) / (a + b + 2).
double beta_fraction(double a, double b, double x) {
  constexpr int kMostTerms = 100000;
  constexpr double kTiny = 1e-300;
  constexpr double kEnough = 1e-16;
  const auto off_zero = [](double v) { return std::fabs(v) < kTiny ? kTiny : v; };
  double c = 1.0;
  double d = 1.0 / off_zero(1.0 - (a + b) * x / (a + 1.0));
  double fraction = d;
  for (int m = 1; m < kMostTerms; ++m) {
    const double n = m;
    const double even = n * (b - n) * x / ((a + 2.0 * n - 1.0) * (a + 2.0 * n));
    d = 1.0 / off_zero(1.0 + even * d);
    c = off_zero(1.0 + even / c);
    fraction *= d * c;
    const double odd = -(a + n) * (a + b + n) * x / ((a + 2.0 * n) * (a + 2.0 * n + 1.0));
    d = 1.0 / off_zero(1.0 + odd * d);
    c = off_zero(1.0 + odd / c);
    fraction *= d * c;
    if (std::fabs(d * c - 1.0) < kEnough) {
      break;
    }
  }
  return fraction;
}

/// The logarithm of the gamma function.  std::lgamma writes to a global variable; this one does
/// not.
double log_gamma(double x) {
  int sign = 0;
  return ::lgamma_r(x, &sign);
}

/// I_x(a, b), the regularised incomplete beta function; y = 1 - x, given apart so that it keeps its
/// digits.
double regularised_beta(double a, double b, double x, double y) {
  if (x <= 0.0 || y <= 0.0) {
    return x <= 0.0 ? 0.0 : 1.0;
  }
  const double front =
      std::exp(log_gamma(a + b) - log_gamma(a) - log_gamma(b) + a * std::log(x) + b * std::log(y));
  return x < (a + 1.0) / (a + b + 2.0) ? front * beta_fraction(a, b, x) / a
                                       : 1.0 - front * beta_fraction(b, a, y) / b;
}

/// The probability of |T| > t.
double two_tails(double t, double freedom) {
  const double sum = freedom + t * t;
  return regularised_beta(0.5 * freedom, 0.5, freedom / sum, t * t / sum);
}

}  // namespace

double student_t_probability(double t, std::size_t freedom) {
  G31_EXPECTS(freedom >= 1);
  const double tail = 0.5 * two_tails(std::fabs(t), static_cast<double>(freedom));
  return t < 0.0 ? tail : 1.0 - tail;
}

double student_t_quantile(double p, std::size_t freedom) {
  G31_EXPECTS(p > 0.0 && p < 1.0 && freedom >= 1);
  if (p == 0.5) {
    return 0.0;
  }
  // In both tails the probability of the tail keeps its digits, so look for that one.
  const double wanted = 2.0 * (p < 0.5 ? p : 1.0 - p);
  const auto degrees = static_cast<double>(freedom);
  double low = 0.0;
  double high = 1.0;
  while (two_tails(high, degrees) > wanted && high < std::numeric_limits<double>::max() / 4.0) {
    low = high;
    high *= 2.0;
  }
  for (double middle = 0.5 * (low + high); low < middle && middle < high;
       middle = 0.5 * (low + high)) {
    (two_tails(middle, degrees) > wanted ? low : high) = middle;
  }
  return p < 0.5 ? -high : high;
}

}  // namespace g31::study

#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>

namespace g31 {

/// Which row of random numbers: every random model of a run takes its own stream of the run's seed,
/// so that adding a model changes no number of another.
struct Stream {
  std::uint64_t seed = 0;
  std::uint32_t stream = 0;
};

/// Philox4x32-10 of Salmon, Moraes, Dror, Shaw (SC 2011): a counter and a key in, 128 random bits
/// out.  No state: number n can be asked for without the numbers before it, on any core.
constexpr std::array<std::uint32_t, 4> philox4x32(std::array<std::uint32_t, 4> counter,
                                                  std::array<std::uint32_t, 2> key) {
  constexpr int kRounds = 10;
  constexpr std::uint64_t kMultiplier0 = 0xD2511F53U;
  constexpr std::uint64_t kMultiplier1 = 0xCD9E8D57U;
  constexpr std::uint32_t kWeyl0 = 0x9E3779B9U;
  constexpr std::uint32_t kWeyl1 = 0xBB67AE85U;
  for (int round = 0; round < kRounds; ++round) {
    const std::uint64_t product0 = kMultiplier0 * counter[0];
    const std::uint64_t product1 = kMultiplier1 * counter[2];
    counter = {static_cast<std::uint32_t>(product1 >> 32) ^ counter[1] ^ key[0],
               static_cast<std::uint32_t>(product1),
               static_cast<std::uint32_t>(product0 >> 32) ^ counter[3] ^ key[1],
               static_cast<std::uint32_t>(product0)};
    key[0] += kWeyl0;
    key[1] += kWeyl1;
  }
  return counter;
}

/// A number evenly spread over the open interval (0, 1): 52 random bits and a half, never 0 or 1.
/// @param event  the running number of the draw; the same event gives the same number
constexpr double uniform(Stream stream, std::uint64_t event) {
  constexpr double kTwoToMinus52 = 1.0 / 4503599627370496.0;
  const auto bits = philox4x32(
      {static_cast<std::uint32_t>(event), static_cast<std::uint32_t>(event >> 32), stream.stream,
       0U},
      {static_cast<std::uint32_t>(stream.seed), static_cast<std::uint32_t>(stream.seed >> 32)});
  const std::uint64_t word = (static_cast<std::uint64_t>(bits[1]) << 32) | bits[0];
  return (static_cast<double>(word >> 12) + 0.5) * kTwoToMinus52;
}

namespace random_detail {

/// c[0] + c[1] x + c[2] x^2 ...
template <std::size_t count>
constexpr double polynomial(const std::array<double, count>& c, double x) {
  double sum = 0.0;
  for (std::size_t i = count; i-- > 0;) {
    sum = sum * x + c[i];
  }
  return sum;
}

/// The natural logarithm of x > 0 by additions, multiplications and one division, each rounded
/// once: std::log may differ in the last bit between two libraries, this may not.  frexp is exact.
/// Relative error below 4e-16 for 0 < x <= 0.5.
inline double portable_log(double x) {
  constexpr double kLn2 = 0.69314718055994530942;
  constexpr double kHalfRoot = 0.70710678118654752440;
  int exponent = 0;
  double mantissa = std::frexp(x, &exponent);
  if (mantissa < kHalfRoot) {
    mantissa *= 2.0;
    --exponent;
  }
  // log m = 2 artanh z with z = (m - 1) / (m + 1), |z| <= 0.172: twelve terms reach 1e-20.
  const double z = (mantissa - 1.0) / (mantissa + 1.0);
  double sum = 0.0;
  for (int odd = 23; odd >= 1; odd -= 2) {
    sum = sum * (z * z) + 1.0 / odd;
  }
  return exponent * kLn2 + 2.0 * z * sum;
}

/// The x with Phi(x) = p, 0 < p < 1.  Wichura, Algorithm AS 241 (PPND16), Applied Statistics 37
/// (1988): relative error about 1e-16 in its own arithmetic.
inline double normal_quantile(double p) {
  constexpr std::array<double, 8> kA = {3.3871328727963666080e0, 1.3314166789178437745e2,
                                        1.9715909503065514427e3, 1.3731693765509461125e4,
                                        4.5921953931549871457e4, 6.7265770927008700853e4,
                                        3.3430575583588128105e4, 2.5090809287301226727e3};
  constexpr std::array<double, 8> kB = {1.0,
                                        4.2313330701600911252e1,
                                        6.8718700749205790830e2,
                                        5.3941960214247511077e3,
                                        2.1213794301586595867e4,
                                        3.9307895800092710610e4,
                                        2.8729085735721942674e4,
                                        5.2264952788528545610e3};
  constexpr std::array<double, 8> kC = {1.42343711074968357734e0,  4.63033784615654529590e0,
                                        5.76949722146069140550e0,  3.64784832476320460504e0,
                                        1.27045825245236838258e0,  2.41780725177450611770e-1,
                                        2.27238449892691845833e-2, 7.74545014278341407640e-4};
  constexpr std::array<double, 8> kD = {1.0,
                                        2.05319162663775882187e0,
                                        1.67638483018380384940e0,
                                        6.89767334985100004550e-1,
                                        1.48103976427480074590e-1,
                                        1.51986665636164571966e-2,
                                        5.47593808499534494600e-4,
                                        1.05075007164441684324e-9};
  constexpr std::array<double, 8> kE = {6.65790464350110377720e0,  5.46378491116411436990e0,
                                        1.78482653991729133580e0,  2.96560571828504891230e-1,
                                        2.65321895265761230930e-2, 1.24266094738807843860e-3,
                                        2.71155556874348757815e-5, 2.01033439929228813265e-7};
  constexpr std::array<double, 8> kF = {1.0,
                                        5.99832206555887937690e-1,
                                        1.36929880922735805310e-1,
                                        1.48753612908506148525e-2,
                                        7.86869131145613259100e-4,
                                        1.84631831751005468180e-5,
                                        1.42151175831644588870e-7,
                                        2.04426310338993978564e-15};
  const double q = p - 0.5;
  if (std::fabs(q) <= 0.425) {
    const double r = 0.180625 - q * q;
    return q * polynomial(kA, r) / polynomial(kB, r);
  }
  const double tail = std::sqrt(-portable_log(q < 0.0 ? p : 1.0 - p));
  const double size = tail <= 5.0 ? polynomial(kC, tail - 1.6) / polynomial(kD, tail - 1.6)
                                  : polynomial(kE, tail - 5.0) / polynomial(kF, tail - 5.0);
  return q < 0.0 ? -size : size;
}

}  // namespace random_detail

/// A number of the standard normal distribution (mean 0, standard deviation 1), |x| < 8.3.
///
/// The same bits on every IEEE machine: one uniform number through the inverse distribution, with
/// no library function that may round differently (frexp and sqrt are exactly defined).
/// @param event  the running number of the draw; the same event gives the same number
inline double standard_normal(Stream stream, std::uint64_t event) {
  return random_detail::normal_quantile(uniform(stream, event));
}

}  // namespace g31

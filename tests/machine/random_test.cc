#include "machine/base/random.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <numbers>

#include <gtest/gtest.h>

namespace g31::random_test {
namespace {

// The vectors that come with the authors' library (Random123, kat_vectors).
TEST(Philox, GivesThePublishedAnswers) {
  using Words = std::array<std::uint32_t, 4>;
  EXPECT_EQ(philox4x32({0, 0, 0, 0}, {0, 0}),
            (Words{0x6627e8d5, 0xe169c58d, 0xbc57ac4c, 0x9b00dbd8}));
  EXPECT_EQ(philox4x32({0xffffffff, 0xffffffff, 0xffffffff, 0xffffffff}, {0xffffffff, 0xffffffff}),
            (Words{0x408f276d, 0x41c83b0e, 0xa20bc7c6, 0x6d5451fd}));
  EXPECT_EQ(philox4x32({0x243f6a88, 0x85a308d3, 0x13198a2e, 0x03707344}, {0xa4093822, 0x299f31d0}),
            (Words{0xd16cfe09, 0x94fdcceb, 0x5001e420, 0x24126ea1}));
}

/// Phi(x), through the library's erfc.
double normal_distribution(double x) {
  return 0.5 * std::erfc(-x / std::numbers::sqrt2);
}

TEST(NormalQuantile, InvertsTheDistributionFunction) {
  // Middle, both tails and both switches between the approximations.
  for (const double p : {1e-16, 1.4e-11, 1.3e-11, 1e-9, 1e-3, 0.0749, 0.0751, 0.3, 0.5, 0.7, 0.9249,
                         0.9251, 0.999, 1.0 - 1e-9}) {
    SCOPED_TRACE(p);
    const double x = random_detail::normal_quantile(p);
    EXPECT_NEAR(normal_distribution(x) / p, 1.0, 1e-13);
    EXPECT_NEAR(random_detail::normal_quantile(0.5), 0.0, 0.0);
  }
}

TEST(PortableLog, AgreesWithTheLibrary) {
  for (double x = 1e-16; x <= 0.5; x *= 1.37) {
    EXPECT_NEAR(random_detail::portable_log(x) / std::log(x), 1.0, 4e-16) << x;
  }
}

TEST(Random, HasTheMomentsOfItsDistributions) {
  constexpr int kDraws = 200000;
  double mean = 0.0;
  double normal_mean = 0.0;
  double square = 0.0;
  double fourth = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto event = static_cast<std::uint64_t>(i);
    const double u = uniform({7, 1}, event);
    ASSERT_TRUE(u > 0.0 && u < 1.0);
    const double x = standard_normal({7, 1}, event);
    mean += u / kDraws;
    normal_mean += x / kDraws;
    square += x * x / kDraws;
    fourth += x * x * x * x / kDraws;
  }
  // Five standard errors each.
  EXPECT_NEAR(mean, 0.5, 5 * std::sqrt(1.0 / 12 / kDraws));
  EXPECT_NEAR(normal_mean, 0.0, 5 * std::sqrt(1.0 / kDraws));
  EXPECT_NEAR(square, 1.0, 5 * std::sqrt(2.0 / kDraws));
  EXPECT_NEAR(fourth, 3.0, 5 * std::sqrt(96.0 / kDraws));
}

TEST(Random, DependsOnSeedStreamAndEventAndNothingElse) {
  const double x = standard_normal({1, 2}, 3);
  EXPECT_EQ(standard_normal({1, 2}, 3), x);
  EXPECT_NE(standard_normal({2, 2}, 3), x);
  EXPECT_NE(standard_normal({1, 3}, 3), x);
  EXPECT_NE(standard_normal({1, 2}, 4), x);
  EXPECT_NE(standard_normal({1 + (1ULL << 40), 2}, 3), x);
  EXPECT_NE(standard_normal({1, 2}, 3 + (1ULL << 40)), x);
}

// Correlation between neighbouring streams and events would show as a common order.
TEST(Random, StreamsAreUncorrelated) {
  constexpr int kDraws = 100000;
  double streams = 0.0;
  double events = 0.0;
  for (int i = 0; i < kDraws; ++i) {
    const auto event = static_cast<std::uint64_t>(i);
    const double x = standard_normal({0, 0}, event);
    streams += x * standard_normal({0, 1}, event) / kDraws;
    events += x * standard_normal({0, 0}, event + 1) / kDraws;
  }
  EXPECT_NEAR(streams, 0.0, 5 / std::sqrt(kDraws));
  EXPECT_NEAR(events, 0.0, 5 / std::sqrt(kDraws));
}

}  // namespace
}  // namespace g31::random_test

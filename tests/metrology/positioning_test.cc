// ISO 230-2 by hand: two targets, two directions, few approaches.

#include "probe/metrology/positioning.h"

#include <cmath>
#include <vector>

#include <gtest/gtest.h>

namespace g31::positioning_test {
namespace {

using metrology::Approach;

std::vector<Approach> approaches(double target, std::vector<double> up, std::vector<double> down) {
  std::vector<Approach> all;
  for (const double x : up) {
    all.push_back({target, target + x, true});
  }
  for (const double x : down) {
    all.push_back({target, target + x, false});
  }
  return all;
}

TEST(Positioning, IsThatOfTheStandardByHand) {
  // In um.  At 0: up 1, 2, 3 (mean 2, s 1), down 4, 6, 8 (mean 6, s 2).
  // At 100: up 3, 3, 3 (mean 3, s 0), down 1, 2, 3 (mean 2, s 1).
  std::vector<Approach> all = approaches(100.0, {3e-3, 3e-3, 3e-3}, {1e-3, 2e-3, 3e-3});
  const auto first = approaches(0.0, {1e-3, 2e-3, 3e-3}, {4e-3, 6e-3, 8e-3});
  all.insert(all.end(), first.begin(), first.end());
  const auto made = metrology::evaluate_positioning(all);
  ASSERT_TRUE(made.ok());
  const auto& p = made.value();
  EXPECT_EQ(p.targets.front().target, 0.0);
  EXPECT_NEAR(*p.B, 4e-3, 1e-12);        // |2 - 6|, |3 - 2|
  EXPECT_NEAR(*p.R_up, 4e-3, 1e-12);     // 4 * 1
  EXPECT_NEAR(*p.R_down, 8e-3, 1e-12);   // 4 * 2
  EXPECT_NEAR(*p.R, 10e-3, 1e-12);       // 2 * 1 + 2 * 2 + 4
  EXPECT_NEAR(*p.E, 4e-3, 1e-12);        // 6 - 2
  EXPECT_NEAR(*p.E_up, 1e-3, 1e-12);     // 3 - 2
  EXPECT_NEAR(*p.E_down, 4e-3, 1e-12);   // 6 - 2
  EXPECT_NEAR(*p.M, 1.5e-3, 1e-12);      // 4 - 2.5
  EXPECT_NEAR(*p.A, 10e-3, 1e-12);       // 6 + 4 - (2 - 2)
  EXPECT_NEAR(*p.A_up, 4e-3, 1e-12);     // 2 + 2 - (2 - 2)
  EXPECT_NEAR(*p.A_down, 10e-3, 1e-12);  // 6 + 4 - (2 - 2)
}

TEST(Positioning, OfOneDirectionHasNoReversal) {
  const auto made = metrology::evaluate_positioning(approaches(0.0, {1e-3, 3e-3}, {}));
  ASSERT_TRUE(made.ok());
  EXPECT_NEAR(*made.value().R_up, 4e-3 * std::sqrt(2.0), 1e-12);
  EXPECT_FALSE(made.value().B.has_value());
  EXPECT_FALSE(made.value().A_down.has_value());
  EXPECT_FALSE(metrology::evaluate_positioning(approaches(5.0, {1e-3}, {})).ok());
}

}  // namespace
}  // namespace g31::positioning_test

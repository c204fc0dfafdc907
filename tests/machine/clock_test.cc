#include "machine/sim/clock.h"

#include <cmath>

#include <gtest/gtest.h>

#include "tests/support/expect_violated.h"

namespace g31::machine::clock_test {
namespace {

TEST(Clock, TenMillionTenthsMakeAMillion) {
  Clock clock;
  double plain_sum = 0.0;
  for (int i = 0; i < 10'000'000; ++i) {
    clock.advance(0.1);
    plain_sum += 0.1;
  }
  EXPECT_EQ(clock.now_s(), 1e6);
  EXPECT_GT(std::abs(plain_sum - 1e6), 1e-5) << "the compensation has nothing to do";
}

TEST(ClockDeathTest, TimeDoesNotRunBackwards) {
  Clock clock;
  testing::expect_violated([&] { clock.advance(-1e-9); }, "seconds >= 0.0");
}

}  // namespace
}  // namespace g31::machine::clock_test

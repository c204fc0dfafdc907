// Skip moves without a signal and what has their result, beside the conformance cases: order,
// limits.

#include "interpreter/runtime/missed_touches.h"

#include <vector>

#include <gtest/gtest.h>

namespace g31::runtime::missed_touches_test {
namespace {

constexpr source::FileId kFile{1};

source::Location at(std::uint64_t begin) {
  return {kFile, 1, begin};
}

/// A move at a place without a signal, its result in a variable.
void miss_into(MissedTouches& missed, std::uint64_t begin, MissedTouches::Holder holder) {
  missed.missed(at(begin));
  missed.reads_result();
  missed.assigns(holder);
}

TEST(MissedTouches, AreToldInTheirOrderNotInThatOfTheText) {
  MissedTouches missed;
  miss_into(missed, 30, 1);
  miss_into(missed, 10, 2);
  miss_into(missed, 20, 3);
  missed.touched();
  EXPECT_EQ(missed.ends(), (std::vector{at(30), at(10), at(20)}));
  EXPECT_FALSE(missed.any());
  EXPECT_TRUE(missed.ends().empty()) << "each once";
}

TEST(MissedTouches, ALoopOwesItsPlaceOnce) {
  MissedTouches missed;
  for (int i = 0; i < 100000; ++i) {
    miss_into(missed, 10, static_cast<MissedTouches::Holder>(i % 3));
  }
  EXPECT_EQ(missed.ends(), std::vector{at(10)});
}

TEST(MissedTouches, ASumOfVeryManyIsToldThroughSomeOfThem) {
  MissedTouches missed;
  for (std::uint64_t i = 0; i < 100000; ++i) {
    missed.missed(at(i));
    missed.reads_result();
    missed.reads(7);
    missed.assigns(7);
  }
  const auto told = missed.ends();
  ASSERT_FALSE(told.empty());
  EXPECT_LE(told.size(), 100U);
  EXPECT_FALSE(missed.any());
}

TEST(MissedTouches, OfMovesThatNobodyReadsTheLastAloneIsOwed) {
  MissedTouches missed;
  for (std::uint64_t i = 0; i < 1000; ++i) {
    missed.missed(at(i));
  }
  EXPECT_EQ(missed.last(), at(999));
  EXPECT_EQ(missed.ends(), std::vector{at(999)});
  missed.missed(at(1));
  missed.touched();
  EXPECT_FALSE(missed.any());
}

TEST(MissedTouches, WhatIsOverwrittenOrForgottenIsNotOwed) {
  MissedTouches missed;
  miss_into(missed, 10, 5);
  missed.touched();
  missed.assigns(5);
  EXPECT_FALSE(missed.any());
  miss_into(missed, 10, 5);
  miss_into(missed, 20, 9);
  missed.touched();
  missed.forget(6, 9);
  EXPECT_EQ(missed.ends(), std::vector{at(10)});
}

}  // namespace
}  // namespace g31::runtime::missed_touches_test

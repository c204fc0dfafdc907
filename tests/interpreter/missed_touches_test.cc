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
  missed.missed(at(begin), {});
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
    missed.missed(at(i), {});
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
    missed.missed(at(i), {});
  }
  EXPECT_EQ(missed.last(), at(999));
  EXPECT_EQ(missed.ends(), std::vector{at(999)});
  missed.missed(at(1), {});
  missed.touched();
  EXPECT_FALSE(missed.any());
}

TEST(MissedTouches, OfAProgramThatIsBrokenOffTheLastAloneIsOwedIfNothingReadIt) {
  MissedTouches missed;
  miss_into(missed, 10, 1);
  EXPECT_TRUE(missed.breaks_off().empty()) << "it may still have been compared";
  missed.missed(at(20), {});
  EXPECT_EQ(missed.breaks_off(), std::vector{at(20)});
  missed.missed(at(30), {});
  missed.touched();
  EXPECT_TRUE(missed.breaks_off().empty());
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

/// Compares what a variable holds with a number.
void compare(MissedTouches& missed, MissedTouches::Holder holder, double value, double other) {
  missed.reads(holder);
  MissedTouches::Side side{value, missed.set_aside()};
  missed.compares(side, {other, nullptr});
}

TEST(MissedTouches, AreSettledByTheEndAndExcusedByALimit) {
  MissedTouches missed;
  miss_into(missed, 10, 5);
  compare(missed, 5, 50.0, 49.5);
  EXPECT_FALSE(missed.any());

  miss_into(missed, 10, 5);
  compare(missed, 5, 50.0, 48.9);
  EXPECT_TRUE(missed.any());
  missed.reads(5);
  missed.assigns(6);
  MissedTouches copied = missed;
  EXPECT_EQ(copied.ends(), std::vector{at(10)}) << "what is made of it afterwards";
  missed.reads(6);
  EXPECT_EQ(missed.uses(), std::vector{at(10)});

  miss_into(missed, 20, 5);
  missed.reads(5);
  missed.assigns(6);
  compare(missed, 5, 50.0, 0.0);
  EXPECT_TRUE(missed.ends().empty()) << "left where they were when it was compared";
}

TEST(MissedTouches, AResultThatShowsTheFormerTouchIsComparedWithAnyValue) {
  MissedTouches missed;
  missed.missed(at(10), {MissedTouches::Result::Former});
  missed.reads_result();
  missed.assigns(5);
  compare(missed, 5, 50.0, 50.0);
  missed.reads(5);
  missed.assigns(6);
  EXPECT_EQ(missed.ends(), std::vector{at(10)});

  missed.missed(at(20), {MissedTouches::Result::Former});
  missed.reads_result();
  missed.assigns(5);
  missed.looks();
  missed.compares({50.0, missed.set_aside()}, {50.0, nullptr});
  EXPECT_FALSE(missed.any()) << "the axes stand at the end";
}

TEST(MissedTouches, ALimitExcusesItsOwnMoveAlone) {
  MissedTouches missed;
  miss_into(missed, 10, 5);
  miss_into(missed, 20, 6);
  missed.reads(5);
  missed.reads(6);
  missed.assigns(7);
  compare(missed, 5, 50.0, 0.0);
  missed.assigns(6);
  EXPECT_EQ(missed.ends(), std::vector{at(20)}) << "the sum of both";
}

TEST(MissedTouches, ADecisionExcusesTheResultAndSettlesTheSignal) {
  MissedTouches missed;
  miss_into(missed, 10, 5);
  missed.reads(5);
  missed.decides();
  EXPECT_TRUE(missed.any());
  EXPECT_TRUE(missed.ends().empty());

  miss_into(missed, 20, 5);
  missed.looks_at_signal(0);
  missed.decides();
  EXPECT_FALSE(missed.any());
}

}  // namespace
}  // namespace g31::runtime::missed_touches_test

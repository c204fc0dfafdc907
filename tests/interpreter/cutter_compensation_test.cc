#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/interpreter/compensated_path.h"

namespace g31::path::testing::cutter_compensation_test {
namespace {

using Lines = std::vector<std::string>;
using Program = std::function<void(PathDriver&)>;

/// 5 mm to the left along the X axis up to (0, 0), where the corner is: the start-up is smooth.
PathDriver along_x(const CompensationRules& rules = {}) {
  PathDriver driver({-30.0, 0.0}, rules);
  driver.offset(5.0).line(-20.0, 0.0).line(0.0, 0.0);
  return driver;
}

TEST(CutterCompensation, CornersOfLinesAndArcs) {
  struct Case {
    const char* name;
    Program behind;
    Lines expected;  ///< from the end of the line along X
  };
  const Case kCases[] = {
      {"straight on",
       [](PathDriver& p) { p.line(20, 0); },
       {"G1 0.0000 5.0000", "G1 20.0000 5.0000"}},
      {"inside, 90 degrees: intersection",
       [](PathDriver& p) { p.line(0, 20); },
       {"G1 -5.0000 5.0000", "G1 -5.0000 20.0000"}},
      {"outside, 45 degrees: intersection",
       [](PathDriver& p) { p.line(20, -20); },
       {"G1 2.0711 5.0000", "G1 23.5355 -16.4645"}},
      {"outside, 90 degrees: still the intersection",
       [](PathDriver& p) { p.line(0, -20); },
       {"G1 5.0000 5.0000", "G1 5.0000 -20.0000"}},
      {"outside, 135 degrees: both lines go on by the radius",
       [](PathDriver& p) { p.line(-20, -20); },
       {"G1 5.0000 5.0000", "G1 7.0711 0.0000", "G1 -16.4645 -23.5355"}},
      {"back on the same line: around its end",
       [](PathDriver& p) { p.line(-30, 0); },
       {"G1 5.0000 5.0000", "G1 5.0000 -5.0000", "G1 -30.0000 -5.0000"}},
      {"inside, line and arc: line y = 5 and circle of 8 mm meet at -13 + sqrt(39)",
       [](PathDriver& p) { p.left_arc(-13, 13, -13, 0); },
       {"G1 -6.7550 5.0000", "G3 -13.0000 8.0000 about -13.0000 0.0000"}},
      {"outside, line and arc: along the tangent to the start of the offset arc",
       [](PathDriver& p) { p.right_arc(-13, -13, -13, 0); },
       {"G1 5.0000 5.0000", "G1 5.0000 0.0000", "G2 -13.0000 -18.0000 about -13.0000 0.0000"}},
      {"smooth, line and arc",
       [](PathDriver& p) { p.left_arc(20, 20, 0, 20); },
       {"G1 0.0000 5.0000", "G3 15.0000 20.0000 about 0.0000 20.0000"}},
      {"the side changes at a corner: where the lines meet",
       [](PathDriver& p) { p.offset(-5).line(0, 20); },
       {"G1 5.0000 5.0000", "G1 5.0000 20.0000"}},
      {"the side changes straight on: beside the next block",
       [](PathDriver& p) { p.offset(-5).line(20, 0); },
       {"G1 0.0000 -5.0000", "G1 20.0000 -5.0000"}},
      {"another D: in force from the end of its block",
       [](PathDriver& p) { p.offset(2).line(20, 0); },
       {"G1 0.0000 5.0000", "G1 20.0000 2.0000"}},
      {"rapid blocks are compensated too",
       [](PathDriver& p) { p.rapid(-20, -20); },
       {"G1 5.0000 5.0000", "G0 7.0711 0.0000", "G0 -16.4645 -23.5355"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    PathDriver driver = along_x();
    c.behind(driver);
    driver.flush();
    Lines expected{"G1 -20.0000 5.0000"};
    expected.insert(expected.end(), c.expected.begin(), c.expected.end());
    EXPECT_EQ(driver.text(), expected);
    EXPECT_FALSE(driver.fault().has_value());
  }
}

// Circles of 13 mm about (0, 0) and (24, 0) meet in (12, 5); 5-12-13 triangles give the tangents.
TEST(CutterCompensation, CornersOfTwoArcs) {
  const auto two_arcs = [](double offset) {
    PathDriver driver({-20.0, -13.0});
    driver.offset(offset).line(0, -13).left_arc(12, 5, 0, 0).left_arc(24, -13, 24, 0).flush();
    return driver;
  };
  EXPECT_EQ(two_arcs(0.5).text(),
            (Lines{"G1 0.0000 -12.5000", "G3 12.0000 3.5000 about 0.0000 0.0000",
                   "G3 24.0000 -12.5000 about 24.0000 0.0000"}));
  EXPECT_EQ(two_arcs(-0.5).text(),
            (Lines{"G1 0.0000 -13.5000", "G3 12.4615 5.1923 about 0.0000 0.0000",
                   "G1 12.2692 5.6538", "G1 11.7308 5.6538", "G1 11.5385 5.1923",
                   "G3 24.0000 -13.5000 about 24.0000 0.0000"}));
  ASSERT_TRUE(two_arcs(5.0).fault().has_value());
  EXPECT_EQ(two_arcs(5.0).fault()->error, CompensationError::NoIntersection);
}

TEST(CutterCompensation, StartUpAndCancel) {
  struct Case {
    const char* name;
    PlanePoint next;
    Lines a;
    Lines b;
  };
  // From (0, 0) to the corner (10, 0) and on to `next`; then the same way back, cancelling.
  const Case kCases[] = {
      {"inside", {10, 30}, {"G1 5.0000 0.0000"}, {"G1 5.0000 0.0000"}},
      {"outside, 90 degrees",
       {10, -30},
       {"G1 15.0000 0.0000"},
       {"G1 10.0000 5.0000", "G1 15.0000 5.0000"}},
      {"outside, 135 degrees",
       {0, -10},
       {"G1 13.5355 -3.5355"},
       {"G1 10.0000 5.0000", "G1 15.0000 5.0000", "G1 17.0711 0.0000"}},
      {"straight on", {40, 0}, {"G1 10.0000 5.0000"}, {"G1 10.0000 5.0000"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    for (const StartUp type : {StartUp::TypeA, StartUp::TypeB}) {
      CompensationRules rules;
      rules.start_up = type;
      const Lines& corner = type == StartUp::TypeA ? c.a : c.b;
      PathDriver there({0.0, 0.0}, rules);
      there.offset(5.0).line(10, 0).line(c.next.x(), c.next.y()).flush();
      Lines text = there.text();
      text.pop_back();
      EXPECT_EQ(text, corner);

      PathDriver back(c.next - 10.0 * (PlanePoint(10, 0) - c.next).normalized(), rules);
      back.offset(-5.0).line(c.next.x(), c.next.y()).line(10, 0).off().line(0, 0);
      text = back.text();
      EXPECT_EQ(text.back(), "G1 0.0000 0.0000");
      EXPECT_EQ(Lines(text.rbegin() + 1, text.rend() - 1), corner);
      EXPECT_FALSE(back.compensation().engaged());
    }
  }
}

TEST(CutterCompensation, FullCircleInsideABore) {
  PathDriver driver({5.0, 0.0});
  driver.offset(5.0).line(20, 0).left_arc(20, 0, 0, 0).off().line(5, 0);
  EXPECT_EQ(driver.text(), (Lines{"G1 15.0000 0.0000", "G3 15.0000 0.0000 about 0.0000 0.0000",
                                  "G1 5.0000 0.0000"}));
}

TEST(CutterCompensation, BlocksWithoutMotionInThePlane) {
  struct Case {
    const char* name;
    Program between;
    Lines expected;
  };
  const Case kCases[] = {
      {"one is read past",
       [](PathDriver& p) { p.idle(); },
       {"G1 -5.0000 5.0000", "G1 -5.0000 20.0000"}},
      {"two are not: the block ends beside its end",
       [](PathDriver& p) { p.idle().idle(); },
       {"G1 0.0000 5.0000", "G1 -5.0000 20.0000"}},
      {"a motion of no length is as two",
       [](PathDriver& p) { p.line(0, 0); },
       {"G1 0.0000 5.0000", "G1 0.0000 5.0000", "G1 -5.0000 20.0000"}},
      {"other axes move at the corner point",
       [](PathDriver& p) { p.height(-3); },
       {"G1 -5.0000 5.0000", "G1 -5.0000 5.0000 Z-3.0000", "G1 -5.0000 20.0000 Z-3.0000"}},
      {"a pause is made there",
       [](PathDriver& p) { p.pause(0.5); },
       {"G1 -5.0000 5.0000", "P 0.5", "G1 -5.0000 20.0000"}},
      {"G41 alone: beside the end",
       [](PathDriver& p) { p.renewed(); },
       {"G1 0.0000 5.0000", "G1 -5.0000 20.0000"}},
      {"nothing can be read ahead",
       [](PathDriver& p) { p.flush(); },
       {"G1 0.0000 5.0000", "G1 -5.0000 20.0000"}},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    PathDriver driver = along_x();
    c.between(driver);
    driver.line(0, 20).flush();
    const Lines text = driver.text();
    EXPECT_EQ(Lines(text.begin() + 1, text.end()), c.expected);
  }
}

TEST(CutterCompensation, PauseIsAtTheFirstPointOfAnOutsideCorner) {
  PathDriver driver = along_x();
  driver.pause(0.5).line(-20, -20).flush();
  EXPECT_EQ(driver.text()[1], "G1 5.0000 5.0000");
  EXPECT_EQ(driver.text()[2], "P 0.5");
  EXPECT_EQ(driver.text()[3], "G1 7.0711 0.0000");
}

TEST(CutterCompensation, MoreBlocksAreReadWhenTheParameterSaysSo) {
  CompensationRules rules;
  rules.idle_limit = 3;
  PathDriver driver = along_x(rules);
  driver.idle().idle().idle().line(0, 20).flush();
  EXPECT_EQ(driver.text()[1], "G1 -5.0000 5.0000");
}

TEST(CutterCompensation, CancelWithoutMotionKeepsTheOffsetUntilTheNextMotionInThePlane) {
  PathDriver driver = along_x();
  driver.off().height(10.0).line(0, 20);
  EXPECT_EQ(driver.text(), (Lines{"G1 -20.0000 5.0000", "G1 0.0000 5.0000",
                                  "G1 0.0000 5.0000 Z10.0000", "G1 0.0000 20.0000 Z10.0000"}));
  EXPECT_FALSE(driver.compensation().engaged());
}

TEST(CutterCompensation, PositionIsBesideTheEndOfTheBlockThatWaits) {
  const PathDriver driver = along_x();
  EXPECT_EQ(driver.items().size(), 1U);
  EXPECT_NEAR(driver.compensation().position()[0], 0.0, 1e-12);
  EXPECT_NEAR(driver.compensation().position()[1], 5.0, 1e-12);
}

TEST(CutterCompensation, MinuteCornerLinesAreLeftOut) {
  CompensationRules rules;
  rules.minute_mm = 5.1;
  PathDriver driver = along_x(rules);
  driver.line(-20, -20).flush();
  EXPECT_EQ(driver.text(),
            (Lines{"G1 -20.0000 5.0000", "G1 5.0000 5.0000", "G1 -16.4645 -23.5355"}));
}

// The block of 6 mm lies between a sharp outside and a sharp inside corner: the second point of the
// outside corner would be passed backwards, the first is not.
TEST(CutterCompensation, CornerPointsThatLeadBackwardsAreLeftOut) {
  PathDriver driver = along_x();
  driver.line(-4.242640687, -4.242640687).line(30.0, -4.242640687).flush();
  ASSERT_FALSE(driver.fault().has_value());
  EXPECT_EQ(driver.text(), (Lines{"G1 -20.0000 5.0000", "G1 5.0000 5.0000", "G1 7.8284 0.7574",
                                  "G1 30.0000 0.7574"}));
}

TEST(CutterCompensation, WhatCannotBeCompensated) {
  struct Case {
    const char* name;
    Program program;
    CompensationError error;
    std::size_t block;  ///< counted from 0
  };
  const Case kCases[] = {
      {"start-up on an arc", [](PathDriver& p) { p.offset(5).left_arc(10, 10, 0, 10); },
       CompensationError::ArcAtStartOrEnd, 0},
      {"cancel on an arc",
       [](PathDriver& p) { p.offset(5).line(10, 0).line(20, 0).off().left_arc(30, 10, 20, 10); },
       CompensationError::ArcAtStartOrEnd, 2},
      {"cancel alone, then an arc",
       [](PathDriver& p) {
         p.offset(5).line(10, 0).line(20, 0).off().idle().left_arc(30, 10, 20, 10);
       },
       CompensationError::ArcAtStartOrEnd, 3},
      {"another plane",
       [](PathDriver& p) {
         p.offset(5).line(10, 0).plane({2, 0}).line(20, 0);
       },
       CompensationError::PlaneChanged, 1},
      {"another plane in a block without motion",
       [](PathDriver& p) {
         p.offset(5).line(10, 0).plane({2, 0}).idle();
       },
       CompensationError::PlaneChanged, 1},
      {"an arc smaller than the tool, inside",
       [](PathDriver& p) { p.offset(5).line(10, 0).left_arc(14, 4, 10, 4); },
       CompensationError::Interference, 1},
      {"an arc of the size of the tool, inside",
       [](PathDriver& p) { p.offset(5).line(10, 0).left_arc(15, 5, 10, 5); },
       CompensationError::ArcWithoutRadius, 1},
      {"a groove narrower than the tool",
       [](PathDriver& p) {
         p.offset(5).line(10, 0).line(30, 0).line(30, 8).line(10, 8).line(0, 8);
       },
       CompensationError::Interference, 2},
      {"inside corners at both ends of an arc eat it up",
       [](PathDriver& p) {
         p.offset(5).line(10, 0).line(30, 0).left_arc(34, 8, 24, 8).line(0, 8).flush();
       },
       CompensationError::Interference, 2},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    PathDriver driver({0.0, 0.0});
    c.program(driver);
    ASSERT_TRUE(driver.fault().has_value());
    EXPECT_EQ(driver.fault()->error, c.error);
    EXPECT_EQ(driver.fault()->where.begin, c.block);
  }
}

TEST(CutterCompensation, WithoutTheInterferenceCheckTheToolGoesBackwards) {
  CompensationRules rules;
  rules.check = CompensationRules::InterferenceCheck::Off;
  PathDriver driver({0.0, 0.0}, rules);
  driver.offset(5).line(10, 0).line(30, 0).line(30, 8).line(10, 8).flush();
  EXPECT_FALSE(driver.fault().has_value());
  EXPECT_EQ(driver.text(), (Lines{"G1 10.0000 5.0000", "G1 25.0000 5.0000", "G1 25.0000 3.0000",
                                  "G1 10.0000 3.0000"}));
}

}  // namespace
}  // namespace g31::path::testing::cutter_compensation_test

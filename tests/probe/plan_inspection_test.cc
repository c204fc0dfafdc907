#include "probe/planning/plan_inspection.h"

#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

namespace g31::probe::plan_inspection_test {
namespace {

using parts::Feature;
using parts::FeatureKind;
using parts::Side;

const parts::Box kBlock{{0, 0, -40}, {160, 110, 0}};

Feature feature(FeatureKind kind, const parts::Box& box, const std::vector<Side>& open) {
  Feature feature;
  feature.kind = kind;
  feature.box_P = feature.own = box;
  feature.walls_from_z = box.min.z();
  feature.walls_to_z = box.max.z();
  feature.has_flat_floor = true;
  for (const Side side : open) {
    feature.open[static_cast<std::size_t>(side)] = true;
  }
  return feature;
}

parts::RecognisedPart part_with(const Feature& feature) {
  return {kBlock, {feature}, {}};
}

/// Every place is reached.
std::optional<std::string> never(const PlannedPoint& /*point*/, double /*error*/) {
  return std::nullopt;
}

const PlannedMeasure* find(const InspectionPlan& plan, std::string_view id) {
  for (const PlannedMeasure& measure : plan.measures) {
    if (measure.id == id) {
      return &measure;
    }
  }
  return nullptr;
}

void expect_point(const PlannedPoint& point, const Point& at, const Point& normal,
                  const Point& start) {
  EXPECT_NEAR((point.at_P - at).norm(), 0.0, 1e-12) << point.id << ": " << point.at_P.transpose();
  EXPECT_NEAR((point.normal_P - normal).norm(), 0.0, 1e-12) << point.id;
  EXPECT_NEAR((point.start_P - start).norm(), 0.0, 1e-12)
      << point.id << ": " << point.start_P.transpose();
}

// The paper's example: an open pocket, its points as its figure and text have them.
TEST(PlanInspection, TouchesAnOpenPocketWhereThePaperDoes) {
  const auto part = part_with(feature(FeatureKind::OpenPocket, {{120, 75, -12}, {160, 110, 0}},
                                      {Side::ZPlus, Side::XPlus, Side::YPlus}));
  const InspectionPlan plan = plan_inspection(part, kBlock, {}, never);
  EXPECT_TRUE(plan.left_out.empty());
  ASSERT_EQ(plan.measures.size(), 3U);
  const auto& p = plan.points;
  const PlannedMeasure& x = *find(plan, "F1.X");
  EXPECT_EQ(x.nominal, 40.0);
  // 5 mm below the upper face; 5 mm below the floor; both in the middle of the pocket's Y.
  expect_point(p[x.first], {120, 92.5, -5}, {1, 0, 0}, {126, 92.5, -5});
  expect_point(p[x.second], {160, 92.5, -17}, {1, 0, 0}, {166, 92.5, -17});
  const PlannedMeasure& y = *find(plan, "F1.Y");
  EXPECT_EQ(y.nominal, 35.0);
  expect_point(p[y.first], {140, 75, -5}, {0, 1, 0}, {140, 81, -5});
  expect_point(p[y.second], {140, 110, -17}, {0, 1, 0}, {140, 116, -17});
  const PlannedMeasure& z = *find(plan, "F1.Z");
  EXPECT_EQ(z.nominal, 12.0);
  expect_point(p[z.first], {140, 92.5, -12}, {0, 0, 1}, {140, 92.5, 1});
  expect_point(p[z.second], {117, 92.5, 0}, {0, 0, 1}, {117, 92.5, 13});
}

TEST(PlanInspection, MeasuresOfEachKindWhatThePaperSays) {
  struct Case {
    FeatureKind kind;
    std::vector<Side> open;
    std::string measures;
  };
  const Case cases[] = {
      {FeatureKind::ClosedPocket, {Side::ZPlus}, "X X.place Y Y.place Z "},
      {FeatureKind::ThroughPocket, {Side::ZPlus, Side::ZMinus}, "X X.place Y Y.place "},
      {FeatureKind::ClosedSlot, {Side::ZPlus, Side::YMinus}, "X X.place Y Z "},
      {FeatureKind::OpenSlot, {Side::ZPlus, Side::XPlus, Side::XMinus}, "Y Y.place Z "},
      {FeatureKind::OpenSlot, {Side::ZPlus, Side::YPlus, Side::YMinus}, "X X.place Z "},
      {FeatureKind::OpenPocket, {Side::ZPlus, Side::XMinus, Side::YMinus}, "X Y Z "},
      {FeatureKind::Step, {Side::ZPlus, Side::XPlus, Side::YPlus, Side::YMinus}, "X Z "},
      {FeatureKind::Step, {Side::ZPlus, Side::XPlus, Side::XMinus, Side::YMinus}, "Y Z "},
  };
  for (const Case& row : cases) {
    const auto part = part_with(feature(row.kind, {{20, 20, -12}, {60, 50, 0}}, row.open));
    std::string measures;
    for (const PlannedMeasure& measure : plan_inspection(part, kBlock, {}, never).measures) {
      measures += measure.id.substr(3) + " ";
      if (measure.what == Characteristic::Place) {
        EXPECT_EQ(measure.nominal, measure.axis == 'X' ? 40.0 : 35.0);
      }
    }
    EXPECT_EQ(measures, row.measures) << name_of(row.kind);
  }
}

// From outside: 5 mm below its top; from the floor 3.5 mm beside it, where a ball of 6 mm is free.
TEST(PlanInspection, TouchesWhatStandsFreeFromOutside) {
  using enum Side;
  for (const FeatureKind kind : {FeatureKind::Boss, FeatureKind::Rib}) {
    SCOPED_TRACE(name_of(kind));
    Feature standing =
        feature(kind, {{40, 20, -12}, {60, 30, 0}}, {XPlus, XMinus, YPlus, YMinus, ZPlus});
    standing.is_round = kind == FeatureKind::Boss;
    const InspectionPlan plan = plan_inspection(part_with(standing), kBlock, {}, never);
    EXPECT_TRUE(plan.left_out.empty());
    ASSERT_EQ(plan.measures.size(), 5U);
    const auto& p = plan.points;
    const PlannedMeasure& x = *find(plan, "F1.X");
    EXPECT_EQ(x.nominal, 20.0);
    EXPECT_EQ(x.direction_P, Point(1, 0, 0));
    expect_point(p[x.first], {40, 25, -5}, {-1, 0, 0}, {34, 25, -5});
    expect_point(p[x.second], {60, 25, -5}, {1, 0, 0}, {66, 25, -5});
    EXPECT_EQ(find(plan, "F1.X.place")->nominal, 50.0);
    EXPECT_EQ(find(plan, "F1.Y")->nominal, 10.0);
    EXPECT_EQ(find(plan, "F1.Y.place")->nominal, 25.0);
    const PlannedMeasure& z = *find(plan, "F1.Z");
    EXPECT_EQ(z.nominal, 12.0);
    expect_point(p[z.first], {36.5, 25, -12}, {0, 0, 1}, {36.5, 25, 1});
    expect_point(p[z.second], {50, 25, 0}, {0, 0, 1}, {50, 25, 13});
  }
}

TEST(PlanInspection, MovesAPointAlongItsFaceWhereItIsNotReached) {
  const auto part =
      part_with(feature(FeatureKind::ClosedPocket, {{20, 20, -12}, {60, 50, 0}}, {Side::ZPlus}));
  const auto clamp_in_the_middle = [](const PlannedPoint& point, double /*error*/) {
    const bool is_in = std::abs(point.at_P.y() - 35.0) < 4.0;
    return is_in ? std::optional<std::string>("stylus stem touches clamp") : std::nullopt;
  };
  const InspectionPlan plan = plan_inspection(part, kBlock, {}, clamp_in_the_middle);
  const PlannedMeasure& x = *find(plan, "F1.X");
  const PlannedPoint& first = plan.points[x.first];
  EXPECT_EQ(first.at_P.x(), 20.0);
  EXPECT_GE(std::abs(first.at_P.y() - 35.0), 4.0);
  EXPECT_EQ(first.moved, "not at X20.000 Y35.000 Z-5.000: stylus stem touches clamp");
  EXPECT_EQ(x.nominal, 40.0);
  EXPECT_TRUE(plan.points[find(plan, "F1.Y")->first].moved.empty());
}

TEST(PlanInspection, LeavesASizeOutWithTheReasonWhereNoPlaceIsReached) {
  const auto part =
      part_with(feature(FeatureKind::ClosedPocket, {{20, 20, -12}, {60, 50, 0}}, {Side::ZPlus}));
  const auto not_in_x = [](const PlannedPoint& point, double /*error*/) {
    return point.normal_P.x() != 0.0 ? std::optional<std::string>("it is covered") : std::nullopt;
  };
  const InspectionPlan plan = plan_inspection(part, kBlock, {}, not_in_x);
  ASSERT_EQ(plan.left_out.size(), 1U);
  EXPECT_EQ(plan.left_out[0].axis, 'X');
  EXPECT_NE(plan.left_out[0].why.find("not at X20.000 Y35.000 Z-5.000: it is covered"),
            std::string::npos);
  EXPECT_EQ(find(plan, "F1.X"), nullptr);
  EXPECT_NE(find(plan, "F1.Y"), nullptr);
}

// A ball of 6 mm, with half a millimetre free on each side of it.
TEST(PlanInspection, LeavesOutWhatTheBallDoesNotFitInto) {
  struct Case {
    parts::Box box;
    double floor_radius;
    std::string left_out;
  };
  const Case cases[] = {
      {{{20, 20, -12}, {25, 50, 0}},
       0.0,
       "X: the ball of 6 mm does not fit between its walls, which are 5 mm apart\n"
       "Z: the ball of 6 mm with 0.5 mm free on each side takes 7 mm; its walls are 5 mm apart in "
       "X\n"},
      {{{20, 20, -12}, {50, 26.8, 0}},
       0.0,
       "Z: the ball of 6 mm with 0.5 mm free on each side takes 7 mm; its walls are 6.8 mm apart "
       "in "
       "Y\n"},
      {{{20, 20, -12}, {30, 50, 0}},
       2.0,
       "Z: the ball of 6 mm with 0.5 mm free on each side and the rounding of 2 mm at its floor "
       "takes 11 mm; its walls are 10 mm apart in X\n"},
      {{{20, 20, -3.25}, {60, 50, 0}},
       0.0,
       "X: the ball of 6 mm stays 0.5 mm above the floor, so it touches a wall 3.5 mm above it; "
       "its "
       "walls go up to 3.25 mm\n"
       "Y: the ball of 6 mm stays 0.5 mm above the floor, so it touches a wall 3.5 mm above it; "
       "its "
       "walls go up to 3.25 mm\n"},
  };
  for (const Case& row : cases) {
    Feature pocket = feature(FeatureKind::ClosedPocket, row.box, {Side::ZPlus});
    pocket.floor_radius_mm = row.floor_radius;
    std::string left_out;
    for (const LeftOut& size : plan_inspection(part_with(pocket), kBlock, {}, never).left_out) {
      left_out += fmt::format("{}: {}\n", size.axis, size.why);
    }
    EXPECT_EQ(left_out, row.left_out);
  }
}

// Edges at any place: differences of their coordinates come out below the limits by a rounding.
TEST(PlanInspection, MeasuresWhatIsJustAsLargeAsTheBallNeedsWhereverItIs) {
  for (int i = 0; i < 200; ++i) {
    const double x = 20.0 + 0.37 * i;
    const double y = 10.0 + 0.13 * i;
    const auto part = part_with(
        feature(FeatureKind::ClosedPocket, {{x, y, -3.5}, {x + 7.0, y + 7.0, 0}}, {Side::ZPlus}));
    const InspectionPlan plan = plan_inspection(part, {{0, 0, -40}, {200, 110, 0}}, {}, never);
    EXPECT_TRUE(plan.left_out.empty()) << x << ' ' << y << ' ' << plan.left_out.front().why;
  }
}

TEST(PlanInspection, MeasuresATurnedPocketAlongItsOwnAxes) {
  Feature pocket =
      feature(FeatureKind::ClosedPocket, {{60, -10, -12}, {100, 20, 0}}, {Side::ZPlus});
  pocket.axes.angle_deg = 30.0;
  const InspectionPlan plan = plan_inspection(part_with(pocket), kBlock, {}, never);
  const PlannedMeasure& x = *find(plan, "F1.X");
  EXPECT_NEAR((x.direction_P - Point(std::sqrt(3.0) / 2, 0.5, 0)).norm(), 0.0, 1e-12);
  EXPECT_NEAR(x.nominal, 40.0, 1e-9);
  const auto& p = plan.points;
  EXPECT_NEAR((p[x.second].at_P - p[x.first].at_P).dot(x.direction_P), 40.0, 1e-9);
  const PlannedMeasure& place = *find(plan, "F1.X.place");
  EXPECT_NEAR(place.nominal, 80.0, 1e-9);  // the block's corner is the origin
}

}  // namespace
}  // namespace g31::probe::plan_inspection_test

#include "probe/planning/round_features.h"

#include <array>
#include <optional>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "probe/planning/plan_inspection.h"

namespace g31::probe::round_features_test {
namespace {

using parts::Feature;
using parts::FeatureKind;
using parts::Side;

constexpr double kRadius = 3.0;
constexpr double kClearZ = 13.0;
const parts::Box kBlock{{0, 0, -40}, {160, 110, 0}};

/// Round, 20 mm across about X 30, Y 85, from -18 up to 0.
Feature circle(FeatureKind kind, const std::vector<Side>& open) {
  Feature feature;
  feature.kind = kind;
  feature.box_P = feature.own = {{20, 75, -18}, {40, 95, 0}};
  feature.walls_from_z = -18;
  feature.has_flat_floor = feature.is_round = true;
  for (const Side side : open) {
    feature.open[static_cast<std::size_t>(side)] = true;
  }
  return feature;
}

Feature hole() {
  return circle(FeatureKind::BlindHole, {Side::ZPlus});
}

Feature boss() {
  using enum Side;
  return circle(FeatureKind::Boss, {XPlus, XMinus, YPlus, YMinus, ZPlus});
}

InspectionPlan plan_of(const parts::RecognisedPart& part, const IsUnreachable& unreachable) {
  return plan_inspection(part, kBlock, {}, unreachable);
}

std::optional<std::string> is_reached(const PlannedPoint& /*point*/, double /*error*/) {
  return std::nullopt;
}

std::optional<std::string> is_free(const Point& /*from*/, const Point& /*to*/) {
  return std::nullopt;
}

std::vector<PlannedRound> rounds_of(const parts::RecognisedPart& part, const InspectionPlan& plan,
                                    const IsBlocked& is_blocked) {
  return round_features(part, plan, kRadius, kClearZ, is_blocked);
}

TEST(RoundFeatures, AreHolesAndBossesThatAreMeasuredAcross) {
  for (const Feature& feature : {hole(), boss()}) {
    const parts::RecognisedPart part{kBlock, {feature}, {}};
    const InspectionPlan plan = plan_of(part, is_reached);
    const auto rounds = rounds_of(part, plan, is_free);
    ASSERT_EQ(rounds.size(), 1U);
    const PlannedRound& round = rounds[0];
    EXPECT_EQ(round.centre_P, Point(30, 85, -5));
    EXPECT_EQ(round.diameter_mm, 20.0);
    EXPECT_EQ(round.is_standing, feature.is_standing());
    EXPECT_EQ(round.approach_mm, 3.0);
    EXPECT_EQ(round.by_points, "");
    const std::array<Point, 4> at = {Point(20, 85, -5), Point(40, 85, -5), Point(30, 75, -5),
                                     Point(30, 95, -5)};
    const std::array<std::string, 4> measures = {"F1.X", "F1.X.place", "F1.Y", "F1.Y.place"};
    for (std::size_t i = 0; i < at.size(); ++i) {
      EXPECT_EQ(plan.points[round.points[i]].at_P, at[i]);
      EXPECT_EQ(plan.measures[round.measures[i]].id, measures[i]);
    }
  }
}

TEST(RoundFeatures, AreNoneOfAPocketNorOfAWallThatIsNotReached) {
  Feature pocket = hole();
  pocket.is_round = false;
  const parts::RecognisedPart square{kBlock, {pocket}, {}};
  EXPECT_TRUE(rounds_of(square, plan_of(square, is_reached), is_free).empty());
  const parts::RecognisedPart part{kBlock, {hole()}, {}};
  const auto at_north = [](const PlannedPoint& point, double /*error*/) {
    return point.normal_P.y() < 0.0 ? std::optional<std::string>("a clamp") : std::nullopt;
  };
  EXPECT_TRUE(rounds_of(part, plan_of(part, at_north), is_free).empty());
}

TEST(RoundFeatures, AreTouchedByThemselvesWhereTheirWallsAreAtDifferentHeights) {
  const auto high_at_west = [](const PlannedPoint& point, double /*error*/) {
    return point.normal_P.x() > 0.5 && point.at_P.z() > -7.0 ? std::optional<std::string>("a clamp")
                                                             : std::nullopt;
  };
  const parts::RecognisedPart part{kBlock, {hole()}, {}};
  const auto rounds = rounds_of(part, plan_of(part, high_at_west), is_free);
  ASSERT_EQ(rounds.size(), 1U);
  EXPECT_EQ(rounds[0].by_points, "its walls are not touched at one height");
}

// A cycle goes down in the middle of a hole; beside a boss as a touch by itself does.
TEST(RoundFeatures, AreTouchedByThemselvesWhereTheWayOfACycleIsBlocked) {
  const auto in_the_middle = [](const Point& from, const Point& to) {
    const bool is_it = from == Point(30, 85, kClearZ) && to == Point(30, 85, -5);
    return is_it ? std::optional<std::string>("the probe would meet 'pin'") : std::nullopt;
  };
  const auto to_the_west = [](const Point& from, const Point& to) {
    const bool is_it = from == Point(30, 85, -5) && to == Point(26, 85, -5);
    return is_it ? std::optional<std::string>("the probe would meet 'pin'") : std::nullopt;
  };
  for (const IsBlocked& is_blocked : {IsBlocked(in_the_middle), IsBlocked(to_the_west)}) {
    for (const Feature& feature : {hole(), boss()}) {
      const parts::RecognisedPart part{kBlock, {feature}, {}};
      const auto rounds = rounds_of(part, plan_of(part, is_reached), is_blocked);
      ASSERT_EQ(rounds.size(), 1U);
      EXPECT_EQ(rounds[0].by_points, feature.is_standing()
                                         ? ""
                                         : "the probe would meet 'pin' on the way from its middle");
    }
  }
}

}  // namespace
}  // namespace g31::probe::round_features_test

#include "parts/features/recognise.h"

#include <numbers>
#include <set>
#include <string>
#include <vector>

#include <gtest/gtest.h>

#include "tests/parts/removed_volumes.h"

namespace g31::parts::recognise_test {
namespace {

using testing::VolumeMaker;
using enum Side;

const Box kStock{{0, 0, -40}, {160, 110, 0}};
const Box kPocket{{90, 10, -15}, {130, 35, 0}};

RecognisedPart recognised(const VolumeMaker& maker) {
  return recognise(kStock, {maker.volume});
}

std::string kind_of(const VolumeMaker& maker) {
  const RecognisedPart part = recognised(maker);
  return part.features.empty() ? part.unknown.at(0).why
                               : std::string(name_of(part.features.at(0).kind));
}

std::set<std::string_view> open_of(const Feature& feature) {
  std::set<std::string_view> names;
  for (std::size_t side = 0; side < kSides; ++side) {
    if (feature.open[side]) {
      names.insert(name_of(static_cast<Side>(side)));
    }
  }
  return names;
}

TEST(Recognise, NamesEveryKindInAllItsOrientationsByItsOpenSides) {
  struct Case {
    std::string kind;
    std::vector<Side> open;
  };
  const std::vector<Case> cases = {
      {"closed_pocket", {ZPlus}},
      {"through_pocket", {ZPlus, ZMinus}},
      {"closed_slot", {ZPlus, XPlus}},
      {"closed_slot", {ZPlus, XMinus}},
      {"closed_slot", {ZPlus, YPlus}},
      {"closed_slot", {ZPlus, YMinus}},
      {"open_slot", {ZPlus, XPlus, XMinus}},
      {"open_slot", {ZPlus, YPlus, YMinus}},
      {"open_pocket", {ZPlus, XPlus, YPlus}},
      {"open_pocket", {ZPlus, XPlus, YMinus}},
      {"open_pocket", {ZPlus, XMinus, YPlus}},
      {"open_pocket", {ZPlus, XMinus, YMinus}},
      {"step", {ZPlus, XPlus, YPlus, YMinus}},
      {"step", {ZPlus, XMinus, YPlus, YMinus}},
      {"step", {ZPlus, XPlus, XMinus, YPlus}},
      {"step", {ZPlus, XPlus, XMinus, YMinus}},
  };
  for (const double angle : {0.0, 30.0, -20.0, 45.0}) {
    for (const Case& row : cases) {
      SCOPED_TRACE(row.kind + " at " + std::to_string(angle));
      const RecognisedPart part = recognised({kPocket, row.open, angle});
      ASSERT_EQ(part.features.size(), 1U);
      const Feature& feature = part.features.front();
      EXPECT_EQ(name_of(feature.kind), row.kind);
      EXPECT_NEAR(feature.axes.angle_deg, angle, 1e-9);
      std::set<std::string_view> open;
      for (const Side side : row.open) {
        open.insert(name_of(side));
      }
      EXPECT_EQ(open_of(feature), open);
      EXPECT_NEAR((feature.own.min - kPocket.min).norm(), 0.0, 1e-8);
      EXPECT_NEAR((feature.own.max - kPocket.max).norm(), 0.0, 1e-8);
    }
  }
}

TEST(Recognise, CallsARoundWallAHole) {
  for (const bool is_through : {false, true}) {
    VolumeMaker maker({{20, 75, -18}, {40, 95, 0}}, {ZPlus});
    maker.volume.faces[static_cast<std::size_t>(ZMinus)].is_open = is_through;
    maker.volume.faces.erase(maker.volume.faces.begin(), maker.volume.faces.begin() + 4);
    const Box heights{{0, 0, -18}, {0, 0, 0}};
    // Two halves, as some CAD systems write them.
    maker.add(VolumeMaker::upright({30, 85, 0}, 10.0, 0.0, 180.0, heights));
    maker.add(VolumeMaker::upright({30, 85, 0}, 10.0, 180.0, 360.0, heights));
    const RecognisedPart part = recognised(maker);
    ASSERT_EQ(part.features.size(), 1U);
    const Feature& hole = part.features.front();
    EXPECT_EQ(name_of(hole.kind), is_through ? "through_hole" : "blind_hole");
    EXPECT_TRUE(hole.is_round);
    EXPECT_EQ(hole.own.min, Point(20, 75, -18));
    EXPECT_EQ(hole.own.max, Point(40, 95, 0));
  }
}

TEST(Recognise, HalfARoundWallIsNoHole) {
  VolumeMaker maker({{20, 75, -18}, {40, 95, 0}}, {ZPlus});
  maker.volume.faces.erase(maker.volume.faces.begin(), maker.volume.faces.begin() + 4);
  maker.add(VolumeMaker::upright({30, 85, 0}, 10.0, 0.0, 180.0, {{0, 0, -18}, {0, 0, 0}}));
  EXPECT_EQ(kind_of(maker), "it is round, but not all round");
}

TEST(Recognise, ARoundEndClosesASlot) {
  // 20 wide, open at -Y, its end half round about (28, 30).
  VolumeMaker maker({{18, 0, -12}, {38, 40, 0}}, {ZPlus, YMinus});
  maker.volume.faces.erase(maker.volume.faces.begin() + 2);  // +Y
  maker.add(VolumeMaker::upright({28, 30, 0}, 10.0, 0.0, 180.0, {{0, 0, -12}, {0, 0, 0}}));
  maker.volume.volume_mm3 = 12.0 * (20.0 * 30.0 + 50.0 * std::numbers::pi);
  const RecognisedPart part = recognised(maker);
  ASSERT_EQ(part.features.size(), 1U) << part.unknown.at(0).why;
  EXPECT_EQ(name_of(part.features[0].kind), "closed_slot");
  EXPECT_EQ(part.features[0].own.max, Point(38, 40, 0));
  EXPECT_EQ(part.features[0].corner_radius_mm, 10.0);
}

TEST(Recognise, ChamfersAndRoundedFloorsOnlyMoveWhereTheWallsAreUpright) {
  VolumeMaker maker(kPocket, {ZPlus});
  RemovedFace chamfer;
  chamfer.at_P = {90.5, 20, -0.5};
  chamfer.normal_P = Point(-1, 0, -1).normalized();
  chamfer.area_mm2 = 1.0;
  chamfer.border_P = {{91, 20, -1}, {90, 20, 0}};
  maker.add(chamfer);
  RemovedFace fillet;
  fillet.surface = FaceSurface::Cylinder;
  fillet.axis_P = Point::UnitY();
  fillet.axis_at_P = {92, 20, -13};
  fillet.radius_mm = 2.0;
  fillet.at_P = {92 - std::sqrt(2.0), 20, -13 - std::sqrt(2.0)};
  fillet.normal_P = Point(-1, 0, -1).normalized();
  fillet.border_P = {{90, 20, -13}, {92, 20, -15}};
  maker.add(fillet);
  const RecognisedPart part = recognised(maker);
  ASSERT_EQ(part.features.size(), 1U) << part.unknown.at(0).why;
  const Feature& pocket = part.features.front();
  EXPECT_EQ(pocket.own.max, kPocket.max);
  EXPECT_EQ(pocket.walls_to_z, -1.0);
  EXPECT_EQ(pocket.walls_from_z, -13.0);
  EXPECT_EQ(pocket.floor_radius_mm, 2.0);
}

TEST(Recognise, WhatStandsInAPocketIsABoss) {
  VolumeMaker maker(kPocket, {ZPlus});
  RemovedFace round = VolumeMaker::upright({110, 22, 0}, 4.0, 0.0, 360.0, kPocket);
  round.normal_P = -round.normal_P;
  maker.add(round);
  maker.volume.volume_mm3 -= 16.0 * std::numbers::pi * 15.0;
  const RecognisedPart part = recognised(maker);
  ASSERT_EQ(part.features.size(), 2U) << part.unknown.at(0).why;
  EXPECT_EQ(name_of(part.features[0].kind), "closed_pocket");
  EXPECT_EQ(part.features[0].own.max, kPocket.max);
  EXPECT_EQ(name_of(part.features[1].kind), "boss");
  EXPECT_EQ(part.features[1].own.min, Point(106, 18, -15));
  EXPECT_EQ(part.features[1].own.max, Point(114, 26, 0));
  // The pocket is less than its box without the boss.
  maker.volume.volume_mm3 -= 10.0;
  EXPECT_EQ(recognised(maker).features.size(), 1U);
}

TEST(Recognise, SaysWhyAVolumeIsOfNoKind) {
  VolumeMaker island(kPocket, {ZPlus});
  island.add_wall({105, 20, -5}, {1, 0, 0});
  EXPECT_NE(kind_of(island).find("an island stands in it"), std::string::npos);

  VolumeMaker draft(kPocket, {ZPlus});
  RemovedFace wall;
  wall.at_P = {91, 20, -7};
  wall.normal_P = {-std::cos(0.05), 0.0, -std::sin(0.05)};
  wall.border_P = {{90, 20, 0}, {92, 20, -15}};
  draft.add(wall);
  EXPECT_NE(kind_of(draft).find("inclined by 2.86 deg"), std::string::npos);  // 0.05 rad

  EXPECT_NE(kind_of({kPocket, {ZPlus, XPlus, XMinus, YPlus, YMinus}}).find("no upright walls"),
            std::string::npos);
  EXPECT_NE(kind_of({kPocket, {ZMinus}}).find("material is above it"), std::string::npos);
  EXPECT_NE(kind_of({kPocket, {ZPlus, ZMinus, XPlus}}).find("open below and at a side"),
            std::string::npos);

  VolumeMaker crooked(kPocket, {ZPlus});
  crooked.add_wall({100, 35, -5}, Point(0.1, 1, 0).normalized());
  EXPECT_NE(kind_of(crooked).find("right angles"), std::string::npos);

  VolumeMaker corner(kPocket, {ZPlus});
  RemovedFace round = VolumeMaker::upright({90, 10, 0}, 4.0, 0.0, 90.0, kPocket);
  round.normal_P = -round.normal_P;
  corner.add(round);
  EXPECT_NE(kind_of(corner).find("rounded outer corner"), std::string::npos);

  VolumeMaker smaller(kPocket, {ZPlus});
  smaller.volume.volume_mm3 *= 0.9;
  EXPECT_NE(kind_of(smaller).find("no rectangle"), std::string::npos);
}

TEST(Recognise, PutsWhatItFindsInTheOrderOfTheirLowerCorners) {
  const VolumeMaker right({{60, 0, -8}, {72, 25, 0}}, {ZPlus, YMinus});
  const VolumeMaker left({{20, 5, -12}, {36, 25, 0}}, {ZPlus});
  const VolumeMaker unknown({{50, 50, -8}, {60, 60, 0}}, {ZPlus, ZMinus, XPlus});
  const RecognisedPart part = recognise(kStock, {right.volume, unknown.volume, left.volume});
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_EQ(part.features[0].box_P.min.x(), 20.0);
  EXPECT_EQ(part.features[1].box_P.min.x(), 60.0);
  ASSERT_EQ(part.unknown.size(), 1U);
  EXPECT_EQ(part.unknown[0].box_P.min, Point(50, 50, -8));
}

}  // namespace
}  // namespace g31::parts::recognise_test

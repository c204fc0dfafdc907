// What Open CASCADE cuts from a block is recognised: every kind in all its
// orientations, upright and turned, on several levels, with the edges that
// tools leave; and what is of no kind has a reason.

#include <functional>
#include <set>
#include <string>
#include <vector>

#include <BRepBuilderAPI_Transform.hxx>
#include <BRepFilletAPI_MakeChamfer.hxx>
#include <BRepFilletAPI_MakeFillet.hxx>
#include <BRepOffsetAPI_DraftAngle.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRep_Tool.hxx>
#include <TopExp.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Edge.hxx>
#include <TopoDS_Vertex.hxx>
#include <fmt/format.h>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include "parts/features/recognise.h"
#include "parts/solids/removal.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/temporary_folder.h"

namespace g31::recognised_solids_test {
namespace {

using parts::Box;
using parts::Side;
using enum parts::Side;
using testing::block;
using testing::cut;
using testing::pin;

const Box kStock{{0, 0, -40}, {160, 110, 0}};
/// Above the stock, so that no upper face of a cut lies in that of the stock.
constexpr double kAbove = 5.0;

TopoDS_Shape pocket(const Box& box) {
  return block({box.min, {box.max.x(), box.max.y(), box.max.z() + kAbove}});
}

parts::RecognisedPart recognised(const std::vector<TopoDS_Shape>& cuts) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("product.step");
  testing::write_step(cut(block(kStock), cuts), "product", path);
  const auto removal = parts::removal_of(path, {"", kStock.max - kStock.min});
  EXPECT_TRUE(removal.ok()) << removal.error();
  return removal ? parts::recognise(removal.value().stock_P, removal.value().volumes)
                 : parts::RecognisedPart{};
}

/// The names of what was found, and why the rest was not.
std::vector<std::string> kinds_of(const parts::RecognisedPart& part) {
  std::vector<std::string> kinds;
  for (const auto& feature : part.features) {
    kinds.emplace_back(name_of(feature.kind));
  }
  for (const auto& unknown : part.unknown) {
    kinds.push_back(unknown.why);
  }
  return kinds;
}

std::set<std::string> open_of(const parts::Feature& feature) {
  std::set<std::string> open;
  for (std::size_t side = 0; side < parts::kSides; ++side) {
    if (feature.open[side]) {
      open.emplace(name_of(static_cast<Side>(side)));
    }
  }
  return open;
}

/// A cuboid in the middle of the stock that reaches its open sides.
Box reaching(const std::vector<Side>& open) {
  Box box{{50, 35, -12}, {110, 75, 0}};
  for (const Side side : open) {
    const auto axis = static_cast<int>(side) / 2;
    (static_cast<int>(side) % 2 == 0 ? box.max : box.min)[axis] =
        (static_cast<int>(side) % 2 == 0 ? kStock.max : kStock.min)[axis];
  }
  return box;
}

TEST(RecognisedSolids, EveryKindInAllItsOrientations) {
  struct Case {
    std::string kind;
    std::vector<Side> open;
  };
  const std::vector<Case> cases = {
      {"closed_pocket", {}},
      {"through_pocket", {ZMinus}},
      {"closed_slot", {XPlus}},
      {"closed_slot", {XMinus}},
      {"closed_slot", {YPlus}},
      {"closed_slot", {YMinus}},
      {"open_slot", {XPlus, XMinus}},
      {"open_slot", {YPlus, YMinus}},
      {"open_pocket", {XPlus, YPlus}},
      {"open_pocket", {XPlus, YMinus}},
      {"open_pocket", {XMinus, YPlus}},
      {"open_pocket", {XMinus, YMinus}},
      {"step", {XPlus, YPlus, YMinus}},
      {"step", {XMinus, YPlus, YMinus}},
      {"step", {XPlus, XMinus, YPlus}},
      {"step", {XPlus, XMinus, YMinus}},
  };
  for (const Case& row : cases) {
    SCOPED_TRACE(row.kind);
    const Box box = reaching(row.open);
    const auto part = recognised({pocket(box)});
    ASSERT_EQ(kinds_of(part), std::vector<std::string>{row.kind});
    std::set<std::string> open = {"+Z"};
    for (const Side side : row.open) {
      open.emplace(name_of(side));
    }
    EXPECT_EQ(open_of(part.features[0]), open);
    EXPECT_LT((part.features[0].box_P.min - box.min).norm(), 1e-6);
    EXPECT_LT((part.features[0].box_P.max - box.max).norm(), 1e-6);
  }
}

TEST(RecognisedSolids, Holes) {
  EXPECT_EQ(kinds_of(recognised({pin({80, 55, -20}, 16, 25)})),
            std::vector<std::string>{"blind_hole"});
  EXPECT_EQ(kinds_of(recognised({pin({80, 55, -50}, 16, 60)})),
            std::vector<std::string>{"through_hole"});
  // With a drill's point of 118 degrees.
  const double point = 8.0 / std::tan(59.0 * std::acos(-1.0) / 180.0);
  const TopoDS_Shape cone =
      BRepPrimAPI_MakeCone(gp_Ax2(gp_Pnt(80, 55, -20 - point), gp_Dir(0, 0, 1)), 0.0, 8.0, point);
  const auto drilled = recognised({pin({80, 55, -20}, 16, 25), cone});
  ASSERT_EQ(kinds_of(drilled), std::vector<std::string>{"blind_hole"});
  EXPECT_FALSE(drilled.features[0].has_flat_floor);
  EXPECT_NEAR(drilled.features[0].walls_from_z, -20.0, 1e-9);
}

TopoDS_Shape turned(const TopoDS_Shape& shape, double angle_deg) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(80, 55, 0), gp_Dir(0, 0, 1)), angle_deg * std::acos(-1.0) / 180.0);
  return BRepBuilderAPI_Transform(shape, turn).Shape();
}

TEST(RecognisedSolids, APocketTurnedInThePlane) {
  for (const double angle : {30.0, -12.5, 44.9}) {
    const auto part = recognised({turned(pocket({{60, 45, -12}, {100, 65, 0}}), angle)});
    ASSERT_EQ(kinds_of(part), std::vector<std::string>{"closed_pocket"});
    const parts::Feature& feature = part.features[0];
    EXPECT_NEAR(feature.axes.angle_deg, angle, 1e-7);
    const Point size = feature.own.max - feature.own.min;
    EXPECT_NEAR(size.x(), 40.0, 1e-6);
    EXPECT_NEAR(size.y(), 20.0, 1e-6);
  }
  const auto slot = recognised({turned(pocket({{-100, 45, -12}, {260, 65, 0}}), 20.0)});
  ASSERT_EQ(kinds_of(slot), std::vector<std::string>{"open_slot"});
  EXPECT_EQ(open_of(slot.features[0]), (std::set<std::string>{"+X", "-X", "+Z"}));
}

TEST(RecognisedSolids, SeveralLevelsAreSplitAtTheirFloors) {
  const auto part =
      recognised({pocket({{50, 35, -10}, {110, 75, 0}}), block({{60, 45, -22}, {90, 65, -9}})});
  ASSERT_EQ(kinds_of(part), (std::vector<std::string>{"closed_pocket", "closed_pocket"}));
  EXPECT_EQ(part.features[0].box_P.min, Point(50, 35, -10));
  EXPECT_EQ(part.features[1].box_P.min, Point(60, 45, -22));
  EXPECT_EQ(part.features[1].box_P.max, Point(90, 65, -10));

  const auto step =
      recognised({pocket({{100, 0, -10}, {160, 110, 0}}), pin({130, 55, -50}, 12, 45)});
  EXPECT_EQ(kinds_of(step), (std::vector<std::string>{"step", "through_hole"}));

  // Stairs: the upper step ends where the lower one begins.
  const auto stairs =
      recognised({pocket({{100, 0, -10}, {160, 110, 0}}), block({{130, 0, -20}, {160, 110, -9}})});
  ASSERT_EQ(kinds_of(stairs), (std::vector<std::string>{"step", "step"}));
  EXPECT_EQ(stairs.features[1].box_P.max, Point(160, 110, -10));

  // A counterbore.
  const auto counterbore = recognised({pin({80, 55, -8}, 24, 13), pin({80, 55, -50}, 12, 55)});
  EXPECT_EQ(kinds_of(counterbore), (std::vector<std::string>{"blind_hole", "through_hole"}));
}

void expect_box(const parts::Feature& feature, const Box& box) {
  EXPECT_LT((feature.own.min - box.min).norm(), 1e-6) << feature.own.min.transpose();
  EXPECT_LT((feature.own.max - box.max).norm(), 1e-6) << feature.own.max.transpose();
}

TEST(RecognisedSolids, WhatStandsFreeInAPocketIsABossOrARib) {
  const Box box{{50, 35, -12}, {110, 75, 0}};
  const auto part = recognised(
      {cut(pocket(box), {pin({65, 55, -20}, 10, 40), pocket({{80, 50, -20}, {100, 56, 10}})})});
  ASSERT_EQ(kinds_of(part), (std::vector<std::string>{"closed_pocket", "boss", "rib"}));
  expect_box(part.features[0], box);
  expect_box(part.features[1], {{60, 50, -12}, {70, 60, 0}});
  expect_box(part.features[2], {{80, 50, -12}, {100, 56, 0}});
  EXPECT_EQ(open_of(part.features[1]), (std::set<std::string>{"+X", "-X", "+Y", "-Y", "+Z"}));
  EXPECT_TRUE(part.features[1].is_round);

  const auto turned_rib =
      recognised({cut(pocket(box), {turned(pocket({{70, 52, -20}, {90, 58, 10}}), 20.0)})});
  ASSERT_EQ(kinds_of(turned_rib), (std::vector<std::string>{"closed_pocket", "rib"}));
  EXPECT_NEAR(turned_rib.features[1].axes.angle_deg, 20.0, 1e-7);
}

TEST(RecognisedSolids, ABossThatIsLowerThanThePocketEndsAtItsTop) {
  const Box box{{50, 35, -12}, {110, 75, 0}};
  const auto part = recognised({cut(pocket(box), {pin({65, 55, -20}, 10, 14)})});
  ASSERT_EQ(kinds_of(part), (std::vector<std::string>{"closed_pocket", "closed_pocket", "boss"}));
  expect_box(part.features[2], {{60, 50, -12}, {70, 60, -6}});
}

TEST(RecognisedSolids, ABossOnAPlateIsAllThatIsFound) {
  const auto part =
      recognised({cut(pocket({{0, 0, -15}, {160, 110, 0}}), {pin({80, 55, -20}, 30, 40)})});
  ASSERT_EQ(kinds_of(part), std::vector<std::string>{"boss"});
  expect_box(part.features[0], {{65, 40, -15}, {95, 70, 0}});
  const auto tube =
      recognised({cut(pocket({{0, 0, -15}, {160, 110, 0}}), {pin({80, 55, -20}, 30, 40)}),
                  pin({80, 55, -10}, 12, 15)});
  EXPECT_EQ(kinds_of(tube), (std::vector<std::string>{"boss", "blind_hole"}));
}

// A stock that is higher: what is faced off is one volume, and no pocket's floor divides another.
TEST(RecognisedSolids, AHigherStockIsDividedAtTheFaceOfThePart) {
  const Box deep{{20, 20, -25}, {60, 50, 0}};
  const Box flat{{90, 60, -6}, {140, 100, 0}};
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("product.step");
  testing::write_step(cut(block(kStock), {pocket(deep), pocket(flat)}), "product", path);
  const auto removal = parts::removal_of(path, {"", kStock.max - kStock.min + Point(0, 0, 10)});
  ASSERT_TRUE(removal.ok()) << removal.error();
  const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
  ASSERT_EQ(part.features.size(), 2U);
  expect_box(part.features[0], deep);
  expect_box(part.features[1], flat);
  ASSERT_EQ(part.unknown.size(), 1U);
  EXPECT_EQ(part.unknown[0].box_P.min, Point(0, 0, 0));
  EXPECT_NE(part.unknown[0].why.find("the stock is higher"), std::string::npos);
}

// A stock that is wider, higher too: what is beside the part is one volume, and the features that
// reach the part's sides are those of a stock that ends there.
TEST(RecognisedSolids, AWiderStockIsDividedAtTheSidesOfThePart) {
  const Box step{{140, 0, -15}, {160, 110, 0}};
  const Box open{{0, 0, -12}, {40, 35, 0}};
  const Box slot{{60, 80, -8}, {80, 110, 0}};
  const Box closed{{60, 20, -25}, {100, 50, 0}};
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("product.step");
  testing::write_step(
      cut(block(kStock), {pocket(step), pocket(open), pocket(slot), pocket(closed)}), "product",
      path);
  for (const Point& wider : {Point(20, 20, 0), Point(20, 0, 0), Point(0, 6, 0), Point(8, 8, 10)}) {
    SCOPED_TRACE(wider.transpose());
    const auto removal = parts::removal_of(path, {"", kStock.max - kStock.min + wider});
    ASSERT_TRUE(removal.ok()) << removal.error();
    const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
    ASSERT_EQ(kinds_of({part.stock_P, part.features, {}}),
              (std::vector<std::string>{"open_pocket", "closed_pocket", "closed_slot", "step"}));
    expect_box(part.features[0], open);
    expect_box(part.features[1], closed);
    expect_box(part.features[2], slot);
    expect_box(part.features[3], step);
    EXPECT_EQ(open_of(part.features[0]), (std::set<std::string>{"-X", "-Y", "+Z"}));
    EXPECT_EQ(open_of(part.features[2]), (std::set<std::string>{"+Y", "+Z"}));
    EXPECT_EQ(open_of(part.features[3]), (std::set<std::string>{"+X", "+Y", "-Y", "+Z"}));
    std::size_t beside = 0;
    for (const parts::UnknownVolume& unknown : part.unknown) {
      const bool is_beside = unknown.why.find("the stock is wider") != std::string::npos;
      beside += is_beside ? 1 : 0;
      EXPECT_TRUE(is_beside || unknown.why.find("the stock is higher") != std::string::npos)
          << unknown.why;
    }
    // A frame round the part, or one piece at either side.
    EXPECT_EQ(beside, wider.x() > 0.0 && wider.y() > 0.0 ? 1U : 2U);
  }
}

/// Rounds the edges of a shape that are chosen.
TopoDS_Shape rounded(const TopoDS_Shape& shape, double radius,
                     const std::function<bool(const gp_Pnt&, const gp_Pnt&)>& is_chosen) {
  BRepFilletAPI_MakeFillet fillet(shape);
  for (TopExp_Explorer each(shape, TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(each.Current());
    const gp_Pnt from = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const gp_Pnt to = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    if (is_chosen(from, to)) {
      fillet.Add(radius, edge);
    }
  }
  return fillet.Shape();
}

bool is_upright(const gp_Pnt& a, const gp_Pnt& b) {
  return std::abs(a.Z() - b.Z()) > 1e-9;
}

TEST(RecognisedSolids, CornersAndFloorsRoundedByATool) {
  const Box box{{50, 35, -12}, {110, 75, 0}};
  const auto corners = recognised({rounded(pocket(box), 6.0, is_upright)});
  ASSERT_EQ(kinds_of(corners), std::vector<std::string>{"closed_pocket"});
  EXPECT_NEAR(corners.features[0].corner_radius_mm, 6.0, 1e-9);
  EXPECT_LT((corners.features[0].box_P.min - box.min).norm(), 1e-6);

  const auto is_of_floor = [](const gp_Pnt& a, const gp_Pnt& b) {
    return a.Z() < -11.0 && b.Z() < -11.0;
  };
  const auto floor = recognised({rounded(rounded(pocket(box), 6.0, is_upright), 2.0, is_of_floor)});
  ASSERT_EQ(kinds_of(floor), std::vector<std::string>{"closed_pocket"});
  EXPECT_NEAR(floor.features[0].floor_radius_mm, 2.0, 1e-9);
  EXPECT_NEAR(floor.features[0].walls_from_z, -10.0, 1e-6);
  EXPECT_LT((floor.features[0].box_P.max - box.max).norm(), 1e-6);

  // As long as it is wide at its ends: a slot of a mill.
  const auto slot = recognised({rounded(pocket({{50, 45, -12}, {110, 65, 0}}), 9.999, is_upright)});
  EXPECT_EQ(kinds_of(slot), std::vector<std::string>{"closed_pocket"});
}

TEST(RecognisedSolids, AChamferAroundTheUpperEdge) {
  const Box box{{50, 35, -12}, {110, 75, 0}};
  const TopoDS_Shape product = cut(block(kStock), {pocket(box)});
  BRepFilletAPI_MakeChamfer chamfer(product);
  for (TopExp_Explorer each(product, TopAbs_EDGE); each.More(); each.Next()) {
    const TopoDS_Edge& edge = TopoDS::Edge(each.Current());
    const gp_Pnt a = BRep_Tool::Pnt(TopExp::FirstVertex(edge));
    const gp_Pnt b = BRep_Tool::Pnt(TopExp::LastVertex(edge));
    const auto is_inside = [](const gp_Pnt& p) {
      return p.Z() > -1e-9 && p.X() > 10 && p.X() < 150 && p.Y() > 10 && p.Y() < 100;
    };
    if (is_inside(a) && is_inside(b)) {
      chamfer.Add(1.0, edge);
    }
  }
  const testing::TemporaryFolder folder;
  testing::write_step(chamfer.Shape(), "product", folder.path("p.step"));
  const auto removal = parts::removal_of(folder.path("p.step"), {"", kStock.max - kStock.min});
  ASSERT_TRUE(removal.ok()) << removal.error();
  const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
  ASSERT_EQ(kinds_of(part), std::vector<std::string>{"closed_pocket"});
  EXPECT_LT((part.features[0].box_P.min - box.min).norm(), 1e-6);
  EXPECT_LT((part.features[0].box_P.max - box.max).norm(), 1e-6);
  EXPECT_NEAR(part.features[0].walls_to_z, -1.0, 1e-6);
}

TEST(RecognisedSolids, WhatIsOfNoKindHasAReason) {
  const Box box{{50, 35, -12}, {110, 75, 0}};
  const auto reason = [](const std::vector<TopoDS_Shape>& cuts) {
    const auto part = recognised(cuts);
    EXPECT_TRUE(part.features.empty());
    return part.unknown.empty() ? "" : part.unknown[0].why;
  };
  // An island that leans against a wall, and one of six sides.
  EXPECT_NE(
      reason({cut(pocket(box), {pocket({{75, 50, -20}, {85, 90, 10}})})}).find("no rectangle"),
      std::string::npos);
  const TopoDS_Shape block_of_island = pocket({{70, 48, -20}, {90, 62, 10}});
  EXPECT_NE(reason({cut(pocket(box), {block_of_island, turned(block_of_island, 45.0)})})
                .find("an island stands in it"),
            std::string::npos);
  // An L.
  EXPECT_NE(reason({pocket({{50, 35, -12}, {110, 50, 0}}), pocket({{50, 35, -12}, {65, 90, 0}})})
                .find("an L"),
            std::string::npos);
  // Two slots that cross.
  EXPECT_NE(reason({pocket({{0, 45, -12}, {160, 60, 0}}), pocket({{70, 0, -12}, {90, 110, 0}})})
                .find("open"),
            std::string::npos);
  // A notch through the whole height.
  EXPECT_NE(reason({block({{140, 90, -50}, {170, 120, 10}})}).find("open below and at a side"),
            std::string::npos);
}

TEST(RecognisedSolids, InclinedWallsHaveTheirAngle) {
  const TopoDS_Shape upright = pocket({{50, 35, -12}, {110, 75, 0}});
  BRepOffsetAPI_DraftAngle draft(upright);
  for (TopExp_Explorer each(upright, TopAbs_FACE); each.More(); each.Next()) {
    Box box;
    for (TopExp_Explorer corner(each.Current(), TopAbs_VERTEX); corner.More(); corner.Next()) {
      const gp_Pnt p = BRep_Tool::Pnt(TopoDS::Vertex(corner.Current()));
      box.include(Point(p.X(), p.Y(), p.Z()));
    }
    if (box.max.z() - box.min.z() > 1.0) {
      draft.Add(TopoDS::Face(each.Current()), gp_Dir(0, 0, 1), -3.0 * std::acos(-1.0) / 180.0,
                gp_Pln(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)));
    }
  }
  draft.Build();
  ASSERT_TRUE(draft.IsDone());
  const auto part = recognised({draft.Shape()});
  ASSERT_EQ(part.unknown.size(), 1U);
  EXPECT_EQ(part.unknown[0].why, "one of its walls is inclined by 3 deg");
}

}  // namespace
}  // namespace g31::recognised_solids_test

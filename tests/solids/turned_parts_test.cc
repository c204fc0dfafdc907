// A product and its stock turned about Z: sizes along the features' own axes, from STEP and from
// meshes, whose coordinates are rounded to 24 bits.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <string>
#include <utility>

#include <BRepBuilderAPI_Transform.hxx>
#include <fmt/format.h>
#include <gp_Ax1.hxx>
#include <gp_Trsf.hxx>
#include <gtest/gtest.h>

#include "parts/import/step_file.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"
#include "tools/plan/plan_part.h"

namespace g31::turned_parts_test {
namespace {

const parts::Box kStock{{0, 0, -40}, {100, 60, 0}};

TopoDS_Shape turned(const TopoDS_Shape& shape, double angle_deg) {
  gp_Trsf turn;
  turn.SetRotation(gp_Ax1(gp_Pnt(0, 0, 0), gp_Dir(0, 0, 1)), angle_deg * std::numbers::pi / 180.0);
  return BRepBuilderAPI_Transform(shape, turn).Shape();
}

/// A text OBJ of the facets of a STEP file.
std::string obj_of(const std::string& step) {
  const auto mesh = parts::read_step_file(step, 0.01);
  EXPECT_TRUE(mesh.ok()) << mesh.error();
  std::string text;
  for (const Point& p : mesh.value().vertices) {
    text += fmt::format("v {} {} {}\n", p.x(), p.y(), p.z());
  }
  for (const auto& t : mesh.value().triangles) {
    text += fmt::format("f {} {} {}\n", t[0] + 1, t[1] + 1, t[2] + 1);
  }
  return text;
}

enum class As { Step, Obj };

/// Plans a shape cut from kStock, both turned.
plan::PlannedPart planned(const TopoDS_Shape& shape, double angle_deg, As as) {
  const testing::TemporaryFolder folder;
  plan::PlanRequest request;
  request.product = folder.path("product.step");
  request.stock = folder.path("stock.step");
  testing::write_step(turned(shape, angle_deg), "product", request.product);
  testing::write_step(turned(testing::block(kStock), angle_deg), "stock", request.stock);
  if (as == As::Obj) {
    request.product = folder.write("product.obj", obj_of(request.product));
    request.stock = folder.write("stock.obj", obj_of(request.stock));
  }
  request.folder = folder.path("");
  auto made = plan::plan_part(request);
  EXPECT_TRUE(made.ok()) << made.error().message;
  return made ? std::move(made.value()) : plan::PlannedPart{};
}

/// @param sizes  "F1.X": of each size that is to be measured, along axes within 45 deg of X and Y
void expect_sizes(const plan::PlannedPart& part, double angle_deg,
                  const std::map<std::string, double>& sizes) {
  EXPECT_TRUE(part.part.unknown.empty()) << part.part.unknown.front().why;
  EXPECT_TRUE(part.plan.left_out.empty()) << part.plan.left_out.front().why;
  for (const parts::Feature& feature : part.part.features) {
    EXPECT_NEAR(feature.axes.angle_deg, angle_deg, 1e-4);
  }
  std::size_t found = 0;
  for (std::size_t i = 0; i < part.plan.measures.size(); ++i) {
    const probe::PlannedMeasure& measure = part.plan.measures[i];
    if (measure.what == probe::Characteristic::Size) {
      SCOPED_TRACE(measure.id);
      EXPECT_NEAR(measure.nominal, sizes.at(measure.id), 5e-5);
      EXPECT_NEAR(part.proven_values[i].value_or(-1.0), sizes.at(measure.id), 5e-5);
      ++found;
    }
  }
  EXPECT_EQ(found, sizes.size());
}

TEST(TurnedParts, SlotsWithAnOpenSideAreMeasuredAlongTheirOwnAxes) {
  const TopoDS_Shape slot =
      testing::cut(testing::block(kStock), {testing::block({{80, 0, -12}, {90, 15, 0}})});
  for (const As as : {As::Step, As::Obj}) {
    for (const double angle_deg : testing::some_of(std::vector{-35.0, 7.0, 20.0, 30.0, 44.0})) {
      SCOPED_TRACE(fmt::format("{} deg, {}", angle_deg, as == As::Step ? "STEP" : "OBJ"));
      expect_sizes(planned(slot, angle_deg, as), angle_deg,
                   {{"F1.X", 10.0}, {"F1.Y", 15.0}, {"F1.Z", 12.0}});
    }
  }
}

TEST(TurnedParts, PocketsAreMeasuredAlongTheirOwnAxes) {
  const TopoDS_Shape pockets = testing::cut(
      testing::block(kStock),
      {testing::block({{30, 20, -15}, {70, 45, 0}}), testing::block({{80, 10, -10}, {95, 40, 0}})});
  for (const As as : {As::Step, As::Obj}) {
    for (const double angle_deg : testing::some_of(std::vector{-10.0, 20.0, 30.0})) {
      SCOPED_TRACE(fmt::format("{} deg, {}", angle_deg, as == As::Step ? "STEP" : "OBJ"));
      expect_sizes(planned(pockets, angle_deg, as), angle_deg,
                   {{"F1.X", 40.0},
                    {"F1.Y", 25.0},
                    {"F1.Z", 15.0},
                    {"F2.X", 15.0},
                    {"F2.Y", 30.0},
                    {"F2.Z", 10.0}});
    }
  }
}

// The block itself is not turned: no plane is at right angles to the slot's walls where it is open.
TEST(TurnedParts, ATurnedSlotInAStraightBlockHasNoLength) {
  const TopoDS_Shape slot = turned(testing::block({{40, -40, -12}, {50, 15, 0}}), 10.0);
  const plan::PlannedPart part =
      planned(testing::cut(testing::block(kStock), {slot}), 0.0, As::Step);
  ASSERT_EQ(part.plan.left_out.size(), 1U);
  EXPECT_EQ(part.plan.left_out[0].axis, 'Y');
  EXPECT_EQ(part.plan.left_out[0].why, "its open side is not at right angles to its walls");
}

}  // namespace
}  // namespace g31::turned_parts_test

// STEP as different systems write it: protocols, units, several bodies, assemblies with placements.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRep_Builder.hxx>
#include <Interface_Static.hxx>
#include <STEPControl_Controller.hxx>
#include <TopLoc_Location.hxx>
#include <TopoDS_Compound.hxx>
#include <gp_Trsf.hxx>
#include <gp_Vec.hxx>
#include <gtest/gtest.h>

#include "parts/features/recognise.h"
#include "parts/import/step_file.h"
#include "parts/solids/removal.h"
#include "tests/probe/test_meshes.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/temporary_folder.h"

namespace g31::step_dialects_test {
namespace {

using testing::block;

/// A block of 100 x 80 x 30 with a pocket of 40 x 20 x 10.
TopoDS_Shape pocketed() {
  return testing::cut(block({{0, 0, -30}, {100, 80, 0}}), {block({{30, 30, -10}, {70, 50, 0}})});
}

/// What a product of a shape is made of.
parts::RecognisedPart read_back(const TopoDS_Shape& shape, const std::string& unit = "MM") {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("part.step");
  testing::write_step(shape, "part", path, unit);
  const auto removal = parts::removal_of(path, {});
  EXPECT_TRUE(removal.ok()) << removal.error();
  return removal ? parts::recognise(removal.value().stock_P, removal.value().volumes)
                 : parts::RecognisedPart{};
}

void expect_pocket(const parts::RecognisedPart& part, const Point& min) {
  ASSERT_EQ(part.features.size(), 1U);
  EXPECT_EQ(name_of(part.features[0].kind), "closed_pocket");
  EXPECT_LT((part.features[0].box_P.min - min).norm(), 1e-6);
  EXPECT_LT((part.features[0].box_P.max - min - Point(40, 20, 10)).norm(), 1e-6);
}

TEST(StepDialects, Protocols) {
  STEPControl_Controller::Init();
  for (const char* const schema : {"AP203", "AP214IS", "AP242DIS"}) {
    SCOPED_TRACE(schema);
    ASSERT_TRUE(Interface_Static::SetCVal("write.step.schema", schema));
    expect_pocket(read_back(pocketed()), {30, 30, -10});
  }
  Interface_Static::SetCVal("write.step.schema", "AP214IS");
}

TEST(StepDialects, Units) {
  for (const char* const unit : {"INCH", "M", "CM"}) {
    SCOPED_TRACE(unit);
    expect_pocket(read_back(pocketed(), unit), {30, 30, -10});
  }
}

TEST(StepDialects, AnAssemblyWithPlacements) {
  gp_Trsf move;
  move.SetTranslation(gp_Vec(500, -200, 40));
  TopoDS_Compound assembly;
  BRep_Builder builder;
  builder.MakeCompound(assembly);
  builder.Add(assembly, pocketed().Moved(TopLoc_Location(move)));
  expect_pocket(read_back(assembly), {530, -170, 30});
}

TEST(StepDialects, TwoBodiesAreOneProduct) {
  gp_Trsf beside;
  beside.SetTranslation(gp_Vec(100, 0, 0));
  TopoDS_Compound bodies;
  BRep_Builder builder;
  builder.MakeCompound(bodies);
  builder.Add(bodies, pocketed());
  builder.Add(bodies, pocketed().Moved(TopLoc_Location(beside)));
  const auto part = read_back(bodies);
  ASSERT_EQ(part.features.size(), 2U);
  EXPECT_EQ(part.features[1].box_P.min, Point(130, 30, -10));
  EXPECT_TRUE(part.unknown.empty());
}

TEST(StepDialects, AStockOfItsOwn) {
  const testing::TemporaryFolder folder;
  testing::write_step(pocketed(), "part", folder.path("part.step"));
  testing::write_step(block({{0, 0, -30}, {120, 80, 0}}), "stock", folder.path("stock.step"));
  const auto removal = parts::removal_of(folder.path("part.step"), {folder.path("stock.step"), {}});
  ASSERT_TRUE(removal.ok()) << removal.error();
  // The pocket, and the strip at +X, which is open all around.
  ASSERT_EQ(removal.value().volumes.size(), 2U);
  const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
  expect_pocket(part, {30, 30, -10});
  ASSERT_EQ(part.unknown.size(), 1U);
  EXPECT_EQ(part.unknown[0].box_P.min, Point(100, 0, -30));

  testing::write_step(block({{0, 0, -30}, {90, 80, 0}}), "stock", folder.path("small.step"));
  const auto outside = parts::removal_of(folder.path("part.step"), {folder.path("small.step"), {}});
  ASSERT_FALSE(outside.ok());
  EXPECT_NE(outside.error().find("10 mm outside of the stock on its +X side"), std::string::npos)
      << outside.error();
}

// Millimetres that are taken for metres.
TEST(StepDialects, APartOfManyMetresIsRefused) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("part.step");
  testing::write_step(block({{0, 0, 0}, {100'000, 80'000, 30'000}}), "part", path);
  const auto removal = parts::removal_of(path, {});
  ASSERT_FALSE(removal.ok());
  EXPECT_NE(removal.error().find("is its unit right?"), std::string::npos) << removal.error();
}

// As a translator writes countersinks: the seam line of the cone misses the plane of its axis by
// the noise of floats, and is opposite to where the angle around the axis begins.
TEST(StepDialects, DirectionsOffAnAxisByNoise) {
  constexpr double kSagitta = 1e-3;
  const auto mesh = parts::read_step_file("tests/solids/frustum.step", kSagitta);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_TRUE(testing::is_closed_and_oriented(mesh.value()));
  // Radii 5 and 11, 6 apart; the wall lacks up to the sagitta.
  const double frustum = std::numbers::pi * 6.0 / 3.0 * (25.0 + 55.0 + 121.0);
  const double wall = std::numbers::pi * (5.0 + 11.0) * std::hypot(6.0, 6.0);
  EXPECT_LT(testing::enclosed_volume(mesh.value()), frustum);
  EXPECT_GT(testing::enclosed_volume(mesh.value()), frustum - kSagitta * wall);
}

}  // namespace
}  // namespace g31::step_dialects_test

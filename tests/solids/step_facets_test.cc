// The facets of STEP files cover each face, whichever way Open CASCADE takes to make them.

#include <cmath>
#include <numbers>
#include <string>
#include <vector>

#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepBuilderAPI_MakePolygon.hxx>
#include <BRepPrimAPI_MakeCone.hxx>
#include <BRepPrimAPI_MakeCylinder.hxx>
#include <BRepPrimAPI_MakePrism.hxx>
#include <BRep_Builder.hxx>
#include <TopExp_Explorer.hxx>
#include <TopoDS_Compound.hxx>
#include <TopoDS_Shell.hxx>
#include <TopoDS_Wire.hxx>
#include <gp_Ax2.hxx>
#include <gp_Pln.hxx>
#include <gp_Vec.hxx>
#include <gtest/gtest.h>

#include "parts/import/step_file.h"
#include "tests/probe/test_meshes.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/effort.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tools/cli/run_options.h"
#include "tools/plan/plan_part.h"

namespace g31::step_facets_test {
namespace {

constexpr double kQuarter = 0.5 * std::numbers::pi;

Result<parts::Mesh, std::string> facets_of(const TopoDS_Shape& shape, double sagitta_mm) {
  const testing::TemporaryFolder folder;
  const std::string path = folder.path("part.step");
  testing::write_step(shape, "part", path);
  return parts::read_step_file(path, sagitta_mm);
}

TopoDS_Wire wire_through(const std::vector<gp_Pnt>& corners) {
  BRepBuilderAPI_MakePolygon outline;
  for (const gp_Pnt& corner : corners) {
    outline.Add(corner);
  }
  outline.Close();
  return outline.Wire();
}

/// A square with a hole that goes beyond its outline.
TopoDS_Shape crossed_face() {
  BRepBuilderAPI_MakeFace face(gp_Pln(gp_Pnt(0, 0, 5), gp_Dir(0, 0, 1)),
                               wire_through({{0, 0, 5}, {10, 0, 5}, {10, 10, 5}, {0, 10, 5}}));
  face.Add(wire_through({{2, 2, 5}, {2, 4, 5}, {14, 4, 5}, {14, 2, 5}}));
  return face.Shape();
}

/// @param exact    volume
/// @param arcs_mm2 area of the round walls: facets are off by the sagitta there
void expect_solid(const TopoDS_Shape& shape, double sagitta_mm, double exact, double arcs_mm2) {
  const auto mesh = facets_of(shape, sagitta_mm);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_TRUE(testing::is_closed_and_oriented(mesh.value()));
  EXPECT_NEAR(testing::enclosed_volume(mesh.value()), exact, sagitta_mm * arcs_mm2 + 1e-6);
}

// All corners of such a face lie on a circle but the one in its middle.
TEST(StepFacets, CoverAQuarterOfADisc) {
  for (const double radius : testing::some_of(
           std::vector{2.0, 6.0, 14.0, 20.0, 22.0, 25.0, 30.0, 36.0, 40.0, 42.0, 45.0})) {
    for (const double sagitta : {0.01, 0.001}) {
      SCOPED_TRACE(radius);
      const double wall = kQuarter * radius;
      expect_solid(BRepPrimAPI_MakeCylinder(radius, 30.0, kQuarter).Shape(), sagitta,
                   wall * radius / 2.0 * 30.0, wall * 30.0);
      expect_solid(testing::cut(testing::block({{0, 0, -30}, {150, 100, 0}}),
                                {testing::pin({0, 0, -12}, 2.0 * radius, 12)}),
                   sagitta, 150.0 * 100.0 * 30.0 - wall * radius / 2.0 * 12.0, wall * 12.0);
    }
  }
}

// With thousands of corners the quick way of meshing comes first, which breaks off here.
TEST(StepFacets, AreMadeTheSureWayWhereTheQuickOneBreaksOff) {
  constexpr double kRadius = 14.0;
  constexpr double kSagitta = 1e-6;
  const double wall = kQuarter * kRadius;
  expect_solid(BRepPrimAPI_MakeCylinder(kRadius, 30.0, kQuarter).Shape(), kSagitta,
               wall * kRadius / 2.0 * 30.0, wall * 30.0);
}

TEST(StepFacets, ThatCannotCoverAFaceAreRefused) {
  const auto mesh = facets_of(crossed_face(), 0.01);
  ASSERT_FALSE(mesh.ok());
  EXPECT_NE(mesh.error().find("does not cover its face 1 (with a corner at X0.000 Y0.000 Z5.000)"),
            std::string::npos)
      << mesh.error();
  EXPECT_NE(mesh.error().find("step_sagitta"), std::string::npos) << mesh.error();
}

/// @param whole  a new compound or shell
TopoDS_Shape with(TopoDS_Shape whole, const std::vector<TopoDS_Shape>& parts) {
  const BRep_Builder builder;
  for (const TopoDS_Shape& part : parts) {
    builder.Add(whole, part);
  }
  return whole;
}

TopoDS_Shape together(const std::vector<TopoDS_Shape>& shapes) {
  TopoDS_Compound all;
  BRep_Builder().MakeCompound(all);
  return with(all, shapes);
}

TopoDS_Shape shell_of(const std::vector<TopoDS_Shape>& faces) {
  TopoDS_Shell shell;
  BRep_Builder().MakeShell(shell);
  return with(shell, faces);
}

TopoDS_Shape plane_face(double z_mm) {
  return BRepBuilderAPI_MakeFace(
             wire_through({{0, 0, z_mm}, {9, 0, z_mm}, {9, 9, z_mm}, {0, 9, z_mm}}))
      .Shape();
}

/// What a run says of the part in a STEP file, whose top a touch along Z meets at `top_mm`.
std::string told_of(const TopoDS_Shape& shape, double top_mm) {
  const testing::TemporaryFolder folder;
  testing::write_step(shape, "part", folder.path("part.step"));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nG91 G31 Z-100. F100.\n#1=#5063\nM30\n")};
  options.setups = {folder.write("sheet.toml",
                                 "[probe]\nlength = 100.0\n[machine]\nstopping = \"ideal\"\n"
                                 "[[part]]\nfile = \"part.step\"\nat = [-4.0, -3.0, 0.0]\n"
                                 "[start]\nZ = 180.0\n")};
  options.prints = {"#5063"};
  const testing::RunOutput output = testing::run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  // Of the spindle nose: the probe of 100 mm ends in a ball with a radius of 3 mm.
  EXPECT_EQ(output.document["variables"]["#5063"], top_mm + 103.0);
  return output.errors;
}

// Reference planes and surfaces that a body was cut with are no material.
TEST(StepFacets, AreOfTheBodiesWhereAFileHasAny) {
  const TopoDS_Shape block = testing::block({{0, 0, 0}, {10, 10, 10}});
  EXPECT_EQ(told_of(block, 10.0), "");
  const std::string one = told_of(together({shell_of({plane_face(20)}), block}), 10.0);
  EXPECT_NE(one.find("note: surfaces beside the bodies of a part are no material: 1 of the faces "
                     "in the file of 'part' belongs to no solid and no closed shell"),
            std::string::npos)
      << one;
  const auto mesh =
      facets_of(together({block, shell_of({plane_face(20)}), shell_of({plane_face(30)})}), 0.01);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_EQ(mesh.value().faces_left_out, 2U);
  EXPECT_TRUE(testing::is_closed_and_oriented(mesh.value()));
  EXPECT_NEAR(testing::enclosed_volume(mesh.value()), 1000.0, 1e-9);
}

TEST(StepFacets, AreOfClosedShellsToo) {
  std::vector<TopoDS_Shape> faces;
  const TopoDS_Shape upper = testing::block({{0, 0, 20}, {10, 10, 25}});
  for (TopExp_Explorer each(upper, TopAbs_FACE); each.More(); each.Next()) {
    faces.push_back(each.Current());
  }
  const auto mesh =
      facets_of(together({testing::block({{0, 0, 0}, {10, 10, 10}}), shell_of(faces)}), 0.01);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_EQ(mesh.value().faces_left_out, 0U);
  EXPECT_NEAR(testing::enclosed_volume(mesh.value()), 1500.0, 1e-9);
}

TEST(StepFacets, AreOfAllSurfacesWhereAFileHasNoBody) {
  const auto mesh = facets_of(shell_of({plane_face(20)}), 0.01);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  EXPECT_EQ(mesh.value().faces_left_out, 0U);
  EXPECT_EQ(mesh.value().triangles.size(), 2U);
}

TEST(StepFacets, ThatCannotBeMadeAreNoMistakeOfThePlannedSheet) {
  const TopoDS_Shape both =
      together({testing::cut(testing::block({{0, 0, -30}, {100, 80, 0}}),
                             {testing::block({{30, 30, -10}, {70, 50, 0}})}),
                BRepPrimAPI_MakePrism(crossed_face(), gp_Vec(0, 0, 5)).Shape()});
  const testing::TemporaryFolder folder;
  plan::PlanRequest request;
  request.product = folder.path("part.step");
  testing::write_step(both, "part", request.product);
  request.stock = "box";
  request.folder = folder.path("");
  const auto planned = plan::plan_part(request);
  ASSERT_FALSE(planned.ok());
  EXPECT_EQ(planned.error().ending, session::Ending::BadInput);
  EXPECT_NE(planned.error().message.find("does not cover its face"), std::string::npos)
      << planned.error().message;
}

// Facets without area are the import's own: who has a STEP file can do nothing about them.
TEST(StepFacets, OfADrillPointAreNothingToTell) {
  constexpr double kRadius = 6.0;
  const double tip = kRadius / std::tan(59.0 * std::numbers::pi / 180.0);
  const gp_Ax2 axes(gp_Pnt(25, 25, -20), gp_Dir(0, 0, -1));
  const testing::TemporaryFolder folder;
  plan::PlanRequest request;
  request.product = folder.path("drilled.step");
  testing::write_step(testing::cut(testing::block({{0, 0, -40}, {50, 50, 0}}),
                                   {testing::pin({25, 25, -20}, 2.0 * kRadius, 20),
                                    BRepPrimAPI_MakeCone(axes, kRadius, 0.0, tip).Shape()}),
                      "part", request.product);
  request.stock = "box";
  request.folder = folder.path("");
  const auto planned = plan::plan_part(request);
  ASSERT_TRUE(planned.ok()) << planned.error().message;
  EXPECT_EQ(planned.value().notes, "");
}

}  // namespace
}  // namespace g31::step_facets_test

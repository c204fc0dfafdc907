// A cylinder of radius 10 mm, from z = -20 to 0, as STEP.  Where g31 is built without Open CASCADE
// there is nothing to read it with, and the tests say so.

#include "parts/import/step_file.h"

#include <cmath>
#include <filesystem>
#include <fstream>
#include <numbers>
#include <string>

#include <gtest/gtest.h>
#include <unistd.h>

#include "parts/import/mesh_file.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::step_file_test {
namespace {

const char* const kCylinder = "tests/parts/cylinder.step";

class StepReader : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!can_read_step()) {
      GTEST_SKIP()
          << "no module that reads STEP: Debian libocct-data-exchange-dev, then build again";
    }
  }
};

TEST(StepFile, IsKnownByItsEnding) {
  for (const char* path : {"a.step", "a.stp", "A.STP", "/x.y/part.Step"}) {
    EXPECT_TRUE(is_step_file(path)) << path;
  }
  for (const char* path : {"a.stl", "step", "a.step.stl", ".stepx", ""}) {
    EXPECT_FALSE(is_step_file(path)) << path;
  }
}

TEST_F(StepReader, MakesAClosedMeshWithinTheSagitta) {
  constexpr double kRadius = 10.0;
  for (const double sagitta : {0.1, 0.01, 0.001}) {
    SCOPED_TRACE(sagitta);
    const auto read = read_mesh_file(kCylinder, {sagitta, "", 1.0});
    ASSERT_TRUE(read.ok()) << read.error();
    const Mesh& mesh = read.value();
    EXPECT_TRUE(testing::is_closed_and_oriented(mesh));
    // Corners on the cylinder: the volume is too small, by less than a skin as thick as the
    // sagitta.
    const double exact = std::numbers::pi * kRadius * kRadius * 20.0;
    EXPECT_LT(testing::enclosed_volume(mesh), exact);
    EXPECT_GT(testing::enclosed_volume(mesh),
              exact - sagitta * 2.0 * std::numbers::pi * kRadius * 20.0);
    for (const auto& t : mesh.triangles) {
      const double z = mesh.vertices[t[0]].z();
      const bool is_wall = mesh.vertices[t[1]].z() != z || mesh.vertices[t[2]].z() != z;
      for (std::size_t i = 0; i < 3; ++i) {
        const Point& a = mesh.vertices[t[i]];
        const Point& b = mesh.vertices[t[(i + 1) % 3]];
        EXPECT_NEAR(a.head<2>().norm(), kRadius, 1e-9);
        EXPECT_TRUE(std::fabs(a.z()) < 1e-9 || std::fabs(a.z() + 20.0) < 1e-9);
        if (is_wall) {
          EXPECT_GE((0.5 * (a + b)).head<2>().norm(), kRadius - sagitta);
        }
      }
    }
  }
}

TEST_F(StepReader, SaysWhatIsWrong) {
  const auto folder = std::filesystem::temp_directory_path();
  const std::string path = (folder / ("g31_step_" + std::to_string(::getpid()) + ".stp")).string();
  for (const char* text : {"", "not a STEP file\n", "ISO-10303-21;\nHEADER;\nENDSEC;\nDATA;\n"}) {
    std::ofstream(path, std::ios::binary) << text;
    ::testing::internal::CaptureStdout();
    const auto read = read_mesh_file(path);
    EXPECT_EQ(::testing::internal::GetCapturedStdout(), "") << "that is the program's own output";
    ASSERT_FALSE(read.ok()) << text;
    EXPECT_NE(read.error().find("STEP"), std::string::npos) << read.error();
  }
  std::filesystem::remove(path);
}

}  // namespace
}  // namespace g31::parts::step_file_test

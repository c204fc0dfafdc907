// A hole in a plane that G68.2 tilts, measured by the G100 family with the tool turned to it by
// G53.1: it reads as large as it is and where it is, in the coordinates of the plane.

#include <cmath>
#include <numbers>
#include <random>
#include <string>

#include <Eigen/Geometry>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/effort.h"
#include "tests/support/run_program.h"

namespace g31::tilted_hole_test {
namespace {

using Eigen::AngleAxisd;
using Eigen::Matrix3d;
using Eigen::Vector3d;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr double kRadians = std::numbers::pi / 180.0;

/// The control, the probe and what G100 and G120 need.
const char* const kCommon = R"([control]
profile = "fanuc-30i"
[macro_calls]
G100 = 9010
G120 = 9013
[variables]
"#515" = 6.0
"#516" = 123.0
"#517" = 0.0
"#518" = 0.0
"#519" = 0.0
"#530" = 0.0
"#531" = 0.0
[start]
X = 0.0
Y = 0.0
Z = 400.0
[tools.99]
length = 120.0
radius = 3.0
[probe]
ball_diameter = 6.0
length = 120.0
)";

struct Machine {
  const char* name;
  const char* sheet;
  Vector3d origin;  ///< of G54
};

const Machine kMachines[] = {
    {"tables",
     R"([machine]
table_side = "CA"
tool_side = "XYZ"
[machine.axes.A]
travel = [-120.0, 120.0]
centre = [0.0, 20.0, -450.0]
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [5.0, -3.0, 0.0]
)",
     {40, -25, -380}},
    {"head and table",
     R"([machine]
table_side = "C"
tool_side = "XYZB"
[machine.axes.B]
travel = [-95.0, 110.0]
centre = [10.0, 0.0, 180.0]
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [200.0, -150.0, -500.0]
)",
     {230, -120, -420}},
    {"heads",
     R"([machine]
table_side = ""
tool_side = "XYZCA"
[machine.axes.C]
travel = [-36000.0, 36000.0]
centre = [0.0, 5.0, 0.0]
[machine.axes.A]
travel = [-110.0, 110.0]
centre = [0.0, -8.0, 220.0]
)",
     {300, 100, -500}},
};

/// A plane, and a hole in it.
struct Tilted {
  Vector3d p_W_plane;  ///< origin
  Vector3d euler_deg;  ///< about Z, the new X, the new Z
  Vector3d p_hole;     ///< in the plane
  double bore = 0.0;
};

Tilted random_set_up(std::mt19937& random) {
  const auto within = [&](double most) {
    const double value = std::uniform_real_distribution<>(-most, most)(random);
    return std::round(value * 1000.0) / 1000.0;  // as a program writes it
  };
  Tilted s;
  s.p_W_plane = {within(40), within(40), within(20)};
  s.euler_deg = {within(180), within(40), within(180)};
  s.p_hole = {within(15), within(15), 0.0};
  s.bore = 30.0 + within(8);
  return s;
}

Matrix3d turned(const Tilted& s) {
  return (AngleAxisd(s.euler_deg.x() * kRadians, Vector3d::UnitZ()) *
          AngleAxisd(s.euler_deg.y() * kRadians, Vector3d::UnitX()) *
          AngleAxisd(s.euler_deg.z() * kRadians, Vector3d::UnitZ()))
      .toRotationMatrix();
}

std::string sheet_of(const Machine& machine, const Tilted& s) {
  const Matrix3d m = turned(s);
  const Vector3d at = machine.origin + s.p_W_plane + m * s.p_hole;
  return fmt::format(
      "{}{}[work_offsets.G54]\nX = {:.1f}\nY = {:.1f}\nZ = {:.1f}\n"
      "[[part]]\nname = \"ring\"\nshape = \"ring\"\nbore = {:.17g}\nouter_diameter = 80.0\n"
      "height = 20.0\nat = [{:.17g}, {:.17g}, {:.17g}]\nrotate_deg = [{:.17g}, {:.17g}, {:.17g}]\n",
      kCommon, machine.sheet, machine.origin.x(), machine.origin.y(), machine.origin.z(), s.bore,
      at.x(), at.y(), at.z(), std::atan2(m(2, 1), m(2, 2)) / kRadians,
      std::asin(-m(2, 0)) / kRadians, std::atan2(m(1, 0), m(0, 0)) / kRadians);
}

std::string program_of(const Tilted& s) {
  return fmt::format(
      "%\nO1\nG54 G90 G00\nG43 H99\nG68.2 X{:.3f} Y{:.3f} Z{:.3f} I{:.3f} J{:.3f} K{:.3f}\nG53.1\n"
      "G0 Z150.\nX{:.3f} Y{:.3f}\nZ50.\nG100 U50. R5. Z-7.5 A1.\nG100 V50. R5. Z-7.5 A2.\n"
      "G100 U-50. R5. Z-7.5 A3.\nG120 A123. H0 C1.\nG69\nM30\n%\n",
      s.p_W_plane.x(), s.p_W_plane.y(), s.p_W_plane.z(), s.euler_deg.x(), s.euler_deg.y(),
      s.euler_deg.z(), s.p_hole.x(), s.p_hole.y());
}

TEST(TiltedHole, ReadsItsTrueSizeAndPlace) {
  std::mt19937 random(22);
  const int rounds = testing::of_many(67);
  for (int round = 0; round < rounds; ++round) {
    for (const Machine& machine : kMachines) {
      const Tilted s = random_set_up(random);
      TemporaryFolder folder;
      cli::RunOptions options;
      options.programs = {folder.write("hole.nc", program_of(s)), "macros/fanuc/O9010.nc",
                          "macros/fanuc/O9013.nc", "macros/fanuc/O9016.nc"};
      options.setups = {folder.write("hole.toml", sheet_of(machine, s))};
      options.prints = {"#105,#120,#150"};
      const RunOutput output = testing::run_program(options);
      SCOPED_TRACE(
          fmt::format("{}, round {}\n{}{}", machine.name, round, program_of(s), output.errors));
      ASSERT_EQ(output.exit_code, 0);
      const auto& read = output.document.at("variables");
      EXPECT_NEAR(read.at("#105").get<double>(), s.p_hole.x(), 1e-6);
      EXPECT_NEAR(read.at("#120").get<double>(), s.p_hole.y(), 1e-6);
      EXPECT_NEAR(read.at("#150").get<double>(), s.bore, 1e-6);
    }
  }
}

}  // namespace
}  // namespace g31::tilted_hole_test

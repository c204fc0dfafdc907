// Mills that turn above a beam of light that is much narrower than they are.

#include <cmath>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::testing::laser_teeth_test {
namespace {

constexpr double kFeed = 5.0;      // mm/min
constexpr double kSpeed = 1000.0;  // turns a minute
constexpr double kLength = 100.0;  // of the tool, mm
constexpr double kBeam = -400.0;   // machine Z of the beam's middle

struct Mill {
  double diameter;
  int teeth;
};

std::string sheet_of(const Mill& mill, double beam) {
  std::string teeth;
  for (int i = 0; i < mill.teeth; ++i) {
    teeth += fmt::format("{}{{ angle_deg = {} }}", i == 0 ? "" : ", ", 360.0 * i / mill.teeth);
  }
  return fmt::format(
      "[machine]\nstopping = \"ideal\"\n[[tool]]\nnumber = 1\nkind = \"mill\"\nlength = {}\n"
      "diameter = {}\nteeth = [{}]\n[[tool_probe]]\nname = \"laser\"\nshape = \"laser\"\n"
      "size = [200.0, {}]\nat = [0.0, 0.0, {}]\n",
      kLength, mill.diameter, teeth, beam, kBeam);
}

/// How much lower than the top of the beam the mill is when it breaks it, mm.
double depth_at_break(const Mill& mill, double beam, double beside, double start) {
  const TemporaryFolder folder;
  const std::string program = fmt::format(
      "O1\nT1 M6\nM3 S{:.0f}\nG0 X0. Y{:.4f}\nZ{:.4f}\nG31 Z-320. F{:.1f}\n#501=#5063\nM30\n",
      kSpeed, beside, kBeam + kLength + start, kFeed);
  const auto run = g31({"run", folder.write("case.nc", program), "-s",
                        folder.write("sheet.toml", sheet_of(mill, beam)), "--print", "#501", "-q"});
  EXPECT_EQ(run.exit_code, 0) << run.errors;
  const std::size_t value = run.out.find("= ");
  EXPECT_NE(value, std::string::npos) << run.out;
  return kBeam + kLength + beam / 2.0 - std::stod(run.out.substr(value + 2));
}

/// The outer corner of each tooth, which is its lowest point, crosses the beam in each turn: the
/// beam is broken at most the feed of one tooth below its top, wherever the spindle stands when the
/// way begins.
TEST(LaserTeeth, BreakTheBeamWithinTheFeedOfATooth) {
  constexpr double kOneIncrement = 0.0001;
  for (const Mill mill : {Mill{8.0, 4}, Mill{14.0, 3}, Mill{16.0, 1}, Mill{40.0, 4}}) {
    for (const double beam : {0.03, 0.05, 0.1, 0.5}) {
      for (const double beside : {0.0, 0.0003, 3.999}) {
        for (const double start : {0.9916, 0.9874, 1.0031, 1.0007}) {
          SCOPED_TRACE(fmt::format("diameter {}, beam {}, {} beside, from {}", mill.diameter, beam,
                                   beside, start));
          const double depth = depth_at_break(mill, beam, beside, start);
          EXPECT_GE(depth, -kOneIncrement);
          EXPECT_LE(depth, kFeed / kSpeed / mill.teeth + kOneIncrement);
        }
      }
    }
  }
}

}  // namespace
}  // namespace g31::testing::laser_teeth_test

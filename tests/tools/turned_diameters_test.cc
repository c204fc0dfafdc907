// A shaft and a bushing with six diameters and a groove each, measured by CYCLE974 and CYCLE994 in
// all their variants, in diameters and in radii, on main and counter spindle: what the parts truly
// are.

#include <array>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/turning_run.h"

namespace g31::testing::turned_diameters_test {
namespace {

constexpr double kNear = 1e-6;

/// A section of the part: where its middle lies from the face, and how large it is.
struct Section {
  double z;
  double diameter;
  bool is_groove = false;
};
constexpr double kWide = 20.0;
constexpr std::array<Section, 7> kOutside = {{{-10.0, 40.02},
                                              {-30.0, 44.01},
                                              {-50.0, 50.03},
                                              {-70.0, 36.04, true},
                                              {-90.0, 56.05},
                                              {-110.0, 60.06},
                                              {-130.0, 66.07}}};
constexpr std::array<Section, 7> kInside = {{{-10.0, 60.02},
                                             {-30.0, 56.01},
                                             {-50.0, 52.03},
                                             {-70.0, 54.04, true},
                                             {-90.0, 48.05},
                                             {-110.0, 44.06},
                                             {-130.0, 40.07}}};

struct Spindle {
  const char* name;
  const char* offset;
  double face;  ///< machine coordinate
  double sense;
  std::string along;  ///< sheet of the probe that reaches into the part
};
const std::array<Spindle, 2> kSpindles = {{{"main spindle", "G54", 200.0, 1.0, kProbeToMinusZ},
                                           {"counter spindle", "G55", 600.0, -1.0, kProbeToPlusZ}}};

std::string placed(const Spindle& spindle, const std::string& shape, double z,
                   const std::string& more) {
  return part(shape, 0.0, 0.0, spindle.face + spindle.sense * z,
              more + (spindle.sense < 0.0 ? "\nrotate_deg = [0.0, 180.0, 0.0]" : ""));
}

std::string shaft(const Spindle& spindle) {
  std::string profile;
  for (const Section& section : kOutside) {
    const double half = (section.diameter - 40.0) / 2.0;
    profile += fmt::format("[{:.3f}, {:.6f}], [{:.3f}, {:.6f}], ", -section.z - kWide / 2.0, half,
                           -section.z + kWide / 2.0 - 0.01, half);
  }
  return placed(spindle, "shaft", 0.0,
                "diameter = 40.0\nheight = 140.0\nprofile = [" + profile + "]");
}

std::string bushing(const Spindle& spindle) {
  std::string rings;
  for (const Section& section : kInside) {
    rings += placed(spindle, "ring", section.z + kWide / 2.0,
                    fmt::format("bore = {:.6f}\nouter_diameter = 100.0\nheight = {:.1f}",
                                section.diameter, kWide));
  }
  return rings;
}

/// Places of X as the program counts.
struct Counting {
  const char* name;
  const char* code;
  double per_radius;

  [[nodiscard]] std::string x(double radius) const {
    return fmt::format("X{:.3f}", radius * per_radius);
  }
};
constexpr std::array<Counting, 2> kCountings = {
    {{"diameters", "DIAMON", 2.0}, {"radii", "DIAMOF", 1.0}}};

/// Runs a program that leaves R1, R2 and so on, and expects these.
void expect_readings(const std::string& program, const std::vector<std::string>& sheets,
                     const std::vector<double>& readings) {
  std::vector<ExpectedValue> expected;
  for (std::size_t i = 0; i < readings.size(); ++i) {
    expected.push_back({fmt::format("R{}", i + 1), readings[i]});
  }
  expect_turned(program, sheets, expected, kNear);
}

/// A program of calls and what they read.
struct Readings {
  std::string program;
  std::vector<double> values;

  /// @param way_in, way_out  blocks around the call
  void add(const std::string& way_in, const std::string& call, const std::string& way_out,
           double truth) {
    values.push_back(truth);
    program +=
        way_in + "\n" + call + fmt::format("\nR{}=_OVR[4]\n", values.size()) + way_out + "\n";
  }
};

template <typename Case>
void on_both_spindles(const Case& one) {
  for (const Spindle& spindle : kSpindles) {
    for (const Counting& counting : kCountings) {
      SCOPED_TRACE(fmt::format("{}, {}", spindle.name, counting.name));
      one(spindle, counting);
    }
  }
}

TEST(TurnedDiameters, OnePointOutsideAndTheFace) {
  on_both_spindles([](const Spindle& spindle, const Counting& count) {
    Readings all;
    const std::string out = "G0 " + count.x(50.0);
    for (const Section& section : kOutside) {
      const std::string in = fmt::format("{}\nG0 Z{:.1f}", out, section.z);
      const std::string call = fmt::format(",,,1,{:.0f},2,3,5", section.diameter);
      all.add(in, "CYCLE974(2" + call + ")", out, section.diameter);
      all.add(in, "CYCLE974(10002" + call + ",0)", out, section.diameter);
    }
    all.add(out + "\nZ10\n" + count.x(10.0), "CYCLE974(0,,,1,0.2,1,3,5)", "G0 Z10\n" + out, 0.0);
    expect_readings(fmt::format("{} {}\n{}", spindle.offset, count.code, all.program),
                    {kProbeToMinusX, kCalibrated, shaft(spindle)}, all.values);
  });
}

TEST(TurnedDiameters, TwoPointsOutsideRoundTheFace) {
  on_both_spindles([](const Spindle& spindle, const Counting& count) {
    Readings all;
    for (const Section& section : kOutside) {
      if (section.is_groove) {
        continue;  // the stylus along Z does not reach into it
      }
      const double round = 12.0 - section.z;
      const std::string in = "G0 Z20\n" + count.x(50.0) + fmt::format("\nZ{:.1f}", section.z);
      const std::string out = "G0 " + count.x(-50.0);
      const std::string sizes = fmt::format(",,,1,{:.0f}", section.diameter);
      all.add(in, fmt::format("CYCLE994(1002{},2,30,{:.1f},3,5)", sizes, round), out,
              section.diameter);
      all.add(in, fmt::format("CYCLE994(2{},102,0,{:.1f},3,5)", sizes, round), out,
              section.diameter);
    }
    expect_readings(fmt::format("{} {}\n{}", spindle.offset, count.code, all.program),
                    {spindle.along, kCalibrated, shaft(spindle)}, all.values);
  });
}

TEST(TurnedDiameters, OneAndTwoPointsInside) {
  on_both_spindles([](const Spindle& spindle, const Counting& count) {
    Readings all;
    for (const Section& section : kInside) {
      const std::string in = fmt::format("G0 X0\nZ{:.1f}", section.z);
      const std::string sizes = fmt::format(",,,1,{:.0f}", section.diameter);
      all.add(in, "CYCLE974(1" + sizes + ",2,3,5)", "G0 X0", section.diameter);
      all.add(in, "CYCLE974(10001" + sizes + ",2,3,5,0)", "G0 X0", section.diameter);
      all.add(in, "CYCLE994(1" + sizes + ",2,,,3,5)", "G0 X0", section.diameter);
      all.add(in, fmt::format("CYCLE994(1001{},2,8,{:.1f},3,5)", sizes, 12.0 - section.z), "G0 X0",
              section.diameter);
    }
    expect_readings(fmt::format("{} {}\nG0 Z20\n{}", spindle.offset, count.code, all.program),
                    {spindle.along, kCalibrated, bushing(spindle)}, all.values);
  });
}

const std::string kWithY =
    "[machine]\ntool_side = \"ZXY\"\n[machine_data]\n\"$MCS_TECHNOLOGY\" = 1\n"
    "\"$MCS_MEA_FUNCTION_MASK\" = 65538\n[variables]\n\"$SNS_MEA_WP_TRIG_PLUS_DIR_AX3[0]\" = 3.0\n"
    "\"$SNS_MEA_WP_TRIG_MINUS_DIR_AX3[0]\" = -3.0\n";

/// A stylus along X stands in the groove; it measures in Y and goes round the part above the
/// shoulders.
TEST(TurnedDiameters, TheGrooveOutsideByTwoPoints) {
  on_both_spindles([](const Spindle& spindle, const Counting& count) {
    const Section groove = kOutside[3];
    const std::string in = fmt::format("G0 {}\nY60\nZ{:.1f}\nX0", count.x(60.0), groove.z);
    const std::string out = fmt::format("G0 Y-60\n{}\nY0", count.x(60.0));
    Readings all;
    all.add(in, "CYCLE994(1002,,,1,36,3,50,90,3,5)", out, groove.diameter);
    all.add(in, "CYCLE994(2002,,,1,36,3,50,80,3,5)", out, groove.diameter);
    all.add(in, "CYCLE974(2,,,1,36,3,3,5)", "G0 Y60", groove.diameter);
    expect_readings(fmt::format("{} {}\nG0 Z20\n{}", spindle.offset, count.code, all.program),
                    {kProbeToMinusX, kCalibrated, shaft(spindle), kWithY}, all.values);
  });
}

/// With Y the probe measures in it, and goes round the part in it.
TEST(TurnedDiameters, WithY) {
  Readings all;
  all.add("G0 X0 Y60\nZ-50", "CYCLE974(2,,,1,50,3,3,5)", "G0 Y60", 50.03);
  all.add("G0 X0 Y60\nZ-50", "CYCLE994(2,,,1,50,103,20,62,3,5)", "G0 Y-60\nX100\nY0", 50.03);
  all.add("G0 X100 Y0\nZ-50", "CYCLE994(2,,,1,50,302,20,60,3,5)", "G0 X-100\nY60", 50.03);
  all.add("G0 X0 Y60\nZ-50", "CYCLE994(2,,,1,50,203,20,60,3,5)", "G0 Y-60\nX100", 50.03);
  all.add("G0 X100 Y0\nZ-50", "CYCLE994(3002,,,1,50,2,20,60,3,5)", "G0 X-100", 50.03);
  expect_readings("G54 DIAMON\n" + all.program,
                  {kProbeToMinusZ, kCalibrated, shaft(kSpindles[0]), kWithY}, all.values);
}

}  // namespace
}  // namespace g31::testing::turned_diameters_test

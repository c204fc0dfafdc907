// Whole runs on machines as they are: the shipped ones, zero errors, warm parts, traces.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"
#include "tools/setup/duration.h"

namespace g31::real_machine_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;
using testing::text_of;

const char* const kRing = "parts/library/ring_gauge/ring.toml";

/// Every key of a real machine, and none of them says anything.
const char* const kAllZero = R"([machine]
stop_delay_s = 0.0
table_side = "XY"
tool_side = "Z"
[machine.axes.X]
jerk = 0.0
servo_gain = 0.0
resolution = 0.0
backlash = 0.0
reversal_spike = 0.0
expansion = 11.5
temperature = 20.0
[machine.axes.Y]
jerk = 0
expansion = 0.0
temperature = 35.0
[machine.axes.Z]
fixed_at = 100.0
[machine.errors]
EXX = [[0.0, 0.0], [900.0, 0.0]]
EAX = 0.0
EBZ = [[-100, 0]]
A0Z = 0.0
B0Z = 0.0
C0Y = 0.0
[probe]
repeatability_mm = 0.0
)";

cli::RunOptions on_ring(std::vector<std::string> more_sheets) {
  cli::RunOptions options;
  options.programs = {"macros/fanuc/O6001.nc"};
  options.setups = {kRing};
  options.setups.insert(options.setups.end(), more_sheets.begin(), more_sheets.end());
  options.prints = {"#517,#518,#160,#161,#164,#177,#178,#179"};
  options.moves = options.touches = true;
  return options;
}

/// The document of a run, as it stands in the file, without the names of its sheets.
std::string document_of(cli::RunOptions options, const std::string& path) {
  options.json = path;
  ::testing::internal::CaptureStdout();
  EXPECT_EQ(static_cast<int>(cli::run_command(options)), 0);
  ::testing::internal::GetCapturedStdout();
  const std::string text = text_of(path);
  const std::size_t inputs = text.find("\n \"inputs\": ");
  return text.substr(0, inputs) + text.substr(text.find("\n \"blocks\": ", inputs));
}

TEST(RealMachine, WithAllErrorsZeroTheWholeRingExampleIsTheSameByteForByte) {
  TemporaryFolder folder;
  const std::string ideal = document_of(on_ring({}), folder.path("ideal.json"));
  const std::string zero =
      document_of(on_ring({folder.write("zero.toml", kAllZero)}), folder.path("zero.json"));
  cli::RunOptions traced = on_ring({});
  traced.trace = folder.path("trace.csv");
  traced.trace_period = "50ms";
  ASSERT_GT(ideal.size(), 10'000U);
  EXPECT_EQ(ideal, zero);
  EXPECT_EQ(ideal, document_of(traced, folder.path("traced.json")));
}

TEST(RealMachine, EveryShippedMachineMoves) {
  struct Case {
    const char* file;
    const char* program;
    double x, z;
  };
  const Case kCases[] = {
      {"ideal.toml", "G90G1X5000.Z-70.F9000", 5000.0, -70.0},
      {"v55.toml", "G90G1X50.Z-70.F3000\nG3X60.R5.", 60.0, -70.0},
      {"five_axis_ac.toml", "G90G1X50.Z-70.F3000\nG0A-30.C400.", 50.0, -70.0},
      {"lathe.toml", "G90G1X50.Z70.F3000", 50.0, 70.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.file);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write("move.nc", "O1\n" + std::string(c.program) + "\nM30\n")};
    options.setups = {
        folder.write("s.toml", "[machine]\nfile = \"" + std::string(c.file) + "\"\n")};
    options.prints = {"#5021,#5023"};
    const RunOutput output = run_program(options);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_EQ(output.document["variables"]["#5021"], c.x);
    EXPECT_EQ(output.document["variables"]["#5023"], c.z);
  }
}

TEST(RealMachine, TheLatheHasNoY) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("move.nc", "O1\nG0Y1.\nM30\n")};
  options.setups = {folder.write("s.toml", "[machine]\nfile = \"lathe.toml\"\n")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 4) << "over-travel";
  EXPECT_NE(output.errors.find("the machine has no axis Y"), std::string::npos) << output.errors;
}

TEST(RealMachine, TheV55CalibratesOnTheRingWithinItsErrors) {
  TemporaryFolder folder;
  const RunOutput output =
      run_program(on_ring({folder.write("sheet.toml", "[machine]\nfile = \"v55.toml\"\n")}));
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  for (const char* name : {"#517", "#518"}) {
    const double calibration = output.document["variables"][name];
    EXPECT_NE(calibration, 0.0);
    EXPECT_LT(std::abs(calibration), 0.002) << "half the backlash and the straightness";
  }
}

TEST(RealMachine, AWarmRingIsLarger) {
  TemporaryFolder folder;
  const std::string sheet = folder.write("warm.toml", R"([[part]]
name = "ring"
shape = "ring"
bore = 39.996
outer_diameter = 80.0
height = 20.0
at = [250.0, -180.0, -300.0]
expansion = 11.5
temperature = 30.0
)");
  const RunOutput output = run_program(on_ring({sheet}));
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  // From touch to touch it is the bore: 11.5 um/(m K) for 10 K.
  const double plus = output.document["variables"]["#160"];
  const double minus = output.document["variables"]["#161"];
  EXPECT_NEAR(plus - minus, 39.996 * (1.0 + 115e-6), 1e-8);
}

/// The rows of a table of numbers under its line of names.
std::vector<std::vector<double>> rows_of(const std::string& path, std::string& names) {
  std::ifstream in(path);
  std::getline(in, names);
  std::vector<std::vector<double>> rows;
  for (std::string line; std::getline(in, line);) {
    std::vector<double>& row = rows.emplace_back();
    std::stringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(std::stod(cell));
    }
  }
  return rows;
}

// The path of the paper: a square at 3 m/min, seen every 182.32 us.
TEST(Trace, HoldsTheCommandTheEncoderAndTheTruth) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("square.nc", "O1\nG91G1X10.F3000\nY10.\nX-10.\nG9Y-10.\nM30\n")};
  options.setups = {folder.write("s.toml", R"([machine.axes.X]
servo_gain = 1.8
resolution = 0.001
[machine.axes.Y]
servo_gain = 1.8
[machine.errors]
EXX = [[0.0, 0.0], [100.0, 0.1]]
)")};
  options.trace = folder.path("square.csv");
  options.trace_period = "182.32us";
  const RunOutput output = run_program(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  std::string names;
  const auto rows = rows_of(options.trace, names);
  EXPECT_EQ(names,
            "time_s,X_commanded,Y_commanded,Z_commanded,X_encoder,Y_encoder,Z_encoder,"
            "X_true,Y_true,Z_true");
  const double seconds = output.document["machine_time_s"];
  ASSERT_EQ(rows.size(), static_cast<std::size_t>(seconds / 182.32e-6) + 2U);
  EXPECT_NEAR(rows.back()[0], seconds, 1e-9) << "where motion has ended";
  double nearest_to_corner = 1e9;
  for (std::size_t i = 0; i < rows.size(); ++i) {
    ASSERT_EQ(rows[i].size(), 10U);
    if (i + 1 < rows.size()) {
      ASSERT_NEAR(rows[i][0], static_cast<double>(i) * 182.32e-6, 1e-11);
    }
    const double steps = rows[i][4] / 0.001;
    ASSERT_NEAR(steps, std::round(steps), 1e-3) << "whole steps of the encoder";
    ASSERT_NEAR(rows[i][7], rows[i][4] * 1.001, 0.6e-3) << "the scale errs by 0.1 %";
    ASSERT_EQ(rows[i][8], rows[i][5]);
    nearest_to_corner = std::min(nearest_to_corner, std::hypot(rows[i][4] - 10, rows[i][5]));
  }
  EXPECT_GT(nearest_to_corner, 0.3) << "the corners are rounded";
  EXPECT_NEAR(rows.back()[4], 0.0, 0.0101) << "the last one is not: it is waited for";
  EXPECT_EQ(folder.names().size(), 3U) << "no temporary file stays behind";
}

TEST(Trace, AFileThatCannotBeWrittenAndAPeriodThatIsNoneAreWrongUsage) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("move.nc", "O1\nG0X1.\nM30\n")};
  options.trace = folder.path("no/such/folder/t.csv");
  EXPECT_EQ(run_program(options).exit_code, 2);
  options.trace = folder.path("t.csv");
  options.trace_period = "fast";
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_NE(output.errors.find("182.32us"), std::string::npos) << output.errors;
  EXPECT_FALSE(std::filesystem::exists(options.trace));
}

TEST(Duration, IsANumberWithItsUnit) {
  struct Case {
    const char* text;
    double seconds;  ///< 0: refused
  };
  const Case kCases[] = {{"182.32us", 182.32e-6},
                         {"4ms", 0.004},
                         {"0.5s", 0.5},
                         {"2", 2.0},
                         {"10ns", 1e-8},
                         {"1e-3", 1e-3},
                         {"0", 0},
                         {"-1ms", 0},
                         {"ms", 0},
                         {"1h", 0},
                         {"", 0},
                         {"inf", 0},
                         {"1 ms", 0}};
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto seconds = setup::parse_duration(c.text);
    ASSERT_EQ(seconds.ok(), c.seconds > 0.0);
    if (seconds) {
      EXPECT_DOUBLE_EQ(seconds.value(), c.seconds);
    }
  }
}

}  // namespace
}  // namespace g31::real_machine_test

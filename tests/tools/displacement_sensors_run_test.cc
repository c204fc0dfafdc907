// Displacement sensors as programs of both controls read them, the table of --readings, and
// straightness by two sensors against the errors that the sheets put in.

#include <array>
#include <cmath>
#include <filesystem>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include <fcntl.h>
#include <gtest/gtest.h>
#include <sys/stat.h>
#include <unistd.h>

#include "tests/support/run_program.h"

namespace g31::displacement_sensors_run_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

/// 20 mm above the bed's top face, which rises by 0.001 mm a mm of X.
constexpr const char* kRising =
    "[start]\nZ = 120.0\n"
    "[[part]]\nshape = \"bed\"\nlength = 400.0\nprofile = [[0.0, 0.0], [400.0, 0.4]]\n"
    "[[sensor]]\nname = \"A\"\nat = [0.0, 0.0, -100.0]\nrange = 25.0\n"
    "[[sensor]]\nname = \"B\"\nat = [50.0, 0.0, -100.0]\nrange = 25.0\n";

RunOutput run_on(const std::string& sheet, const std::string& name, const std::string& program,
                 const std::vector<std::string>& prints) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {folder.write("sheet.toml", sheet)};
  options.prints = prints;
  return run_program(options);
}

double value_of(const RunOutput& output, const std::string& name) {
  return output.document["variables"][name].get<double>();
}

TEST(DisplacementSensorsRun, AFanucReadsCountsInItsWords) {
  const std::string program = "O1\nG0 X100.\n#100=#1132\n#101=#1133\n#102=#1134\nM30\n";
  const std::vector<std::string> prints = {"#100", "#101", "#102"};
  const RunOutput usual = run_on(kRising, "read.nc", program, prints);
  ASSERT_EQ(usual.exit_code, 0) << usual.errors;
  EXPECT_EQ(value_of(usual, "#100"), 199000.0);  // 19.9 mm in 0.0001 mm
  EXPECT_EQ(value_of(usual, "#101"), 198500.0);
  EXPECT_EQ(value_of(usual, "#102"), 0.0);  // no sensor's

  std::string sheet = kRising;
  sheet += "resolution = 0.002\nword = 34\n";  // #1034, of B
  const RunOutput chosen =
      run_on(sheet, "read.nc", "O1\nG0 X100.\n#100=#1034\n#101=#1133\nM30\n", {"#100", "#101"});
  ASSERT_EQ(chosen.exit_code, 0) << chosen.errors;
  EXPECT_EQ(value_of(chosen, "#100"), 9925.0);
  EXPECT_EQ(value_of(chosen, "#101"), 0.0);
}

TEST(DisplacementSensorsRun, ASinumerikReadsMillimetres) {
  const RunOutput output =
      run_on(std::string(kRising) + "input = 5\n", "read.mpf",
             "G0 X100\nR1=$A_INA[1] R2=$A_INA[5] R3=$A_INA[2]\nG0 X400\nR4=$A_INA[5]\nM30\n",
             {"R1", "R2", "R3", "R4"});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(value_of(output, "R1"), 19.9, 1e-12);
  EXPECT_NEAR(value_of(output, "R2"), 19.85, 1e-12);
  EXPECT_EQ(value_of(output, "R3"), 0.0);
  EXPECT_EQ(value_of(output, "R4"), 25.0);  // beside the bed: the range
}

std::vector<std::vector<std::string>> rows_of(const std::string& text) {
  std::vector<std::vector<std::string>> rows;
  std::istringstream lines(text);
  for (std::string line; std::getline(lines, line);) {
    auto& row = rows.emplace_back();
    std::istringstream cells(line);
    for (std::string cell; std::getline(cells, cell, ',');) {
      row.push_back(cell);
    }
  }
  return rows;
}

using Rows = std::vector<std::vector<std::string>>;

Rows readings_of(const std::string& name, const std::string& program) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {folder.write("sheet.toml", kRising)};
  options.readings = folder.path("readings.csv");
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  return rows_of(testing::text_of(options.readings));
}

TEST(DisplacementSensorsRun, EveryStopIsARowOfTheReadings) {
  const Rows fanuc =
      readings_of("stops.nc", "O1\nG4 P1500\nG1 X100. F6000.\nM00\nG1 X200.\nM01\nG1 X300.\nM30\n");
  ASSERT_EQ(fanuc.size(), 4U);
  EXPECT_EQ(fanuc[0], (std::vector<std::string>{"t", "X", "Y", "Z", "A", "B"}));
  EXPECT_EQ(fanuc[1], (std::vector<std::string>{"1.5", "0.0000000", "0.0000000", "120.0000000",
                                                "20", "19.95"}));
  EXPECT_EQ(fanuc[2][1], "100.0000000");
  EXPECT_NEAR(std::stod(fanuc[2][4]), 19.9, 1e-12);
  EXPECT_EQ(fanuc[3][1], "200.0000000");

  const Rows sinumerik =
      readings_of("stops.mpf", "G1 X100 F6000\nSTOPRE\nM0\nG1 X200\nG4 F2\nM1\nM30\n");
  ASSERT_EQ(sinumerik.size(), 5U);
  EXPECT_EQ(sinumerik[1], sinumerik[2]);
  EXPECT_EQ(sinumerik[3], sinumerik[4]);
  EXPECT_NEAR(std::stod(sinumerik[4][5]), 19.75, 1e-12);
}

/// Straight between the rows.
double between(const std::vector<std::pair<double, double>>& rows, double place) {
  for (std::size_t i = 1; i < rows.size(); ++i) {
    if (place <= rows[i].first) {
      const double share = (place - rows[i - 1].first) / (rows[i].first - rows[i - 1].first);
      return rows[i - 1].second + share * (rows[i].second - rows[i - 1].second);
    }
  }
  return rows.back().second;
}

// What parts/library/straightness/bed.toml puts in.
const std::vector<std::pair<double, double>> kMotion = {
    {0.0, 0.0}, {1000.0, 0.012}, {2500.0, 0.031}, {3800.0, 0.014}, {5000.0, 0.0}};
const std::vector<std::pair<double, double>> kWork = {
    {0.0, 0.0}, {900.0, 0.018}, {2200.0, -0.007}, {3600.0, 0.022}, {5200.0, 0.15}};
constexpr double kTipsMm = 0.00257;
constexpr const char* kFolder = "parts/library/straightness/";

RunOutput straightness(const std::string& program, const std::string& sheet, double step_mm,
                       double count_mm, const std::string& more = "") {
  const TemporaryFolder folder;
  std::ostringstream finer;
  finer.precision(17);
  const int steps = static_cast<int>(5000.0 / step_mm);
  for (const auto& [name, at] : {std::pair("A", "[0.0, 0.0, -100.0]"),
                                 std::pair("B", step_mm == 100.0 ? "[100.0, 0.0, -100.00257]"
                                                                 : "[200.0, 0.0, -100.00257]")}) {
    finer << "[[sensor]]\nname = \"" << name << "\"\nat = " << at
          << "\nrange = 20.0\nresolution = " << count_mm
          << "\nword = " << (*name == 'A' ? 1033 : 1034) << "\n";
  }
  const bool is_fanuc = program.ends_with(".nc");
  finer << "[variables]\n"
        << (is_fanuc ? "\"#523\" = " : "R1 = ") << step_mm << "\n"
        << (is_fanuc ? "\"#524\" = " : "R2 = ") << steps << "\n";
  if (is_fanuc) {
    finer << "\"#525\" = " << count_mm << "\n";
  }
  finer << more;
  cli::RunOptions options;
  options.programs = {program};
  options.setups = {std::string(kFolder) + "bed.toml", std::string(kFolder) + sheet,
                    folder.write("finer.toml", finer.str())};
  if (is_fanuc) {
    for (int i = 0; i <= steps; ++i) {
      options.prints.push_back("#" + std::to_string(800 + i) + ",#" + std::to_string(900 + i));
    }
  }
  options.prints.emplace_back(is_fanuc ? "#520,#521,#522" : "R10,R11,R12");
  return run_program(options);
}

TEST(Straightness, TheMacroOfAFanucSeparatesMotionAndWork) {
  constexpr double kCountMm = 1e-8;  // so that 50 steps of counts err by less than 1e-6
  for (const double step_mm : {100.0, 200.0}) {
    const RunOutput output = straightness("macros/fanuc/O6020.nc", "fanuc.toml", step_mm, kCountMm);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const int steps = static_cast<int>(5000.0 / step_mm);
    for (int i = 0; i <= steps; ++i) {
      const double place = i * step_mm;
      EXPECT_NEAR(value_of(output, "#" + std::to_string(800 + i)), between(kMotion, place), 1e-6);
      EXPECT_NEAR(value_of(output, "#" + std::to_string(900 + i)), between(kWork, place), 1e-6);
    }
    EXPECT_NEAR(value_of(output, "#520"), kTipsMm, 1e-7);
    EXPECT_NEAR(value_of(output, "#521"), between(kMotion, step_mm == 100.0 ? 2500.0 : 2400.0),
                1e-6);
  }
}

TEST(Straightness, TheMacroOfASinumerikFindsTheSame) {
  const RunOutput output =
      straightness(std::string(kFolder) + "step.mpf", "sinumerik.toml", 100.0, 0.0);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(value_of(output, "R10"), kTipsMm, 1e-9);
  EXPECT_NEAR(value_of(output, "R11"), 0.031, 1e-9);
  // Highest at 900, lowest at 3600, off the line from (0, 0) to (5000, 0.134).
  const auto off = [](double place) { return between(kWork, place) - 0.134 * place / 5000.0; };
  EXPECT_NEAR(value_of(output, "R12"), std::max(off(900.0), 0.0) - off(3600.0), 1e-9);
}

/// The motion that was found, with its sign turned, is what `g31 evaluate --compensation` writes.
TEST(Straightness, AMachineWithItsCompensationMovesStraight) {
  std::ostringstream sheet;
  sheet << "[machine.compensation]\nEZX = [";
  for (int place = 0; place <= 5000; place += 100) {
    sheet << "[" << place << ".0, " << -between(kMotion, place) << "],";
  }
  sheet << "]\n";
  const RunOutput output =
      straightness(std::string(kFolder) + "step.mpf", "sinumerik.toml", 100.0, 0.0, sheet.str());
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(value_of(output, "R10"), kTipsMm, 1e-8);
  EXPECT_NEAR(value_of(output, "R11"), 0.0, 1e-7);  // the sheet's numbers have six digits
  EXPECT_NEAR(value_of(output, "R12"), 0.07448, 1e-7) << "the bed is what it was";
}

TEST(Straightness, TheMacrosRefuseWhatTheyCannotUse) {
  const auto alarm_of = [](const std::string& call) {
    const RunOutput output = run_on("[control]\nprofile = \"fanuc-16i\"\n", "call.nc",
                                    "O1\n#600=1.\n#700=1.\n" + call + "\nM30\n", {});
    EXPECT_EQ(output.exit_code, 3) << output.errors;
    return output.document["alarm"]["number"].get<int>();
  };
  EXPECT_EQ(alarm_of("G65 P9020"), 3160);
  EXPECT_EQ(alarm_of("G65 P9020 K99."), 3182);
  EXPECT_EQ(alarm_of("G65 P9020 K1.5"), 3182);
  EXPECT_EQ(alarm_of("#601=1.\n#701=#0\nG65 P9020 K1."), 3160);
  EXPECT_EQ(alarm_of("#601=1.\n#701=1.\nG65 P9020 K1. S2."), 3182);
}

TEST(DisplacementSensorsSheet, TakesDirectionsOfAnyLength) {
  for (const char* const along : {"1e-300", "1e300", "0.5"}) {
    const RunOutput output =
        run_on(std::string(kRising) + "direction = [0.0, 0.0, -" + along + "]\n", "read.mpf",
               "R1=$A_INA[2]\nM30\n", {"R1"});
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_NEAR(value_of(output, "R1"), 19.95, 1e-12) << along;
  }
}

/// A device or a pipe takes what is written; a file in its place would be its end.
TEST(DisplacementSensorsRun, APipeStaysOne) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("stop.mpf", "STOPRE\nM30\n")};
  options.setups = {folder.write("sheet.toml", kRising)};
  options.readings = folder.path("pipe");
  ASSERT_EQ(::mkfifo(options.readings.c_str(), 0600), 0);
  const int reader = ::open(options.readings.c_str(), O_RDONLY | O_NONBLOCK);
  ASSERT_GE(reader, 0);
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  std::array<char, 200> bytes{};
  const auto count = ::read(reader, bytes.data(), bytes.size());
  ::close(reader);
  ASSERT_GT(count, 0);
  EXPECT_TRUE(
      std::string(bytes.data(), static_cast<std::size_t>(count)).starts_with("t,X,Y,Z,A,B\n"));
  EXPECT_TRUE(std::filesystem::is_fifo(options.readings));
}

std::string refused(const std::string& more) {
  const RunOutput output = run_on(kRising + more, "end.nc", "O1\nM30\n", {});
  EXPECT_EQ(output.exit_code, 2) << more;
  return output.errors;
}

TEST(DisplacementSensorsSheet, SaysWhatIsWrong) {
  const auto says = [](const std::string& errors, const std::string& text) {
    EXPECT_NE(errors.find(text), std::string::npos) << errors;
  };
  says(refused("[[sensor]]\nname = \"A\"\n"), "sensor.name is A, which sensor A already has");
  says(refused("[[sensor]]\ninput = 2\n"), "sensor.input is 2, which sensor B already has");
  says(refused("[[sensor]]\nword = 132\n"), "sensor.word is 1132, which sensor A already has");
  says(refused("[[sensor]]\nname = \"a,b\"\n"), "a name of letters, digits");
  says(refused("[[sensor]]\nword = 1100\n"), "1032 to 1035 or 1132 to 1135");
  says(refused("[[sensor]]\ndirection = [0.0, 0.0, 0.0]\n"), "not all 0");
  says(refused("[[sensor]]\nresolution = 1e-9\n"), "2147483647 counts");
  says(refused("[[sensor]]\ninput = 9\n"), "1 to 8");
  says(refused("[[sensor]]\nspot = 1e7\n"), "sensor.spot is 10000000");
  says(refused("[[sensor]]\nat = [0.0, -1e9, 0.0]\n"), "1000000 mm at most");
  std::string many;
  for (int i = 3; i <= 9; ++i) {
    many += "[[sensor]]\n";
  }
  says(refused(many), "there are only 8 analog inputs");
}

}  // namespace
}  // namespace g31::displacement_sensors_run_test

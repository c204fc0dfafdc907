// What a user is told whose program measures without its probe.

#include <string>
#include <utility>

#include <gtest/gtest.h>

#include "tests/support/run_program.h"

namespace g31::probe_as_tool_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr const char* kSheet = R"([start]
Z = 200.0
[probe]
tool = 1
on = "M80"
[[part]]
shape = "cylinder"
)";

/// A program on that sheet.
RunOutput run_with_probe(const TemporaryFolder& folder, const std::string& name,
                         const std::string& program) {
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {folder.write("sheet.toml", kSheet)};
  return run_program(options);
}

/// Standard error without the folder of the program.
std::string said(const RunOutput& output, const TemporaryFolder& folder) {
  std::string text = output.errors;
  const std::string prefix = folder.path("");
  for (std::size_t at = text.find(prefix); at != text.npos; at = text.find(prefix)) {
    text.erase(at, prefix.size());
  }
  return text;
}

TEST(ProbeAsTool, ALoopWithoutItIsToldOnceWithTheNumberOfTimes) {
  const TemporaryFolder folder;
  const RunOutput output = run_with_probe(folder, "loop.nc",
                                          "O1\n"
                                          "T5 M6\n"
                                          "#1=0\n"
                                          "WHILE [#1 LT 3] DO1\n"
                                          "G31 Z[190.-#1] F500.\n"
                                          "#1=#1+1\n"
                                          "END1\n"
                                          "M30\n");
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_EQ(output.document["status"], "completed");
  EXPECT_EQ(
      said(output, folder),
      R"(loop.nc:5:1: warning: measuring move without the probe in the spindle: no signal can come [PRB311]
    5 | G31 Z[190.-#1] F500.
      | ^~~~~~~~~~~~~~~~~~~~
      = change to the tool that probe.tool in the set-up sheet names: T and M6
loop.nc:5:1: note: 3 times in all
loop.nc:5:1: warning: the skip move reached its end point without a signal [PRB301]
    5 | G31 Z[190.-#1] F500.
      | ^~~~~~~~~~~~~~~~~~~~
      = the control raises no alarm here: compare the reading with the programmed end point before using it (SINUMERIK: check $AC_MEA), or program a longer move
)");
}

TEST(ProbeAsTool, OffAndTurningAreToldByTheirPlaceInBothDialects) {
  const TemporaryFolder folder;
  const RunOutput fanuc = run_with_probe(folder, "off.nc", "O1\nM3 S100\nG31 Z190. F500.\nM30\n");
  EXPECT_EQ(fanuc.exit_code, 1);
  EXPECT_EQ(
      said(fanuc, folder),
      R"(off.nc:3:1: warning: measuring move with the probe switched off, or not ready yet: no signal can come [PRB312]
    3 | G31 Z190. F500.
      | ^~~~~~~~~~~~~~~
      = switch it on first, as probe.on in the set-up sheet says, and wait for probe.start_up_s
off.nc:3:1: warning: measuring move with the spindle turning [PRB313]
    3 | G31 Z190. F500.
      | ^~~~~~~~~~~~~~~
      = stop the spindle with M5, or orient it with M19 or SPOS
off.nc:3:1: warning: the skip move reached its end point without a signal [PRB301]
    3 | G31 Z190. F500.
      | ^~~~~~~~~~~~~~~
      = the control raises no alarm here: compare the reading with the programmed end point before using it (SINUMERIK: check $AC_MEA), or program a longer move
)");
  const RunOutput sinumerik =
      run_with_probe(folder, "off.mpf", "M3 S100\nMEAS=1 G1 Z190 F500\nM30\n");
  EXPECT_EQ(sinumerik.exit_code, 1);
  EXPECT_EQ(
      said(sinumerik, folder),
      R"(off.mpf:2:1: warning: measuring move with the probe switched off, or not ready yet: no signal can come [PRB312]
    2 | MEAS=1 G1 Z190 F500
      | ^~~~~~~~~~~~~~~~~~~
      = switch it on first, as probe.on in the set-up sheet says, and wait for probe.start_up_s
off.mpf:2:1: warning: measuring move with the spindle turning [PRB313]
    2 | MEAS=1 G1 Z190 F500
      | ^~~~~~~~~~~~~~~~~~~
      = stop the spindle with M5, or orient it with M19 or SPOS
off.mpf:2:1: warning: the skip move reached its end point without a signal [PRB301]
    2 | MEAS=1 G1 Z190 F500
      | ^~~~~~~~~~~~~~~~~~~
      = the control raises no alarm here: compare the reading with the programmed end point before using it (SINUMERIK: check $AC_MEA), or program a longer move
)");
}

TEST(ProbeAsTool, OneThatMayTurnIsNotToldToStand) {
  const TemporaryFolder folder;
  std::string may_turn = kSheet;
  may_turn.insert(may_turn.find("[[part]]"), "may_turn = true\n");
  const std::pair<std::string, std::string> kPrograms[] = {
      {"turn.nc", "O1\nM80\nM3 S100\nG31 Z190. F500.\nM30\n"},
      {"turn.mpf", "M80\nM3 S100\nMEAS=1 G1 Z190 F500\nM30\n"}};
  for (const auto& [name, program] : kPrograms) {
    SCOPED_TRACE(name);
    const RunOutput told = run_with_probe(folder, name, program);
    EXPECT_NE(told.errors.find("[PRB313]"), std::string::npos) << told.errors;
    cli::RunOptions options;
    options.programs = {folder.path(name)};
    options.setups = {folder.write("may_turn.toml", may_turn)};
    const RunOutput allowed = run_program(options);
    EXPECT_EQ(allowed.errors.find("[PRB313]"), std::string::npos) << allowed.errors;
    EXPECT_NE(allowed.errors.find("[PRB301]"), std::string::npos) << "the rest is told";
  }
}

}  // namespace
}  // namespace g31::probe_as_tool_test

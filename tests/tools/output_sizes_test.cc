// What --max-output counts for an entry of a list is within a factor of three of what the document
// takes for it: a run that is ended by one list alone has a list of that size.

#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace g31::output_sizes_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr std::uint64_t kMost = 400'000;

constexpr const char* kRing =
    "[probe]\nball_diameter = 6.0\nlength = 100.0\n[[part]]\nname = \"ring\"\nshape = \"ring\"\n"
    "bore = 40.0\nouter_diameter = 60.0\nheight = 20.0\n";

/// Lines that are each a block of their own.
std::string many(const char* line, int count) {
  std::string text;
  for (int i = 0; i < count; ++i) {
    text += line;
  }
  return text;
}

struct Case {
  const char* name;
  const char* list;  ///< of the document
  const char* grows;
  const char* file;
  std::string program;
  const char* sheet = "";
};

/// Made when it is asked for: as a constant, its texts would slow down the start of every test.
std::vector<Case> cases() {
  return {
      {"moves of whole millimetres", "moves", "moves", "m.nc",
       "O1\nG91\nN1G1X1.F100.\nG1X-1.\nGOTO1\nM30\n"},
      {"moves of many digits", "moves", "moves", "d.nc",
       "O1\nN1#1=#1+1\nG1X[SIN[#1]*7.]Y[COS[#1]*3.]Z[SIN[#1*3]]F[100.1+SIN[#1]]\nGOTO1\nM30\n"},
      {"touches", "touches", "touches", "t.nc",
       "O1\nG90G1X0Y0Z90.F9999.\nN1#1=#1+7.7\nG1X0Y0\nG31X[22.*COS[#1]]Y[22.*SIN[#1]]F100."
       "\nGOTO1\nM30\n",
       kRing},
      {"stops", "stops", "stops", "s.nc", "O1\nN1#3006=1(A)\nGOTO1\nM30\n"},
      {"events", "events", "events", "e.nc", "O1\nN1M60\nM61\nGOTO1\nM30\n"},
      {"calls", "calls", "calls", "c.nc", "O1\nN1M98P9998\nGOTO1\nM30\nO9998\nM99\n"},
      {"blocks", "counts", "counts of blocks", "b.nc", "O1\n" + many("G90\n", 30'000) + "M30\n"},
      {"blocks with conditions", "counts", "counts of blocks", "i.nc",
       "O1\n" + many("IF[1EQ2]GOTO9\n", 30'000) + "N9M30\n"},
      {"values of few variables", "history", "values of variables", "v.nc",
       "O1\n#33=0\nWHILE[#33LT999]DO1\n#32=100\nWHILE[#32LE149]DO2\n#[#32]=SIN[#32+#33]\n#32=#32+"
       "1\nEND2\n"
       "#33=#33+1\nEND1\nM30\n"},
      {"a value each of many variables", "history", "values of variables", "g.mpf",
       "DEF INT A[20000]\nDEF INT I\nFOR I=0 TO 19999\nA[I]=I\nENDFOR\nM30\n"},
      {"texts", "history", "values of variables", "x.mpf",
       "DEF STRING[200] A[40]\nDEF INT I\nLOOP\nFOR I=0 TO 39\nA[I]=\"" + std::string(190, 'X') +
           "\"\nENDFOR\nENDLOOP\nM30\n"},
  };
}

TEST(OutputSizes, OfEntriesOfListsAreWithinAFactorOfThree) {
  for (const Case& c : cases()) {
    SCOPED_TRACE(c.name);
    TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write(c.file, c.program)};
    options.setups = {folder.write("sheet.toml", c.sheet)};
    options.max_output = kMost;
    const std::string list = c.list;
    options.moves = list == "moves";
    options.touches = list == "touches";
    options.blocks = list == "calls" || list == "counts" || list == "history";
    const RunOutput output = run_program(options);
    ASSERT_EQ(output.document.at("status"), "budget") << output.errors.substr(0, 1000);
    const auto is_told = [&](const char* kilobytes) {
      return output.errors.find(fmt::format("{} {}", c.grows, kilobytes)) != std::string::npos;
    };
    EXPECT_TRUE(is_told("39") || is_told("400.")) << output.errors.substr(0, 1000);
    // As deep as it stands in the document.
    const std::size_t size = nlohmann::json{{list, output.document.at(list)}}.dump(1).size();
    EXPECT_LT(size, 3 * kMost);
    EXPECT_GT(size, kMost / 3);
    RecordProperty(c.name, static_cast<int>(size));
  }
}

// Of a variable that is written without end a thousand values are kept: they do not spend a budget
// that they fit in.
TEST(OutputSizes, OfValuesThatAreLeftOutAreGivenBack) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write("v.nc", "O1\nN1#1=#1+1\nIF[#1LT99999]GOTO1\nM30\n")};
  options.blocks = true;
  options.max_output = 100'000;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.document.at("status"), "completed") << output.errors.substr(0, 1000);
  EXPECT_GT(output.document.at("history").at(0).at("values").size(), 400U);
}

}  // namespace
}  // namespace g31::output_sizes_test

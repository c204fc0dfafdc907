// --max-output: programs that would fill disk or memory end with exit code 6, what they wrote is
// whole.

#include "interpreter/runtime/output_budget.h"

#include <cstdio>
#include <fstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include "tests/support/captured.h"
#include "tests/support/effort.h"
#include "tests/support/run_arguments.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"
#include "tools/setup/byte_count.h"

namespace g31::output_budget_test {
namespace {

using nlohmann::ordered_json;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

constexpr std::uint64_t kMegabyte = 1'000'000;

/// Address space that this process has now, bytes.
std::uint64_t address_space() {
  std::uint64_t pages = 0;
  std::ifstream("/proc/self/statm") >> pages;
  return pages * static_cast<std::uint64_t>(::sysconf(_SC_PAGESIZE));
}

/// Runs the command in a child process that may take so much more memory than this one has.
/// @returns its exit code; -1 where it was killed
int exit_code_within(std::uint64_t more_bytes, const cli::RunOptions& options) {
  std::fflush(nullptr);  // or the child writes it, too
  const pid_t child = ::fork();
  if (child == 0) {
    if (!testing::under_sanitizers()) {  // these take terabytes of addresses themselves
      const rlim_t most = address_space() + more_bytes;
      const struct rlimit limit = {most, most};
      ::setrlimit(RLIMIT_AS, &limit);
    }
    (void)std::freopen("/dev/null", "wb", stdout);
    (void)std::freopen("/dev/null", "wb", stderr);
    int code = 99;
    try {
      code = static_cast<int>(cli::run_command(options));
    } catch (const std::exception&) {
      code = 70;
    }
    ::_exit(code);
  }
  int status = 0;
  ::waitpid(child, &status, 0);
  return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
}

struct Attack {
  const char* name;
  const char* file;
  std::string program;
  const char* grows;  ///< which output the message names
};

const std::string kLongComment(60'000, 'A');

const Attack kAttacks[] = {
    {"WRITE in a loop", "w.mpf",
     "DEF INT E\nN10 WRITE(E,\"A.TXT\",\"0123456789012345678901234567890123456789\")\nGOTOB N10\n",
     "files of the program 1.0 MB"},
    {"EXTWRITE in a loop", "x.mpf",
     "DEF INT E\nEXTOPEN(E,\"/A.TXT\",\"ASYNC\",\"SHARED\",\"OVR\")\nN10 EXTWRITE(E,\"/A.TXT\","
     "\"0123456789012345678901234567890123456789\")\nGOTOB N10\n",
     "files of the program 1.0 MB"},
    {"many files", "f.mpf",
     "DEF INT E\nDEF INT I=0\nN10 WRITE(E,\"F\"<<I<<\".TXT\",\"X\")\nI=I+1\nGOTOB N10\n",
     "files of the program 1.0 MB"},
    {"MSG in a loop", "m.mpf", "N10 MSG(\"HELLO OPERATOR\")\nGOTOB N10\n", "printouts 1.0 MB"},
    {"DPRNT in a loop", "d.nc", "O1\nPOPEN\nN1DPRNT[HELLO*WORLD]\nGOTO1\nM30\n",
     "printouts 1.0 MB"},
    {"#3006 in a loop", "s.nc", "O1\nN1#3006=1(" + kLongComment + ")\nGOTO1\nM30\n",
     "stops 1.0 MB"},
    {"G1 in a loop", "g1.nc", "O1\nG91\nN1G1X1.F100.\nG1X-1.\nGOTO1\nM30\n", "moves 1.0 MB"},
    {"G31 in a loop", "g31.nc", "O1\nG91\nN1G31X1.F100.\nG31X-1.\nGOTO1\nM30\n", "touches 8"},
    {"a dwell of years", "g4.nc", "O1\nG4X99999999.\nM30\n", "rows of the trace 1.0 MB"},
};

cli::RunOptions options_of(const TemporaryFolder& folder, const Attack& attack) {
  cli::RunOptions options;
  options.programs = {folder.write(attack.file, attack.program)};
  options.max_output = kMegabyte;
  options.moves = true;
  options.touches = true;
  options.trace = attack.name == std::string("a dwell of years") ? folder.path("t.csv") : "";
  return options;
}

TEST(OutputBudget, EndsEveryLoopWithAWholeDocument) {
  for (const Attack& attack : kAttacks) {
    SCOPED_TRACE(attack.name);
    TemporaryFolder folder;
    const RunOutput output = run_program(options_of(folder, attack));
    EXPECT_EQ(output.exit_code, 6);
    EXPECT_EQ(output.document.at("status"), "budget");
    const auto& last = output.document.at("diagnostics").back();
    EXPECT_EQ(last.at("code"), "PRB605");
    EXPECT_NE(last.at("message").get<std::string>().find(attack.grows), std::string::npos) << last;
    EXPECT_TRUE(last.contains("line")) << last;
    EXPECT_NE(output.errors.find("--max-output raises the limit"), std::string::npos);
    const std::size_t size = output.document.dump(1).size();
    EXPECT_LT(size, 2 * kMegabyte);
  }
}

TEST(OutputBudget, HoldsMemoryInProportion) {
  constexpr std::uint64_t kMoreMemory = 48 << 20;
  for (const Attack& attack : kAttacks) {
    SCOPED_TRACE(attack.name);
    TemporaryFolder folder;
    cli::RunOptions options = options_of(folder, attack);
    options.json = folder.path("result.json");
    EXPECT_EQ(exit_code_within(kMoreMemory, options), 6);
    EXPECT_EQ(nlohmann::json::parse(testing::text_of(options.json)).at("status"), "budget");
  }
}

TEST(OutputBudget, LeavesATraceOfWholeLines) {
  TemporaryFolder folder;
  const Attack dwell = kAttacks[8];
  run_program(options_of(folder, dwell));
  const std::string trace = testing::text_of(folder.path("t.csv"));
  ASSERT_GT(trace.size(), kMegabyte * 9 / 10);
  EXPECT_LT(trace.size(), kMegabyte * 11 / 10);
  EXPECT_EQ(trace.back(), '\n');
  const std::size_t begin = trace.rfind('\n', trace.size() - 2) + 1;
  EXPECT_EQ(std::ranges::count(trace.substr(begin), ','), 9);
  EXPECT_EQ(std::ranges::count(trace.substr(0, trace.find('\n')), ','), 9);
}

/// Axes that lag, in moves that pass on: the budget is spent while others are still open.
TEST(OutputBudget, BreaksOffMovesThatPassOn) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("pass.nc", "O1\nG64G91\nN1G1X1.F600.\nG1Y1.\nG1X-1.\nG1Y-1.\nGOTO1\nM30\n")};
  options.setups = {folder.write("lag.toml",
                                 "[machine.axes.X]\nservo_gain = 3.0\nbacklash = 0.01\n"
                                 "[machine.axes.Y]\nservo_gain = 3.0\n")};
  options.trace = folder.path("t.csv");
  options.prints = {"#5041", "#5001", "#3001"};
  options.max_output = kMegabyte;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 6) << output.errors;
  EXPECT_EQ(output.document.at("status"), "budget");
  EXPECT_TRUE(output.document.at("variables").at("#5041").is_number());
  EXPECT_EQ(testing::text_of(options.trace).back(), '\n');
}

/// What is deleted or begun anew counts no more.
TEST(OutputBudget, CountsFilesWithWhatTheyAre) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(
      "w.mpf", "DEF INT E\nDEF INT I\nFOR I=1 TO 4000\nWRITE(E,\"A.TXT\",\"" +
                   std::string(150, 'X') +
                   "\")\nDELETE(E,\"A.TXT\")\nEXTOPEN(E,\"B.TXT\",\"ASYNC\",\"SHARED\",\"OVR\")\n"
                   "EXTWRITE(E,\"B.TXT\",\"" +
                   std::string(150, 'X') + "\")\nEXTCLOSE(E,\"B.TXT\")\nENDFOR\nM30\n")};
  options.max_output = 20'000;
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.document.at("files").at("B.TXT").get<std::string>().size(), 151U);
}

/// A program that grows is compiled anew at each call, and all that was compiled is kept.
TEST(OutputBudget, HoldsForProgramsThatAreWrittenAndCalled) {
  constexpr std::uint64_t kMoreMemory = 400 << 20;
  const Attack grows = {
      "a program that grows", "grow.mpf",
      "DEF INT E\nN10 WRITE(E,\"SUB.SPF\",\";" + std::string(190, 'X') + "\")\nSUB\nGOTOB N10\n",
      ""};
  TemporaryFolder folder;
  cli::RunOptions options = options_of(folder, grows);
  EXPECT_EQ(run_program(options).exit_code, 3);
  EXPECT_EQ(exit_code_within(kMoreMemory, options), 3);
}

/// Texts piece by piece are what nlohmann makes of the whole.
TEST(OutputBudget, DocumentReadsAsIfWrittenAtOnce) {
  TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("all.mpf",
                   "DEF INT E\nMSG(\"\xB0 \" << "
                   "\"1\")\nWRITE(E,\"A.TXT\",\"LINE\")\nWRITE(E,\"B.TXT\",\"\xE4\")\n"
                   "G1 X1 F100\nMEAS=1 G1 X2\nM0\nG4 F1\nM30\n")};
  options.prints = {"R1", "$P_UIFR[1,X,TR]"};
  options.moves = true;
  options.touches = true;
  for (const bool is_empty : {false, true}) {
    if (is_empty) {
      options.programs = {folder.write("none.nc", "O1\nM30\n")};
      options.prints.clear();
    }
    options.json = folder.path("result.json");
    testing::captured([&] { return cli::run_command(options); });
    const std::string text = testing::text_of(options.json);
    EXPECT_EQ(ordered_json::parse(text).dump(1) + "\n", text);
  }
}

TEST(OutputBudget, IsThatOfEachRunOfAStudy) {
  TemporaryFolder folder;
  folder.write("w.mpf", kAttacks[0].program);
  cli::StudyOptions options;
  const auto study = [&](const std::string& limit) {
    options.study = folder.write("study.toml",
                                 "[study]\nprogram = \"w.mpf\"\nrepeats = 3\n"
                                 "max_output = \"" +
                                     limit +
                                     "\"\n"
                                     "[results.r]\nvalue = \"R1\"\n");
    return testing::study_document(options);
  };
  const auto ended = study("100K");
  const auto document = nlohmann::json::parse(ended.out);
  ASSERT_EQ(document.at("rows").size(), 3U);
  for (const auto& row : document.at("rows")) {
    EXPECT_EQ(row.at("status"), "budget") << row;
  }
  const auto wrong = study("much");
  EXPECT_EQ(wrong.exit_code, 2);
  EXPECT_NE(wrong.errors.find("study.toml:4:14: error: max_output is \"much\", it should be a size "
                              "such as \"64M\" [SET105]"),
            std::string::npos)
      << wrong.errors;
}

TEST(ByteCount, TakesUnits) {
  const struct {
    const char* text;
    std::uint64_t bytes;  // 0: refused
  } kCases[] = {{"1", 1},
                {"256M", 256'000'000},
                {"500k", 500'000},
                {"2G", 2'000'000'000},
                {"1.5MB", 1'500'000},
                {"10kB", 10'000},
                {"0", 0},
                {"-5", 0},
                {"", 0},
                {"M", 0},
                {"1T", 0},
                {"1 M", 0},
                {"nan", 0},
                {"inf", 0},
                {"1e6", 0},
                {"99999999G", 0},
                {"0.1", 0},
                {"1MM", 0}};
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.text);
    const auto bytes = setup::parse_byte_count(c.text);
    EXPECT_EQ(bytes ? bytes.value() : 0U, c.bytes);
  }
}

TEST(OutputBudget, OptionTakesASize) {
  const auto parsed = [](const std::string& text) {
    return testing::parsed_run_options({"a.nc", "--max-output", text});
  };
  ASSERT_TRUE(parsed("1.5M"));
  EXPECT_EQ(parsed("1.5M").value().max_output, 1'500'000U);
  EXPECT_FALSE(parsed("much"));
}

TEST(SizeInDocument, IsThatOfTheEscapedText) {
  std::string all;
  for (int c = 0; c < 256; ++c) {
    all += static_cast<char>(c);
  }
  std::string utf8;
  for (const char c : all) {
    const auto byte = static_cast<unsigned char>(c);
    if (byte < 0x80) {
      utf8 += c;
    } else {
      utf8 += static_cast<char>(0xC0 | (byte >> 6));
      utf8 += static_cast<char>(0x80 | (byte & 0x3F));
    }
  }
  EXPECT_EQ(runtime::size_in_document(all), ordered_json(utf8).dump().size() - 2);
}

}  // namespace
}  // namespace g31::output_budget_test

// The document of a run is there whatever happened, and never that of an earlier run.

#include <filesystem>
#include <fstream>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/command_line.h"
#include "tools/disk/file_hash.h"

namespace g31::run_records_test {
namespace {

using nlohmann::json;
using testing::g31;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

TEST(RunRecord, IsThereWhateverHappened) {
  const struct {
    const char* name;
    const char* program;
    std::vector<std::string> words;
    const char* status;
    int exit_code;
  } kCases[] = {
      {"completed", "O1\nM30\n", {}, "completed", 0},
      {"findings", "O1\nG31 X9. F100.\nM30\n", {}, "completed", 1},
      {"syntax", "O1\n#1=[2+\nM30\n", {}, "alarm", 2},
      {"no program in the file", "", {}, "usage", 2},
      {"an unknown option", "O1\nM30\n", {"--nonsense"}, "usage", 2},
      {"an option without its value", "O1\nM30\n", {"--seed"}, "usage", 2},
      {"a wrong name", "O1\nM30\n", {"--print", "nonsense"}, "usage", 2},
      {"a missing sheet", "O1\nM30\n", {"-s", "/nowhere/none.toml"}, "usage", 2},
      {"an unknown control", "O1\nM30\n", {"--control", "fanuk"}, "setup", 5},
      {"an alarm", "O1\n#3000=1(STOP)\nM30\n", {}, "alarm", 3},
      {"a budget", "O1\nN1 GOTO 1\nM30\n", {"--max-blocks", "50"}, "budget", 6},
  };
  for (const auto& c : kCases) {
    for (const bool is_joined : {false, true}) {
      SCOPED_TRACE(fmt::format("{}, --json{}FILE", c.name, is_joined ? "=" : " "));
      const TemporaryFolder folder;
      const std::string path = folder.write("result.json", "of an earlier run");
      std::vector<std::string> words = {"run", folder.write("a.nc", c.program)};
      if (is_joined) {
        words.push_back("--json=" + path);
      } else {
        words.insert(words.end(), {"--json", path});
      }
      words.insert(words.end(), c.words.begin(), c.words.end());
      const auto said = g31(words);
      EXPECT_EQ(said.exit_code, c.exit_code) << said.errors;
      const json document = json::parse(testing::text_of(path), nullptr, false);
      ASSERT_TRUE(document.is_object()) << testing::text_of(path);
      EXPECT_EQ(document.at("schema"), "g31.run/1");
      EXPECT_EQ(document.at("version"), "7.8.9");
      EXPECT_EQ(document.at("status"), c.status);
      EXPECT_EQ(document.at("exit_code"), c.exit_code);
      // Of words that CLI11 cannot go through to their end it gives none.
      if (c.words != std::vector<std::string>{"--seed"}) {
        EXPECT_EQ(document.at("inputs").at(0).at("sha256"), *disk::sha256_of(words[1]));
      }
      if (c.exit_code >= 2) {
        EXPECT_FALSE(document.at("diagnostics").empty());
        EXPECT_EQ(document.at("diagnostics").back().at("severity"), "error");
      }
    }
  }
}

TEST(RunRecord, TakesThePlaceOfNothingThatIsRead) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM30\n");
  const auto said = g31({"run", program, "--json", program});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.errors.find("it would take the place of what is to be read"), std::string::npos);
  EXPECT_EQ(testing::text_of(program), "O1\nM30\n");
}

// A document names the subprograms that its program calls; the next run takes it for none of them.
TEST(RunRecord, TakesThePlaceOfThatOfAnEarlierRun) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nG65 P9010 A1.\nM30\n");
  for (const char* const option : {"--json", "--jsonl"}) {
    const std::string document = folder.path(std::string("a") + option + ".txt");
    for (int i = 0; i < 2; ++i) {
      const auto said = g31({"run", program, option, document});
      EXPECT_EQ(said.exit_code, 3) << said.errors;  // O9010 misses its data
      EXPECT_NE(testing::text_of(document).find("O9010"), std::string::npos);
    }
  }
}

/// Each option that writes a file, pointed at a file that only the sheet or the program names.
TEST(RunRecord, TakesThePlaceOfNothingThatASheetOrAProgramNames) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM98 P2\nDPRNT[X]\nM30\n");
  const std::string sheet =
      folder.write("s.toml",
                   "[control]\nvariables_file = \"kept.vars\"\n[machine]\nfile = \"m.toml\"\n"
                   "[expect]\noutput_file = \"golden.txt\"\n[[part]]\nfile = \"part.stl\"\n");
  const std::map<std::string, std::string> kFiles = {{"O0002.nc", "O2\nM99\n"},
                                                     {"kept.vars", ""},
                                                     {"m.toml", "name = \"M\"\n"},
                                                     {"golden.txt", "GOLDEN\n"},
                                                     {"part.stl",
                                                      "solid t\nfacet normal 0 0 1\nouter loop\n"
                                                      "vertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
                                                      "endloop\nendfacet\nendsolid t\n"}};
  for (const auto& [name, text] : kFiles) {
    folder.write(name, text);
  }
  for (const char* const option : {"--json", "--jsonl", "--trace", "--readings", "--printer"}) {
    for (const auto& [name, text] : kFiles) {
      SCOPED_TRACE(std::string(option) + " " + name);
      const std::string other = folder.path("./" + name);
      const auto said = g31({"run", program, "--setup", sheet, option, other});
      EXPECT_EQ(said.exit_code, 2);
      EXPECT_NE(said.errors.find(other + ": it would take the place of what is to be read"),
                std::string::npos)
          << said.errors;
      EXPECT_EQ(testing::text_of(folder.path(name)), text);
      EXPECT_FALSE(std::filesystem::exists(folder.path(name + ".part")));
    }
  }
}

TEST(RunRecord, OfARefusedRunLeavesOtherFilesAsTheyAre) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM30\n");
  const std::string broken = folder.write("s.toml", "[contr");
  const std::string other = folder.write("other.nc", "O2\nM99\n");
  const auto said = g31({"run", program, "--setup", broken, "--jsonl", other});
  EXPECT_EQ(said.exit_code, 2);
  EXPECT_NE(said.errors.find("no document of g31"), std::string::npos) << said.errors;
  EXPECT_EQ(testing::text_of(other), "O2\nM99\n");
  const std::string log = folder.path("events.log");
  EXPECT_EQ(g31({"run", program, "--jsonl", log}).exit_code, 0);
  EXPECT_EQ(g31({"run", program, "--setup", broken, "--jsonl", log}).exit_code, 2);
  EXPECT_NE(testing::text_of(log).find("SET102"), std::string::npos)
      << "an earlier log is replaced";
}

TEST(Outputs, OfCheckSetupAndStudyTakeThePlaceOfNothingThatIsRead) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM98 P2\n#100=1\nM30\n");
  const std::string called = folder.write("O0002.nc", "O2\nM99\n");
  const std::string machine = folder.write("m.toml", "name = \"M\"\n");
  const std::string sheet = folder.write("s.toml", "[machine]\nfile = \"m.toml\"\n");
  const std::string study = folder.write("st.toml",
                                         "[study]\nprogram = \"a.nc\"\nsetup = \"s.toml\"\n"
                                         "[results.r]\nvalue = \"#100\"\n");
  const std::vector<std::vector<std::string>> kLines = {{"check", program, "--json", called},
                                                        {"setup", sheet, "--json", machine},
                                                        {"study", study, "--json", program},
                                                        {"study", study, "--csv", machine},
                                                        {"study", study, "--json", sheet}};
  for (const std::vector<std::string>& line : kLines) {
    SCOPED_TRACE(line[0] + " " + line[2] + " " + line[3]);
    const std::string before = testing::text_of(line[3]);
    const auto said = g31(line);
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_NE(said.errors.find("it would take the place of what is to be read"), std::string::npos)
        << said.errors;
    EXPECT_EQ(testing::text_of(line[3]), before);
  }
}

TEST(Outputs, CannotShareStandardOutput) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM30\n");
  for (const auto& [first, second] :
       {std::pair("--json", "--trace"), std::pair("--jsonl", "--trace"),
        std::pair("--json", "--readings"), std::pair("--json", "--printer"),
        std::pair("--trace", "--readings")}) {
    const auto said = g31({"run", program, second, "-", first, "-"});
    EXPECT_EQ(said.exit_code, 2);
    EXPECT_EQ(said.out, "");
    EXPECT_EQ(said.errors,
              fmt::format("g31: error: {} and {} cannot both be standard output\n", first, second));
  }
}

TEST(Outputs, ThatCannotBeWrittenAreToldBeforeTheRun) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\n#3006=1(STOP)\nM30\n");
  for (const char* const option : {"--json", "--jsonl", "--trace", "--readings"}) {
    const auto said = g31({"run", program, option, folder.path("")});
    EXPECT_EQ(said.exit_code, 2) << option;
    EXPECT_EQ(
        said.errors.find(fmt::format("g31: error: {} {}: cannot write", option, folder.path(""))),
        0U)
        << said.errors;
  }
}

TEST(Outputs, TablesOnStandardOutputAreFreeOfPrintouts) {
  const TemporaryFolder folder;
  const std::string program =
      folder.write("a.nc", "O1\nPOPEN\nDPRNT[HELLO]\nPCLOS\nG1X1.F600.\nM30\n");
  const auto said = g31({"run", program, "--trace", "-", "-q"});
  EXPECT_EQ(said.exit_code, 0) << said.errors;
  EXPECT_EQ(said.out.find("HELLO"), std::string::npos);
  EXPECT_EQ(said.out.find("time_s"), 0U) << said.out;
  EXPECT_NE(said.errors.find("HELLO"), std::string::npos) << said.errors;
}

TEST(RunRecord, NamesItsInputsWithTheirHashes) {
  // Of FIPS 180-2, appendix B.1, and of nothing.
  const TemporaryFolder folder;
  EXPECT_EQ(disk::sha256_of(folder.write("abc", "abc")),
            "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad");
  EXPECT_EQ(disk::sha256_of(folder.write("none", "")),
            "e3b0c44298fc1c149afbf4c8996fb92427ae41e4649b934ca495991b7852b855");
  EXPECT_EQ(disk::sha256_of(folder.path("missing")), std::nullopt);
  cli::RunOptions options;
  options.programs = {folder.write("a.nc", "O1\nM98 P2\nM98 P3\n#500=1\nM30\n")};
  options.setups = {folder.write("s.toml",
                                 "[control]\nvariables_file = \"kept.vars\"\n"
                                 "[machine]\nfile = \"m.toml\"\n")};
  const std::string called = folder.write("O0002.nc", "O2\nM99\n");
  const std::string holds = folder.write("shop.nc", "O30\nM99\nO 0003(IT)\n#501=1\nM99\n");
  // Only looked into.
  const std::string holds_not = folder.write("other.nc", "O4\n#501=2(O 33)\nM99\n");
  folder.write("m.toml", "[machine]\nname = \"M\"\n");
  const std::string kept = folder.write("kept.vars", "#500=7\n");
  const std::string kept_before = *disk::sha256_of(kept);
  const RunOutput output = run_program(options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  std::map<std::string, std::string> hashes;
  for (const json& input : output.document.at("inputs")) {
    hashes[input.at("file")] = input.at("sha256");
  }
  EXPECT_EQ(hashes.size(), 6U) << output.document.at("inputs");
  EXPECT_TRUE(hashes.contains(holds));
  EXPECT_FALSE(hashes.contains(holds_not));
  EXPECT_EQ(hashes[options.programs[0]], *disk::sha256_of(options.programs[0]));
  EXPECT_EQ(hashes[called], *disk::sha256_of(called));
  EXPECT_EQ(hashes[kept], kept_before) << "as it was read";
  EXPECT_NE(hashes[kept], *disk::sha256_of(kept)) << "it has been saved since";
}

TEST(RunRecord, OfATouchSaysWhenByWhomAndWhere) {
  const struct {
    const char* file;
    const char* program;
    std::string sheet;
  } kCases[] = {
      {"a.nc", "O1\nT1 M6\nG90G54G43H1\nG00X0Y0\nM98P2\nM30\nO2\nG31 X20. F100.\n#1=#5061\nM99\n",
       "[tools.1]\nlength = 5.0\n"},
      {"a.mpf", "T1 M6\nG54 D1\nG0 X0 Y0\nTOUCHIT\nM30\n",
       "[tools.1]\nlength = 5.0\ntype = 120.0\n"}};
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.file);
    const TemporaryFolder folder;
    folder.write("TOUCHIT.SPF", "MEAS=1 G1 X20 F100\nR1=$AA_MW[X]\nM17\n");
    cli::RunOptions options;
    options.programs = {folder.write(c.file, c.program)};
    options.setups = {folder.write("s.toml", c.sheet +
                                                 "[work_offsets.G54]\nX = 3.0\nY = 4.0\nZ = -30.0\n"
                                                 "[[skip_signal]]\naxis = \"X\"\nat = 15.0\n")};
    options.touches = true;
    const RunOutput output = run_program(options);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const json& touch = output.document.at("touches").at(0);
    EXPECT_EQ(touch.at("latched").at(0), 15.0);
    EXPECT_EQ(touch.at("work").at(0), 12.0);
    EXPECT_EQ(touch.at("work").at(1), 0.0);
    EXPECT_EQ(touch.at("work").at(2), touch.at("latched").at(2).get<double>() + 30.0 - 5.0);
    EXPECT_EQ(touch.at("tool"), 1);
    EXPECT_GT(touch.at("time_s"), 0.0);
    EXPECT_LE(touch.at("time_s"), output.document.at("machine_time_s"));
    ASSERT_EQ(touch.at("calls").size(), 1U);
    EXPECT_EQ(touch.at("calls").at(0).at("file"), c.file);
    EXPECT_EQ(touch.at("calls").at(0).at("line"), c.file == std::string("a.nc") ? 5 : 4);
  }
}

TEST(RunRecord, HasTheMoveThatACollisionEnded) {
  const struct {
    const char* file;
    const char* program;
  } kCases[] = {{"a.nc", "O1\nG54\nG01 X100. F500.\nM30\n"}, {"a.mpf", "G54\nG1 X100 F500\nM30\n"}};
  for (const auto& c : kCases) {
    SCOPED_TRACE(c.file);
    const TemporaryFolder folder;
    cli::RunOptions options;
    options.programs = {folder.write(c.file, c.program)};
    options.setups = {folder.write(
        "s.toml",
        "[work_offsets.G54]\nX = 1.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\n[[part]]\n"
        "name = \"box\"\nshape = \"block\"\nheight = 40.0\nat = [80.0, 0.0, 0.0]\n[start]\n"
        "Z = 80.0\n")};
    const RunOutput output = run_program(options);
    ASSERT_EQ(output.exit_code, 4) << output.errors;
    const json& fault = output.document.at("collision");
    EXPECT_EQ(fault.at("what"), output.document.at("diagnostics").back().at("message"));
    EXPECT_NEAR(fault.at("at").at(0).get<double>() - fault.at("work").at(0).get<double>(), 1.0,
                1e-12);
    EXPECT_EQ(fault.at("part"), "box");
    EXPECT_EQ(fault.at("move").at("g"), 1);
    EXPECT_EQ(fault.at("move").at("feed"), 500.0);
    EXPECT_EQ(fault.at("move").at("to").at(0), 101.0);
    EXPECT_EQ(fault.at("line"), c.file == std::string("a.nc") ? 3 : 2);
  }
}

TEST(RunRecord, ListsWhatIsAllowed) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {
      folder.write("a.nc", "O1\nG31 X9. F100. (g31: allow PRB301 may be empty)\nM30\n")};
  const RunOutput output = run_program(options);
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_TRUE(output.document.at("diagnostics").empty());
  const json& allowed = output.document.at("allowed").at(0);
  EXPECT_EQ(allowed.at("code"), "PRB301");
  EXPECT_EQ(allowed.at("reason"), "may be empty");
  EXPECT_EQ(allowed.at("line"), 2);
}

}  // namespace
}  // namespace g31::run_records_test

// No output of any command takes the place of anything that the command reads, and a command that
// is refused for one tells it in its document.

#include <cstdlib>
#include <filesystem>
#include <map>
#include <string>
#include <string_view>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"

namespace g31::output_places_test {
namespace {

namespace fs = std::filesystem;
using nlohmann::json;
using testing::CommandOutput;
using testing::TemporaryFolder;
using testing::text_of;
using Words = std::vector<std::string>;

constexpr const char* kTriangle =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nendsolid t\n";

/// A shop's folder, in which everything names something else.
const std::map<std::string, std::string>& files() {
  static const std::map<std::string, std::string> kFiles = {
      {"a.nc", "O1\nM98 P2\nM98 P3\n#100=1\nM30\n"},
      {"O0002.nc", "O2\nM99\n"},
      {"lib/O0003.nc", "O3\nM99\n"},
      {"more.nc", "O4\nM99\n"},
      {"before.nc", "O1\nM98 P5\nM30\n"},
      {"O0005.nc", "O5\nM99\n"},
      {"s.toml",
       "[control]\nvariables_file = \"kept.vars\"\n[machine]\nfile = \"m.toml\"\n"
       "[expect]\noutput_file = \"golden.txt\"\n[[part]]\nname = \"p\"\nfile = \"part.stl\"\n"},
      {"t.toml", "[variables]\n\"#101\" = 1.0\n"},
      {"m.toml", "name = \"M\"\n"},
      {"n.toml", "name = \"N\"\n"},
      {"v1.toml", "[variables]\n\"#102\" = 1.0\n"},
      {"v2.toml", "[machine]\nfile = \"n.toml\"\n"},
      {"kept.vars", "#500=1\n"},
      {"golden.txt", "GOLDEN\n"},
      {"part.stl", kTriangle},
      {"known.json", R"({"schema": "g31.check/1", "findings": []})"},
      {"other.json", R"({"schema": "g31.run/1"})"},
      {"st.toml",
       "[study]\nprogram = \"a.nc\"\nsetup = \"s.toml\"\nlibraries = [\"lib\"]\n"
       "before = [\"before.nc\"]\n[results.r]\nvalue = \"#100\"\n[evaluation]\nkind = \"speed\"\n"
       "[[vary]]\nkey = \"setup\"\nvalues = [\"v1.toml\", \"v2.toml\"]\n"},
      {"shard.json", R"({"schema": "g31.study.shard/1"})"},
      {"product.step", "no product yet\n"},
      {"stock.step", "no stock yet\n"},
      {"made.step", "not made yet\n"},
      {"plan.json", R"({"schema": "g31.plan/1", "measures": [{"id": "D", "nominal": 1}]})"},
      {"results.txt", "D 1.0\n"},
      {"r.csv", "t,X,Y\n0,1,0\n1,0,1\n2,-1,0\n"},
      {"d.csv", "theta,D\n0,1\n"},
  };
  return kFiles;
}

/// A command with the options by which it writes, and what it reads.
struct Command {
  const char* schema;
  Words words;  ///< names of files begin with @
  Words outputs;
  Words inputs;
};

std::vector<Command> commands() {
  const Words named = {"s.toml", "m.toml", "kept.vars", "golden.txt", "part.stl"};
  const Words called = {"a.nc", "O0002.nc", "lib/O0003.nc"};
  const auto with = [](Words all, const Words& more) {
    all.insert(all.end(), more.begin(), more.end());
    return all;
  };
  const Words job = with(named, called);
  const Words plan = {"plan", "@product.step", "--stock",    "@stock.step", "-o",
                      "@out", "--as-machined", "@made.step", "-s",          "@s.toml"};
  return {
      {"g31.run/1",
       {"run", "@a.nc", "@more.nc", "-s", "@s.toml", "-s", "@t.toml", "--lib", "@lib"},
       {"--json", "--jsonl", "--trace", "--readings", "--printer", "--report"},
       with(job, {"more.nc", "t.toml"})},
      {"g31.run/1",
       {"run", "@a.nc", "--lib", "@lib", "--compare", "@other.json", "--report", "@out.html"},
       {"--json", "--jsonl", "--trace", "--readings", "--printer"},
       {"other.json"}},
      {"g31.scene/1", {"scene", "@a.nc", "-s", "@s.toml", "--lib", "@lib"}, {"-o"}, job},
      {"g31.scene/1",
       {"scene", "@a.nc", "-s", "@s.toml", "--lib", "@lib", "-o", "@out.svg"},
       {"--json"},
       job},
      {"g31.setup/1", {"setup", "@s.toml", "--program", "@a.nc", "--lib", "@lib"}, {"--json"}, job},
      {"g31.check/1",
       {"check", "@a.nc", "-s", "@s.toml", "--lib", "@lib", "--baseline", "@known.json"},
       {"--json"},
       with(job, {"known.json"})},
      {"g31.study/1",
       {"study", "@st.toml", "--threads", "2"},
       {"--json", "--csv", "--svg", "--report"},
       with(job, {"st.toml", "before.nc", "O0005.nc", "v1.toml", "v2.toml", "n.toml"})},
      {"g31.study/1",
       {"study", "--merge", "@shard.json"},
       {"--json", "--csv", "--report"},
       {"shard.json"}},
      {"g31.evaluation/1",
       {"evaluate", "circle", "@r.csv"},
       {"--json", "--svg", "--report"},
       {"r.csv"}},
      {"g31.evaluation/1", {"evaluate", "positioning", "@r.csv"}, {"--compensation"}, {"r.csv"}},
      {"g31.evaluation/1",
       {"evaluate", "cylindricity", "@r.csv", "--diameters", "@d.csv", "--step", "20"},
       {"--json", "--svg", "--report"},
       {"r.csv", "d.csv"}},
      {"g31.plan/1", plan, {"--json"}, with(named, {"product.step", "stock.step", "made.step"})},
      {"g31.judgement/1",
       {"judge", "@plan.json", "@results.txt"},
       {"--json", "--report"},
       {"plan.json", "results.txt"}},
  };
}

Words in_folder(const TemporaryFolder& folder, Words words) {
  for (std::string& word : words) {
    word = word.starts_with('@') ? folder.path(word.substr(1)) : word;
  }
  return words;
}

/// By which what an option writes is known; "": by none.
std::string ending_of(const std::string& option) {
  if (option == "-o") {
    return ".svg";
  }
  return option == "--report" ? ".html" : "";
}

/// Of a document on standard output: that the command was refused, and for what.
void expect_refusal(const std::string& text, const std::string& schema, const std::string& why) {
  const json document = json::parse(text, nullptr, false);
  ASSERT_TRUE(document.is_object()) << "'" << text << "'";
  EXPECT_EQ(document.at("schema"), schema);
  EXPECT_EQ(document.at("status"), "usage");
  EXPECT_EQ(document.at("exit_code"), 2);
  EXPECT_NE(document.at("diagnostics").at(0).at("message").get<std::string>().find(why),
            std::string::npos)
      << text;
}

class OutputPlaces : public ::testing::Test {
 protected:
  OutputPlaces() {
    fs::create_directories(folder_.path("lib"));
    for (const auto& [name, text] : files()) {
      folder_.write(name, text);
    }
  }

  /// Points an option at a file that is read.
  void expect_untouched(const Command& command, const std::string& option,
                        const std::string& input) {
    SCOPED_TRACE(command.words.front() + " " + option + " " + input);
    std::string place = folder_.path(input);
    if (const std::string ending = ending_of(option); !ending.empty()) {
      place = folder_.path("link" + ending);
      fs::remove(place);
      fs::create_symlink(folder_.path(input), place);
    }
    Words words = in_folder(folder_, command.words);
    words.insert(words.end(), {option, place});
    if (option != "--json") {
      words.insert(words.end(), {"--json", "-"});
    }
    const CommandOutput said = testing::g31(words);
    EXPECT_EQ(said.exit_code, 2) << said.errors;
    const std::string why =
        option + " " + place + ": it would take the place of what is to be read";
    EXPECT_NE(said.errors.find(why), std::string::npos) << said.errors;
    EXPECT_EQ(said.errors.find(why), said.errors.rfind(why)) << "once: " << said.errors;
    EXPECT_EQ(text_of(folder_.path(input)), files().at(input));
    if (option != "--json") {
      expect_refusal(said.out, command.schema, why);
    }
  }

  TemporaryFolder folder_;
};

TEST_F(OutputPlaces, AreNoneOfWhatIsRead) {
  for (const Command& command : commands()) {
    for (const std::string& option : command.outputs) {
      for (const std::string& input : command.inputs) {
        expect_untouched(command, option, input);
      }
    }
  }
}

TEST_F(OutputPlaces, AreNoneOfTheMacrosThatComeAlong) {
  folder_.write("b.nc", "O1\nG65 P9777\nM30\n");
  fs::create_directories(folder_.path("home/macros/fanuc"));
  const std::string macro = folder_.write("home/macros/fanuc/O9777.nc", "O9777\nM99\n");
  ::setenv("G31_HOME", folder_.path("home").c_str(), 1);
  for (const Words& words : {Words{"run", "@b.nc", "--json"}, Words{"check", "@b.nc", "--json"},
                             Words{"scene", "@b.nc", "-o", "@b.svg", "--json"}}) {
    SCOPED_TRACE(words.front());
    Words line = in_folder(folder_, words);
    line.push_back(macro);
    const CommandOutput said = testing::g31(line);
    EXPECT_EQ(said.exit_code, 2) << said.errors;
    EXPECT_NE(said.errors.find("it would take the place of what is to be read"), std::string::npos)
        << said.errors;
    EXPECT_EQ(text_of(macro), "O9777\nM99\n");
  }
  ::unsetenv("G31_HOME");
}

// Drawings of several runs have names of their own.
TEST_F(OutputPlaces, OfSingleRunsAreNoneOfWhatIsRead) {
  folder_.write("v-1.toml", "[variables]\n\"#103\" = 1.0\n");
  const std::string study = folder_.write(
      "drawn.toml",
      "[study]\nprogram = \"circle.nc\"\nsetup = \"v-1.toml\"\nrepeats = 2\n[results.r]\n"
      "value = \"#100\"\n[evaluation]\nkind = \"circle\"\n");
  folder_.write("circle.nc", "O1\n#100=1\nG90G54G17G02X0Y0I50.F3000.\nM30\n");
  const CommandOutput said = testing::g31({"study", study, "--svg", folder_.path("v.toml")});
  EXPECT_EQ(said.exit_code, 2) << said.errors;
  EXPECT_NE(said.errors.find("v-1.toml: it would take the place"), std::string::npos)
      << said.errors;
  EXPECT_EQ(text_of(folder_.path("v-1.toml")), "[variables]\n\"#103\" = 1.0\n");
  // Nor are they other outputs, nor devices with a number behind their names.
  const CommandOutput shared = testing::g31(
      {"study", study, "--svg", folder_.path("e.svg"), "--json", folder_.path("e-2.svg")});
  EXPECT_EQ(shared.exit_code, 2) << shared.errors;
  EXPECT_NE(shared.errors.find("--json and --svg cannot both be"), std::string::npos)
      << shared.errors;
  const CommandOutput device = testing::g31({"study", study, "--svg", "/dev/null"});
  EXPECT_EQ(device.exit_code, 2) << device.errors;
  EXPECT_FALSE(fs::exists("/dev/null-1"));
}

TEST_F(OutputPlaces, AreNoneOfWhatTheProgramWrites) {
  folder_.write("w.mpf", "DEF INT E\nWRITE(E,\"LOG\",\"line\")\nM30\n");
  folder_.write("files.toml", "[control]\nprofile = \"sinumerik-828d\"\nfiles = \"kept\"\n");
  fs::create_directories(folder_.path("kept"));
  const CommandOutput said =
      testing::g31({"run", folder_.path("w.mpf"), "-s", folder_.path("files.toml"), "--json",
                    folder_.path("kept/LOG")});
  EXPECT_EQ(said.exit_code, 2) << said.errors;
  EXPECT_NE(said.errors.find("it would take the place"), std::string::npos) << said.errors;
  EXPECT_FALSE(fs::exists(folder_.path("kept/LOG")));
}

TEST_F(OutputPlaces, AreNoneOfWhatTheProgramDeletes) {
  folder_.write("d.mpf", "DEF INT E\nDELETE(E,\"OUT\")\nM30\n");
  folder_.write("files.toml", "[control]\nprofile = \"sinumerik-828d\"\nfiles = \"kept\"\n");
  fs::create_directories(folder_.path("kept"));
  for (const std::string option : {"--printer", "--json"}) {
    SCOPED_TRACE(option);
    const std::string place = folder_.write("kept/OUT", option == "--json" ? "" : "x\n");
    const CommandOutput said = testing::g31(
        {"run", folder_.path("d.mpf"), "-s", folder_.path("files.toml"), option, place});
    EXPECT_EQ(said.exit_code, 2) << said.errors;
    EXPECT_NE(said.errors.find(option + " " + place + ": it would take the place"),
              std::string::npos)
        << said.errors;
    EXPECT_TRUE(fs::exists(place));
  }
}

// What an earlier run of the command has left is no input.
TEST_F(OutputPlaces, AreThoseOfAnEarlierDocument) {
  for (const Words& words :
       {Words{"setup", "@t.toml", "--program", "@a.nc", "--lib", "@lib"},
        Words{"check", "@a.nc", "--lib", "@lib"}, Words{"run", "@a.nc", "--lib", "@lib"},
        Words{"scene", "@a.nc", "--lib", "@lib", "-o", "@out.svg"}}) {
    SCOPED_TRACE(words.front());
    Words line = in_folder(folder_, words);
    line.insert(line.end(), {"--json", folder_.path(words.front() + ".txt")});
    const CommandOutput first = testing::g31(line);
    EXPECT_LT(first.exit_code, 2) << first.errors;
    const CommandOutput second = testing::g31(line);
    EXPECT_EQ(second.exit_code, first.exit_code) << second.errors;
  }
}

/// Outputs in a folder that is not there: the document says so once, and so does standard error.
TEST_F(OutputPlaces, ThatCannotBeAreToldInTheDocument) {
  for (const Command& command : commands()) {
    for (const std::string& option : command.outputs) {
      if (option == "--json" || option == "--printer" || command.words[1] == "--merge" ||
          command.inputs == Words{"other.json"}) {
        continue;
      }
      SCOPED_TRACE(command.words.front() + " " + option);
      Words words = in_folder(folder_, command.words);
      const std::string place = folder_.path("nodir/x" + ending_of(option));
      words.insert(words.end(), {option, place, "--json", "-"});
      const CommandOutput said = testing::g31(words);
      EXPECT_EQ(said.exit_code, 2) << said.errors;
      constexpr std::string_view kError = "error: ";
      EXPECT_EQ(said.errors.find(kError), said.errors.rfind(kError)) << said.errors;
      expect_refusal(said.out, command.schema, place);
    }
  }
}

}  // namespace
}  // namespace g31::output_places_test

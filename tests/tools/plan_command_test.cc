// `g31 plan`: from the case study's model to a program that has run on it, in every dialect.

#include <array>
#include <cmath>
#include <filesystem>
#include <fstream>
#include <map>
#include <numbers>
#include <string>
#include <thread>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/effort.h"
#include "tests/support/played_printer.h"
#include "tests/tools/planned_case.h"
#include "tools/cli/judge_command.h"
#include "tools/session/control.h"

namespace g31::plan_command_test {
namespace {

using nlohmann::json;
using testing::CommandOutput;
using testing::ProgramRun;
using testing::row_of;
using testing::run_plan;
using testing::text_of;

const std::string kProduct = testing::kInspected;

class Plan : public testing::PlannedCase {};

TEST_F(Plan, FindsTheSevenFeaturesOfFiveKindsOfTheCaseStudy) {
  const CommandOutput output = plan({kProduct, "--stock", "160,110,40"});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.errors, "");
  struct Row {
    const char* kind;
    std::vector<double> min;
    std::vector<double> max;
    std::vector<std::string> open;
  };
  const std::vector<Row> rows = {
      {"open_slot", {0, 45, -10}, {160, 57, 0}, {"+X", "-X", "+Z"}},
      {"closed_slot", {20, 0, -12}, {36, 25, 0}, {"-Y", "+Z"}},
      {"blind_hole", {20, 75, -18}, {40, 95, 0}, {"+Z"}},
      {"closed_slot", {60, 0, -8}, {72, 25, 0}, {"-Y", "+Z"}},
      {"blind_hole", {67, 77, -14}, {83, 93, 0}, {"+Z"}},
      {"closed_pocket", {90, 10, -15}, {130, 35, 0}, {"+Z"}},
      {"open_pocket", {120, 75, -12}, {160, 110, 0}, {"+X", "+Y", "+Z"}},
  };
  const json features = document().at("features");
  ASSERT_EQ(features.size(), rows.size());
  for (std::size_t i = 0; i < rows.size(); ++i) {
    EXPECT_EQ(features[i].at("id"), fmt::format("F{}", i + 1));
    EXPECT_EQ(features[i].at("kind"), rows[i].kind);
    EXPECT_EQ(features[i].at("min"), rows[i].min);
    EXPECT_EQ(features[i].at("max"), rows[i].max);
    EXPECT_EQ(features[i].at("open"), rows[i].open);
  }
  EXPECT_TRUE(document().at("not_measured").empty());
}

// The paper's points: 5 mm below the upper face and 5 mm below the floor, 3 mm beside the edge.
TEST_F(Plan, TouchesWhereThePaperDoes) {
  ASSERT_EQ(plan({kProduct, "--stock", "box"}).exit_code, 0);
  const json plan = document();
  const auto point = [&plan](const std::string& measure, std::size_t which) {
    return row_of(plan.at("points"), row_of(plan.at("measures"), measure).at("points").at(which));
  };
  using V = std::vector<double>;
  EXPECT_EQ(point("F7.X", 0).at("at"), V({120, 92.5, -5}));
  EXPECT_EQ(point("F7.X", 0).at("start"), V({126, 92.5, -5}));
  EXPECT_EQ(point("F7.X", 1).at("at"), V({160, 92.5, -17}));
  EXPECT_EQ(point("F7.X", 1).at("start"), V({166, 92.5, -17}));
  EXPECT_EQ(point("F7.Y", 1).at("at"), V({140, 110, -17}));
  EXPECT_EQ(point("F7.Z", 0).at("at"), V({140, 92.5, -12}));
  EXPECT_EQ(point("F7.Z", 0).at("start"), V({140, 92.5, 1}));
  EXPECT_EQ(point("F7.Z", 1).at("at"), V({117, 92.5, 0}));
  EXPECT_EQ(point("F3.X", 0).at("at"), V({20, 85, -5}));
  for (const json& each : plan.at("points")) {
    EXPECT_FALSE(each.contains("moved")) << each;
  }
}

TEST_F(Plan, ItsProgramRunsOnEveryControlAndItsValuesAreThoseOfTheModel) {
  for (const std::string& control : testing::some_of(session::control_names())) {
    SCOPED_TRACE(control);
    // What eight digits hold; rounding may take half of the last one.
    const CommandOutput output =
        plan({kProduct, "--stock", "box", "--control", control, "--tolerance", "1.1e-5"});
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const std::string program = out(control == "sinumerik-828d" ? "INSPECT.MPF" : "inspect.nc");
    const json measures = document().at("measures");
    ASSERT_EQ(measures.size(), 29U);
    const ProgramRun run = run_plan(program, out("setup.toml"), measures);
    ASSERT_EQ(run.variables.size(), measures.size());
    for (const json& measure : measures) {
      EXPECT_NEAR(run.variables.at(measure.at("variable")), measure.at("nominal"), 1e-6)
          << measure.at("id");
    }
    const CommandOutput judged =
        testing::g31({"judge", out("plan.json"), folder_.write("results.txt", run.printed)});
    EXPECT_EQ(judged.exit_code, 0) << judged.out << judged.errors;
    EXPECT_NE(judged.out.find("29 of 29 good"), std::string::npos);
  }
}

/// A block with a pocket of 40, 24 and 9 mm that is turned, as a text whose numbers are cut.
std::string turned_pocket(double degrees, const char* number) {
  const double cosine = std::cos(degrees * std::numbers::pi / 180.0);
  const double sine = std::sin(degrees * std::numbers::pi / 180.0);
  constexpr double kOutside[4][2] = {{50, -40}, {50, 40}, {-50, 40}, {-50, -40}};
  constexpr double kInside[4][2] = {{20, -12}, {20, 12}, {-20, 12}, {-20, -12}};
  std::string text = "solid a\n";
  const auto vertex = [&](const double(&ring)[4][2], std::size_t i, double z) {
    const double x = ring[i % 4][0];
    const double y = ring[i % 4][1];
    const bool is_turned = &ring == &kInside;
    const double at[] = {is_turned ? 5.0 + x * cosine - y * sine : x,
                         is_turned ? -3.0 + x * sine + y * cosine : y, z};
    std::string line = "vertex";
    for (const double coordinate : at) {
      line += " " + fmt::format(fmt::runtime(number), coordinate);
    }
    return line + "\n";
  };
  const auto quadrangle = [&](const std::array<std::string, 4>& corners) {
    for (const std::size_t third : {2U, 3U}) {
      text += "facet normal 0 0 0\nouter loop\n" + corners[0] + corners[third - 1] +
              corners[third] + "endloop\nendfacet\n";
    }
  };
  for (std::size_t i = 0; i < 4; ++i) {
    quadrangle({vertex(kInside, i, 30), vertex(kOutside, i, 30), vertex(kOutside, i + 1, 30),
                vertex(kInside, i + 1, 30)});
    quadrangle({vertex(kOutside, i, 0), vertex(kOutside, i + 1, 0), vertex(kOutside, i + 1, 30),
                vertex(kOutside, i, 30)});
    quadrangle({vertex(kInside, i + 1, 21), vertex(kInside, i, 21), vertex(kInside, i, 30),
                vertex(kInside, i + 1, 30)});
  }
  quadrangle({vertex(kInside, 0, 21), vertex(kInside, 1, 21), vertex(kInside, 2, 21),
              vertex(kInside, 3, 21)});
  quadrangle({vertex(kOutside, 3, 0), vertex(kOutside, 2, 0), vertex(kOutside, 1, 0),
              vertex(kOutside, 0, 0)});
  return text + "endsolid a\n";
}

TEST_F(Plan, WallsOfATextWithCutNumbersStandAtRightAngles) {
  for (const char* number : {"{:g}", "{:.4f}", "{:e}", "{:.6f}"}) {
    for (const double degrees : {5.0, 20.0}) {
      SCOPED_TRACE(fmt::format("{} {}", number, degrees));
      const std::string part = folder_.write("turned.stl", turned_pocket(degrees, number));
      const CommandOutput output = plan({part, "--stock", "box", "--tolerance", "0.01"});
      ASSERT_EQ(output.exit_code, 0) << output.out << output.errors;
      std::map<std::string, double> nominals;
      const json measures = document().at("measures");
      for (const json& measure : measures) {
        nominals[measure.at("id")] = measure.at("nominal");
      }
      EXPECT_NEAR(nominals["F1.X"], 40.0, 2e-4);
      EXPECT_NEAR(nominals["F1.Y"], 24.0, 2e-4);
      EXPECT_NEAR(nominals["F1.Z"], 9.0, 1e-4);
    }
  }
}

TEST_F(Plan, FindsTheErrorsOfAMachinedPartAndNothingElse) {
  // The pocket F6 0.05 too wide, the hole F3 0.03 too flat, the slot F4 shifted by 0.02.
  const std::string machined = changed_product({{"(90.,", "(89.975,"},
                                                {"(130.,", "(130.025,"},
                                                {",-18.)", ",-17.97)"},
                                                {"(60.,", "(60.02,"},
                                                {"(72.,", "(72.02,"}});
  const CommandOutput output =
      plan({kProduct, "--stock", "box", "--tolerance", "0.01", "--as-machined", machined});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const std::map<std::string, double> errors = {
      {"F6.X", 0.05}, {"F3.Z", -0.03}, {"F4.X.place", 0.02}};
  const json document_made = document();
  for (const json& row : document_made.at("as_machined").at("measures")) {
    const auto error = errors.find(row.at("id"));
    const bool is_wrong = error != errors.end();
    EXPECT_EQ(row.at("verdict"), is_wrong ? "bad" : "good") << row;
    EXPECT_NEAR(row.at("deviation"), is_wrong ? error->second : 0.0, 1e-3) << row;
  }
  const std::string page = text_of(out("plan.html"));
  for (const char* const piece :
       {"<div class=\"verdict bad\">", "As machined, F3.Z, F4.X.place, F6.X are not good.",
        "F6.X of the part as machined is +50.0 µm off", "of the part as machined</span>",
        "of the part as drawn; every skip move"}) {
    EXPECT_NE(page.find(piece), page.npos) << piece;
  }
}

TEST_F(Plan, ItsPageHasItsDocument) {
  ASSERT_EQ(plan({kProduct, "--stock", "box"}).exit_code, 0);
  const std::string page = text_of(out("plan.html"));
  const std::string mark = "id=\"g31-document\">";
  const std::size_t begin = page.find(mark) + mark.size();
  EXPECT_EQ(json::parse(page.substr(begin, page.find("</script>", begin) - begin)), document());
}

TEST_F(Plan, ItsProgramPrintsOverALineToWhoJudges) {
  ASSERT_EQ(plan({kProduct, "--stock", "box", "--tolerance", "1.1e-5"}).exit_code, 0);
  const testing::PlayedPrinter judge_line;
  testing::PlayedPrinter printer([&judge_line, passed = std::size_t{0}](
                                     testing::PlayedPrinter&, const std::string& received) mutable {
    for (; passed < received.size(); ++passed) {
      judge_line.say(received[passed]);
    }
  });
  printer.start();
  cli::JudgeOptions judge;
  judge.plan = out("plan.json");
  judge.results = judge_line.device() + ",19200,e,7,2";
  judge.json = folder_.path("judgement.json");
  judge.wait_s = 30.0;
  auto verdict = cli::ExitCode::Defect;
  std::thread judging([&] { verdict = cli::judge_command(judge); });
  cli::RunOptions run;
  run.programs = {out("inspect.nc")};
  run.setups = {out("setup.toml")};
  run.printer = printer.device() + ",19200,e,7,2";
  EXPECT_EQ(testing::run_program(run).exit_code, 0);
  judging.join();
  printer.heard();
  EXPECT_EQ(verdict, cli::ExitCode::Completed) << text_of(judge.json);
}

TEST_F(Plan, TheSheetOfAShopKeepsItsFixturesAndTheirPlace) {
  std::filesystem::create_directory(folder_.path("shop"));
  folder_.write(
      "shop/clamp.stl",
      "solid clamp\n"
      "facet normal 0 0 1\nouter loop\nvertex 75 30 20\nvertex 85 30 20\nvertex 80 70 20\n"
      "endloop\nendfacet\nendsolid clamp\n");
  const std::string sheet = folder_.write(
      "shop/machine.toml",
      "[control]\nprofile = \"fanuc-30i\"\n"
      "[work_offsets.G54]\nX = 300.0\nY = -200.0\nZ = -400.0\n"
      "[tools.7]\nlength = 152.0    # to the lower end of the ball\n"
      "[probe]\nball_diameter = 4.0\nlength = 150.0\ntool = 7\non = \"M80\"\noff = \"M81\"\n"
      "[[part]]\nname = \"clamp\"\nfile = \"clamp.stl\"   # bridges the slot F1\n"
      "closed = false\nfixture = true\non = \"G54\"\n");
  const CommandOutput output = plan({kProduct, "--stock", "box", "--setup", sheet});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const json plan = document();
  EXPECT_EQ(plan.at("control"), "fanuc-30i");
  const json y = row_of(plan.at("measures"), "F1.Y");
  const json point = row_of(plan.at("points"), y.at("points").at(0));
  EXPECT_NE(point.value("moved", "").find("clamp"), std::string::npos) << point;
  const ProgramRun run = run_plan(out("inspect.nc"), out("setup.toml"), json::array({y}));
  EXPECT_NEAR(run.variables.at(y.at("variable")), 12.0, 1e-6);
  const std::string program = text_of(out("inspect.nc"));
  for (const char* const block : {"T7 M06", "G43 H7", "M80", "M81"}) {
    EXPECT_NE(program.find(block), std::string::npos) << block;
  }
}

// A machine of g31's own library is named without a folder; what is not there is left as it is.
TEST_F(Plan, TheSheetOfAShopKeepsItsMachineAndItsFiles) {
  std::filesystem::create_directory(folder_.path("shop"));
  const std::string sheet = folder_.write(
      "shop/machine.toml",
      "[work_offsets.G54]\r\nX = 300.0\r\nY = -200.0\r\nZ = -300.0\r\n[machine]\r\nfile = "
      "\"v55.toml\"\r\n[tools.1]\r\nlength = 120.0\r\n[probe]\r\nlength = 120.0\r\n");
  const CommandOutput output =
      plan({kProduct, "--stock", "box", "--setup", sheet, "--control", "haas"});
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const std::string made = text_of(out("setup.toml"));
  EXPECT_NE(made.find("file = \"v55.toml\"\r\n"), std::string::npos) << made;
  EXPECT_NE(made.find("profile = \"haas\""), std::string::npos) << made;
  EXPECT_NE(made.find("on = \"G54\""), std::string::npos) << made;
}

// As people name their control on the command line and in their sheets.
TEST_F(Plan, ASheetMayNameAModelOfTheControl) {
  const std::string sheet = folder_.write(
      "model.toml",
      "[control]\nprofile = \"0i-MF\"\n[work_offsets.G54]\nX = 300.0\nY = -200.0\nZ = -300.0\n"
      "[tools.1]\nlength = 120.0\n[probe]\nlength = 120.0\n");
  for (const char* const control : {"0i-MF", "fanuc-30i"}) {
    const CommandOutput output =
        plan({kProduct, "--stock", "box", "--setup", sheet, "--control", control});
    EXPECT_EQ(output.exit_code, 0) << control << "\n" << output.errors;
  }
  const CommandOutput other =
      plan({kProduct, "--stock", "box", "--setup", sheet, "--control", "haas"});
  EXPECT_EQ(other.exit_code, 2);
  EXPECT_NE(other.errors.find("the sheet is for 0i-MF, the program for haas"), std::string::npos)
      << other.errors;
}

// An axis that ends before a feature leaves that one out.
TEST_F(Plan, WhatTheAxesDoNotGetToIsNotMeasured) {
  const std::string sheet = folder_.write(
      "shop.toml",
      "[control]\nprofile = \"fanuc-30i\"\n[work_offsets.G54]\nX = 100.0\nY = 0.0\nZ = -300.0\n"
      "[machine.axes.X]\ntravel = [-500.0, 240.0]\n[tools.1]\nlength = 120.0\n"
      "[probe]\nlength = 120.0\n");
  const CommandOutput output = plan({kProduct, "--stock", "box", "--setup", sheet});
  ASSERT_EQ(output.exit_code, 1) << output.errors;
  const json made = document();
  EXPECT_GT(made.at("measures").size(), 5U);
  ASSERT_FALSE(made.at("not_measured").empty());
  for (const json& row : made.at("not_measured")) {
    EXPECT_NE(row.at("why").get<std::string>().find("its travel ends at 240 mm"), std::string::npos)
        << row;
  }
}

TEST_F(Plan, LeavesNoProgramOfAnEarlierPlanBesideIt) {
  ASSERT_EQ(plan({kProduct, "--stock", "box", "--control", "828D"}).exit_code, 0);
  ASSERT_EQ(plan({kProduct, "--stock", "box", "--control", "fanuc-30i"}).exit_code, 0);
  EXPECT_TRUE(std::filesystem::exists(out("inspect.nc")));
  EXPECT_FALSE(std::filesystem::exists(out("INSPECT.MPF")));
}

TEST_F(Plan, ReplacesNoFilesOfTheUser) {
  std::filesystem::create_directory(folder_.path("out"));
  for (const char* const name : {"setup.toml", "inspect.nc", "INSPECT.MPF"}) {
    const std::string own = folder_.write(std::string("out/") + name, "mine");
    const CommandOutput output = plan({kProduct, "--stock", "box"});
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(std::string(name) + " is there already"), std::string::npos)
        << output.errors;
    EXPECT_EQ(text_of(own), "mine");
    std::filesystem::remove(own);
  }
}

TEST_F(Plan, MakesTheFoldersOnTheWay) {
  const CommandOutput output =
      testing::g31({"plan", kProduct, "--stock", "box", "-o", folder_.path("new/and/out")});
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_TRUE(std::filesystem::exists(folder_.path("new/and/out/plan.json")));
  EXPECT_EQ(testing::g31({"plan", folder_.path("none.step"), "--stock", "box", "-o",
                          folder_.path("other/and/out")})
                .exit_code,
            2);
  EXPECT_FALSE(std::filesystem::exists(folder_.path("other")));
}

// Of the block around a cylinder four corners are removed, all of no kind.
TEST_F(Plan, WhatIsOfNoKindIsNamedAndTheRestIsWritten) {
  const std::string boss = folder_.write("boss.step", text_of("tests/parts/cylinder.step"));
  const CommandOutput output = plan({boss, "--stock", "box"});
  ASSERT_EQ(output.exit_code, 1) << output.errors;
  const json plan = document();
  EXPECT_TRUE(plan.at("features").empty());
  EXPECT_TRUE(plan.at("measures").empty());
  ASSERT_FALSE(plan.at("not_measured").empty());
  for (const json& row : plan.at("not_measured")) {
    EXPECT_FALSE(row.at("why").get<std::string>().empty());
    EXPECT_TRUE(row.contains("min") && row.contains("max")) << row;
  }
  for (const char* const name : {"inspect.nc", "setup.toml", "plan.html"}) {
    EXPECT_FALSE(text_of(out(name)).empty()) << name;
  }
  const std::string page = text_of(out("plan.html"));
  for (const char* const piece :
       {"<div class=\"verdict bad\">", "<div class=\"state\">Incomplete</div>",
        ">Not measured: F1, F2, F3 … (4).</h2>", "<h3>Findings: 4</h3>",
        ">F1 is not measured: ", "<dt>Exit code</dt><dd>1</dd>"}) {
    EXPECT_NE(page.find(piece), page.npos) << piece;
  }
  EXPECT_NE(output.out.find("nothing is measured"), std::string::npos) << output.out;
  EXPECT_EQ(this->plan({boss, "--stock", "box", "--control", "828D"}).exit_code, 1);
}

TEST_F(Plan, RefusesWhatItCannotUseAndWritesNothing) {
  const std::string whole = text_of(kProduct);
  const std::string truncated = folder_.write("cut.step", whole.substr(0, whole.size() / 2));
  const std::string empty = folder_.write("empty.step", "");
  const std::string other = folder_.write(
      "other.toml",
      "[control]\nprofile = \"haas\"\n[work_offsets.G54]\nX = 0.0\n[probe]\nlength = 100.0\n");
  const auto sheet_of = [&](const char* name, const char* g54, const char* probe) {
    return folder_.write(
        name, std::string("[work_offsets.G54]\nX = 300.0\nY = -200.0\nZ = -300.0\n") + g54 +
                  "[tools.1]\nlength = 120.0\n[probe]\nlength = 120.0\n" + probe);
  };
  const std::string no_tool = sheet_of("no_tool.toml", "", "tool = 3\n");
  const std::string turned = sheet_of("turned.toml", "rotate_deg = [0.0, 0.0, 20.0]\n", "");
  const std::string mirrored = sheet_of("mirrored.toml", "mirror = \"X\"\n", "");
  const std::string no_probe = folder_.write("no_probe.toml", "[work_offsets.G54]\nX = 0.0\n");
  const std::string own_part = folder_.write(
      "own.toml",
      "[work_offsets.G54]\nX = 0.0\n[probe]\nlength = 100.0\n[[part]]\nshape = \"ring\"\n");
  struct Case {
    std::vector<std::string> words;
    int exit_code;
    std::string message;
  };
  const std::vector<Case> cases = {
      {{kProduct, "--stock", "box", "--control", "828D", "-s", no_tool}, 5, "no [tools.3]"},
      {{kProduct, "--stock", "box", "--control", "828D", "-s", turned}, 5, "not turned"},
      {{kProduct, "--stock", "box", "--control", "828D", "-s", mirrored}, 5, "neither mirrored"},
      {{truncated, "--stock", "box"}, 2, "cut.step"},
      {{empty, "--stock", "box"}, 2, "empty.step"},
      {{folder_.path("none.step"), "--stock", "box"}, 2, "none.step: there is no such file"},
      {{kProduct, "--stock", "100,110,40"}, 2, "outside"},
      {{kProduct, "--stock", "0,110,40"}, 2, "--stock"},
      {{kProduct, "--stock", "160,110"}, 2, "expected three sizes"},
      {{kProduct, "--stock", "nan,110,40"}, 2, "--stock"},
      {{kProduct, "--stock", "1e300,110,40"}, 2, "--stock"},
      {{kProduct, "--stock", folder_.path("none.stl")}, 2, "none.stl"},
      {{kProduct, "--stock", "box", "--control", "fanuc-99"}, 5, "fanuc-99"},
      {{kProduct, "--stock", "box", "--setup", other, "--control", "fanuc-30i"},
       2,
       "other.toml:2:"},
      {{kProduct, "--stock", "box", "--setup", no_probe}, 2, "no [probe]"},
      {{kProduct, "--stock", "box", "--setup", own_part}, 2, "fixture = true"},
      {{kProduct, "--stock", "box", "--tolerance", "-1"}, 2, "--tolerance"},
      {{kProduct, "--stock", "box", "--as-machined", truncated}, 2, "--as-machined"},
      {{kProduct, "--stock", "box", "--as-machined", truncated}, 2, "cut.step"},
      {{kProduct, "--stock", "box", "--as-machined", "none.step"}, 2, "none.step: no such file"},
  };
  for (const Case& row : cases) {
    SCOPED_TRACE(fmt::format("{}", fmt::join(row.words, " ")));
    const CommandOutput output = plan(row.words);
    EXPECT_EQ(output.exit_code, row.exit_code) << output.errors;
    EXPECT_NE(output.errors.find(row.message), std::string::npos) << output.errors;
    EXPECT_EQ(output.out, "");
    EXPECT_FALSE(std::filesystem::exists(folder_.path("out")));
    for (const std::string& name : folder_.names()) {
      EXPECT_EQ(name.find("out."), std::string::npos) << name << " is left over";
    }
  }
}

// The way down to the slot F1 is the first skip move; its walls are touched by the next two.
TEST_F(Plan, ItsPageShowsTheTouchesOfAMeasure) {
  ASSERT_EQ(plan({kProduct, "--stock", "box"}).exit_code, 0);
  const std::string page = text_of(out("plan.html"));
  const std::size_t begin = page.find("class=\"name\">F1.Y <");
  ASSERT_NE(begin, page.npos);
  const std::string row = page.substr(begin, page.find("</tr>", begin) - begin);
  EXPECT_NE(row.find("data-t=\"2\""), row.npos) << row;
  EXPECT_NE(row.find("data-t=\"3\""), row.npos) << row;
  EXPECT_EQ(row.find("data-t=\"1\""), row.npos) << row;
}

TEST_F(Plan, ItsPageShowsWhatTheProgramPrints) {
  ASSERT_EQ(plan({kProduct, "--stock", "box", "--control", "0i-MF"}).exit_code, 0);
  const std::string page = text_of(out("plan.html"));
  EXPECT_EQ(page.find("The program printed nothing"), page.npos);
  const std::size_t printed = page.find("<pre class=\"out\"");
  ASSERT_NE(printed, page.npos);
  EXPECT_NE(page.find("F1.Y", printed), page.npos);
}

TEST_F(Plan, IsTheSameEachTime) {
  ASSERT_EQ(plan({kProduct, "--stock", "box"}).exit_code, 0);
  std::map<std::string, std::string> first;
  for (const char* const name : {"plan.json", "plan.html", "inspect.nc", "setup.toml"}) {
    first[name] = text_of(out(name));
    EXPECT_GT(first[name].size(), 100U) << name;
  }
  ASSERT_EQ(plan({kProduct, "--stock", "box"}).exit_code, 0);
  for (const auto& [name, text] : first) {
    EXPECT_TRUE(text_of(out(name)) == text) << name;
  }
}

}  // namespace
}  // namespace g31::plan_command_test

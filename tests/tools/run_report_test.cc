// The page of --report: what stands in it without script.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"
#include "tools/cli/command_line.h"
#include "tools/page/charts.h"
#include "tools/page/html.h"
#include "tools/page/parts.h"
#include "tools/page/write_page.h"

namespace g31::run_report_test {
namespace {

using testing::g31;
using testing::TemporaryFolder;

std::string text_in(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream text;
  text << file.rdbuf();
  return text.str();
}

bool has(const std::string& page, const std::string& piece) {
  return page.find(piece) != std::string::npos;
}

constexpr const char* kRing =
    "[start]\n"
    "Z = 150.0\n"
    "[probe]\n"
    "ball_diameter = 6.0\n"
    "length = 100.0\n"
    "trigger_delay_s = 0.004\n"
    "[[part]]\n"
    "name = \"ring\"\n"
    "shape = \"ring\"\n"
    "bore = 40.0\n"
    "at = [0.0, 0.0, 20.0]\n";

/// Touches the bore towards +X with 300 mm/min: 4 ms are 20 um too deep.
constexpr const char* kTouch =
    "%\n"
    "O7(ONE TOUCH)\n"
    "G90 G0 X0. Y0.\n"
    "G1 Z115. F2000.\n"
    "G31 X30. F300.\n"
    "#160=#5061(WALL <b>)\n"
    "IF[#160LT0]THEN #161=1\n"
    "M30\n"
    "%\n";

class Report : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!page::read_assets()) {
      GTEST_SKIP() << "the page's script was not built: node and npm are not here";
    }
  }

  std::string page_of(const std::string& program, const std::vector<std::string>& more = {}) {
    program_ = folder_.write("part.nc", program);
    std::vector<std::string> words = {"run",      program_, "-s", folder_.write("ring.toml", kRing),
                                      "--report", path()};
    words.insert(words.end(), more.begin(), more.end());
    output_ = g31(words);
    return text_in(path());
  }

  [[nodiscard]] std::string path() const { return folder_.path("part.html"); }

  TemporaryFolder folder_;
  std::string program_;
  testing::CommandOutput output_;
};

TEST_F(Report, HasResultsTouchesAndListing) {
  const std::string page = page_of(kTouch, {"--expect", "#160=17.02+-0.001"});
  EXPECT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_TRUE(has(page, "In tolerance"));
  EXPECT_TRUE(has(page, R"(<table id="results" )"));
  EXPECT_TRUE(has(page, R"(<tr data-touch="1">)"));
  EXPECT_TRUE(has(page, "+20.0</td>")) << "4 ms at 5 mm/s";
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc-5" data-l="5" class="x">)"));
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc-7" data-l="7" class="p">)")) << "only one way";
  EXPECT_TRUE(has(page, "G31 X30. F300."));
  for (const char* const id : {"summary", "scenebox", "timeline", "plan", "chart", "listing"}) {
    EXPECT_TRUE(has(page, fmt::format(R"( id="{}")", id))) << id;
  }
}

TEST_F(Report, LeavesTheDocumentOfTheRunAsItIs) {
  const std::string document = folder_.path("run.json");
  const std::string page = page_of(kTouch, {"--json", document});
  const std::string beside = text_in(document);
  g31({"run", program_, "-s", folder_.path("ring.toml"), "--json", document});
  EXPECT_EQ(text_in(document), beside);
  EXPECT_FALSE(nlohmann::json::parse(beside).contains("moves"));
  EXPECT_TRUE(has(page, "\"moves\"")) << "the page has them";
}

TEST_F(Report, OfAFileOfReadingsHasItsResults) {
  std::string rows = "t,X,Y\n";
  for (int i = 0; i <= 360; ++i) {
    const double angle = 0.0174532925199433 * i;
    rows += fmt::format("{},{:.6f},{:.6f}\n", i, 10.0 * std::cos(angle), 10.0 * std::sin(angle));
  }
  g31({"evaluate", "circle", folder_.write("circle.csv", rows), "--report", path()});
  const std::string page = text_in(path());
  EXPECT_TRUE(has(page, R"(<table id="results">)"));
  EXPECT_TRUE(has(page, R"(id="headline">circular_error is )"));
  EXPECT_TRUE(has(page, "<h3>Notes: ")) << "they are no findings";
  EXPECT_FALSE(has(page, "<h3>Findings: "));
}

TEST_F(Report, OfReadingsNamesTheFileOfDiameters) {
  std::string shaft = "K,theta,A,B\n";
  for (int theta = 0; theta < 360; theta += 45) {
    shaft += fmt::format("0,{0},0,0\n1,{0},0,0\n2,{0},0,0\n3,{0},0,0\n", theta);
  }
  const std::string rows = folder_.write("rows.csv", shaft);
  const std::string ends = folder_.write("ends.csv", "K,d\n0,40\n3,40\n");
  g31({"evaluate", "cylindricity", rows, "--diameters", ends, "--step", "10", "--report", path()});
  const std::string page = text_in(path());
  EXPECT_TRUE(has(page, "rows.csv</code></td><td class=\"hash\">")) << page;
  EXPECT_TRUE(has(page, "ends.csv</code></td><td class=\"hash\">"));
}

TEST_F(Report, OfAStudySaysWhichSetUpItSpeaksOf) {
  folder_.write("a.nc", "O1\n#501=#500*2\nM30\n");
  const std::string study =
      folder_.write("study.toml",
                    "[study]\nprogram = \"a.nc\"\nrepeats = 2\n[results.double]\nvalue = \"#501\"\n"
                    "[[vary]]\nkey = \"variables.#500\"\nvalues = [3.0, 4.0]\n");
  output_ = g31({"study", study, "--report", path()});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  const std::string page = text_in(path());
  EXPECT_TRUE(has(page, R"(<table id="results">)"));
  EXPECT_TRUE(has(page, folder_.path("a.nc") + "</code>")) << "the program decides, too";
  EXPECT_TRUE(has(page, "95 % interval of the mean"));
  EXPECT_TRUE(has(page, "6.000000 … 6.000000")) << "as terminal and document have it";
  EXPECT_TRUE(has(page, "double, variables.#500 = 3: mean 6"))
      << page.substr(0, page.find("<main>"));
}

TEST_F(Report, SaysByHowMuchAResultIsOut) {
  const std::string page = page_of(kTouch, {"--expect", "#160=17+-0.005"});
  EXPECT_EQ(output_.exit_code, 1);
  // 17.020 is 0.015 beyond 17.005, of a unit that nobody has said.
  EXPECT_TRUE(has(page, "WALL &lt;b&gt; is 0.0150 over its upper limit.")) << page.substr(0, 400);
}

/// Figures of a page that is small enough for plain text.
nlohmann::json figures_in(const std::string& page) {
  const std::string begin = R"(<script type="application/json" id="g31-figures">)";
  const std::size_t from = page.find(begin) + begin.size();
  return nlohmann::json::parse(page.substr(from, page.find("</script>", from) - from));
}

void expect_near(const nlohmann::json& point, const nlohmann::json& wanted) {
  ASSERT_EQ(point.size(), wanted.size());
  for (std::size_t i = 0; i < point.size(); ++i) {
    EXPECT_NEAR(point[i].get<double>(), wanted[i].get<double>(), 1e-6) << point;
  }
}

/// A block on a table that C turns.
constexpr const char* kTable =
    "[start]\nZ = 150.0\n"
    "[machine]\ntable_side = \"C\"\ntool_side = \"XYZ\"\n"
    "[probe]\nball_diameter = 6.0\nlength = 100.0\n"
    "[[part]]\nname = \"block\"\nshape = \"block\"\n"
    "length = 40.0\nwidth = 40.0\nheight = 20.0\n"
    "at = [30.0, 0.0, 0.0]\n";

TEST_F(Report, ShowsAValueBeyondItsLimitBeyondIt) {
  const std::string page = page_of("O8\n#500=10.00504\n#501=0.000004\nM30\n",
                                   {"--expect", "#500=10+-0.005", "--print", "#501"});
  EXPECT_EQ(output_.exit_code, 1);
  EXPECT_TRUE(has(page, "the program measured 10.00504, allowed is 9.99500 to 10.00500."));
  EXPECT_TRUE(has(page, "#500 is 0.000040 over its upper limit."));
  EXPECT_TRUE(has(page, "101 %"));
  EXPECT_TRUE(has(page, ">0.0000040</td>")) << "of #501";
}

TEST(ReportNumbers, OfSmallAmountsHaveTwoDigits) {
  EXPECT_EQ(page::significant(4e-6, 4), "0.0000040");
  EXPECT_EQ(page::significant(9.96e-5, 4), "0.00010");
  EXPECT_EQ(page::significant(-4.2e-12, 4), "−4.2e−12");
  EXPECT_EQ(page::significant(4.2e-12, 4, page::ShowSign::Always), "+4.2e−12");
  EXPECT_EQ(page::significant(1.03173, 4), "1.0317");
  EXPECT_EQ(page::significant(0.0, 4), "0.0000");
  EXPECT_EQ(page::significant(std::nullopt, 4), "–");
  EXPECT_EQ(page::decimals_apart(10.00504, 10.005, 4), 5);
  EXPECT_EQ(page::decimals_apart(10.006, 10.005, 4), 4);
  EXPECT_EQ(page::decimals_apart(10.005, 10.005, 4), 4);
}

TEST(ReportCharts, HaveRoomForTheirNumbers) {
  const page::Readings readings{{-1234.500001, -1234.500002}, "mm", {}, {}, {}, {}};
  const std::string chart = page::run_chart(readings, page::Language::English);
  const std::string last = R"html( text-anchor="end" fill="var(--ink2)">−1234.5000)html";
  const std::size_t end = chart.find(last);
  ASSERT_NE(end, std::string::npos) << chart;
  const std::size_t at = chart.rfind("<text x=\"", end) + 9;
  EXPECT_GT(std::stod(chart.substr(at)), 13 * 6.9) << "thirteen letters stand before it";
}

// The table has turned the block's side x = 20 towards -Y; the ball meets it squarely and in time.
TEST_F(Report, TellsTouchesInTheFrameOfATurnedPart) {
  const std::string sheet = folder_.write("table.toml", kTable);
  const std::string program = folder_.write(
      "turned.nc",
      "O4\nG21 G90 G54\nG0 C90.\nG0 X0. Y-80.\nG1 Z95. F2000.\nG31 Y0. F300.\nG0 Y-80.\nM30\n");
  output_ = g31({"run", program, "-s", sheet, "--report", path()});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_TRUE(has(text_in(path()),
                  R"(<td>block</td><td class="n">20.0000</td><td class="n">0.0000</td>)"
                  R"(<td class="n">−5.0000</td><td class="n dev">0.0</td><td class="n">0.0</td>)"));
  // Pictures have the part as it stands without the turn; the document has where it was touched.
  const nlohmann::json figure = figures_in(text_in(path())).at("touch").at(0);
  expect_near(figure.at("contact"), {50.0, 0.0, -5.0});
  expect_near(figure.at("normal"), {1.0, 0.0, 0.0});
}

TEST_F(Report, TellsWhereOnATurnedPartACollisionWas) {
  const std::string program = folder_.write(
      "crash.nc", "O4\nG21 G90 G54\nG0 C90.\nG0 X0. Y-80.\nG1 Z95. F2000.\nG1 Y0. F300.\nM30\n");
  output_ = g31({"run", program, "-s", folder_.write("table.toml", kTable), "--report", path()});
  ASSERT_EQ(output_.exit_code, 4) << output_.errors;
  const nlohmann::json figure = figures_in(text_in(path())).at("collision");
  expect_near(figure.at("contact"), {50.0, 0.0, -5.0});
  expect_near(figure.at("normal"), {1.0, 0.0, 0.0});
}

// A ball of 4 mm stands 30 mm beside the main one, along X where the spindle is at 0: in a bore of
// 100 mm it touches at X18, and 4 ms at 300 mm/min are 20 um more.  Then along Y, turned by 90.
TEST_F(Report, HasTheBallThatTouched) {
  const std::string sheet = folder_.write(
      "star.toml",
      "[start]\nZ = 150.0\n[probe]\nball_diameter = 6.0\nlength = 100.0\ntrigger_delay_s = 0.004\n"
      "[[probe.ball]]\nat = [30.0, 0.0, 0.0]\ndiameter = 4.0\n"
      "[[part]]\nname = \"ring\"\nshape = \"ring\"\nbore = 100.0\nat = [0.0, 0.0, 20.0]\n");
  const std::string program = folder_.write(
      "star.mpf",
      "G90 G0 X0 Y0\nG1 Z115 F2000\nMEAS=1 G1 X30 F300\nG0 X0\nSPOS=90\nMEAS=1 G1 Y30 F300\n"
      "G0 Y0\nM30\n");
  output_ = g31({"run", program, "-s", sheet, "--report", path(), "--allow", "PRB316"});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  const nlohmann::json figures = figures_in(text_in(path()));
  const nlohmann::json& touches = figures.at("touch");
  ASSERT_EQ(touches.size(), 2U);
  for (std::size_t axis = 0; axis < 2; ++axis) {
    const nlohmann::json& touch = touches[axis];
    EXPECT_EQ(touch.at("radius"), 2.0);
    EXPECT_NEAR(touch.at("ball").at(axis).get<double>(), 48.02, 1e-6);
    EXPECT_NEAR(touch.at("ball").at(1 - axis).get<double>(), 0.0, 1e-9);
    EXPECT_NEAR(touch.at("deviation").get<double>(), 0.02, 1e-6);
  }
  const nlohmann::json& probe = figures.at("probe");
  EXPECT_EQ(probe.at("further"), nlohmann::json::parse(R"([{"at": [30, 0, 0], "diameter": 4}])"));
  EXPECT_EQ(probe.at("arms").size(), 1U);
  // Upright at first; behind SPOS about Z by 90 degrees.
  EXPECT_FALSE(figures.at("ways").front().contains("turns"));
  const auto turn = figures.at("ways").back().at("turns").at(1).get<std::vector<double>>();
  EXPECT_NEAR(turn.at(2), std::sqrt(0.5), 1e-12);
  EXPECT_NEAR(turn.at(3), std::sqrt(0.5), 1e-12);
}

// The block on its turned table again, beside itself: what the document tells of the machine is
// brought to the part.
TEST_F(Report, ComparesInTheFrameOfATurnedPart) {
  const std::string sheet = folder_.write("table.toml", kTable);
  const std::string program = folder_.write(
      "turned.nc",
      "O4\nG21 G90 G54\nG0 C90.\nG0 X0. Y-80.\nG1 Z95. F2000.\nG31 Y0. F300.\nG0 Y-80.\nM30\n");
  const std::string other = folder_.path("other.json");
  ASSERT_EQ(g31({"run", program, "-s", sheet, "--json", other, "--moves", "--touches", "--blocks"})
                .exit_code,
            0);
  output_ = g31({"run", program, "-s", sheet, "--report", path(), "--compare", other});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_FALSE(has(output_.errors, "note")) << output_.errors;
  const nlohmann::json figures = figures_in(text_in(path()));
  const nlohmann::json touch = figures.at("compare").at("figures").at("touch").at(0);
  expect_near(touch.at("contact"), {50.0, 0.0, -5.0});
  expect_near(touch.at("normal"), {1.0, 0.0, 0.0});
  expect_near(touch.at("ball"), figures.at("touch").at(0).at("ball"));
  EXPECT_NEAR(touch.at("deviation").get<double>(), 0.0, 1e-6);
  expect_near(figures.at("compare").at("figures").at("ways").back().at("points"),
              figures.at("ways").back().at("points"));
}

TEST_F(Report, HasATableOfTouchesWhereThereAreNone) {
  EXPECT_TRUE(
      has(page_of("O1\nM30\n"), "<table id=\"touches\"><tbody><tr><td class=\"wrapcell mut\">"));
}

TEST_F(Report, SaysWhereTheOtherRunTellsNoTimes) {
  const std::string other = folder_.path("other.json");
  page_of(kTouch, {"--json", other, "--moves", "--touches", "--blocks"});
  const std::string timed = page_of(kTouch, {"--compare", other});
  EXPECT_FALSE(has(timed, "tells no times"));
  EXPECT_FALSE(has(output_.errors, "tells no times")) << output_.errors;
  ASSERT_EQ(g31({"run", program_, "-s", folder_.path("ring.toml"), "--json", other, "--moves",
                 "--touches"})
                .exit_code,
            0);
  const std::string untimed = page_of(kTouch, {"--compare", other});
  EXPECT_TRUE(has(untimed, "tells no times of its moves"));
  EXPECT_TRUE(has(output_.errors, "g31: note: --compare " + other + " tells no times of its moves"))
      << output_.errors;
}

TEST_F(Report, IsTheSameBytesTwice) {
  EXPECT_EQ(page_of(kTouch), page_of(kTouch));
}

// Program text is only ever text.
TEST_F(Report, ShowsHostileTextAsText) {
  const std::string page = page_of(
      "O8(</script><script>alert 1</script>)\n"
      "#100=1(<img src=x onerror=alert>)\n"
      "#3006=1(<b>&\"'STOP)\n"
      "M30\n");
  EXPECT_FALSE(has(page, "<script>alert 1"));
  EXPECT_FALSE(has(page, "<img src=x"));
  EXPECT_TRUE(has(page, "&lt;img src=x onerror=alert&gt;"));
  EXPECT_TRUE(has(page, "&lt;b&gt;&amp;&quot;&#39;STOP"));
  EXPECT_TRUE(has(page, "\\u003c/script>"));
}

TEST_F(Report, ASemicolonInAFanucCommentIsOfTheComment) {
  const std::string page = page_of("O8\n#501=1 (WIDTH; HEIGHT)\nM30\n", {"--print", "#501"});
  EXPECT_TRUE(has(page, R"(class="name">WIDTH; HEIGHT <)")) << page;
}

// Brackets of a SINUMERIK program are code: only what stands behind ; is a comment, and not in a
// text.
TEST_F(Report, TakesMeaningsFromWhatIsACommentOfTheDialect) {
  const std::string program =
      folder_.write("part.mpf",
                    "DEF STRING[9] S\nR1=3\nR2=4\nR4=SIN(30)*MAXVAL(R1,R2)\nR5=(R1+R2) ; ROOM (X)\n"
                    "S=\"A;B\"\nM30\n");
  output_ = g31({"run", program, "--report", path(), "--print", "R4,R5"});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  const std::string page = text_in(path());
  EXPECT_TRUE(has(page, R"(<code>R4</code></th><td class="wrapcell" lang=""></td>)")) << page;
  EXPECT_TRUE(has(page, R"(<code>R5</code></th><td class="wrapcell" lang="">ROOM (X)</td>)"));
  EXPECT_FALSE(has(page, R"(lang="">B&quot;)"));
}

TEST_F(Report, HasItsResultsWhereThereAreNone) {
  const std::string page = page_of("O8\n#501=1\nM30\n");
  EXPECT_TRUE(has(page, R"(<table id="results">)"));
  EXPECT_TRUE(has(page, R"(<a class="skip" href="#results">)"));
  EXPECT_TRUE(has(page_of("O8\nG65 P2 D3O.\nM30\n"), R"(<table id="results">)")) << "nothing ran";
}

TEST_F(Report, JudgesWhatIsToBeVacant) {
  const std::vector<std::string> vacant = {"--expect", "#501=vacant", "--print", "#501"};
  const std::string page = page_of("O1\n#501=3\nM30\n", vacant);
  EXPECT_TRUE(has(page, "#501 is not as expected."));
  EXPECT_TRUE(has(page, "Not as expected</span></td></tr>"));
  EXPECT_FALSE(has(page, "verd mut")) << "it is told once";
  EXPECT_TRUE(has(page_of("O1\nM30\n", vacant), "As expected</span></td></tr>"));
}

TEST_F(Report, TellsWhereACollisionWas) {
  const std::string page = page_of("O9\nG90 G0 X30. Y0.\nG1 Z100. F800.\nM30\n");
  EXPECT_EQ(output_.exit_code, 4) << output_.errors;
  EXPECT_TRUE(has(page, "<code>Machine coordinates</code>"));
  EXPECT_TRUE(has(page, R"(<code>Feed</code></th><td class="n">800 mm/min</td>)"));
  EXPECT_TRUE(has(page, R"(<section id="alarm")"));
  EXPECT_TRUE(has(page, "part.nc:3"));
  EXPECT_TRUE(has(page, " err\">"));
}

TEST_F(Report, SpeaksJapanese) {
  const std::string page = page_of(kTouch, {"--lang", "ja"});
  EXPECT_TRUE(has(page, R"(<html lang="ja">)"));
  EXPECT_TRUE(has(page, "測定"));
  EXPECT_FALSE(has(page, ">Results<"));
  EXPECT_TRUE(has(page, "プログラムは最後まで実行されました。"));
  EXPECT_TRUE(has(page, "対象外: 切削"));
  EXPECT_TRUE(has(page, R"(aria-label="測定点 1")"));
  const std::string out = page_of(kTouch, {"--lang", "ja", "--expect", "#160=17+-0.005"});
  EXPECT_TRUE(has(out, "WALL &lt;b&gt; は上限を 0.0150 超えています。"));
  const std::string crash = page_of("O9\nG90 G0 X30. Y0.\nG0 Z100.\nM30\n", {"--lang", "ja"});
  EXPECT_TRUE(has(crash, R"(<div class="state">衝突</div>)"));
  EXPECT_TRUE(has(crash, "その後の動作は不明です。"));
  const std::string alarm = page_of("O9\n#3000=7(BAD)\nM30\n", {"--lang", "ja"});
  EXPECT_TRUE(has(alarm, "アラーム 3007 で停止しました: BAD"));
}

// Every word that the script says has its Japanese.
TEST(ReportWords, OfTheScriptAreThereInJapanese) {
  const std::string script = text_in("tools/page/web/src/words.js");
  const std::string table = text_in("tools/page/words.def");
  const std::size_t begin = script.find("const ENGLISH = {");
  std::istringstream lines(script.substr(begin, script.find("\n};", begin) - begin));
  int words = 0;
  for (std::string line; std::getline(lines, line);) {
    const std::size_t colon = line.find(':');
    if (line.starts_with("  ") && line.size() > 2 && line[2] >= 'a' && line[2] <= 'z') {
      const std::string key = line.substr(2, colon - 2);
      EXPECT_TRUE(has(table, fmt::format("SCRIPT_WORD(\"{}\"", key))) << key;
      ++words;
    }
  }
  EXPECT_GT(words, 40);
}

// Comments and printouts, in whatever they are written.
TEST_F(Report, ShowsTextsAsTheyWereMeant) {
  const std::string page = page_of(
      "O8(\x91\xAA\x92\xE8)\n"
      "#100=1(\x8C\x61)\n"
      "#101=2(Bohrung \xD8 20)\n"
      "#102=3(径)\n"
      "M30\n");
  EXPECT_TRUE(has(page, "O8(測定)"));
  EXPECT_TRUE(has(page, R"(<td class="wrapcell" lang="">径</td>)"));
  EXPECT_TRUE(has(page, "#101=2(Bohrung Ø 20)"));
  EXPECT_TRUE(has(page, "#102=3(径)"));
}

// Two files of one name, in two folders.
TEST_F(Report, GivesFilesOfOneNameNamesOfTheirOwn) {
  std::filesystem::create_directory(folder_.path("lib"));
  folder_.write("lib/part.nc", "O9\nG0 X1.\nG31 X30. F300.\n#3006=1(HERE)\nM99\n");
  const std::string page =
      page_of("O8\nG90 G0 X0. Y0.\nG1 Z115. F2000.\nG65 P9\nM30\n", {"--lib", folder_.path("lib")});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc-4")"));
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc~2-3" data-l="3")"));
  EXPECT_TRUE(has(page, R"(<a href="#L-part.nc~2-3" data-go="part.nc~2:3">part.nc~2:3</a> G31)"));
  EXPECT_TRUE(
      has(page, R"("names":{"touches":["part.nc~2"],"moves":["part.nc","part.nc","part.nc~2")"));
  EXPECT_TRUE(has(page, R"("counts":["part.nc~2","part.nc"])") ||
              has(page, R"("counts":["part.nc","part.nc~2"])"));
}

TEST_F(Report, CountsAJumpToTheVeryNextBlockAsMet) {
  const std::string page =
      page_of("O8\n#1=2\nIF[#1EQ2]GOTO5\nN5 #2=1\nIF[#1EQ3]GOTO6\nN6 #3=1\nM30\n");
  EXPECT_TRUE(
      has(page, R"(data-l="3" class="p"><span class="ct" title="condition met 1, not met 0")"));
  EXPECT_TRUE(
      has(page, R"(data-l="5" class="p"><span class="ct" title="condition met 0, not met 1")"));
}

// G68 turns what the program writes; #5061 and the table of touches stay as they are.
TEST_F(Report, TellsTouchesUnderARotationAsTheControlShowsThem) {
  const std::string page = page_of(
      "O8\nG90 G17 G0 X0. Y0.\nG1 Z115. F2000.\nG68 X0 Y0 R90.\nG31 X30. F300.\n"
      "#160=#5062\nG69\nM30\n",
      {"--print", "#160", "--allow", "PRB303"});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_TRUE(output_.out.starts_with("#160 = 17.02")) << output_.out;
  // Commanded 0, 30 and latched 0, 17.02: along Y.
  EXPECT_TRUE(has(page, R"(<td class="n">0.000</td><td class="n">30.000</td>)")) << page;
  EXPECT_TRUE(has(page, R"(<td class="n">0.0000</td><td class="n">17.0200</td>)"));
}

TEST_F(Report, OfAnEarlierRunIsGoneBeforeTheWork) {
  page_of(kTouch);
  ASSERT_FALSE(text_in(path()).empty());
  const std::string page = page_of(kTouch, {"--print", "nonsense"});
  EXPECT_EQ(output_.exit_code, 2);
  EXPECT_FALSE(has(page, "In tolerance"));
}

TEST(ReportOptions, AreRefusedWhereTheyCannotBe) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM30\n");
  EXPECT_EQ(g31({"run", program, "--report", "a.pdf"}).exit_code, 2);
  EXPECT_EQ(g31({"run", program, "--report", "a.html", "--lang", "fr"}).exit_code, 2);
  EXPECT_EQ(g31({"run", program, "--report", program}).exit_code, 2);
  EXPECT_EQ(g31({"run", program, "--lang", "ja"}).exit_code, 2) << "of which report?";
  EXPECT_EQ(g31({"run", program, "--trace-period", "1ms"}).exit_code, 2) << "of which trace?";
  const std::string page = folder.path("a.html");
  EXPECT_EQ(g31({"run", program, "--report", page, "--compare", ""}).exit_code, 2);
}

// D3O with the letter: nothing of the program has run, and its line is what one wants to see.
TEST(ReportOfAProgramThatIsWrongInItself, HasItsListingAndWhatWouldBeRight) {
  const TemporaryFolder folder;
  const std::string page = folder.path("a.html");
  const std::string program = folder.write("a.nc", "O1\nG65 P2 D3O.\nM30\n");
  EXPECT_EQ(g31({"run", program, "--report", page}).exit_code, 2);
  const std::string html = text_in(page);
  EXPECT_NE(html.find("id=\"listing\""), std::string::npos);
  EXPECT_NE(html.find("id=\"L-a.nc-2\""), std::string::npos);
  EXPECT_NE(html.find("href=\"#L-a.nc-2\""), std::string::npos);
  EXPECT_NE(html.find("<p class=\"remark\">write a number, a #variable or [an expression]"),
            std::string::npos);
}

TEST(ReportOptions, AreRefusedBeforeTheWorkWhereThePageCannotBeWritten) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nPOPEN\nDPRNT[DONE]\nM30\n");
  std::filesystem::create_directory(folder.path("folder.html"));
  for (const std::string& page : {folder.path("none/a.html"), folder.path("folder.html")}) {
    const testing::CommandOutput output = g31({"run", program, "--report", page});
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_EQ(output.out, "") << "the program has run";
    EXPECT_NE(output.errors.find("cannot write"), std::string::npos) << output.errors;
  }
}

TEST(ReportOptions, ThatChangeARunAreInTheCommandThatRepeatsIt) {
  const TemporaryFolder folder;
  const std::string program = folder.write("a.nc", "O1\nM30\n");
  const std::string page = folder.path("a.html");
  ASSERT_EQ(g31({"run",
                 program,
                 "--report",
                 page,
                 "--lang",
                 "ja",
                 "--fail-on",
                 "error",
                 "--max-blocks",
                 "100",
                 "--max-time",
                 "7",
                 "--max-output",
                 "1M",
                 "--printer-wait",
                 "5",
                 "--trace",
                 folder.path("t.csv"),
                 "--trace-period",
                 "4ms",
                 "--moves",
                 "--touches",
                 "--blocks",
                 "--changes"})
                .exit_code,
            0);
  EXPECT_NE(text_in(page).find("--fail-on error --max-blocks 100 --max-time 7 --max-output 1000000 "
                               "--printer-wait 5 --trace " +
                               folder.path("t.csv") +
                               " --trace-period 4ms --moves --touches --blocks --changes "
                               "--report " +
                               page + " --lang ja"),
            std::string::npos);
}

// A listing of more rows than a page writes out is filled in by the script.
TEST(ReportParts, LeaveLongTablesToTheScript) {
  page::Report report;
  page::Listing listing{"long.nc", "", {}, {}};
  for (int i = 0; i < 2001; ++i) {
    listing.text += "G4 X1.\n";
  }
  report.listings.push_back(listing);
  EXPECT_TRUE(has(page::listing_part(report), R"(data-virtual data-rows="2001")"));
  report.listings[0].text.resize(report.listings[0].text.size() - 7);
  EXPECT_TRUE(has(page::listing_part(report), R"(id="L-long.nc-2000")"));
  report.touches.resize(2001);
  EXPECT_TRUE(has(page::touches_part(report), "<tbody data-virtual>"));
}

TEST(ReportNumbers, HaveARealMinusAndNoNegativeZero) {
  EXPECT_EQ(page::number(-0.00004, 4), "0.0000");
  EXPECT_EQ(page::number(-1.5, 1), "−1.5");
  EXPECT_EQ(page::number(1.5, 1, page::ShowSign::Always), "+1.5");
  EXPECT_EQ(page::number(std::nullopt, 3), "–");
  EXPECT_EQ(page::number(NAN, 3), "–");
  EXPECT_EQ(page::micrometres(0.0046), "+4.6");
  EXPECT_EQ(page::json_for_script("a</script>"), "a\\u003c/script>");
}

/// 220 high, 176 of it for the values and 6 % of their span above and below: 1 is at 23.4, 0 at
/// 180.6.
TEST(RunChart, LosesNoReadingOfManyThatIsFarOff) {
  page::Readings readings;
  readings.values.assign(10001, 0.0);
  readings.values[7] = 1.0;
  const std::string chart = page::run_chart(readings, page::Language::English);
  EXPECT_NE(chart.find(" 180.6V23.4"), std::string::npos);
  EXPECT_LT(chart.size(), 60000U) << "2,000 places are enough";
  EXPECT_NE(chart.find("run chart of 10001 readings"), std::string::npos);
}

}  // namespace
}  // namespace g31::run_report_test

// The page of --report: what stands in it without script.

#include <cmath>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/captured.h"
#include "tests/support/temporary_folder.h"
#include "tools/cli/command_line.h"
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
  EXPECT_TRUE(has(page, R"(<table id="results">)"));
  EXPECT_TRUE(has(page, R"(<tr data-touch="1">)"));
  EXPECT_TRUE(has(page, "+20.0</td>")) << "4 ms at 5 mm/s";
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc-5" data-l="5" class="x">)"));
  EXPECT_TRUE(has(page, R"(<li id="L-part.nc-7" data-l="7" class="p">)")) << "only one way";
  EXPECT_TRUE(has(page, "G31 X30. F300."));
  for (const char* const id : {"summary", "scenebox", "timeline", "plan", "chart", "listing"}) {
    EXPECT_TRUE(has(page, fmt::format(R"( id="{}")", id))) << id;
  }
}

TEST_F(Report, SaysByHowMuchAResultIsOut) {
  const std::string page = page_of(kTouch, {"--expect", "#160=17+-0.005"});
  EXPECT_EQ(output_.exit_code, 1);
  // 17.020 is 15 um beyond 17.005.
  EXPECT_TRUE(has(page, "WALL &lt;b&gt; is 15.0 µm over its upper limit.")) << page.substr(0, 400);
}

// The table has turned the block's side x = 20 towards -Y; the ball meets it squarely and in time.
TEST_F(Report, TellsTouchesInTheFrameOfATurnedPart) {
  const std::string sheet = folder_.write("table.toml",
                                          "[start]\nZ = 150.0\n"
                                          "[machine]\ntable_side = \"C\"\ntool_side = \"XYZ\"\n"
                                          "[probe]\nball_diameter = 6.0\nlength = 100.0\n"
                                          "[[part]]\nname = \"block\"\nshape = \"block\"\n"
                                          "length = 40.0\nwidth = 40.0\nheight = 20.0\n"
                                          "at = [30.0, 0.0, 0.0]\n");
  const std::string program = folder_.write(
      "turned.nc",
      "O4\nG21 G90 G54\nG0 C90.\nG0 X0. Y-80.\nG1 Z95. F2000.\nG31 Y0. F300.\nG0 Y-80.\nM30\n");
  output_ = g31({"run", program, "-s", sheet, "--report", path()});
  ASSERT_EQ(output_.exit_code, 0) << output_.errors;
  EXPECT_TRUE(has(text_in(path()),
                  R"(<td>block</td><td class="n">20.0000</td><td class="n">0.0000</td>)"
                  R"(<td class="n">−5.0000</td><td class="n dev">0.0</td><td class="n">0.0</td>)"));
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

TEST_F(Report, TellsWhereACollisionWas) {
  const std::string page = page_of("O9\nG90 G0 X30. Y0.\nG0 Z100.\nM30\n");
  EXPECT_EQ(output_.exit_code, 4) << output_.errors;
  EXPECT_TRUE(has(page, R"(<section id="alarm")"));
  EXPECT_TRUE(has(page, "part.nc:3"));
  EXPECT_TRUE(has(page, " err\">"));
}

TEST_F(Report, SpeaksJapanese) {
  const std::string page = page_of(kTouch, {"--lang", "ja"});
  EXPECT_TRUE(has(page, R"(<html lang="ja">)"));
  EXPECT_TRUE(has(page, "測定"));
  EXPECT_FALSE(has(page, ">Results<"));
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
  const std::string page = folder.path("a.html");
  EXPECT_EQ(g31({"run", program, "--report", page, "--compare", ""}).exit_code, 2);
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
  ASSERT_EQ(g31({"run", program, "--report", page, "--lang", "ja", "--fail-on", "error",
                 "--max-blocks", "100", "--max-time", "7", "--max-output", "1M"})
                .exit_code,
            0);
  EXPECT_NE(text_in(page).find("--fail-on error --max-blocks 100 --max-time 7 --max-output 1000000 "
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

}  // namespace
}  // namespace g31::run_report_test

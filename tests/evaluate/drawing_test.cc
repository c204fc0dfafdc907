// Drawings: peaks stay when a long record is thinned, the same bytes each time, nothing of the
// place where they are made.

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <regex>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"
#include "tools/plot/curve_plot.h"
#include "tools/plot/path_plot.h"
#include "tools/plot/scale.h"

namespace g31::drawing_test {
namespace {

using evaluate::OptionId;
using testing::TemporaryFolder;

TEST(Drawing, KeepsThePeaksOfALongRecord) {
  std::vector<double> heights(1'000'000, 0.0);
  heights[123456] = 7.0;
  heights[654321] = -3.0;
  const auto shown = plot::shown_points(heights);
  EXPECT_LE(shown.size(), 4004U);
  EXPECT_TRUE(std::ranges::is_sorted(shown));
  EXPECT_EQ(shown.front(), 0U);
  EXPECT_EQ(shown.back(), 999'999U);
  EXPECT_EQ(std::ranges::count(shown, 123456U), 1);
  EXPECT_EQ(std::ranges::count(shown, 654321U), 1);
  EXPECT_EQ(plot::shown_points({1.0, 2.0}).size(), 2U);
  EXPECT_TRUE(plot::shown_points({}).empty());
}

TEST(Drawing, ScalesHaveRoundNumbers) {
  EXPECT_DOUBLE_EQ(plot::round_down(0.049), 0.02);
  EXPECT_DOUBLE_EQ(plot::round_down(0.05), 0.05);
  EXPECT_DOUBLE_EQ(plot::round_down(999.0), 500.0);
  const plot::Ticks ticks = plot::ticks_between(-0.31, 1.02, 8);
  EXPECT_DOUBLE_EQ(ticks.step, 0.2);
  ASSERT_EQ(ticks.places.size(), 7U);
  EXPECT_DOUBLE_EQ(ticks.places.front(), -0.2);
  EXPECT_EQ(plot::label_of(ticks.places[1], ticks.step), "0.0");
  EXPECT_EQ(plot::label_of(-0.0, 5.0), "0");
  EXPECT_EQ(plot::label_of(1234.5, 0.5), "1234.5");
}

/// The numbers of the first line of a class.
std::string points_of(const std::string& svg, const std::string& style) {
  const std::string head = fmt::format("<polyline class=\"{}\" points=\"", style);
  const std::size_t at = svg.find(head);
  return at == std::string::npos
             ? std::string()
             : svg.substr(at + head.size(), svg.find('"', at + head.size()) - at - head.size());
}

TEST(Drawing, EnlargesErrorsAlongTheRay) {
  // A radius of 50 with an error of 0.01 at 90 degrees, 1000 times: drawn at 60.  The frame spans
  // 60 and 6 percent, 540 pixels from (80, 56).
  plot::PathPlot chart;
  chart.nominal_radius = [](double) { return 50.0; };
  chart.traces = {{"path", {{50.0, 0.0}, {0.0, 50.01}}, {0.0, 0.01}, 0}};
  chart.magnification = 1000.0;
  const std::string svg = plot::draw(chart);
  const double scale = 540.0 / (2.0 * 1.06 * 60.0);
  EXPECT_EQ(points_of(svg, "way line0"),
            fmt::format("{:.2f},{:.2f} {:.2f},{:.2f}", 80.0 + 270.0 + 50.0 * scale, 326.0,
                        80.0 + 270.0, 326.0 - 60.0 * scale));
  EXPECT_NE(svg.find("errors 1000 times enlarged"), std::string::npos);
  EXPECT_NE(svg.find("prefers-color-scheme: dark"), std::string::npos);
}

// A page that has the drawing within it keeps the colours of its own texts.
TEST(Drawing, HasRulesForItselfAlone) {
  const std::string svg = plot::draw(plot::CurvePlot());
  EXPECT_NE(svg.find(" class=\"plot\" role=\"img\">"), std::string::npos);
  const std::size_t from = svg.find("<style>");
  const std::string style = svg.substr(from, svg.find("</style>") - from);
  const std::regex rule(R"(([^{}]+)\{ [^{}]*\})");
  int count = 0;
  for (auto it = std::sregex_iterator(style.begin(), style.end(), rule);
       it != std::sregex_iterator(); ++it, ++count) {
    const std::string selectors = (*it)[1];
    for (std::size_t at = 0; at != std::string::npos; at = selectors.find(',', at + 1)) {
      EXPECT_TRUE(std::regex_search(selectors.substr(at, selectors.find(',', at + 1) - at),
                                    std::regex(R"(\.plot \.?\w+ ?$)")))
          << selectors;
    }
  }
  EXPECT_GT(count, 40) << "shapes, and four times the colours";
}

TEST(Drawing, IsWideEnoughForWhatStandsBesideIt) {
  plot::PathPlot chart;
  chart.nominal_radius = [](double) { return 50.0; };
  chart.traces = {{"path", {{50.0, 0.0}, {0.0, 50.01}}, {0.0, 0.01}, 0}};
  chart.facts = {"centre_x 0.000000049 mm (u 9.1e-08)"};
  EXPECT_NE(plot::draw(chart).find("width=\"900\""), std::string::npos);
  // 48 letters of 12 pixels' height from x = 650 on.
  chart.facts.emplace_back("reference_centre_x -0.00000000491 mm (u 9.1e-09)");
  const std::string svg = plot::draw(chart);
  EXPECT_GT(std::stod(svg.substr(svg.find("width=\"") + 7)), 650.0 + 48 * 6.4);
}

TEST(Drawing, OfNothingToSeeIsDrawnAllTheSame) {
  plot::CurvePlot empty;
  EXPECT_NE(plot::draw(empty).find("</svg>"), std::string::npos);
  empty.traces = {{"flat <&>", {{1.0, 5.0}, {1.0, 5.0}}, plot::CurveStyle::Marked, 0}};
  const std::string svg = plot::draw(empty);
  EXPECT_EQ(svg.find("nan"), std::string::npos);
  EXPECT_EQ(svg.find("inf"), std::string::npos);
  EXPECT_NE(svg.find("flat &lt;&amp;&gt;"), std::string::npos);
}

/// A file of each kind, and how it is asked to be evaluated.
struct KindCase {
  const char* kind;
  std::string text;
  std::map<OptionId, std::string> given;
};

std::vector<KindCase> a_case_of_each_kind(TemporaryFolder& folder) {
  std::string circle = "t,X,Y\n";
  std::string square = "t,X,Y\n";
  for (int i = 0; i <= 400; ++i) {
    const double angle = i * 0.015707963267948966;
    circle +=
        fmt::format("{},{},{}\n", 0.01 * i, 9.0 + 50.0 * std::cos(angle), 50.0 * std::sin(angle));
    const int s = (i + 50) % 400;
    square += fmt::format("{},{},{}\n", 0.02 * i,
                          s < 100   ? 50.0
                          : s < 200 ? 150.0 - s
                          : s < 300 ? -50.0
                                    : s - 350.0,
                          s < 100   ? s - 50.0
                          : s < 200 ? 50.0
                          : s < 300 ? 250.0 - s
                                    : -50.0);
  }
  const std::string pos =
      "axis,target,direction,cycle,position\nX,0,1,1,0.001\nX,0,1,2,0.002\nX,9,1,1,9\nX,9,1,2,9."
      "001\n";
  const std::string shaft =
      "theta,A,B\n0,1,1\n0,1,1\n90,1,1\n90,1,1\n180,1,1\n180,1,1\n270,1.001,1\n270,1,1\n";
  const std::string ends = folder.write("ends.csv", "K,d\n0,20\n1,20\n");
  return {
      {"circle", circle, {}},
      {"square", square, {}},
      {"speed", square, {}},
      {"diagonal", square, {{OptionId::Target, "50,0"}}},
      {"straightness", "A,B\n0,1\n0,-1\n0,0\n", {{OptionId::Step, "100"}}},
      {"flatness", "x,y,z\n0,0,0\n1,0,0.001\n0,1,0\n1,1,0\n", {}},
      {"cylindricity", shaft, {{OptionId::Step, "100"}, {OptionId::Diameters, ends}}},
      {"positioning", pos, {}},
  };
}

TEST(Drawing, OfEachKindIsTheSameEachTime) {
  TemporaryFolder folder;
  const std::vector<KindCase> cases = a_case_of_each_kind(folder);
  ASSERT_EQ(cases.size(), evaluate::kinds().size());
  for (const KindCase& c : cases) {
    SCOPED_TRACE(c.kind);
    cli::EvaluateOptions options;
    options.kind = c.kind;
    options.given = c.given;
    options.svg = folder.path("drawing.svg");
    ASSERT_EQ(testing::evaluate_text(c.text, options).exit_code, 0);
    const std::string first = testing::text_of(options.svg);
    ASSERT_EQ(testing::evaluate_text(c.text, options).exit_code, 0);
    EXPECT_EQ(testing::text_of(options.svg), first);
    EXPECT_TRUE(first.starts_with("<svg ") && first.ends_with("</svg>\n"));
    for (const char* const never : {"nan", "inf", "data.csv", "ends.csv"}) {
      EXPECT_EQ(first.find(never), std::string::npos) << never;
    }
  }
}

/// How many dots stand in the frame of a chart.
std::size_t dots_of(const std::string& svg) {
  static const std::regex kDot("<circle [^>]*cx=\"([0-9.]+)\"");
  constexpr double kRightEdge = 660.0;
  return static_cast<std::size_t>(
      std::count_if(std::sregex_iterator(svg.begin(), svg.end(), kDot), std::sregex_iterator(),
                    [](const std::smatch& dot) { return std::stod(dot[1]) <= kRightEdge; }));
}

// Of scattered points each is a line of its own; lines past the fourth are dashed.
TEST(Drawing, OfFlatnessHasEveryPoint) {
  struct Case {
    const char* name;
    std::size_t lines;
    std::size_t points_each;
    const char* title;
  };
  for (const Case& c :
       {Case{"scattered", 16, 1, "over X and Y"}, Case{"ten lines", 10, 2, "along X"}}) {
    SCOPED_TRACE(c.name);
    std::string rows = "x,y,z\n";
    for (std::size_t i = 0; i < c.lines * c.points_each; ++i) {
      rows += fmt::format("{},{},{}\n", 7 * i % 19, 10 * (i / c.points_each),
                          0.001 * static_cast<double>(i % 3));
    }
    TemporaryFolder folder;
    cli::EvaluateOptions options;
    options.kind = "flatness";
    options.svg = folder.path("drawing.svg");
    ASSERT_EQ(testing::evaluate_text(rows, options).exit_code, 0);
    const std::string svg = testing::text_of(options.svg);
    EXPECT_EQ(dots_of(svg), c.lines * c.points_each);
    EXPECT_NE(svg.find(c.title), std::string::npos);
    EXPECT_EQ(svg.find("2 more lines") != std::string::npos, c.lines == 10);
  }
}

/// The Latin words of a drawing's texts that are neither units nor names of results.
std::vector<std::string> english_of(const std::string& svg) {
  static const std::regex kText("<(?:text|title)[^>]*>([^<]*)<");
  static const std::regex kWord("[A-Za-z_][A-Za-z0-9_]+");
  const std::set<std::string> units = {"mm", "min", "deg", "ms"};
  std::vector<std::string> words;
  for (std::sregex_iterator text(svg.begin(), svg.end(), kText), end; text != end; ++text) {
    const std::string said = (*text)[1];
    for (std::sregex_iterator word(said.begin(), said.end(), kWord); word != end; ++word) {
      const auto is_it = [&](const evaluate::ResultRow& row) {
        return evaluate::names(row, word->str());
      };
      // y_0 is a line of a plate at its place.
      if (!units.contains(word->str()) && !word->str().starts_with("y_") &&
          std::ranges::none_of(evaluate::results(), is_it)) {
        words.push_back(word->str());
      }
    }
  }
  return words;
}

TEST(Drawing, OfEachKindHasNoEnglishWordWhereItIsJapanese) {
  TemporaryFolder folder;
  for (const KindCase& c : a_case_of_each_kind(folder)) {
    SCOPED_TRACE(c.kind);
    cli::EvaluateOptions options;
    options.kind = c.kind;
    options.given = c.given;
    options.svg = folder.path("drawing.svg");
    ASSERT_EQ(testing::evaluate_text(c.text, options).exit_code, 0);
    EXPECT_FALSE(english_of(testing::text_of(options.svg)).empty());
    EXPECT_EQ(testing::text_of(options.svg).find("xml:lang"), std::string::npos);
    options.language = plot::Language::Japanese;
    ASSERT_EQ(testing::evaluate_text(c.text, options).exit_code, 0);
    const std::string japanese = testing::text_of(options.svg);
    EXPECT_EQ(english_of(japanese), std::vector<std::string>());
    EXPECT_NE(japanese.find(R"(role="img" xml:lang="ja")"), std::string::npos);
  }
}

TEST(Drawing, HasALanguageOfItsOwnOnlyWhereThereIsOne) {
  TemporaryFolder folder;
  const std::string record = folder.write("d.csv", "X,Y\n0,0\n50,50.01\n");
  const std::string svg = folder.path("d.svg");
  EXPECT_EQ(
      testing::g31({"evaluate", "diagonal", record, "--target", "50,50", "--lang", "ja"}).exit_code,
      2);
  ASSERT_EQ(testing::g31(
                {"evaluate", "diagonal", record, "--target", "50,50", "--svg", svg, "--lang", "ja"})
                .exit_code,
            0);
  EXPECT_NE(testing::text_of(svg).find("<title>2軸の直線移動</title>"), std::string::npos);
}

// A circle about (5, 0), 0.1 mm too large: of its uppermost 1 mm 540 pixels are drawn, the top of
// it at 0.4 of them.
TEST(Drawing, ADetailIsDrawnFromThePointsInIt) {
  plot::PathPlot chart;
  chart.centre = {5.0, 0.0};
  chart.nominal_radius = [](double) { return 10.0; };
  chart.magnification = 1.0;
  plot::PathTrace trace{"path", {}, {}};
  for (int i = 0; i < 360'000; ++i) {
    const double angle = i * std::numbers::pi / 180'000.0;
    trace.points.emplace_back(10.1 * std::cos(angle), 10.1 * std::sin(angle));
    trace.deviations.push_back(0.1);
  }
  chart.traces = {trace};
  chart.detail = {5.0, 10.0, 1.0};
  const std::string svg = plot::draw(chart);
  EXPECT_NE(svg.find("<svg x=\"80\" y=\"56\" width=\"540\" height=\"540\""), std::string::npos);
  const std::string points = points_of(svg, "way line0");
  EXPECT_NE(points.find(",272.00"), std::string::npos);
  EXPECT_GT(std::ranges::count(points, ','), 1000) << "all that is shown of it, thinned";
  EXPECT_EQ(points.find("-300"), std::string::npos) << "nothing far from it";
}

/// Two traces, each twice round a circle of radius 10, of which its uppermost part is shown.
plot::PathPlot two_arcs_in_a_detail(double width) {
  plot::PathPlot chart;
  chart.nominal_radius = [](double) { return 10.0; };
  chart.magnification = 1000.0;
  chart.has_rings = true;
  for (const double deviation : {0.002, -0.001}) {
    plot::PathTrace trace{fmt::format("of {}", deviation), {}, {}, chart.traces.size()};
    for (int turn = 0; turn < 2; ++turn) {
      for (int i = 0; i < 36'000; ++i) {
        const double angle = i * std::numbers::pi / 18'000.0;
        trace.points.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle));
        trace.deviations.push_back(deviation);
      }
    }
    chart.traces.push_back(std::move(trace));
  }
  chart.detail = {0.0, 11.0, width};
  return chart;
}

/// How many times a piece of text stands in another one.
int count_of(const std::string& text, const std::string& piece) {
  int count = 0;
  for (std::size_t at = text.find(piece); at != text.npos; at = text.find(piece, at + 1)) {
    ++count;
  }
  return count;
}

TEST(Drawing, ADetailNamesEachTraceOnce) {
  const std::string svg = plot::draw(two_arcs_in_a_detail(8.0));
  EXPECT_GT(count_of(svg, "class=\"way line1\" points"), 1) << "it comes there twice";
  EXPECT_EQ(count_of(svg, ">of 0.002<"), 1);
  EXPECT_EQ(count_of(svg, ">of -0.001<"), 1);
}

// A micrometre is a millimetre of the drawing, which has 540 / width pixels; the bar begins at 650
// of 900 pixels, and its words take 8 a letter at most.
TEST(Drawing, TheBarOfADetailFitsBesideIt) {
  struct Case {
    double width;
    double pixels;
    const char* words;
  };
  for (const auto& [width, pixels, words] : {Case{20.0, 27.0, ">1 µm error<"},
                                             {5.0, 54.0, ">0.5 µm error<"},
                                             {0.4, 67.5, ">0.05 µm error<"},
                                             {0.01, 54.0, ">0.001 µm error<"}}) {
    const std::string svg = plot::draw(two_arcs_in_a_detail(width));
    EXPECT_NE(svg.find(words), svg.npos) << width;
    std::smatch bar;
    ASSERT_TRUE(std::regex_search(
        svg, bar, std::regex(R"re(<line class="frame" x1="650.00" y1="\S+" x2="(\S+)")re")));
    EXPECT_DOUBLE_EQ(std::stod(bar[1]), 650.0 + pixels) << width;
  }
}

TEST(Drawing, ADetailIsAPointAndAWidth) {
  for (const char* const wrong : {"1,2", "1,2,0", "1,2,-3", "1,2,3,4", "a,2,3", ""}) {
    TemporaryFolder folder;
    cli::EvaluateOptions options;
    options.kind = "circle";
    options.file = folder.write("data.csv", "t,X,Y\n0,1,0\n1,0,1\n2,-1,0\n3,0,-1\n4,1,0\n");
    options.given[OptionId::Detail] = wrong;
    const auto output = testing::run_evaluate(options);
    EXPECT_EQ(output.exit_code, 2) << wrong;
    EXPECT_NE(output.errors.find("--detail"), std::string::npos) << output.errors;
  }
}

}  // namespace
}  // namespace g31::drawing_test

// What an evaluation may take: time and output are limited, and nothing is half-written.

#include <cmath>
#include <cstddef>
#include <filesystem>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "probe/metrology/form_zones.h"
#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"
#include "tools/evaluate/charts.h"
#include "tools/plot/path_plot.h"

namespace g31::evaluation_limits_test {
namespace {

using testing::CommandOutput;
using testing::TemporaryFolder;

std::string circle_file(int rows) {
  std::string text = "t,X,Y\n";
  for (int i = 0; i < rows; ++i) {
    const double angle = 6.4 * i / rows;
    text += fmt::format("{:.4f},{:.7f},{:.7f}\n", 0.001 * i, 10.0 * std::cos(angle),
                        10.0 * std::sin(angle));
  }
  return text;
}

class EvaluationLimits : public ::testing::Test {
 protected:
  CommandOutput evaluate(std::vector<std::string> more) {
    std::vector<std::string> words = {"evaluate",
                                      "circle",
                                      file_,
                                      "--json",
                                      folder_.path("c.json"),
                                      "--svg",
                                      folder_.path("c.svg"),
                                      "--curves"};
    words.insert(words.end(), more.begin(), more.end());
    return testing::g31(words);
  }
  [[nodiscard]] bool is_there(const std::string& name) const {
    return std::filesystem::exists(folder_.path(name));
  }

  TemporaryFolder folder_;
  std::string file_ = folder_.write("circle.csv", circle_file(50'000));
};

TEST_F(EvaluationLimits, EndAnEvaluationWhoseTimeIsUp) {
  const CommandOutput output = evaluate({"--max-time", "0.0001"});
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of computing time is reached"), std::string::npos)
      << output.errors;
  EXPECT_EQ(output.out, "");
  EXPECT_FALSE(is_there("c.svg"));
}

TEST_F(EvaluationLimits, EndAnEvaluationThatWouldWriteTooMuch) {
  const CommandOutput output = evaluate({"--max-output", "100K"});
  EXPECT_EQ(output.exit_code, 6);
  EXPECT_NE(output.errors.find("the limit of output is reached"), std::string::npos)
      << output.errors;
  EXPECT_EQ(output.out, "");
  EXPECT_FALSE(is_there("c.svg"));
}

TEST_F(EvaluationLimits, LetPassWhatKeepsThem) {
  const CommandOutput output = evaluate({"--max-time", "60", "--max-output", "64M", "--quiet"});
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_TRUE(is_there("c.svg"));
  EXPECT_TRUE(is_there("c.json"));
  EXPECT_EQ(output.errors, "") << "no progress where there is no terminal";
}

// What fifty thousand lines of two points each would draw is some 20 MB: it is broken off, and
// nothing is left of it.
TEST_F(EvaluationLimits, EndADrawingAndADocumentAsTheyGrow) {
  std::string text = "x,y,z\n";
  for (int i = 0; i < 100'000; ++i) {
    text += fmt::format("{},{},{}\n", i % 317, i / 2, 1e-4 * ((i * 7919) % 1000));
  }
  const std::string file = folder_.write("flat.csv", text);
  for (const auto& [option, name] :
       {std::pair("--svg", "f.svg"), {"--json", "f.json"}, {"--report", "f.html"}}) {
    const CommandOutput output =
        testing::g31({"evaluate", "flatness", file, option, folder_.path(name), "--curves",
                      "--max-output", "1M"});
    EXPECT_EQ(output.exit_code, 6) << option << output.errors;
    EXPECT_NE(output.errors.find("more than 1.0 MB to write; --max-output"), std::string::npos)
        << output.errors;
    EXPECT_EQ(output.out, "");
    // A document says what has become of the command.
    EXPECT_EQ(is_there(name), std::string(option) == "--json") << name;
    EXPECT_LT(testing::text_of(folder_.path(name)).size(), 1000U);
  }
}

/// Ends work at a look.
class EndsAt final : public machine::WorkWatch {
 public:
  struct Ended {};
  explicit EndsAt(std::size_t last) : last_(last) {}
  void look() override {
    if (++looks_ >= last_) {
      throw Ended();
    }
  }
  [[nodiscard]] std::size_t looks() const { return looks_; }

 private:
  std::size_t last_;
  std::size_t looks_ = 0;
};

// A form is looked at in each step of its fits for each of its points, so that the time between two
// looks does not grow with them: 8 rounds of two fits, and two ranges, for a cylinder; at least
// two exchanges of a plane, one of a line.
TEST(EvaluationWatch, IsAskedInEachStepOfAForm) {
  constexpr Eigen::Index kPoints = 2000;
  Eigen::MatrixX3d plane(kPoints, 3);
  Eigen::MatrixX3d cylinder(kPoints, 3);
  std::vector<double> places;
  std::vector<double> deviations;
  for (Eigen::Index i = 0; i < kPoints; ++i) {
    const double off = 1e-3 * static_cast<double>((i * 7919) % 1000);
    const double angle = 0.1 * static_cast<double>(i);
    plane.row(i) << static_cast<double>(i % 40), static_cast<double>(i / 40), off;
    cylinder.row(i) << (50.0 + off) * std::cos(angle), (50.0 + off) * std::sin(angle), 0.1 * angle;
    places.push_back(static_cast<double>(i));
    deviations.push_back(off);
  }
  const auto looks_of = [](auto work, std::size_t last) {
    EndsAt watch(last);
    try {
      work(watch);
    } catch (const EndsAt::Ended&) {
      EXPECT_EQ(watch.looks(), last);
    }
    return watch.looks();
  };
  const auto flat = [&](machine::WorkWatch& watch) { metrology::flatness_of(plane, &watch); };
  const auto round = [&](machine::WorkWatch& watch) {
    metrology::cylindricity_of(cylinder, &watch);
  };
  const auto straight = [&](machine::WorkWatch& watch) {
    metrology::straightness_of(places, deviations, &watch);
  };
  constexpr std::size_t kNever = 1'000'000'000;
  EXPECT_GE(looks_of(flat, kNever), 2 * kPoints);
  EXPECT_GE(looks_of(round, kNever), 18 * kPoints);
  EXPECT_GE(looks_of(straight, kNever), kPoints);
  for (const std::size_t last : {1UL, 3000UL}) {
    EXPECT_EQ(looks_of(flat, last), last);
    EXPECT_EQ(looks_of(round, last), last);
    EXPECT_EQ(looks_of(straight, last), last);
  }
}

// Drawings and documents tell all that they come to, in small pieces; who is told may end them.
TEST(EvaluationWatch, HearsOfEachPieceOfATextBeforeTheNext) {
  struct Ended {};
  evaluate::Evaluation evaluation;
  evaluation.kind = evaluate::Kind::Flatness;
  evaluation.curves.resize(3000);
  for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
    evaluation.curves[i] = {fmt::format("y_{}", i), {{0.0, 0.001}, {1.0, -0.001}}};
  }
  plot::PathPlot path;
  path.nominal_radius = [](double) { return 50.0; };
  path.traces.resize(1);
  for (int i = 0; i < 5000; ++i) {
    path.traces[0].points.emplace_back(50.0 * std::cos(0.01 * i), 50.0 * std::sin(0.01 * i));
    path.traces[0].deviations.push_back(0.001 * std::sin(i));
  }
  const auto made = [&](int which, const plot::Growth& growth) -> std::string {
    if (which == 0) {
      return evaluation_document(evaluation, true, growth);
    }
    if (which == 1) {
      path.growth = growth;
      return plot::draw(path);
    }
    evaluate::Request request;
    request.growth = growth;
    return which == 2 ? deviation_chart(evaluation, {}, request)
                      : stacked_chart(evaluation, std::vector<double>(3000, 1.0), {}, request);
  };
  for (const int which : {0, 1, 2, 3}) {
    SCOPED_TRACE(which);
    std::size_t told = 0;
    std::size_t largest = 0;
    const std::string text = made(which, [&](std::size_t bytes) {
      told += bytes;
      largest = std::max(largest, bytes);
    });
    EXPECT_GT(text.size(), 50'000U);
    // What begins and ends a text is no piece of it; a curve's name goes with its first point.
    EXPECT_NEAR(static_cast<double>(told), static_cast<double>(text.size()),
                0.05 * static_cast<double>(text.size()) + 3000.0);
    EXPECT_LE(largest, 300U);
    std::size_t until = 0;
    const auto ends = [&](std::size_t bytes) {
      until += bytes;
      if (until > 20'000) {
        throw Ended();
      }
    };
    EXPECT_THROW(made(which, ends), Ended);
    EXPECT_LE(until, 20'000U + largest);
  }
}

TEST_F(EvaluationLimits, AreNumbers) {
  for (const char* const bad : {"0", "-1", "nan", "inf", "soon"}) {
    EXPECT_EQ(evaluate({"--max-time", bad}).exit_code, 2) << bad;
  }
  EXPECT_EQ(evaluate({"--max-output", "much"}).exit_code, 2);
}

}  // namespace
}  // namespace g31::evaluation_limits_test

// Each figure of the paper on path accuracy by one command, from its study file.

#include <cmath>
#include <map>
#include <string>

#include <gtest/gtest.h>

#include "tests/support/run_evaluate.h"
#include "tests/support/run_study.h"

namespace g31::figure_studies_test {
namespace {

using testing::StudyOutput;
using testing::TemporaryFolder;

const std::string kLibrary = "parts/library/path_accuracy/";

struct Figure {
  std::string name;
  std::map<std::string, double> results;  ///< computed outside g31
  double within = 0.0;
  std::string drawn;  ///< in the drawing
};

StudyOutput studied(const TemporaryFolder& folder, const std::string& file) {
  cli::StudyOptions options;
  options.study = file;
  options.json = folder.path("study.json");
  options.svg = folder.path("figure.svg");
  return testing::run_study(options);
}

std::map<std::string, double> results_in(const nlohmann::json& document) {
  std::map<std::string, double> results;
  const auto& forms = document.at("study").at("results");
  const auto& values = document.at("rows").at(0).at("results");
  for (std::size_t i = 0; i < forms.size(); ++i) {
    results[forms[i].at("name")] = values.at(i).is_null() ? std::nan("") : values[i].get<double>();
  }
  return results;
}

// The expected numbers have three to five digits of another solver; the bounds are a unit of their
// last digit and less, and 0.02 um for spikes, whose height counts here from the fitted circle.
TEST(FigureStudies, MakeEachFigureOfThePaper) {
  const std::map<std::string, double> spikes = {{"spike_X", 10.12}, {"spike_Y", 10.12}};
  const auto corners = [](double um) {
    return std::map<std::string, double>{
        {"corner_1", um}, {"corner_2", um}, {"corner_3", um}, {"corner_4", um}};
  };
  const Figure kFigures[] = {
      {"figure_9", spikes, 0.02, "Circle"},
      {"figure_10", spikes, 0.02, "1000"},
      {"figure_11", spikes, 0.02, "1000"},
      {"figure_12", corners(-931.0), 0.1, "50"},
      {"figure_13", corners(-931.0), 0.1, "Square"},
      {"figure_14", corners(-15.2), 0.01, "Square"},
      {"figure_15", {{"usual", 1000.0}, {"lowest", 673.0}}, 0.5, "speed mm/min"},
      {"figure_16", {{"usual", 3000.0}, {"lowest", 2101.0}}, 0.5, "speed mm/min"},
      {"figure_17", {{"lowest", 10.6}}, 0.05, "speed mm/min"},
      {"figure_19", {{"X_on_300", -42.0}, {"Y_on_300", -24.0}}, 0.001, "deviation"},
      {"sinumerik_figure_10", spikes, 0.02, "1000"},
      {"sinumerik_figure_14", corners(-15.2), 0.01, "Square"},
      {"sinumerik_figure_17", {{"lowest", 10.6}}, 0.05, "speed mm/min"},
      {"sinumerik_figure_19", {{"X_on_300", -42.0}, {"Y_on_300", -24.0}}, 0.001, "deviation"}};
  for (const Figure& figure : kFigures) {
    SCOPED_TRACE(figure.name);
    const TemporaryFolder folder;
    const StudyOutput output = studied(folder, kLibrary + figure.name + ".toml");
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    const auto document = nlohmann::json::parse(testing::text_of(folder.path("study.json")));
    const auto results = results_in(document);
    for (const auto& [name, expected] : figure.results) {
      EXPECT_NEAR(results.at(name), expected, figure.within) << name;
    }
    const std::string drawing = testing::text_of(folder.path("figure.svg"));
    EXPECT_EQ(drawing.rfind("<svg", 0), 0U);
    EXPECT_NE(drawing.find(figure.drawn), std::string::npos);
  }
}

/// The same as a run with --trace and an evaluation of its file, but for the seven digits there.
TEST(FigureStudies, AgreeWithARunAndAnEvaluationOfItsTrace) {
  const TemporaryFolder folder;
  const StudyOutput output = studied(folder, kLibrary + "figure_10.toml");
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const auto results =
      results_in(nlohmann::json::parse(testing::text_of(folder.path("study.json"))));
  cli::RunOptions run;
  run.programs = {kLibrary + "circle.nc"};
  run.setups = {kLibrary + "machine.toml"};
  run.trace = folder.path("trace.csv");
  run.trace_period = "182.32us";
  ASSERT_EQ(testing::run_program(run).exit_code, 0);
  cli::EvaluateOptions options;
  options.kind = "circle";
  options.file = run.trace;
  options.given[evaluate::OptionId::Radius] = "50";
  options.given[evaluate::OptionId::Centre] = "0,0";
  const auto evaluated = testing::run_evaluate(options);
  for (const char* const name : {"spike_X", "spike_Y", "radius"}) {
    EXPECT_NEAR(results.at(name), evaluated.value(name), 1e-3) << name;
  }
}

/// On an ideal machine all errors are below 1e-9.
TEST(FigureStudies, OfTheIdealMachineFindNothing) {
  const TemporaryFolder folder;
  folder.write("circle.nc",
               "%\nO1\nG90 G17 G21 G94\nG54 G0 X50. Y0. Z0.\nG3 I-50. J0. F2000.\nG2 I-50. J0.\n"
               "M30\n%\n");
  std::string study =
      "[study]\nprogram = \"circle.nc\"\n[evaluation]\nkind = \"circle\"\noptions = \"--radius 50 "
      "--pitch 10\"\n";
  const char* const kZero[] = {
      "radial_error_max", "radial_error_min", "circular_error", "minimum_zone", "hysteresis",
      "spike_X",          "spike_Y",          "backlash_X",     "backlash_Y",   "scale_X",
      "scale_Y",          "squareness",       "servo_mismatch", "cyclic_X",     "cyclic_Y",
      "centre_x",         "centre_y"};
  for (const std::string name : kZero) {
    study += "[results." + name + "]\nevaluated = \"" + name + "\"\n";
  }
  const StudyOutput output = studied(folder, folder.write("ideal.toml", study));
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  const auto results =
      results_in(nlohmann::json::parse(testing::text_of(folder.path("study.json"))));
  for (const std::string name : kZero) {
    // um are thousandths of mm, um/m millionths, ms thousandths: all below 1e-9.
    const double unit = name.starts_with("centre")                          ? 1.0
                        : name == "squareness" || name.starts_with("scale") ? 1e-6
                                                                            : 1e-3;
    EXPECT_LT(std::abs(results.at(name)) * unit, 1e-9) << name;
  }
}

struct WrongStudy {
  const char* text;
  const char* message;
};

TEST(FigureStudies, SayWhatIsWrongWithAnEvaluation) {
  const std::string head = "[study]\nprogram = \"p.nc\"\n";
  const WrongStudy kWrong[] = {
      {"[evaluation]\noptions = \"--radius 5\"\n[results.a]\nvalue = \"#1\"\n", "kind"},
      {"[evaluation]\nkind = \"circel\"\n[results.a]\nvalue = \"#1\"\n", "\"circle\" or"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--radus 5\"\n[results.a]\nvalue = \"#1\"\n",
       "did you mean --radius?"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--radius\"\n[results.a]\nvalue = \"#1\"\n",
       "--radius has no value"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--radius five\"\n[results.a]\nvalue = "
       "\"#1\"\n",
       "--radius five"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--side 5\"\n[results.a]\nvalue = \"#1\"\n",
       "--side is of square, not of circle"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--interval 1ms\"\n[results.a]\nvalue = "
       "\"#1\"\n",
       "trace_period"},
      {"[evaluation]\nkind = \"circle\"\noptions = \"--columns X=x_act\"\n[results.a]\nvalue = "
       "\"#1\"\n",
       "X_true, X_encoder and X_commanded"},
      {"[evaluation]\nkind = \"circle\"\ntrace_period = \"soon\"\n[results.a]\nvalue = \"#1\"\n",
       "a time such as"},
      {"[evaluation]\nkind = \"diagonal\"\n[results.a]\nvalue = \"#1\"\n", "--target X,Y"},
      {"[evaluation]\nkind = \"circle\"\n[results.a]\nevaluated = \"corner_error_1\"\n",
       "one of radial_error_max"},
      {"[results.a]\nevaluated = \"circular_error\"\n", "[evaluation]"},
      {"[evaluation]\nkind = \"circle\"\n[results.a]\nunit = \"um\"\n", "value or evaluated"},
      {"[evaluation]\nkind = \"circle\"\n[results.a]\nvalue = \"#1\"\nevaluated = \"radius\"\n",
       "one of value and evaluated"}};
  for (const WrongStudy& wrong : kWrong) {
    const TemporaryFolder folder;
    folder.write("p.nc", "%\nO1\nM30\n%\n");
    cli::StudyOptions options;
    options.study = folder.write("study.toml", head + wrong.text);
    const StudyOutput output = testing::run_study(options);
    EXPECT_EQ(output.exit_code, 2) << wrong.text;
    EXPECT_NE(output.errors.find(wrong.message), std::string::npos) << output.errors;
  }
}

/// A path that is none of a circle is a finding of its run, and says why.
TEST(FigureStudies, TellARunWhosePathIsNotWhatItWasTakenFor) {
  const TemporaryFolder folder;
  folder.write("p.nc", "%\nO1\nG1 X100. F1000.\nM30\n%\n");
  const StudyOutput output =
      studied(folder, folder.write("line.toml",
                                   "[study]\nprogram = \"p.nc\"\n[evaluation]\nkind = \"circle\"\n"
                                   "[results.a]\nevaluated = \"circular_error\"\n"));
  EXPECT_EQ(output.exit_code, 1);
  EXPECT_NE(testing::text_of(folder.path("study.json")).find("the path is not a circle"),
            std::string::npos);
  EXPECT_EQ(testing::text_of(folder.path("figure.svg")), "");
}

}  // namespace
}  // namespace g31::figure_studies_test

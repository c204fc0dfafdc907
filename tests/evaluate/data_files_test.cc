// Files of real instruments and files of rubbish: evaluated, or refused with the line.

#include <cmath>
#include <filesystem>
#include <string>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "machine/base/random.h"
#include "tests/support/run_evaluate.h"
#include "tools/evaluate/data_table.h"

namespace g31::data_files_test {
namespace {

using evaluate::ColumnKind;
using evaluate::OptionId;
using testing::evaluate_text;
using testing::EvaluateOutput;

cli::EvaluateOptions of_circle() {
  cli::EvaluateOptions options;
  options.kind = "circle";
  return options;
}

/// Rows of a circle of radius 10 about (3, 4), with what stands between and behind the values.
std::string circle_rows(const std::string& separator, const std::string& end, double unit = 1.0) {
  std::string text;
  for (int i = 0; i <= 720; ++i) {
    const double angle = 0.0174532925199433 * (i <= 360 ? i : 720 - i);
    text += fmt::format("{:.3f}{}{:.9f}{}{:.9f}{}", 0.001 * i, separator,
                        unit * (3.0 + 10.0 * std::cos(angle)), separator,
                        unit * (4.0 + 10.0 * std::sin(angle)), end);
  }
  return text;
}

TEST(DataFiles, OfInstrumentsAreRead) {
  const std::string commas = circle_rows(",", "\n");
  std::string decimal_commas = circle_rows(";", "\r\n");
  std::replace(decimal_commas.begin(), decimal_commas.end(), '.', ',');
  std::string quoted = "\"" + circle_rows("\",\"", "\"\n\"");
  std::replace(quoted.begin(), quoted.end(), '.', ',');
  quoted.pop_back();
  std::string jitter = "t,X,Y\n" + commas;
  jitter.replace(jitter.find("0.300,"), 6, "0.3004,");
  std::string row_missing = "t,X,Y\n" + commas;
  row_missing.erase(row_missing.find("0.300,"),
                    row_missing.find("0.301,") - row_missing.find("0.300,"));
  struct Case {
    const char* name;
    std::string text;
    std::vector<std::string> columns;
    const char* unit;
  };
  const Case kCases[] = {
      {"plain", "t,X,Y\n" + commas, {}, ""},
      {"byte order mark, CR LF", "\xEF\xBB\xBFt,X,Y\r\n" + circle_rows(",", "\r\n"), {}, ""},
      {"CR alone", "t,X,Y\r" + circle_rows(",", "\r"), {}, ""},
      {"comments, empty lines", "# scale 3\n\nt,X,Y\n# begin\n" + commas + "\n \n# end\n", {}, ""},
      {"other names", "zeit, x_act ,\"y act\"\n" + commas, {"t=zeit", "X=x_act", "Y=y act"}, ""},
      {"commas in names", "\"Time, s\",\"X, mm\",Y\n" + commas, {R"("t=Time, s","X=X, mm")"}, ""},
      {"semicolons, a comma in a name",
       "t;\"X, mm\";Y\n" + circle_rows(";", "\n"),
       {R"("X=X, mm")"},
       ""},
      {"a quote that nothing closes", "t,X,\"Y\n" + commas, {"Y=\"Y"}, ""},
      {"decimal commas in quotes", "\"t\",\"X\",\"Y\"\n" + quoted, {}, ""},
      {"semicolons and decimal commas", "t;X;Y\r\n" + decimal_commas, {}, ""},
      {"tabs", "t\tX\tY\n" + circle_rows("\t", "\n"), {}, ""},
      {"a separator behind", "t,X,Y,\n" + circle_rows(",", ",\n"), {}, ""},
      {"no last line break", "t,X,Y\n" + commas.substr(0, commas.size() - 1), {}, ""},
      {"micrometres", "t,X,Y\n" + circle_rows(",", "\n", 1e3), {}, "um"},
      {"inches", "t,X,Y\n" + circle_rows(",", "\n", 1.0 / 25.4), {}, "inch"},
      {"jitter", jitter, {}, ""},
      {"a row missing", row_missing, {}, ""},
      {"a trace", "time_s,X_true,Y_true\n" + commas, {}, ""},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    cli::EvaluateOptions options = of_circle();
    options.columns = c.columns;
    options.unit = c.unit;
    const EvaluateOutput output = evaluate_text(c.text, options);
    ASSERT_EQ(output.exit_code, 0) << output.errors;
    EXPECT_NEAR(output.value("radius"), 10.0, 1e-6);
    EXPECT_NEAR(output.value("centre_x"), 3.0, 1e-6);
    EXPECT_NEAR(output.value("centre_y"), 4.0, 1e-6);
    EXPECT_EQ(output.errors, "");
  }
}

// A jump of the record is no error of the circle, but it is told.
TEST(DataFiles, SamplesOffTheCircleAreTold) {
  const std::string rows = "t,X,Y\n" + circle_rows(",", "\n");
  EXPECT_EQ(evaluate_text(rows, of_circle()).errors.find("do not count"), std::string::npos);
  std::string jump = rows;
  const std::size_t line = jump.find("0.100,");
  jump.replace(line, jump.find('\n', line) - line, "0.100,3.0,15.5");  // 1.5 mm off
  const EvaluateOutput output = evaluate_text(jump, of_circle());
  EXPECT_EQ(output.exit_code, 0);
  const std::string notes = output.document.at("notes").dump();
  EXPECT_NE(notes.find("1 of 721 samples lie between pieces of the circle, up to 1.500 mm off it, "
                       "and do not count"),
            std::string::npos)
      << notes;
}

// A pause between two turns is no stray, and what leads out of the circle at a tangent is none of
// it.
TEST(DataFiles, PausesAndLeadsOfACircleDoNotCount) {
  std::string text = "t,X,Y\n";
  int row = 0;
  const auto add = [&](double x, double y) {
    text += fmt::format("{:.3f},{:.9f},{:.9f}\n", 0.01 * row++, x, y);
  };
  const auto turn = [&] {
    for (int i = 0; i < 720; ++i) {
      const double angle = 0.5 * 0.0174532925199433 * i;
      add(50.0 * std::cos(angle), 50.0 * std::sin(angle));
    }
  };
  turn();
  for (int i = 0; i < 100; ++i) {
    add(50.0, 0.0);
  }
  turn();
  for (int i = 0; i <= 90; ++i) {
    const double angle = 0.0174532925199433 * i;
    add(25.0 + 25.0 * std::cos(angle), 25.0 * std::sin(angle));
  }
  const EvaluateOutput output = evaluate_text(text, of_circle());
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_LT(output.value("circular_error"), 1e-3);
  const std::string notes = output.document.at("notes").dump();
  EXPECT_EQ(notes.find("between pieces"), std::string::npos) << notes;
  EXPECT_NE(notes.find("of 1631 samples lie on the circle"), std::string::npos) << notes;
}

TEST(DataFiles, AreRefusedWithTheLine) {
  const std::string head = "t,X,Y\n0,1,2\n0.1,1,2\n";
  struct Case {
    const char* name;
    std::string text;
    const char* says;
  };
  const Case kCases[] = {
      {"empty", "", "data.csv: error: there is no line with the names of the columns [DAT101]"},
      {"comments only", "# nothing\n", "[DAT101]"},
      {"no rows", "t,X,Y\n", "data.csv:1:1: error: there are no rows"},
      {"a missing column", "t,X,Z\n1,2,3\n",
       "data.csv:1:1: error: there is no column Y; the columns are t, X, Z [DAT103]"},
      {"a missing column, one with a comma in its name", "t,X,\"Y, mm\"\n1,2,3\n",
       "there is no column Y; the columns are t, X, \"Y, mm\" [DAT103]"},
      {"a comma without quotes", "t,X,Y\n0,\"1,5\",2\n0.1,1.5,2\n",
       "data.csv:3:1: error: t is not a number: 0.1 has another decimal mark"},
      {"a column twice", "t,X,Y,X\n1,2,3,4\n", "data.csv:1:1: error: the column X appears twice"},
      {"two separators", "t;X,Y\n1;2,3\n",
       "data.csv:1:1: error: the column names contain commas and semicolons"},
      {"no number", head + "0.2,1,abc\n",
       "data.csv:4:7: error: Y is not a number: abc [DAT107]\n    4 | 0.2,1,abc\n      |       ^"},
      {"nothing", head + "0.2,,2\n", "data.csv:4:5: error: X is not a number: there is nothing"},
      {"nothing at the end", head + "0.2,1,\n",
       "data.csv:4:7: error: Y is not a number: there is nothing"},
      {"half a number", head + "0.2,1.5mm,2\n", "data.csv:4:5: error: X is not a number: 1.5mm"},
      {"hexadecimal", head + "0.2,0x10,2\n", "data.csv:4:5: error: X is not a number"},
      {"not a number", head + "0.2,nan,2\n", "data.csv:4:5: error: X is not a number: nan"},
      {"infinity", head + "0.2,1,-inf\n", "data.csv:4:7: error: Y is out of range: -inf"},
      {"too large", head + "0.2,1e300,2\n", "data.csv:4:5: error: X is out of range: 1e300"},
      {"beyond doubles", head + "0.2,1e999,2\n", "data.csv:4:5: error: X is out of range"},
      {"beyond doubles below 0", head + "0.2,-1e999,2\n", "data.csv:4:5: error: X is out of range"},
      {"CR alone", "t,X,Y\r0,1,2\r0.1,1,abc\r0.2,1,2\r",
       "data.csv:3:7: error: Y is not a number: abc [DAT107]\n    3 | 0.1,1,abc\n      |       ^"},
      {"UTF-16, low byte first", std::string("\xFF\xFEt\0,\0X\0", 8),
       "data.csv: error: this is UTF-16 text, two bytes a character; save it as UTF-8 [DAT115]"},
      {"UTF-16, high byte first", std::string("\xFE\xFF\0t\0,", 6), "[DAT115]"},
      {"UTF-16 without a mark", std::string("t\0,\0X\0", 6), "[DAT115]"},
      {"two decimal marks", "t;X;Y\n0;1,5;2\n0,1;1.000;2\n",
       "data.csv:3:5: error: X is not a number: 1.000 has another decimal mark than a number "
       "before"},
      {"a sentinel", head + "0.2,9999999999,2\n", "data.csv:4:5: error: X is out of range"},
      {"a short row", head + "0.2,1\n",
       "data.csv:4:6: error: a short row: it has 2 values for 3 columns [DAT105]"},
      {"a long row", head + "0.2,1,2,3\n", "data.csv:4:9: error: a long row"},
      {"time back", head + "0.05,1,2\n",
       "data.csv:4:1: error: t does not rise: 0.05 comes after 0.1 [DAT110]"},
      {"time stands", head + "0.1,1,3\n", "data.csv:4:1: error: t does not rise"},
      {"no circle", head, "data.csv: error: the path is not a circle [DAT113]"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const EvaluateOutput output = evaluate_text(c.text, of_circle());
    EXPECT_EQ(output.exit_code, 2);
    const auto document = nlohmann::json::parse(output.out);
    EXPECT_EQ(document.at("status"), "usage");
    EXPECT_FALSE(document.contains("results"));
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
  }
}

TEST(DataFiles, NumbersThatAreTooSmallAre0) {
  const evaluate::DataFile file{"data.csv", "X\n1e-400\n-1e-400\n0.0000001e-399\n4e-320\n",
                                nullptr};
  const auto table = evaluate::read_table(file, {{"X", ColumnKind::Length}}, {});
  ASSERT_TRUE(table.ok()) << table.error().message;
  EXPECT_EQ(table.value().numbers("X"), (std::vector<double>{0.0, 0.0, 0.0, 4e-320}));
}

TEST(DataFiles, ThatAreTooLargeAreNotRead) {
  testing::TemporaryFolder folder;
  cli::EvaluateOptions options = of_circle();
  options.file = folder.write("data.csv", "t,X,Y\n");
  std::filesystem::resize_file(options.file, cli::kMostDataBytes + 1);  // takes no room
  const EvaluateOutput output = testing::run_evaluate(options);
  EXPECT_EQ(output.exit_code, 2);
  EXPECT_EQ(output.errors, "g31: error: " + options.file +
                               ": 256000001 bytes are too many: at most 256000000; leave out rows "
                               "that say nothing new\n");
}

TEST(DataFiles, OptionsThatDoNotFitAreRefused) {
  struct Case {
    const char* name;
    cli::EvaluateOptions options;
    const char* says;
  };
  const auto with = [](auto change) {
    cli::EvaluateOptions options = of_circle();
    change(options);
    return options;
  };
  const Case kCases[] = {
      {"a kind", with([](auto& o) { o.kind = "circel"; }), "did you mean circle?"},
      {"no length", with([](auto& o) { o.given[OptionId::Radius] = "-3"; }),
       "--radius -3: this is not a length above 0"},
      {"no pitch", with([](auto& o) { o.given[OptionId::Pitch] = "1e-300"; }),
       "--pitch 1e-300: write a pitch of 0.0001 mm at least"},
      {"one pitch of two", with([](auto& o) { o.given[OptionId::Pitch] = "10,0.00009"; }),
       "--pitch 10,0.00009: write a pitch"},
      {"infinite", with([](auto& o) { o.given[OptionId::Radius] = "inf"; }), "--radius inf"},
      {"no pair", with([](auto& o) { o.given[OptionId::Centre] = "3"; }), "--centre 3: write two"},
      {"a plane", with([](auto& o) { o.given[OptionId::Plane] = "XX"; }), "--plane XX: a plane is"},
      {"a unit", with([](auto& o) { o.unit = "furlong"; }), "--unit furlong: units are"},
      {"columns", with([](auto& o) { o.columns = {"X"}; }), "--columns X: write NAME=COLUMN"},
      {"a name that is not there", with([](auto& o) { o.columns = {"X=Q"}; }),
       "there is no column Q"},
      {"a name that nothing looks for", with([](auto& o) { o.columns = {"Q=X"}; }),
       "--columns Q=X: Q is none of the columns here, which are "},
      {"one column for two", with([](auto& o) { o.columns = {"X=Y"}; }),
       "the column Y cannot be both Y and X"},
      {"an interval", with([](auto& o) { o.given[OptionId::Interval] = "soon"; }),
       "--interval soon"},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const EvaluateOutput output = evaluate_text("t,X,Y\n" + circle_rows(",", "\n"), c.options);
    EXPECT_EQ(output.exit_code, 2);
    EXPECT_NE(output.errors.find(c.says), std::string::npos) << output.errors;
  }
  cli::EvaluateOptions missing = of_circle();
  missing.file = "no/such/file.csv";
  EXPECT_EQ(testing::run_evaluate(missing).errors,
            "g31: error: cannot read no/such/file.csv: no such file\n");
}

TEST(DataFiles, OfRubbishNeverCrash) {
  const std::string good = "t,X,Y\n" + circle_rows(",", "\n");
  const Stream stream{11, 0};
  std::uint64_t draw = 0;
  const auto below = [&](std::size_t n) {
    return static_cast<std::size_t>(uniform(stream, draw++) * static_cast<double>(n));
  };
  const std::string_view kPieces[] = {",",
                                      ";",
                                      "\t",
                                      "\n",
                                      "\r\n",
                                      "\"",
                                      "-",
                                      "e9",
                                      "nan",
                                      "#",
                                      std::string_view("\0", 1),
                                      "\xFF",
                                      "t,X,Y\n",
                                      "1e308",
                                      "  "};
  int refused = 0;
  for (int round = 0; round < 300; ++round) {
    std::string text = round % 3 == 0 ? "t,X,Y\n" : good.substr(0, below(good.size()));
    for (std::size_t change = below(20); change > 0; --change) {
      text.insert(below(text.size() + 1), kPieces[below(std::size(kPieces))]);
    }
    const EvaluateOutput output = evaluate_text(text, of_circle());
    EXPECT_TRUE(output.exit_code == 0 || output.exit_code == 2) << text;
    refused += output.exit_code == 2 ? 1 : 0;
  }
  EXPECT_GT(refused, 100);
}

TEST(DataTable, TellsWhatTheDigitsResolve) {
  const auto table = evaluate::read_table(
      {"f", "a,b,c\n1.25,2,3e-7\n1.5,2,3\n"},
      {{"a", ColumnKind::Length}, {"b", ColumnKind::Length}, {"c", ColumnKind::Number}},
      {{}, 1e-3});
  ASSERT_TRUE(table.ok());
  EXPECT_DOUBLE_EQ(table.value().resolution("a"), 1e-5);
  EXPECT_DOUBLE_EQ(table.value().resolution("b"), 1e-3);
  EXPECT_DOUBLE_EQ(table.value().resolution("c"), 1e-15);
  EXPECT_DOUBLE_EQ(table.value().numbers("a")[0], 1.25e-3);
}

/// A record that begins with a standstill at 50.0 is as fine as its other rows say.
TEST(DataTable, TellsWhatTheDigitsOfLateRowsResolve) {
  std::string text = "a\n";
  for (int row = 0; row < 5000; ++row) {
    text += "50.0\n";
  }
  const auto table =
      evaluate::read_table({"f", text + "49.99875\n50\n"}, {{"a", ColumnKind::Length}}, {});
  ASSERT_TRUE(table.ok());
  EXPECT_DOUBLE_EQ(table.value().resolution("a"), 1e-5);
}

/// Places of 1e6 mm and steps below their last digit: the zones are those of the steps.
TEST(Records, SmallStepsFarAwayAreEvaluatedAsTheyAreAtZero) {
  const std::string rows = "K,A,B\n0,0,0\n1,0.001,0\n2,0,0.002\n3,0,0\n";
  cli::EvaluateOptions options;
  options.kind = "straightness";
  options.given[evaluate::OptionId::Step] = "1e-12";
  options.given[evaluate::OptionId::From] = "1e6";
  const auto far = testing::evaluate_text(rows, options);
  ASSERT_EQ(far.exit_code, 0) << far.errors;
  options.given[evaluate::OptionId::Step] = "1";
  options.given[evaluate::OptionId::From] = "0";
  const auto near = testing::evaluate_text(rows, options);
  for (const char* name : {"motion_straightness", "motion_straightness_least_squares",
                           "work_straightness_minimum_zone"}) {
    EXPECT_NEAR(far.document["results"][name]["value"].get<double>(),
                near.document["results"][name]["value"].get<double>(), 1e-9)
        << name;
  }
}

TEST(Records, AnIntervalIsForAFileWithoutTimes) {
  cli::EvaluateOptions options;
  options.kind = "speed";
  options.given[evaluate::OptionId::Interval] = "4ms";
  const auto with = testing::evaluate_text("t,X,Y\n0,0,0\n1,10,0\n2,20,0\n3,30,0\n", options);
  EXPECT_EQ(with.exit_code, 2);
  EXPECT_NE(with.errors.find("it has a column t"), std::string::npos) << with.errors;
  EXPECT_EQ(testing::evaluate_text("X,Y\n0,0\n10,0\n20,0\n30,0\n", options).exit_code, 0);
}

TEST(Records, RowsOfOtherAxesAreNoSamples) {
  cli::EvaluateOptions options;
  options.kind = "positioning";
  options.given[evaluate::OptionId::Axis] = "X";
  const auto output = testing::evaluate_text(
      "axis,target,direction,cycle,position\nX,0,+1,1,0.001\nX,0,+1,2,0.002\nX,0,-1,1,0.001\n"
      "X,0,-1,2,0.002\nY,0,+1,1,0\nY,0,+1,2,0\n",
      options);
  ASSERT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.document["samples"], 4);
}

}  // namespace
}  // namespace g31::data_files_test

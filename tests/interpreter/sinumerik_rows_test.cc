// Every row of the SINUMERIK tables is reached: by a program made of the row,
// or by name in a conformance case.

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>
#include <string>
#include <utility>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "interpreter/dialects/sinumerik/vocabulary/alarms.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"
#include "interpreter/dialects/sinumerik/vocabulary/g_codes.h"
#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/dialects/sinumerik/vocabulary/operators.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "tests/support/control_run.h"
#include "tests/support/recording_machine.h"

namespace g31::sinumerik::sinumerik_rows_test {
namespace {

/// A program, its alarm and what it left in R1.
struct Ran {
  int alarm = 0;  ///< 0: none
  std::string detail;
  double r1 = 0.0;
};

Ran run_of(const std::string& program) {
  testing::FilesInMemory files({{"row.mpf", program + "\nM30\n"}});
  source::SourceMap sources(files);
  ProgramLibrary library(sources);
  library.add_file("row.mpf");
  testing::RecordingMachine machine;
  runtime::Observer observer;
  Session session(library, machine, observer);
  session.configure({});
  const runtime::Outcome outcome = session.run({});
  Ran ran;
  ran.alarm = outcome.alarm ? outcome.alarm->number : 0;
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    ran.detail += diagnostic.message + " ";
  }
  const auto value = session.variable("R1");
  const auto* const cell = value ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
  ran.r1 = cell != nullptr ? cell->or_zero() : 0.0;
  return ran;
}

int number_of(AlarmId id) {
  return info(id).number;
}

/// The name of a row, of a family its first member, with indices that there
/// are.
std::string written(const SystemVariable& row) {
  std::string name(row.name);
  for (int i = 1; !find_system_variable(name); ++i) {
    name = fmt::format("{}{}", row.name, i);
  }
  std::string indices;
  for (const char kind : row.indices) {
    const bool first_point = row.id == SystemId::ReferencePoint && indices.empty();
    indices += indices.empty() ? "" : ",";
    indices += kind == 'A' ? "X" : kind == 'n' || first_point ? "0" : "1";
  }
  return indices.empty() ? name : name + "[" + indices + "]";
}

/// T1 with its edge D1 in the spindle.
constexpr const char* kTool = "T1 M6\n$TC_DP1[1,1]=120\nD1\n";

std::string type_of(const SystemVariable& row) {
  return row.type == Type::String ? "STRING[64]" : std::string(name_of(row.type));
}

TEST(SinumerikRows, EverySystemVariableShowsAValueOfItsType) {
  for (const SystemVariable& row : system_variables()) {
    const std::string name = written(row);
    SCOPED_TRACE(name);
    const Ran ran = run_of(fmt::format("DEF {0} V\n{1}V={2}\nR1=1", type_of(row), kTool, name));
    const bool is_refused = row.access == Access::Refused;
    EXPECT_EQ(ran.alarm, is_refused ? number_of(AlarmId::NotImplemented) : 0) << ran.detail;
    EXPECT_EQ(ran.r1, is_refused ? 0.0 : 1.0);
  }
}

TEST(SinumerikRows, EverySystemVariableTakesAValueAndShowsItAgainUnlessItIsOnlyRead) {
  for (const SystemVariable& row : system_variables()) {
    const std::string name = written(row);
    SCOPED_TRACE(name);
    const std::string value = row.type == Type::String  ? "\"NAME\""
                              : row.type == Type::Frame ? "CTRANS(X,3)"
                              : row.type == Type::Axis  ? "Y"
                                                        : "1";
    const Ran ran = run_of(
        fmt::format("DEF {0} V\n{1}{2}={3}\nV={2}\nR1=V=={3}", type_of(row), kTool, name, value));
    if (row.access != Access::Write) {
      const AlarmId id =
          row.access == Access::Read ? AlarmId::WriteProtected : AlarmId::NotImplemented;
      EXPECT_EQ(ran.alarm, number_of(id)) << ran.detail;
    } else {
      EXPECT_EQ(ran.alarm, 0) << ran.detail;
      EXPECT_EQ(ran.r1, 1.0);
    }
  }
}

TEST(SinumerikRows, EveryGCodeSetsItsGroupOrIsRefused) {
  for (const GCode& row : g_codes()) {
    SCOPED_TRACE(std::string(row.name));
    const bool is_modal = row.action == GAction::Modal;
    const std::string show =
        is_modal ? fmt::format("R1=$P_GG[{}]", static_cast<int>(row.group)) : "R1=1";
    const std::string angles = row.action == GAction::SolidAngles ? " X1 Y1" : "";
    const Ran ran = run_of(fmt::format("{}{}{}\n{}", kTool, row.name, angles, show));
    if (row.action == GAction::Refused) {
      EXPECT_EQ(ran.alarm, number_of(AlarmId::NotImplemented)) << ran.detail;
    } else {
      EXPECT_EQ(ran.alarm, 0) << ran.detail;
      EXPECT_EQ(ran.r1, is_modal ? row.number : 1.0);
    }
  }
}

TEST(SinumerikRows, EveryAxisWordIsTakenWithinItsLimitsOrRefused) {
  for (const AxisWordInfo& row : axis_words()) {
    SCOPED_TRACE(std::string(row.name));
    const auto with = [&](double value) {
      return run_of(fmt::format("{}[X]={:.6f}", row.name, value));
    };
    switch (row.role) {
      case AxisRole::Path:
      case AxisRole::Positioning:
        if (row.id == AxisWordId::CentreOfAxis) {
          EXPECT_EQ(run_of("G2 X10 IP[X]=5 IP[Y]=0 F100\nR1=$AA_IM[X]").r1, 10.0);
          break;
        }
        EXPECT_EQ(run_of(fmt::format("G0 {}[X]=5\nR1=$AA_IM[X]", row.name)).r1, 5.0);
        break;
      case AxisRole::Measuring:
        EXPECT_EQ(run_of(fmt::format("{}[X]=(1,1) G1 X5 F100\nR1=$AA_IM[X]", row.name)).r1, 5.0);
        break;
      case AxisRole::Setting:
      case AxisRole::AxisSetting:
        EXPECT_EQ(with(row.least).alarm, 0);
        EXPECT_EQ(with(row.most).alarm, 0);
        EXPECT_NE(with(row.least - 1.0).alarm, 0);
        EXPECT_NE(with(row.most * 2.0).alarm, 0);
        break;
      case AxisRole::Switch:
      case AxisRole::AxisSwitch:
        EXPECT_EQ(run_of(fmt::format("{}[X]", row.name)).alarm, 0);
        EXPECT_EQ(with(1.0).alarm, number_of(AlarmId::SyntaxInText));
        EXPECT_EQ(run_of(fmt::format("{}[S]", row.name)).alarm == 0, row.role == AxisRole::Switch);
        break;
      case AxisRole::Refused:
        EXPECT_EQ(run_of(fmt::format("{}[X]=1", row.name)).alarm,
                  number_of(AlarmId::NotImplemented));
        break;
    }
  }
}

/// All words of the conformance cases, comments left out: names, with what
/// stands before `(` and `[`.
std::set<std::string> words_of_cases() {
  std::set<std::string> words;
  for (const auto& file : std::filesystem::directory_iterator("tests/conformance/sinumerik")) {
    std::ifstream in(file.path());
    for (std::string line; std::getline(in, line);) {
      std::string word;
      for (const char c : upper(line.substr(0, line.find(';'))) + " ") {
        if (is_letter(c) || is_digit(c) || c == '$') {
          word.push_back(c);
        } else if (!word.empty()) {
          words.insert(std::exchange(word, {}));
        }
      }
    }
  }
  return words;
}

/// Whether a case has the address: before =, or before its number.
bool has_address(const std::set<std::string>& words, std::string_view name) {
  const auto is_it = [&](const std::string& word) {
    const bool numbered = word.find_first_not_of("0123456789", name.size()) == std::string::npos;
    return word.starts_with(name) && (word.size() == name.size() || (name.size() == 1 && numbered));
  };
  return std::ranges::any_of(words, is_it);
}

TEST(SinumerikRows, EveryFunctionProcedureAndAddressIsInACase) {
  const std::set<std::string> words = words_of_cases();
  ASSERT_GT(words.size(), 500U);
  for (const FunctionInfo& row : functions()) {
    EXPECT_TRUE(words.contains(std::string(row.name))) << row.name;
  }
  for (const ProcedureInfo& row : procedures()) {
    EXPECT_TRUE(words.contains(std::string(row.name))) << row.name;
  }
  for (const AddressInfo& row : addresses()) {
    EXPECT_TRUE(has_address(words, row.name)) << row.name;
  }
}

TEST(SinumerikRows, EverySystemVariableIsInACase) {
  const std::set<std::string> words = words_of_cases();
  for (const SystemVariable& row : system_variables()) {
    std::string name(row.name);
    bool found = words.contains(name);
    for (int i = 1; !found && i < 100; ++i) {
      const std::string member = fmt::format("{}{}", row.name, i);
      found = find_system_variable(member) && words.contains(member);
    }
    EXPECT_TRUE(found) << row.name;
  }
}

TEST(SinumerikRows, EveryKeywordIsInACaseOrRefused) {
  const std::set<std::string> words = words_of_cases();
  for (const KeywordInfo& row : keywords()) {
    if (!words.contains(std::string(row.name))) {
      const Ran ran = run_of(std::string(row.name));
      EXPECT_EQ(ran.alarm, number_of(AlarmId::NotImplemented)) << row.name;
      EXPECT_NE(ran.detail.find(row.text), std::string::npos) << ran.detail;
    }
  }
}

}  // namespace
}  // namespace g31::sinumerik::sinumerik_rows_test

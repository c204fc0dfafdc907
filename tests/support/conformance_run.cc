#include "tests/support/conformance_run.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <regex>
#include <set>
#include <sstream>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"

namespace g31::testing {
namespace {

using nlohmann::json;

/// What a run left, as the expectations ask for it.
struct Observed {
  RunOutput run;
  std::string status;  ///< as the document has it
  int alarm = 0;       ///< 0: none
  int alarm_line = 0;  ///< counted from the CASE line
};

std::string unescaped(const std::string& text) {
  std::string plain;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] != '\\' || i + 1 == text.size()) {
      plain.push_back(text[i]);
      continue;
    }
    const char kind = text[++i];
    if (kind == 'x') {
      const int code = std::stoi(text.substr(i + 1, 2), nullptr, 16);
      i += 2;
      if (code >= 0x80) {
        plain.push_back(static_cast<char>(0xC0 | (code >> 6)));
      }
      plain.push_back(static_cast<char>(code >= 0x80 ? 0x80 | (code & 0x3F) : code));
    } else {
      plain.push_back(kind == 'n' ? '\n' : kind == 'r' ? '\r' : kind);
    }
  }
  return plain;
}

bool is_near(const json& got, double want, double within) {
  return got.is_number() && std::abs(got.get<double>() - want) <= within;
}

/// The usual tolerance: a millionth, and 1e-9 beside 0.
double tolerance(double want) {
  return std::max(1e-9, 1e-6 * std::abs(want));
}

std::string variable_mismatch(const std::smatch& parts, const Observed& seen) {
  const std::string name = parts[1];
  const json got =
      seen.run.document.value("variables", json::object()).value(name, json("missing"));
  if (parts[2] == "VACANT") {
    return got.is_null() ? "" : fmt::format("{} is {}", name, got.dump());
  }
  if (const std::string quoted = parts[2]; quoted.starts_with('"')) {
    const std::string text = quoted.substr(1, quoted.size() - 2);
    return got == text ? "" : fmt::format("{} is {}", name, got.dump());
  }
  const double want = std::stod(parts[2]);
  const double within = parts[3].matched ? std::stod(parts[3]) : tolerance(want);
  return is_near(got, want, within) ? "" : fmt::format("{} is {}", name, got.dump());
}

/// Alarms of malformed text: which of them a control raises is not settled (MB-326).
std::string format_mismatch(const std::smatch& parts, const Observed& seen) {
  static const std::set<int> kFormatAlarms = {4,    5,    9,    114,  125,  1093, 1131, 1132, 1133,
                                              1134, 1137, 1138, 1139, 1143, 1300, 1301, 1302};
  const bool is_right =
      kFormatAlarms.contains(seen.alarm) && seen.alarm_line == std::stoi(parts[1]);
  return is_right ? "" : fmt::format("alarm {} at {}", seen.alarm, seen.alarm_line);
}

std::string alarm_mismatch(const std::smatch& parts, const Observed& seen) {
  const bool is_right = seen.alarm == std::stoi(parts[1]) &&
                        (!parts[2].matched || seen.alarm_line == std::stoi(parts[2]));
  return is_right ? "" : fmt::format("alarm {} at {}", seen.alarm, seen.alarm_line);
}

std::string message_mismatch(const std::smatch& parts, const Observed& seen) {
  const json got = seen.run.document.value("/alarm/text"_json_pointer, json());
  return got == unescaped(parts[1]) ? "" : fmt::format("message {}", got.dump());
}

std::string output_mismatch(const std::smatch& parts, const Observed& seen) {
  const json got = seen.run.document.value("/output"_json_pointer, json());
  return got == unescaped(parts[1]) ? "" : fmt::format("output {}", got.dump());
}

std::string stop_mismatch(const std::smatch& parts, const Observed& seen) {
  const json stops = seen.run.document.value("stops", json::array());
  const bool found = std::ranges::any_of(
      stops, [&](const json& stop) { return stop["text"] == unescaped(parts[1]); });
  return found ? "" : fmt::format("stops {}", stops.dump());
}

std::string warning_mismatch(const std::smatch& parts, const Observed& seen) {
  const json rows = seen.run.document.value("diagnostics", json::array());
  const bool found = std::ranges::any_of(rows, [&](const json& row) {
    return row["code"] == parts[1].str() &&
           (!parts[2].matched || row.value("line", 0) == std::stoi(parts[2]));
  });
  return found ? "" : fmt::format("diagnostics {}", rows.dump());
}

std::string no_warning_mismatch(const std::smatch& parts, const Observed& seen) {
  const json rows = seen.run.document.value("diagnostics", json::array());
  const bool found =
      std::ranges::any_of(rows, [&](const json& row) { return row["code"] == parts[1].str(); });
  return found ? fmt::format("diagnostics {}", rows.dump()) : "";
}

/// Two bodies met, PRB401; over-travel of the stylus is told in the same way.
std::string collision_mismatch(const std::smatch& parts, const Observed& seen) {
  const std::regex told(
      fmt::format(R"(case\.[a-z]+:{}:[0-9]+: error: .*\[PRB401\])", parts[1].str()));
  return seen.status == "collision" && std::regex_search(seen.run.errors, told)
             ? ""
             : fmt::format("{}: {}", seen.status, seen.run.errors);
}

std::string moves_mismatch(const std::smatch& parts, const Observed& seen) {
  const json moves = seen.run.document.value("moves", json::array());
  return moves.size() == std::stoul(parts[1]) ? "" : fmt::format("moves {}", moves.dump());
}

std::string move_mismatch(const std::smatch& parts, const Observed& seen) {
  const json moves = seen.run.document.value("moves", json::array());
  const std::size_t number = std::stoul(parts[1]);
  if (number < 1 || number > moves.size()) {
    return fmt::format("moves {}", moves.dump());
  }
  const json& move = moves[number - 1];
  bool is_right = true;
  std::istringstream words(parts[2].str());
  for (std::string word; words >> word;) {
    const double want = std::stod(word.substr(1));
    const std::size_t axis = std::string_view("XYZABC").find(word.front());
    const json got = word.front() == 'G'        ? move["g"]
                     : word.front() == 'T'      ? move.value("t", json())
                     : word.front() == 'F'      ? move.value("feed", json())
                     : axis < move["to"].size() ? move["to"][axis]
                                                : json(0.0);
    is_right = is_right && is_near(got, want, 1e-6);
  }
  return is_right ? "" : fmt::format("move {}", move.dump());
}

/// A form of expectation: what it looks like, and what differs ("" when nothing does).
struct Form {
  const char* pattern;
  std::string (*mismatch)(const std::smatch&, const Observed&);
};

const std::vector<Form>& forms() {
  static const std::vector<Form> rows = {
      {"COMPLETED", [](const std::smatch&, const Observed&) { return std::string(); }},
      {R"re(([^ ]+) = (VACANT|"[^"]*"|[-0-9.e]+)(?: WITHIN ([0-9.e-]+))?)re", variable_mismatch},
      {"ALARM ([0-9]+)(?: AT ([0-9]+))?", alarm_mismatch},
      {"ALARM FORMAT AT ([0-9]+)", format_mismatch},
      {"MESSAGE \"(.*)\"", message_mismatch},
      {"OUTPUT \"(.*)\"", output_mismatch},
      {"STOP \"(.*)\"", stop_mismatch},
      {"WARNING ([A-Z0-9]+)(?: AT ([0-9]+))?", warning_mismatch},
      {"NO WARNING ([A-Z0-9]+)", no_warning_mismatch},
      {"COLLISION AT ([0-9]+)", collision_mismatch},
      {"MOVES ([0-9]+)", moves_mismatch},
      {"MOVE ([0-9]+)((?: [GTFXYZABC]-?[0-9.]+)+)", move_mismatch}};
  return rows;
}

std::string mismatch(const std::string& expectation, const Observed& seen) {
  for (const Form& form : forms()) {
    std::smatch parts;
    if (std::regex_match(expectation, parts, std::regex(form.pattern))) {
      return form.mismatch(parts, seen);
    }
  }
  return "no such expectation";
}

void take_status(Observed& seen) {
  const json& document = seen.run.document;
  seen.status = document.value("status", "");
  seen.alarm = document.value("/alarm/number"_json_pointer, 0);
  seen.alarm_line = document.value("/alarm/line"_json_pointer, 0);
}

/// @param file  what the program's file is called
Observed run_case(const ConformanceCase& test, const std::string& control,
                  const std::string& file) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(file, test.program)};
  options.setups = {folder.write("sheet.toml", sheet_of(test))};
  options.control = control;
  options.moves = true;
  options.budget = {2'000'000, 20.0};
  for (const ConformanceCase::Row& row : test.expectations) {
    if (row.text.find(" = ") != std::string::npos) {
      options.prints.push_back(row.text.substr(0, row.text.find(' ')));
    }
  }
  Observed seen;
  seen.run = run_program(options);
  if (!seen.run.document.is_object()) {
    seen.run.document = json::object();
  }
  take_status(seen);
  return seen;
}

}  // namespace

std::vector<std::string> case_files(const std::string& folder) {
  std::vector<std::string> names;
  std::error_code none;
  for (const auto& entry : std::filesystem::directory_iterator(folder, none)) {
    names.push_back(entry.path().stem().string());
  }
  std::ranges::sort(names);
  return names;
}

void expect_case_holds(const ConformanceCase& test, const std::string& control,
                       const std::string& program, const std::string& path,
                       const std::string& place) {
  const auto expects = [&](std::string_view what) {
    return std::ranges::any_of(test.expectations,
                               [&](const auto& row) { return row.text.starts_with(what); });
  };
  const Observed seen = run_case(test, control, program);
  // Over-travel is an alarm of the control and a collision of the machine, a missing tool one of
  // the set-up.
  const bool ended_by_alarm =
      seen.alarm != 0 &&
      (seen.status == "alarm" || seen.status == "setup" || seen.status == "collision");
  EXPECT_TRUE(expects("ALARM")       ? ended_by_alarm
              : expects("COLLISION") ? seen.status == "collision"
                                     : seen.status == "completed")
      << fmt::format("{}:{}: ({}) is {}: {}", path, test.title.line, place, seen.status,
                     seen.run.errors);
  for (const ConformanceCase::Row& row : test.expectations) {
    const std::string wrong = mismatch(row.text, seen);
    EXPECT_TRUE(wrong.empty()) << fmt::format("{}:{}: ({}) {}, not: {}", path, row.line, place,
                                              wrong, row.text);
  }
}

}  // namespace g31::testing

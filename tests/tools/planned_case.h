#pragma once

#include <algorithm>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "parts/import/step_file.h"
#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tests/support/temporary_folder.h"

namespace g31::testing {

/// The product of the case study of `g31 plan`.
inline const std::string kInspected = "parts/library/inspection/product.step";

/// Plans into a folder of its own.
class PlannedCase : public ::testing::Test {
 protected:
  void SetUp() override {
    if (!parts::can_read_step()) {
      GTEST_SKIP() << "g31 was built without Open CASCADE: no STEP file is read";
    }
  }

  [[nodiscard]] CommandOutput plan(std::vector<std::string> words) const {
    words.insert(words.begin(), "plan");
    words.insert(words.end(), {"-o", folder_.path("out")});
    return g31(words);
  }

  [[nodiscard]] std::string out(const std::string& name) const {
    return folder_.path("out") + "/" + name;
  }

  [[nodiscard]] nlohmann::json document() const {
    return nlohmann::json::parse(text_of(out("plan.json")));
  }

  /// The product with other coordinates, as its STEP text has them.
  [[nodiscard]] std::string changed_product(
      const std::vector<std::pair<std::string, std::string>>& changes) const {
    std::string text = text_of(kInspected);
    for (const auto& [from, to] : changes) {
      EXPECT_NE(text.find(from), std::string::npos) << from;
      for (std::size_t at = text.find(from); at != std::string::npos;
           at = text.find(from, at + to.size())) {
        text.replace(at, from.size(), to);
      }
    }
    return folder_.write("machined.step", text);
  }

  TemporaryFolder folder_;
};

/// The row of that id; none: an empty object.
inline nlohmann::json row_of(const nlohmann::json& rows, const std::string& id) {
  const auto found =
      std::ranges::find_if(rows, [&id](const nlohmann::json& row) { return row.at("id") == id; });
  return found == rows.end() ? nlohmann::json::object() : *found;
}

/// The variables that a program leaves, and what it prints.
struct ProgramRun {
  std::map<std::string, double> variables;
  std::string printed;
};

/// @param measures  of the plan
inline ProgramRun run_plan(const std::string& program, const std::string& sheet,
                           const nlohmann::json& measures) {
  cli::RunOptions options;
  options.programs = {program};
  options.setups = {sheet};
  for (const nlohmann::json& measure : measures) {
    options.prints.push_back(measure.at("variable"));
  }
  const auto ran = run_program(options);
  EXPECT_EQ(ran.exit_code, 0) << ran.errors;
  ProgramRun run;
  if (ran.exit_code != 0) {
    return run;
  }
  for (const nlohmann::json& measure : measures) {
    const std::string name = measure.at("variable");
    run.variables[name] = ran.document.at("variables").at(name);
  }
  run.printed = ran.document.at("output");
  for (const nlohmann::json& text : ran.document.at("files")) {
    run.printed += text;
  }
  return run;
}

}  // namespace g31::testing

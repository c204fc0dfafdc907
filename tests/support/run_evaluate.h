#pragma once

#include <string>

#include <gtest/gtest.h>
#include <nlohmann/json.hpp>

#include "tests/support/run_program.h"
#include "tools/cli/evaluate_command.h"

namespace g31::testing {

/// What `g31 evaluate` left.
struct EvaluateOutput {
  int exit_code = -1;
  std::string out;
  std::string errors;
  nlohmann::json document;  ///< null where none came

  [[nodiscard]] double value(const std::string& name) const {
    return document.at("results").at(name).at("value");
  }
  [[nodiscard]] double u(const std::string& name) const {
    return document.at("results").at(name).at("u");
  }
};

/// Runs the command in this process, with the document on standard output.
inline EvaluateOutput run_evaluate(cli::EvaluateOptions options) {
  options.json = "-";
  EvaluateOutput output;
  ::testing::internal::CaptureStdout();
  ::testing::internal::CaptureStderr();
  output.exit_code = static_cast<int>(cli::evaluate_command(options));
  output.errors = ::testing::internal::GetCapturedStderr();
  output.out = ::testing::internal::GetCapturedStdout();
  if (output.exit_code == 0) {
    output.document = nlohmann::json::parse(output.out);
  }
  return output;
}

/// The text, evaluated as a file `data.csv`.
inline EvaluateOutput evaluate_text(const std::string& text, cli::EvaluateOptions options) {
  TemporaryFolder folder;
  options.file = folder.write("data.csv", text);
  EvaluateOutput output = run_evaluate(options);
  // The folder has a name of its own each time.
  for (std::string* said : {&output.out, &output.errors}) {
    for (std::size_t at = said->find(options.file); at != std::string::npos;
         at = said->find(options.file)) {
      said->replace(at, options.file.size(), "data.csv");
    }
  }
  return output;
}

}  // namespace g31::testing

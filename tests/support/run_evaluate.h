#pragma once

#include <string>

#include <nlohmann/json.hpp>

#include "tests/support/captured.h"
#include "tests/support/run_program.h"
#include "tools/cli/evaluate_command.h"

namespace g31::testing {

/// What `g31 evaluate` left.
struct EvaluateOutput : CommandOutput {
  nlohmann::json document;  ///< null where none came

  [[nodiscard]] double value(const std::string& name) const {
    return document.at("results").at(name).at("value");
  }
  [[nodiscard]] double u(const std::string& name) const {
    return document.at("results").at(name).at("u");
  }
};

/// Runs the command in this process, with the document on standard output.
EvaluateOutput run_evaluate(cli::EvaluateOptions options);

/// The text, evaluated as a file `data.csv`.
EvaluateOutput evaluate_text(const std::string& text, cli::EvaluateOptions options);

}  // namespace g31::testing

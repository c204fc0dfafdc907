#include <cstdio>
#include <exception>
#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <malloc.h>

#include "tools/cli/check_command.h"
#include "tools/cli/check_options.h"
#include "tools/cli/evaluate_command.h"
#include "tools/cli/evaluate_options.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/explain_command.h"
#include "tools/cli/explain_options.h"
#include "tools/cli/interruption.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_options.h"
#include "tools/cli/scene_command.h"
#include "tools/cli/scene_options.h"
#include "tools/cli/study_command.h"
#include "tools/cli/study_options.h"

namespace {

using g31::cli::ExitCode;

std::string exit_code_help() {
  std::string text = "Exit codes:\n";
  for (const auto& row : g31::cli::exit_codes()) {
    text += fmt::format("  {:2}  {}\n", static_cast<int>(row.code), row.text);
  }
  return text;
}

/// Windows of a long program come and go: what they leave stays with us for the next ones, instead
/// of going back to the system, which would have to clear it again.
void keep_freed_memory() {
  constexpr int kBytes = 32 << 20;
  mallopt(M_MMAP_THRESHOLD, kBytes);
  mallopt(M_TRIM_THRESHOLD, kBytes);
}

ExitCode dispatch(int argc, char** argv) {
  CLI::App app("g31 runs touch-probe NC programs on a simulated machine.", "g31");
  app.set_version_flag("--version", "g31 " G31_VERSION);
  app.require_subcommand(1);
  app.footer(exit_code_help());
  g31::cli::RunOptions run;
  CLI::App* const run_app = g31::cli::add_run_command(app, run);
  run_app->footer(g31::cli::run_examples() + exit_code_help());
  g31::cli::ExplainOptions explain;
  CLI::App* const explain_app = g31::cli::add_explain_command(app, explain);
  explain_app->footer(g31::cli::explain_examples() + exit_code_help());
  g31::cli::SceneOptions scene;
  CLI::App* const scene_app = g31::cli::add_scene_command(app, scene);
  scene_app->footer(g31::cli::scene_examples() + exit_code_help());
  g31::cli::StudyOptions study;
  CLI::App* const study_app = g31::cli::add_study_command(app, study);
  study_app->footer(g31::cli::study_examples() + exit_code_help());
  g31::cli::CheckOptions check;
  CLI::App* const check_app = g31::cli::add_check_command(app, check);
  check_app->footer(g31::cli::check_examples() + exit_code_help());
  g31::cli::EvaluateOptions evaluate;
  CLI::App* const evaluate_app = g31::cli::add_evaluate_command(app, evaluate);
  evaluate_app->footer(g31::cli::evaluate_examples() + exit_code_help());
  try {
    app.parse(argc, argv);
  } catch (const CLI::ParseError& error) {
    return app.exit(error) == 0 ? ExitCode::Completed : ExitCode::BadUsage;
  }
  if (check_app->parsed()) {
    return check_command(check);
  }
  if (explain_app->parsed()) {
    return explain_command(explain);
  }
  const g31::runtime::Interruption& interruption = g31::cli::catch_interruption();
  run.budget.interruption = scene.run.budget.interruption = &interruption;
  study.interruption = evaluate.interruption = &interruption;
  if (scene_app->parsed()) {
    return scene_command(scene);
  }
  if (study_app->parsed()) {
    return study_command(study);
  }
  return evaluate_app->parsed() ? evaluate_command(evaluate) : run_command(run);
}

}  // namespace

int main(int argc, char** argv) {
  keep_freed_memory();
  try {
    return static_cast<int>(dispatch(argc, argv));
  } catch (const std::exception& error) {
    std::fprintf(stderr, "g31: defect: %s\n", error.what());
    return static_cast<int>(ExitCode::Defect);
  }
}

#include "tools/cli/command_line.h"

#include <string>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/cli/check_command.h"
#include "tools/cli/check_options.h"
#include "tools/cli/evaluate_command.h"
#include "tools/cli/evaluate_options.h"
#include "tools/cli/explain_command.h"
#include "tools/cli/explain_options.h"
#include "tools/cli/interruption.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_options.h"
#include "tools/cli/scene_command.h"
#include "tools/cli/scene_options.h"
#include "tools/cli/study_command.h"
#include "tools/cli/study_options.h"

namespace g31::cli {
namespace {

std::string exit_code_help() {
  std::string text = "Exit codes:\n";
  for (const auto& row : exit_codes()) {
    text += fmt::format("  {:2}  {}\n", static_cast<int>(row.code), row.text);
  }
  return text;
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv, const std::string& version) {
  CLI::App app("g31 runs touch-probe NC programs on a simulated machine.", "g31");
  app.set_version_flag("--version", "g31 " + version);
  app.require_subcommand(1);
  app.footer(exit_code_help());
  RunOptions run;
  CLI::App* const run_app = add_run_command(app, run);
  run_app->footer(run_examples() + exit_code_help());
  ExplainOptions explain;
  CLI::App* const explain_app = add_explain_command(app, explain);
  explain_app->footer(explain_examples() + exit_code_help());
  SceneOptions scene;
  CLI::App* const scene_app = add_scene_command(app, scene);
  scene_app->footer(scene_examples() + exit_code_help());
  StudyOptions study;
  CLI::App* const study_app = add_study_command(app, study);
  study_app->footer(study_examples() + exit_code_help());
  CheckOptions check;
  CLI::App* const check_app = add_check_command(app, check);
  check_app->footer(check_examples() + exit_code_help());
  EvaluateOptions evaluate;
  CLI::App* const evaluate_app = add_evaluate_command(app, evaluate);
  evaluate_app->footer(evaluate_examples() + exit_code_help());
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
  const runtime::Interruption& interruption = catch_interruption();
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

}  // namespace g31::cli

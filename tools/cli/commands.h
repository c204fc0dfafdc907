#pragma once

#include <functional>
#include <span>
#include <string>
#include <string_view>

#include "tools/cli/check_command.h"
#include "tools/cli/command_words.h"
#include "tools/cli/evaluate_command.h"
#include "tools/cli/exit_code.h"
#include "tools/cli/explain_command.h"
#include "tools/cli/judge_command.h"
#include "tools/cli/new_command.h"
#include "tools/cli/pages_options.h"
#include "tools/cli/plan_command.h"
#include "tools/cli/run_command.h"
#include "tools/cli/scene_command.h"
#include "tools/cli/setup_command.h"
#include "tools/cli/study_command.h"
#include "tools/cli/view_command.h"

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// What the words of a command line come to, for each command.
struct Options {
  bool is_version_asked = false;
  bool is_version_json = false;
  bool is_quiet = false;  ///< of commands that have no progress to show
  RunOptions run;
  ViewOptions view;
  ExplainOptions explain;
  SceneOptions scene;
  StudyOptions study;
  CheckOptions check;
  SetupOptions setup;
  NewOptions starter;
  EvaluateOptions evaluate;
  PlanOptions plan;
  JudgeOptions judge;
  PagesOptions pages;
};

/// Gives the words of all commands to those that print them.
using WordsOfAll = std::function<ProgramWords()>;

/// A command of g31: how it is called, what may stand behind it, and what does its work.
struct CommandRow {
  std::string_view name;
  std::string_view text;    ///< what it does, for people
  bool lasts;               ///< it ends itself when it is interrupted
  std::string_view schema;  ///< of its document; "": it has none
  void (*add_options)(CLI::App& command, Options& options);
  std::string (*examples)();
  ExitCode (*run)(const Options& options, const WordsOfAll& words);
};

/// All of them, in the order of --help.
std::span<const CommandRow> commands();

}  // namespace g31::cli

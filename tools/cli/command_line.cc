#include "tools/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <functional>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "tools/cli/check_command.h"
#include "tools/cli/check_options.h"
#include "tools/cli/evaluate_command.h"
#include "tools/cli/evaluate_options.h"
#include "tools/cli/exit_code_help.h"
#include "tools/cli/explain_command.h"
#include "tools/cli/explain_options.h"
#include "tools/cli/interruption.h"
#include "tools/cli/judge_command.h"
#include "tools/cli/judge_options.h"
#include "tools/cli/messages.h"
#include "tools/cli/mistyped.h"
#include "tools/cli/new_command.h"
#include "tools/cli/new_options.h"
#include "tools/cli/pages_command.h"
#include "tools/cli/pages_options.h"
#include "tools/cli/plan_command.h"
#include "tools/cli/plan_options.h"
#include "tools/cli/read_command_words.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_options.h"
#include "tools/cli/run_refusal.h"
#include "tools/cli/scene_command.h"
#include "tools/cli/scene_options.h"
#include "tools/cli/setup_command.h"
#include "tools/cli/setup_options.h"
#include "tools/cli/study_command.h"
#include "tools/cli/study_options.h"
#include "tools/cli/view_command.h"
#include "tools/cli/view_options.h"
#include "tools/cli/write_out.h"

namespace g31::cli {

std::string exit_code_help() {
  std::string text = "Exit codes:\n";
  for (const auto& row : exit_codes()) {
    text += fmt::format("  {:2}  {}\n", static_cast<int>(row.code), row.text);
  }
  return text;
}

namespace {

/// What the words of a command line come to, for each command.
struct Options {
  bool is_version_asked = false;
  bool is_version_json = false;
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

/// A command of g31, and what does its work.
struct Command {
  CLI::App* words;
  bool lasts;  ///< it ends itself when it is interrupted
  std::function<ExitCode()> run;
};

constexpr bool kLasts = true;
constexpr bool kIsShort = false;

/// Tells CLI11 of every command, in the order of --help.
std::vector<Command> add_commands(CLI::App& app, Options& options, const std::string& version) {
  std::vector<Command> commands;
  const auto add = [&](bool lasts, CLI::App* words, const std::string& examples,
                       std::function<ExitCode()> run) {
    words->footer(examples + exit_code_help());
    commands.push_back({words, lasts, std::move(run)});
  };
  const auto words = [&app, version] { return read_command_words(app, version); };
  add(kLasts, add_run_command(app, options.run), run_examples(),
      [&options] { return run_command(options.run); });
  add(kLasts, add_view_command(app, options.view), view_examples(),
      [&options] { return view_command(options.view); });
  add(kIsShort, add_explain_command(app, options.explain), explain_examples(),
      [&options] { return explain_command(options.explain); });
  add(kLasts, add_scene_command(app, options.scene), scene_examples(),
      [&options] { return scene_command(options.scene); });
  add(kLasts, add_study_command(app, options.study), study_examples(),
      [&options] { return study_command(options.study); });
  add(kIsShort, add_check_command(app, options.check), check_examples(),
      [&options] { return check_command(options.check); });
  add(kIsShort, add_setup_command(app, options.setup), setup_examples(),
      [&options] { return setup_command(options.setup); });
  add(kIsShort, add_new_command(app, options.starter), new_examples(),
      [&options] { return new_command(options.starter); });
  add(kLasts, add_evaluate_command(app, options.evaluate), evaluate_examples(),
      [&options] { return evaluate_command(options.evaluate); });
  add(kLasts, add_plan_command(app, options.plan), plan_examples(),
      [&options] { return plan_command(options.plan); });
  add(kLasts, add_judge_command(app, options.judge), judge_examples(),
      [&options] { return judge_command(options.judge); });
  add(kIsShort, add_completion_command(app, options.pages), completion_examples(),
      [&options, words] { return completion_command(words(), options.pages); });
  add(kIsShort, add_manual_command(app, options.pages), manual_examples(),
      [&options, words] { return manual_command(words(), options.pages); });
  return commands;
}

/// --version and its --json hold without a command; else one has to be given.
void add_version(CLI::App& app, Options& options) {
  CLI::Option* const version =
      app.add_flag("--version", options.is_version_asked, "Print the version and exit");
  app.add_flag("--json", options.is_version_json, "With --version: as a document g31.version/1")
      ->needs(version);
  app.require_subcommand(0, 1);
  app.callback([&app, &options] {
    if (!options.is_version_asked && app.get_subcommands().empty()) {
      throw CLI::RequiredError("A command");
    }
  });
}

/// Work that lasts is ended by Ctrl-C at a place where nothing is half done; the rest ends at once.
void take_interruptions(Options& options) {
  const runtime::Interruption& interruption = catch_interruption();
  options.run.budget.interruption = options.scene.run.budget.interruption = &interruption;
  options.view.interruption = options.study.interruption = options.evaluate.interruption =
      options.plan.interruption = options.judge.interruption = &interruption;
}

/// Where the words of a `run` that CLI11 has refused want the document; "": nowhere.
std::string json_of_run(std::span<const char* const> words) {
  constexpr std::string_view kOption = "--json";
  if (words.size() < 2 || words[1] != std::string_view("run")) {
    return {};
  }
  for (std::size_t i = 2; i < words.size(); ++i) {
    const std::string_view word = words[i];
    if (word == kOption && i + 1 < words.size()) {
      return words[i + 1];
    }
    if (word.starts_with(kOption) && word.substr(kOption.size()).starts_with('=')) {
      return std::string(word.substr(kOption.size() + 1));
    }
  }
  return {};
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv, const std::string& version) {
  CLI::App app("g31 runs touch-probe NC programs on a simulated machine.", "g31");
  Options options;
  options.run.version = options.view.run.version = version;
  options.study.version = version;
  options.evaluate.version = options.plan.version = options.check.version = version;
  add_version(app, options);
  const std::vector<Command> commands = add_commands(app, options, version);
  app.footer(exit_code_help());
  const std::vector<std::string> words =
      without_help_word(std::vector<std::string>(argv + std::min(argc, 1), argv + argc));
  try {
    // CLI11 takes them from the last one on.
    app.parse(std::vector<std::string>(words.rbegin(), words.rend()));
  } catch (const CLI::ParseError& error) {
    const std::string hint = mistyped_hint(app, words);
    if (hint.empty()) {
      std::ostringstream asked;
      if (app.exit(error, asked, std::cerr) == 0) {
        const auto unwritten = write_out("-", asked.str());
        return unwritten ? refuse(*unwritten) : ExitCode::Completed;
      }
    }
    std::fputs(hint.c_str(), stderr);
    tell_usage_error(options.run, json_of_run({argv, static_cast<std::size_t>(argc)}),
                     error.what());
    return ExitCode::BadUsage;
  }
  if (options.is_version_asked) {
    return version_command(read_command_words(app, version), options.is_version_json);
  }
  const auto asked = std::ranges::find_if(
      commands, [](const Command& command) { return command.words->parsed(); });
  if (asked->lasts) {
    take_interruptions(options);
  }
  const ExitCode code = asked->run();
  // Input that was waited for until somebody ended the waiting is no bad input.
  const bool is_broken_off = asked->lasts && code == ExitCode::BadUsage &&
                             runtime::is_interrupted(options.run.budget.interruption);
  return is_broken_off ? ExitCode::Interrupted : code;
}

}  // namespace g31::cli

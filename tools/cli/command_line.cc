#include "tools/cli/command_line.h"

#include <algorithm>
#include <cstdio>
#include <exception>
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
#include "tools/cli/control_and_level_options.h"
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
#include "tools/cli/output_places.h"
#include "tools/cli/pages_command.h"
#include "tools/cli/pages_options.h"
#include "tools/cli/plan_command.h"
#include "tools/cli/plan_options.h"
#include "tools/cli/read_command_words.h"
#include "tools/cli/refusal_document.h"
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

std::string exit_code_help(std::string_view command) {
  std::string text(kExitCodesHead);
  for (const ExitCodeRow& row : exit_codes_of(command)) {
    text += fmt::format("  {:2}  {}\n", static_cast<int>(row.code), row.text);
  }
  return text;
}

namespace {

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

/// A command of g31, and what does its work.
struct Command {
  CLI::App* words;
  bool lasts;               ///< it ends itself when it is interrupted
  std::string_view schema;  ///< of its document; "": it has none
  std::function<ExitCode()> run;
};

constexpr bool kLasts = true;
constexpr bool kIsShort = false;

/// Tells CLI11 of every command, in the order of --help.
std::vector<Command> add_commands(CLI::App& app, Options& options, const std::string& version) {
  std::vector<Command> commands;
  const auto add = [&](bool lasts, std::string_view schema, CLI::App* words,
                       const std::string& examples, std::function<ExitCode()> run) {
    words->footer(examples + exit_code_help(words->get_name()));
    add_quiet_option(*words, options.is_quiet);
    commands.push_back({words, lasts, schema, std::move(run)});
  };
  const auto words = [&app, version] { return read_command_words(app, version); };
  add(kLasts, "g31.run/1", add_run_command(app, options.run), run_examples(),
      [&options] { return run_command(options.run); });
  add(kLasts, {}, add_view_command(app, options.view), view_examples(),
      [&options] { return view_command(options.view); });
  add(kIsShort, "g31.explain/1", add_explain_command(app, options.explain), explain_examples(),
      [&options] { return explain_command(options.explain); });
  add(kLasts, "g31.scene/1", add_scene_command(app, options.scene), scene_examples(),
      [&options] { return scene_command(options.scene); });
  add(kLasts, "g31.study/1", add_study_command(app, options.study), study_examples(),
      [&options] { return study_command(options.study); });
  add(kIsShort, "g31.check/1", add_check_command(app, options.check), check_examples(),
      [&options] { return check_command(options.check); });
  add(kIsShort, "g31.setup/1", add_setup_command(app, options.setup), setup_examples(),
      [&options] { return setup_command(options.setup); });
  add(kIsShort, "g31.new/1", add_new_command(app, options.starter), new_examples(),
      [&options] { return new_command(options.starter); });
  add(kLasts, "g31.evaluation/1", add_evaluate_command(app, options.evaluate), evaluate_examples(),
      [&options] { return evaluate_command(options.evaluate); });
  add(kLasts, "g31.plan/1", add_plan_command(app, options.plan), plan_examples(),
      [&options] { return plan_command(options.plan); });
  add(kLasts, "g31.judgement/1", add_judge_command(app, options.judge), judge_examples(),
      [&options] { return judge_command(options.judge); });
  add(kIsShort, {}, add_completion_command(app, options.pages), completion_examples(),
      [&options, words] { return completion_command(words(), options.pages); });
  add(kIsShort, {}, add_manual_command(app, options.pages), manual_examples(),
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

/// Where refused words want the document, "": nowhere, and the others, which may name files too.
/// What stands behind --json may be no place: another option, or of `explain` a topic.
struct RefusedWords {
  std::string json;
  std::vector<std::string> others;
};

/// Of `explain`, whose --json alone means standard output, or the one word that is a file.
void find_file_of_explain(RefusedWords& refused) {
  const auto file = std::ranges::find_if(refused.others, is_file_of_explain);
  refused.json = file == refused.others.end() ? "-" : *file;
  if (file != refused.others.end()) {
    refused.others.erase(file);
  }
}

RefusedWords refused_words(std::span<const std::string> words) {
  constexpr std::string_view kOption = "--json";
  RefusedWords refused;
  bool is_alone = false;
  for (std::size_t i = 0; i < words.size(); ++i) {
    const std::string& word = words[i];
    const std::size_t value = word.starts_with("--") ? word.find('=') + 1 : 0;
    const std::string next = i + 1 < words.size() ? words[i + 1] : "";
    const bool is_explain = words.front() == "explain";
    const bool is_place = !is_explain && (!next.starts_with('-') || next == "-");
    if (word == kOption && is_place) {
      refused.json = next;
      ++i;
    } else if (word == kOption && is_explain) {
      is_alone = true;
    } else if (value == kOption.size() + 1 && word.starts_with(kOption)) {
      refused.json = word.substr(value);
    } else {
      refused.others.push_back(word.substr(value));
    }
  }
  if (is_alone && refused.json.empty()) {
    find_file_of_explain(refused);
  }
  return refused;
}

/// The document of words that are refused, where they want one.
void tell_refused_words(const std::vector<Command>& commands, const Options& options,
                        std::span<const std::string> words, const std::string& why) {
  const auto asked = std::ranges::find_if(commands, [&](const Command& command) {
    return !words.empty() && command.words->get_name() == words.front();
  });
  const auto [json, others] = refused_words(words);
  if (asked == commands.end() || asked->schema.empty() || json.empty()) {
    return;
  }
  if (wrong_place({{"--json", json}}, {others})) {
    refuse(session::bad_input(fmt::format(
        "--json {}: another word of the command names that, too, so nothing is written", json)));
  } else if (asked->words->get_name() == "run") {
    tell_usage_error(options.run, json, why);
  } else if (const auto unwritten = write_refusal(session::bad_input(why), json, asked->schema)) {
    refuse(*unwritten);
  }
}

/// Does the work of a command.  What ends it from within is told in its document, too.
ExitCode carried_out(const Command& command, std::span<const std::string> words) {
  try {
    return command.run();
  } catch (const std::exception& thrown) {
    return refuse(refusal_of(thrown), command.schema.empty() ? "" : refused_words(words).json,
                  command.schema);
  }
}

}  // namespace

ExitCode run_command_line(int argc, const char* const* argv, const std::string& version) {
  CLI::App app("g31 runs touch-probe NC programs on a simulated machine.", "g31");
  Options options;
  options.run.version = options.view.run.version = version;
  options.study.version = version;
  options.evaluate.version = options.plan.version = version;
  options.judge.version = options.check.version = version;
  add_version(app, options);
  const std::vector<Command> commands = add_commands(app, options, version);
  app.footer(exit_code_help(""));
  app.failure_message([](const CLI::App* asked, const CLI::Error& error) {
    return "g31: error: " + CLI::FailureMessage::simple(asked, error);
  });
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
    tell_refused_words(commands, options, words, error.what());
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
  const ExitCode code = carried_out(*asked, words);
  // Input that was waited for until somebody ended the waiting is no bad input.
  const bool is_broken_off = asked->lasts && code == ExitCode::BadUsage &&
                             runtime::is_interrupted(options.run.budget.interruption);
  return is_broken_off ? ExitCode::Interrupted : code;
}

}  // namespace g31::cli

#include "tools/cli/command_line.h"

#include <algorithm>
#include <cstddef>
#include <cstdio>
#include <deque>
#include <exception>
#include <iostream>
#include <span>
#include <sstream>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "tools/cli/commands.h"
#include "tools/cli/control_and_level_options.h"
#include "tools/cli/exit_code_help.h"
#include "tools/cli/explain_options.h"
#include "tools/cli/interruption.h"
#include "tools/cli/messages.h"
#include "tools/cli/mistyped.h"
#include "tools/cli/output_places.h"
#include "tools/cli/pages_command.h"
#include "tools/cli/read_command_words.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_refusal.h"
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

/// The commands as CLI11 knows them.  What may stand behind one is told when that one is asked for,
/// or all are: to tell it of all of them takes as long as a short run.
class KnownCommands {
 public:
  KnownCommands(CLI::App& app, Options& options) : options_(options) {
    for (const CommandRow& row : commands()) {
      CLI::App* const words = app.add_subcommand(std::string(row.name), std::string(row.text));
      words->preparse_callback([this, &known = known_.emplace_back(Known{&row, words})](
                                   std::size_t) { tell_options(known); });
    }
  }

  void tell_all() {
    for (Known& known : known_) {
      tell_options(known);
    }
  }

  /// The command that was given.  @pre one was
  [[nodiscard]] const CommandRow& asked() const {
    return *std::ranges::find_if(known_, [](const Known& known) {
              return known.words->parsed();
            })->row;
  }

 private:
  struct Known {
    const CommandRow* row;
    CLI::App* words;
    bool is_told = false;
  };

  void tell_options(Known& known) {
    if (!known.is_told) {
      known.is_told = true;
      known.row->add_options(*known.words, options_);
      known.words->footer(known.row->examples() + exit_code_help(known.row->name));
      add_quiet_option(*known.words, options_.is_quiet);
    }
  }

  Options& options_;
  std::deque<Known> known_;  // they stay where they are
};

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
      options.plan.interruption = options.judge.interruption = options.check.interruption =
          &interruption;
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
void tell_refused_words(const Options& options, std::span<const std::string> words,
                        const std::string& why) {
  const auto asked = std::ranges::find_if(commands(), [&](const CommandRow& command) {
    return !words.empty() && command.name == words.front();
  });
  const auto [json, others] = refused_words(words);
  if (asked == commands().end() || asked->schema.empty() || json.empty()) {
    return;
  }
  if (wrong_place({{"--json", json}}, {others})) {
    refuse(session::bad_input(fmt::format(
        "--json {}: another word of the command names that, too, so nothing is written", json)));
  } else if (asked->name == "run") {
    tell_usage_error(options.run, json, why);
  } else if (const auto unwritten = write_refusal(session::bad_input(why), json, asked->schema)) {
    refuse(*unwritten);
  }
}

/// Does the work of a command.  What ends it from within is told in its document, too.
ExitCode carried_out(const CommandRow& command, const Options& options, const WordsOfAll& of_all,
                     std::span<const std::string> words) {
  try {
    return command.run(options, of_all);
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
  KnownCommands known(app, options);
  const WordsOfAll words_of_all = [&] {
    known.tell_all();
    return read_command_words(app, version);
  };
  app.footer(exit_code_help(""));
  app.failure_message([](const CLI::App* asked, const CLI::Error& error) {
    return "g31: error: " + source::printable_lines(CLI::FailureMessage::simple(asked, error));
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
    std::fputs(source::printable_lines(hint).c_str(), stderr);
    tell_refused_words(options, words, error.what());
    return ExitCode::BadUsage;
  }
  if (options.is_version_asked) {
    return version_command(words_of_all(), options.is_version_json);
  }
  const CommandRow& asked = known.asked();
  if (asked.lasts) {
    take_interruptions(options);
  }
  const ExitCode code = carried_out(asked, options, words_of_all, words);
  // Input that was waited for until somebody ended the waiting is no bad input.
  const bool is_broken_off = asked.lasts && code == ExitCode::BadUsage &&
                             runtime::is_interrupted(options.run.budget.interruption);
  return is_broken_off ? ExitCode::Interrupted : code;
}

}  // namespace g31::cli

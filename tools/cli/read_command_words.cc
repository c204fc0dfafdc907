#include "tools/cli/read_command_words.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string_view>

#include <CLI/CLI.hpp>

#include "tools/cli/exit_code_help.h"
#include "tools/evaluate/compensation.h"
#include "tools/evaluate/option_values.h"
#include "tools/evaluate/request_words.h"
#include "tools/page/language.h"
#include "tools/session/control.h"

namespace g31::cli {
namespace {

std::vector<std::string> split(std::string_view list, char separator) {
  std::vector<std::string> parts;
  for (std::size_t from = 0; from <= list.size();) {
    const std::size_t to = std::min(list.find(separator, from), list.size());
    parts.emplace_back(list.substr(from, to - from));
    from = to + 1;
  }
  return parts;
}

/// The names that CLI11 shows behind the type of a value, NAME:{a,b}; empty: it takes any.
std::vector<std::string> choices_of(std::string_view type) {
  const std::size_t open = type.find('{');
  const std::size_t close = type.find('}', open);
  if (open == std::string_view::npos || close == std::string_view::npos) {
    return {};
  }
  return split(type.substr(open + 1, close - open - 1), ',');
}

/// Words of these kinds, which are told in other ways than CLI11's.
/// @param called  as --help calls the value
std::vector<std::string> known_words(std::string_view called) {
  if (called == "CONTROL") {
    return session::control_names();
  }
  if (called == "UNIT") {
    return evaluate::unit_names();
  }
  if (called == "SENSE") {
    return evaluate::sense_names();
  }
  if (called == "FORMAT") {
    return evaluate::compensation_format_names();
  }
  std::vector<std::string> words;
  if (called == "KIND") {
    for (const evaluate::KindRow& row : evaluate::kinds()) {
      words.emplace_back(row.word);
    }
  } else if (called == "LANGUAGE") {
    for (const page::Language language : {page::Language::English, page::Language::Japanese}) {
      words.emplace_back(name_of(language));
    }
  }
  return words;
}

/// Whether a value is, or may be, the name of a file.  @param called  as --help calls it
bool may_be_file(std::string_view called) {
  constexpr std::string_view kOthers[] = {"OTHER.json", "PRINTER", "SHEET", "STOCK"};
  return called.starts_with("FILE") || std::ranges::find(kOthers, called) != std::end(kOthers);
}

void set_value(const CLI::Option& option, OptionWords& words) {
  if (option.get_items_expected_max() == 0) {
    return;
  }
  const std::string type = option.get_type_name();
  words.value = type.substr(0, type.find(':'));
  words.choices = known_words(option.get_positional() ? words.names.front() : words.value);
  if (words.choices.empty()) {
    words.choices = choices_of(type);
  }
  if (!words.choices.empty()) {
    words.kind = ValueKind::Choice;
  } else if (may_be_file(words.value)) {
    words.kind = ValueKind::File;
  } else {
    words.kind = words.value.starts_with("DIR") ? ValueKind::Folder : ValueKind::Text;
  }
}

OptionWords words_of(const CLI::Option& option) {
  OptionWords words;
  for (const std::string& name : option.get_snames()) {
    words.names.push_back("-" + name);
  }
  for (const std::string& name : option.get_lnames()) {
    words.names.push_back("--" + name);
  }
  if (words.names.empty()) {
    words.names.push_back(option.get_name(true));
  }
  set_value(option, words);
  words.text = option.get_description();
  words.is_required = option.get_required();
  words.is_repeatable = option.get_expected_max() > 1;
  return words;
}

CommandWords words_of(const CLI::App& app) {
  CommandWords command;
  command.name = app.get_name();
  command.text = app.get_description();
  for (const CLI::Option* const option : app.get_options()) {
    if (!option->get_group().empty()) {
      (option->nonpositional() ? command.options : command.places).push_back(words_of(*option));
    }
  }
  const std::string footer = app.get_footer();
  command.notes = footer.substr(0, footer.find(kExitCodesHead));
  return command;
}

/// What the place of a command may be: known once all of them are.
void name_commands(ProgramWords& words) {
  std::vector<std::string> names;
  for (const CommandWords& command : words.commands) {
    names.push_back(command.name);
  }
  for (CommandWords& command : words.commands) {
    for (OptionWords& place : command.places) {
      if (place.names.front() == "COMMAND") {
        place.kind = ValueKind::Choice;
        place.choices = names;
      }
    }
  }
}

}  // namespace

ProgramWords read_command_words(const CLI::App& app, const std::string& version) {
  ProgramWords words{version, words_of(app), {}};
  // Without a filter CLI11 lists the commands that were given, not those that there are.
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    if (!command->get_group().empty()) {
      words.commands.push_back(words_of(*command));
    }
  }
  name_commands(words);
  return words;
}

}  // namespace g31::cli

#pragma once

#include <string>
#include <vector>

namespace g31::cli {

/// What may stand behind an option.
enum class ValueKind { Nothing, File, Folder, Choice, Text };

/// An option, or a word that stands by its place.
struct OptionWords {
  std::vector<std::string> names;  ///< "-s", "--setup"; of a word by its place its name alone
  ValueKind kind = ValueKind::Nothing;
  std::string value;                 ///< what its value is called: "FILE"; "" where it has none
  std::vector<std::string> choices;  ///< of ValueKind::Choice
  std::string text;
  bool is_required = false;
  bool is_repeatable = false;
};

struct CommandWords {
  std::string name;
  std::string text;
  std::vector<OptionWords> options;
  std::vector<OptionWords> places;
  std::string
      notes;  ///< examples and what else --help says behind the options, without the exit codes
};

/// All that the command line takes, as --help shows it: completions and manual pages are made of
/// it.
struct ProgramWords {
  std::string version;
  CommandWords program;  ///< what holds without a command; its name is that of the program
  std::vector<CommandWords> commands;
};

}  // namespace g31::cli

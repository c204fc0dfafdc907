#pragma once

#include <string>
#include <vector>

namespace CLI {
class App;
}  // namespace CLI

namespace g31::cli {

/// What was probably meant by a command or options that there are not; one line, "" for nothing.
/// @param words  of the command line, without the program's name
std::string mistyped_hint(const CLI::App& app, const std::vector<std::string>& words);

/// `help CMD` is `CMD --help`, and `help` alone `--help`; other words stay as they are.
std::vector<std::string> without_help_word(std::vector<std::string> words);

}  // namespace g31::cli

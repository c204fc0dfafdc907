#include "tools/cli/mistyped.h"

#include <algorithm>
#include <string_view>

#include <CLI/CLI.hpp>
#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"

namespace g31::cli {
namespace {

using Names = std::vector<std::string>;

std::string meant(const std::string& word, const Names& known) {
  const std::vector<std::string_view> views(known.begin(), known.end());
  const auto nearest = nearest_name(word, views);
  return nearest ? fmt::format(", did you mean {}?", *nearest) : std::string();
}

Names options_of(const CLI::App& command) {
  Names names;
  for (const CLI::Option* const option : command.get_options()) {
    for (const std::string& name : option->get_lnames()) {
      names.push_back("--" + name);
    }
  }
  return names;
}

}  // namespace

std::string mistyped_hint(const CLI::App& app, const std::vector<std::string>& words) {
  if (words.empty() || words.front().starts_with('-')) {
    return "";
  }
  Names commands;
  const CLI::App* asked = nullptr;
  for (const CLI::App* const command : app.get_subcommands([](const CLI::App*) { return true; })) {
    commands.push_back(command->get_name());
    asked = commands.back() == words.front() ? command : asked;
  }
  if (asked == nullptr) {
    const std::string hint = meant(words.front(), commands);
    return fmt::format(
        "g31: error: there is no command {}{}\n", words.front(),
        hint.empty() ? fmt::format("; there are {}", fmt::join(commands, ", ")) : hint);
  }
  const Names known = options_of(*asked);
  for (const std::string& word : words) {
    const std::string name = word.substr(0, word.find('='));
    if (name.starts_with("--") && name.size() > 2 &&
        std::ranges::find(known, name) == known.end()) {
      return fmt::format("g31: error: {} has no option {}{}\n", words.front(), name,
                         meant(name, known));
    }
  }
  return "";
}

std::vector<std::string> without_help_word(std::vector<std::string> words) {
  if (words.empty() || words.front() != "help") {
    return words;
  }
  words.erase(words.begin());
  words.emplace_back("--help");
  return words;
}

}  // namespace g31::cli

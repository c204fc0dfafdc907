#include "tools/cli/shown_command.h"

namespace g31::cli {
namespace {

/// A word as a shell takes it.
std::string quoted(std::string_view word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./=+,:%@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string_view::npos) {
    return std::string(word);
  }
  std::string safe = "'";
  for (const char c : word) {
    safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return safe + "'";
}

}  // namespace

void ShownCommand::add(std::string_view word) {
  line_ += " ";
  line_ += quoted(word);
}

void ShownCommand::add(std::string_view option, const std::string& value) {
  if (!value.empty()) {
    add(option);
    add(value);
  }
}

void ShownCommand::add(std::string_view option, const std::vector<std::string>& values) {
  for (const std::string& value : values) {
    add(option, value);
  }
}

}  // namespace g31::cli

#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace g31::cli {

/// A command line as somebody would type it in a shell, word by word.
class ShownCommand {
 public:
  explicit ShownCommand(std::string_view command) : line_(command) {}

  void add(std::string_view word);
  /// An option and its value; nothing where the value is empty.
  void add(std::string_view option, const std::string& value);
  void add(std::string_view option, const std::vector<std::string>& values);

  [[nodiscard]] const std::string& line() const { return line_; }

 private:
  std::string line_;
};

}  // namespace g31::cli

#include "tests/support/conformance_file.h"

#include <fstream>
#include <memory>
#include <sstream>
#include <utility>

#include <fmt/format.h>

namespace g31::testing {
namespace {

/// Reads a conformance file line by line.
class ConformanceReader {
 public:
  using Outcome = Result<std::vector<ConformanceCase>, std::string>;

  explicit ConformanceReader(std::string path) : path_(std::move(path)) {
    common_.controls = {"fanuc-16i", "fanuc-30i"};
  }

  /// @returns the cases, or what is wrong with the file
  Outcome read() {
    std::ifstream in(path_, std::ios::binary);
    if (!in) {
      return path_ + ": cannot be read";
    }
    for (std::string line; std::getline(in, line) && wrong_.empty();) {
      ++line_;
      take(line);
    }
    finish_case();
    if (wrong_.empty() && cases_.empty()) {
      refuse("no (CASE ...) in this file");
    }
    return wrong_.empty() ? Outcome(cases_) : Outcome(wrong_);
  }

 private:
  /// A line for the test leaves an empty line in the program, so that lines keep their numbers.
  void take(const std::string& line) {
    const bool in_brackets = line.starts_with("(") && line.ends_with(")");
    const std::string comment = in_brackets              ? line.substr(1, line.size() - 2)
                                : line.starts_with("; ") ? line.substr(2)
                                                         : std::string();
    const std::size_t blank = comment.find(' ');
    const bool is_ours = blank != comment.npos;
    const std::string word = is_ours ? comment.substr(0, blank) : std::string();
    const std::string rest = is_ours ? comment.substr(blank + 1) : std::string();
    if (word == "CASE") {
      finish_case();
      open_ = std::make_unique<ConformanceCase>(common_);
      open_->title = {line_, rest};
      return;
    }
    const bool is_taken = is_ours && directive(word, rest);
    if (open_) {
      open_->program += (is_taken ? "" : line) + "\n";
    } else if (!is_taken && !line.empty() && !line.starts_with("(") && !line.starts_with(";")) {
      refuse("a program before the first (CASE ...)");
    }
  }

  bool directive(const std::string& word, const std::string& rest) {
    ConformanceCase& target = open_ ? *open_ : common_;
    if (word == "CONTROL") {
      target.controls.clear();
      std::istringstream names(rest);
      for (std::string name; names >> name;) {
        target.controls.push_back(name);
      }
    } else if (word == "PARAMETER") {
      target.sheet["parameters"] += quoted_key(rest);
    } else if (word == "SET") {
      target.sheet["variables"] += quoted_key(rest);
    } else if (word == "SETTING") {
      target.sheet["control"] += rest + "\n";
    } else if (word == "START") {
      target.sheet["start"] += rest + "\n";
    } else if (word == "SIGNAL") {
      target.sheet_lines += rest == "NONE"
                                ? "[[skip_signal]]\n"
                                : fmt::format("[[skip_signal]]\naxis = \"{}\"\nat = {}\n",
                                              rest.front(), with_point(rest.substr(1)));
    } else if (word == "SHEET") {
      target.sheet_lines += rest + "\n";
    } else if (word == "EXPECT") {
      target.expectations.push_back({line_, rest});
    } else {
      return word == "SOURCE";
    }
    return true;
  }

  static std::string quoted_key(const std::string& text) {
    const std::size_t end = text.find(" =");
    return "\"" + text.substr(0, end) + "\"" + (end == text.npos ? "" : text.substr(end)) + "\n";
  }

  static std::string with_point(const std::string& number) {
    return number + (number.find('.') == number.npos ? ".0" : number.ends_with('.') ? "0" : "");
  }

  void finish_case() {
    if (open_ && open_->expectations.empty()) {
      line_ = open_->title.line;
      refuse("a case without an expectation");
    }
    if (open_) {
      cases_.push_back(*open_);
      open_.reset();
    }
  }

  void refuse(const std::string& message) {
    if (wrong_.empty()) {
      wrong_ = fmt::format("{}:{}: {}", path_, line_, message);
    }
  }

  std::string path_;
  int line_ = 0;
  std::string wrong_;
  ConformanceCase common_;
  std::unique_ptr<ConformanceCase> open_;
  std::vector<ConformanceCase> cases_;
};

}  // namespace

Result<std::vector<ConformanceCase>, std::string> read_conformance_file(const std::string& path) {
  return ConformanceReader(path).read();
}

std::string sheet_of(const ConformanceCase& test) {
  std::string text;
  for (const auto& [section, lines] : test.sheet) {
    text += "[" + section + "]\n" + lines;
  }
  return text + test.sheet_lines;
}

}  // namespace g31::testing

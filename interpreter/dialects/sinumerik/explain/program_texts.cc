#include "interpreter/dialects/sinumerik/explain/program_texts.h"

#include <algorithm>
#include <charconv>
#include <map>
#include <optional>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kBlanks = " \t\r";

std::string_view trimmed(std::string_view text) {
  const std::size_t first = text.find_first_not_of(kBlanks);
  if (first == std::string_view::npos) {
    return {};
  }
  return text.substr(first, text.find_last_not_of(kBlanks) - first + 1);
}

/// Takes a word off the front; one ends at a blank.
std::string_view take_word(std::string_view& rest) {
  rest = trimmed(rest);
  const std::size_t end = std::min(rest.find_first_of(kBlanks), rest.size());
  const std::string_view word = rest.substr(0, end);
  rest = trimmed(rest.substr(end));
  return word;
}

/// Where `wanted` stands outside of quotes and brackets, or the end.
std::size_t find_outside(std::string_view text, char wanted) {
  int depth = 0;
  bool quoted = false;
  for (std::size_t i = 0; i < text.size(); ++i) {
    const char c = text[i];
    quoted = quoted != (c == '"');
    if (!quoted && depth == 0 && c == wanted) {
      return i;
    }
    depth += quoted ? 0 : (c == '(' || c == '[') ? 1 : (c == ')' || c == ']') ? -1 : 0;
  }
  return text.size();
}

/// What stands in quotes first, and nothing when there is none.
std::optional<std::string_view> quoted_in(std::string_view text) {
  const std::size_t first = text.find('"');
  const std::size_t last = first == std::string_view::npos ? first : text.find('"', first + 1);
  return last == std::string_view::npos ? std::nullopt
                                        : std::optional(text.substr(first + 1, last - first - 1));
}

std::optional<int> number_in_front(std::string_view text) {
  int number = 0;
  const auto read = std::from_chars(text.data(), text.data() + text.size(), number);
  return read.ec == std::errc() ? std::optional(number) : std::nullopt;
}

/// Goes through a text line by line.
class TextReader {
 public:
  Topics read(std::string_view text) {
    while (!text.empty()) {
      const std::size_t end = std::min(text.find('\n'), text.size());
      line(trimmed(text.substr(0, end)));
      text.remove_prefix(std::min(end + 1, text.size()));
    }
    return std::move(topics_);
  }

 private:
  void line(std::string_view text) {
    if (text.starts_with(';')) {
      comment(trimmed(text.substr(1)));
      return;
    }
    std::string_view rest = text;
    const std::string_view first = take_word(rest);
    if (first == "PROC") {
      program(rest);
    } else if (first == "DEF") {
      variables(rest);
    } else if (first == "DEFINE") {
      macro(rest);
    } else if (first == "CASE") {
      alarm_numbers(rest);
    } else {
      alarm(text);
    }
    said_.clear();
    elements_.clear();
  }

  void comment(std::string_view text) {
    const std::size_t bracket = text.starts_with('[') ? text.find(']') : std::string_view::npos;
    if (bracket != std::string_view::npos) {
      elements_.push_back({std::string(text.substr(0, bracket + 1)),
                           std::string(trimmed(text.substr(bracket + 1)))});
      return;
    }
    said_ += (said_.empty() ? "" : " ") + std::string(text);
  }

  void program(std::string_view call) {
    const std::size_t end = call.find(')');
    call = end != std::string_view::npos ? call.substr(0, end + 1) : take_word(call);
    const std::string name = upper(trimmed(call.substr(0, call.find('('))));
    add({name, "", {"program", name, said_, {{"form", std::string(call)}}}});
  }

  void variables(std::string_view rest) {
    std::string_view type = take_word(rest);
    type = type == "NCK" || type == "CHAN" ? take_word(rest) : type;
    while (!rest.empty()) {
      const std::size_t comma = find_outside(rest, ',');
      std::string_view declared = rest.substr(0, comma);
      rest.remove_prefix(std::min(comma + 1, rest.size()));
      declared = trimmed(declared.substr(0, find_outside(declared, '=')));
      const std::string name = upper(declared.substr(0, declared.find('[')));
      runtime::Entry entry{
          "global variable", std::string(declared), said_, {{"type", std::string(type)}}};
      entry.facts.insert(entry.facts.end(), elements_.begin(), elements_.end());
      add({name, "", std::move(entry)});
    }
  }

  void macro(std::string_view rest) {
    const std::string name = upper(take_word(rest));
    take_word(rest);  // AS
    add({name, "", {"macro", name, said_, {{"stands for", std::string(rest)}}}});
  }

  /// x OF 61301 GOTOF A301 61302 GOTOF A302 ...  Below the alarms of cycles it tells other cases
  /// apart.
  void alarm_numbers(std::string_view rest) {
    constexpr int kFirstOfCycles = 60000;
    std::optional<int> number;
    while (!rest.empty()) {
      const std::string_view word = take_word(rest);
      if (word == "GOTOF" && number.value_or(0) >= kFirstOfCycles) {
        numbers_[std::string(take_word(rest))] = *number;
      }
      number = number_in_front(word);
    }
  }

  void alarm(std::string_view text) {
    constexpr std::string_view kSet = "SETAL(";
    const std::size_t comment = find_outside(text, ';');
    const std::string_view block = text.substr(0, comment);
    const auto shown = quoted_in(block);
    const std::size_t set = block.find(kSet);
    const auto label = numbers_.find(std::string(block.substr(0, block.find(':'))));
    const auto number = set != std::string_view::npos
                            ? number_in_front(block.substr(set + kSet.size()))
                        : label != numbers_.end() ? std::optional(label->second)
                                                  : std::nullopt;
    if (!shown || !number) {
      return;
    }
    const std::string_view remedy = trimmed(text.substr(std::min(comment + 1, text.size())));
    const std::string_view title = trimmed(shown->substr(0, shown->find(':')));
    add({fmt::format("ALARM {}", *number),
         std::to_string(*number),
         {"alarm", fmt::format("{} {}", *number, title), std::string(remedy), {}}});
  }

  /// A line that is cut off names nothing.
  void add(Topic topic) {
    if (!topic.name.empty()) {
      topics_.push_back(std::move(topic));
    }
  }

  Topics topics_;
  std::string said_;                     ///< in the comment above
  std::vector<runtime::Fact> elements_;  ///< its lines about elements
  std::map<std::string, int> numbers_;   ///< of alarms, by label
};

}  // namespace

Topics topics_of_text(std::string_view text) {
  return TextReader().read(text);
}

}  // namespace g31::sinumerik

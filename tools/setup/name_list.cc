#include "tools/setup/name_list.h"

#include <algorithm>
#include <charconv>
#include <optional>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

/// Cuts at every `separator` that is not inside square brackets.
std::vector<std::string_view> split_outside_brackets(std::string_view text, char separator) {
  std::vector<std::string_view> pieces;
  std::size_t begin = 0;
  int depth = 0;
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (text[i] == '[') {
      ++depth;
    } else if (text[i] == ']') {
      --depth;
    } else if (text[i] == separator && depth == 0) {
      pieces.push_back(text.substr(begin, i - begin));
      begin = i + 1;
    }
  }
  pieces.push_back(text.substr(begin));
  return pieces;
}

/// A name cut at the number in which it differs from another one.
struct NumberedName {
  std::string_view prefix;
  std::string_view digits;
  std::string_view suffix;
};

NumberedName cut_at_number(std::string_view name, std::size_t begin) {
  std::size_t end = begin;
  while (end < name.size() && is_digit(name[end])) {
    ++end;
  }
  return {name.substr(0, begin), name.substr(begin, end - begin), name.substr(end)};
}

/// Where the number begins in which two names differ.
std::size_t differing_number(std::string_view a, std::string_view b) {
  auto at = static_cast<std::size_t>(std::ranges::mismatch(a, b).in1 - a.begin());
  while (at > 0 && is_digit(a[at - 1])) {
    --at;
  }
  return at;
}

/// A number without leading zeros and of at most nine digits.
std::optional<std::size_t> index_from(std::string_view digits) {
  const bool plain = digits.size() == 1 || !digits.starts_with('0');
  if (digits.empty() || digits.size() > 9 || !plain) {
    return std::nullopt;
  }
  std::size_t number = 0;
  std::from_chars(digits.data(), digits.data() + digits.size(), number);
  return number;
}

/// The numbers of a range, both ends included, and what stands around them.
struct NameRange {
  std::string prefix;
  std::string suffix;
  std::size_t first = 0;
  std::size_t last = 0;
};

Result<NameRange, std::string> range_between(const std::string& first, const std::string& last) {
  const std::size_t at = differing_number(first, last);
  const NumberedName a = cut_at_number(first, at);
  const NumberedName b = cut_at_number(last, at);
  const std::optional<std::size_t> from = index_from(a.digits);
  const std::optional<std::size_t> to = index_from(b.digits);
  if (!from || !to || a.suffix != b.suffix) {
    return fmt::format("{}-{} is not a range: its names may differ in only one number", first,
                       last);
  }
  if (*from > *to) {
    return fmt::format("{}-{} runs backwards: write {}-{}", first, last, last, first);
  }
  return NameRange{std::string(a.prefix), std::string(a.suffix), *from, *to};
}

/// Gathers names, each once.
class NameList {
 public:
  /// @returns what is wrong, if anything
  std::optional<std::string> add_item(std::string_view item) {
    const std::vector<std::string_view> ends = split_outside_brackets(item, '-');
    std::vector<std::string> names;
    for (const std::string_view end : ends) {
      const std::optional<std::string> name = normal_variable_name(end);
      if (!name) {
        return fmt::format("\"{}\" is not the name of a variable: write #500, R1 or _OVR[0]", end);
      }
      names.push_back(*name);
    }
    if (names.size() > 2) {
      return fmt::format("\"{}\" has more than one minus sign: write FIRST-LAST", item);
    }
    if (names.front() == names.back()) {
      return add(names.front());
    }
    return add_range(names.front(), names.back());
  }

  [[nodiscard]] const std::vector<std::string>& names() const { return names_; }

 private:
  std::optional<std::string> add_range(const std::string& first, const std::string& last) {
    const auto range = range_between(first, last);
    if (!range) {
      return range.error();
    }
    const NameRange& r = range.value();
    std::optional<std::string> problem;
    for (std::size_t n = r.first; n <= r.last && !problem; ++n) {
      problem = add(fmt::format("{}{}{}", r.prefix, n, r.suffix));
    }
    return problem;
  }

  std::optional<std::string> add(std::string name) {
    if (!seen_.insert(name).second) {
      return std::nullopt;
    }
    if (names_.size() == kMostNames) {
      return fmt::format("more than {} names: make the ranges smaller", kMostNames);
    }
    names_.push_back(std::move(name));
    return std::nullopt;
  }

  std::vector<std::string> names_;
  std::set<std::string> seen_;
};

}  // namespace

Result<std::vector<std::string>, std::string> parse_name_list(std::string_view text) {
  NameList list;
  for (const std::string_view item : split_outside_brackets(text, ',')) {
    if (const std::optional<std::string> problem = list.add_item(item)) {
      return *problem;
    }
  }
  return list.names();
}

}  // namespace g31::setup

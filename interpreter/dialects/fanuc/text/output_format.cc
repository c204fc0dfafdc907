#include "interpreter/dialects/fanuc/text/output_format.h"

#include <algorithm>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/scanner.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/syntax/decimal.h"

namespace g31::fanuc {
namespace {

bool is_blank(char c) {
  return c == ' ' || c == '\t' || c == '\r' || c == '\0';
}

/// Reads `#v[cd]` from the front of `text`, which begins behind the #.
Result<OutputItem, std::string> take_variable(std::string_view& text) {
  OutputItem item;
  const auto number = std::from_chars(text.data(), text.data() + text.size(), item.variable);
  if (number.ec != std::errc()) {
    return std::string("a variable of a format is # and a number");
  }
  text.remove_prefix(static_cast<std::size_t>(number.ptr - text.data()));
  const bool opened = !text.empty() && text[0] == '[';
  const std::size_t close = text.find(']');
  if (!opened || close == std::string_view::npos) {
    return fmt::format("#{} needs its places in brackets, like [53]", item.variable);
  }
  const std::string_view places = text.substr(1, close - 1);
  text.remove_prefix(close + 1);
  if (places.empty() || places.size() > 2 || !std::ranges::all_of(places, is_digit)) {
    return fmt::format("[{}]: write one digit for the decimals, or two for places and decimals",
                       places);
  }
  item.integer_places = places.size() == 2 ? places[0] - '0' : 0;
  item.decimals = places.back() - '0';
  return item;
}

}  // namespace

Result<std::vector<OutputItem>, std::string> parse_output_format(std::string_view text) {
  std::string plain;
  std::ranges::copy_if(text, std::back_inserter(plain), [](char c) { return !is_blank(c); });
  std::string_view rest = plain;
  std::vector<OutputItem> items;
  while (!rest.empty()) {
    const char c = rest.front();
    rest.remove_prefix(1);
    if (c == '#') {
      auto item = take_variable(rest);
      if (!item) {
        return item.error();
      }
      items.push_back(item.value());
      continue;
    }
    if (c == '[' || c == ']') {
      return std::string("a bracket must follow a #variable");
    }
    if (items.empty() || items.back().variable >= 0) {
      items.emplace_back();
    }
    items.back().text.push_back(c == '*' ? ' ' : c);
  }
  return items;
}

std::optional<std::string> refused_by(const OutputRule& rule,
                                      const std::vector<OutputItem>& items) {
  int variables = 0;
  for (const OutputItem& item : items) {
    if (item.variable < 0) {
      continue;
    }
    ++variables;
    const int digits = rule.counts_sides_apart ? std::max(item.integer_places, item.decimals)
                                               : item.integer_places + item.decimals;
    if (digits < rule.fewest_digits || digits > rule.most_digits) {
      return fmt::format("#{}[{}{}]: the places {} are {} to {}", item.variable,
                         item.integer_places, item.decimals,
                         rule.counts_sides_apart ? "on either side" : "together",
                         rule.fewest_digits, rule.most_digits);
    }
  }
  if (rule.most_variables != 0 && variables > rule.most_variables) {
    return fmt::format("{} variables, this control takes {}", variables, rule.most_variables);
  }
  return std::nullopt;
}

std::string decimal_text(double value, int integer_places, int decimals, const OutputStyle& style) {
  const double magnitude = round_to_counts(std::abs(value), syntax::kPowersOfTen[decimals]);
  std::string digits = fmt::format("{:.{}f}", magnitude, decimals);
  const std::size_t point = std::min(digits.find('.'), digits.size());
  std::string whole = digits.substr(0, point);
  const std::string fraction = digits.substr(point);
  const auto places = static_cast<std::size_t>(integer_places);
  if (whole.size() > places && (style.overflow == OutputStyle::Overflow::Cut || whole == "0")) {
    whole.erase(0, whole.size() - places);
    // What is left of 12005 in two places is 05: its leading zeros are no digits either.
    while (whole.size() > 1 && whole.front() == '0') {
      whole.erase(0, 1);
    }
  }
  std::string sign = std::signbit(value) ? "-" : "";
  if (style.leading_zeros == OutputStyle::LeadingZeros::Blank) {
    if (sign.empty() && style.plus_sign == OutputStyle::PlusSign::Blank) {
      sign = " ";
    }
    whole.insert(0, places - std::min(places, whole.size()), ' ');
  }
  return sign + whole + fraction;
}

bool cuts_digits(double value, const OutputItem& item, const OutputStyle& style) {
  const double magnitude = round_to_counts(std::abs(value), syntax::kPowersOfTen[item.decimals]);
  return style.overflow == OutputStyle::Overflow::Cut &&
         magnitude >= syntax::kPowersOfTen[item.integer_places];
}

std::optional<std::string> binary_text(double value, int decimals) {
  const double scaled = std::round(round_to_counts(value, syntax::kPowersOfTen[decimals]) *
                                   syntax::kPowersOfTen[decimals]);
  if (scaled < -2147483648.0 || scaled > 2147483647.0) {
    return std::nullopt;
  }
  const auto bits = static_cast<std::uint32_t>(static_cast<std::int32_t>(scaled));
  std::string bytes;
  for (const unsigned shift : {24U, 16U, 8U, 0U}) {
    bytes.push_back(static_cast<char>((bits >> shift) & 0xFFU));
  }
  return bytes;
}

}  // namespace g31::fanuc

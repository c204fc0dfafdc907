#include "tools/setup/variable_name.h"

#include <algorithm>

namespace g31::setup {
namespace {

constexpr std::size_t kMostDigits = 9;

bool is_letter(char c) {
  return (c >= 'A' && c <= 'Z') || (c >= 'a' && c <= 'z') || c == '_' || c == '$';
}

bool all_digits(std::string_view text) {
  return !text.empty() && std::ranges::all_of(text, is_digit);
}

std::string_view without_leading_zeros(std::string_view digits) {
  while (digits.size() > 1 && digits.front() == '0') {
    digits.remove_prefix(1);
  }
  return digits;
}

bool is_identifier(std::string_view text) {
  return !text.empty() && is_letter(text.front()) &&
         std::ranges::all_of(text, [](char c) { return is_letter(c) || is_digit(c); });
}

/// One index between brackets or commas: a number or a name.
std::optional<std::string> normal_index(std::string_view text) {
  std::string_view digits = text;
  const bool negative = digits.starts_with('-');
  if (negative) {
    digits.remove_prefix(1);
  }
  if (all_digits(digits)) {
    return (negative ? "-" : "") + std::string(without_leading_zeros(digits));
  }
  return is_identifier(text) ? std::optional(std::string(text)) : std::nullopt;
}

/// "[1,X,TR]" and the like, brackets included.
std::optional<std::string> normal_indices(std::string_view text) {
  if (text.size() < 3 || text.back() != ']') {
    return std::nullopt;
  }
  std::string_view rest = text.substr(1, text.size() - 2);
  std::string normal = "[";
  while (true) {
    const std::size_t comma = std::min(rest.find(','), rest.size());
    const std::optional<std::string> index = normal_index(rest.substr(0, comma));
    if (!index) {
      return std::nullopt;
    }
    normal += *index;
    if (comma == rest.size()) {
      return normal + "]";
    }
    normal += ',';
    rest.remove_prefix(comma + 1);
  }
}

/// #30012.003: a parameter of a Haas, and one of its elements; #30057.25 is #30057.250.
std::optional<std::string> normal_element(std::string_view stem) {
  constexpr std::size_t kDigits = 5;
  constexpr std::size_t kDigitsOfElement = 3;
  const std::size_t point = stem.find('.');
  const bool is_one = stem.starts_with('#') && point == kDigits + 1 &&
                      stem.size() <= point + 1 + kDigitsOfElement &&
                      all_digits(stem.substr(1, kDigits)) && all_digits(stem.substr(point + 1));
  if (!is_one) {
    return std::nullopt;
  }
  std::string name(stem);
  name.resize(point + 1 + kDigitsOfElement, '0');
  return name;
}

/// What stands before the indices.
std::optional<std::string> normal_stem(std::string_view stem) {
  const std::string_view number = stem.empty() ? stem : stem.substr(1);
  const bool numbered = stem.starts_with('#') || stem.starts_with('R') || stem.starts_with('r');
  if (numbered && all_digits(number)) {
    const std::string_view shortest = without_leading_zeros(number);
    return shortest.size() <= kMostDigits ? std::optional(stem.front() + std::string(shortest))
                                          : std::nullopt;
  }
  if (auto element = normal_element(stem)) {
    return element;
  }
  const bool named = is_identifier(stem) || (stem.starts_with('#') && is_identifier(number));
  return named ? std::optional(std::string(stem)) : std::nullopt;
}

}  // namespace

std::optional<std::string> normal_variable_name(std::string_view text) {
  std::string dense(text);
  std::erase(dense, ' ');
  const std::string_view all = dense;
  const std::size_t bracket = std::min(all.find('['), all.size());
  std::optional<std::string> stem = normal_stem(all.substr(0, bracket));
  if (!stem || bracket == all.size()) {
    return stem;
  }
  const std::optional<std::string> indices = normal_indices(all.substr(bracket));
  return indices ? std::optional(*stem + *indices) : std::nullopt;
}

}  // namespace g31::setup

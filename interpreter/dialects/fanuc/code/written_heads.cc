#include "interpreter/dialects/fanuc/code/written_heads.h"

#include <algorithm>
#include <charconv>
#include <cstdint>
#include <string>

#include "interpreter/dialects/fanuc/text/scanner.h"
#include "machine/base/letters.h"

namespace g31::fanuc {
namespace {

/// Documents of g31 name the numbers of programs.
bool is_document(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  const std::string_view begin = first != text.npos ? text.substr(first) : "";
  const std::string_view angles = begin.substr(0, begin.find('>') + 1);
  const bool is_markup =
      begin.starts_with('<') &&
      !is_program_name(between_angles(angles, {0, static_cast<std::uint32_t>(angles.size())}));
  return begin.starts_with('{') || is_markup;
}

/// The digits from a place on as a number; 0: there are none, or more than any number has.
int number_from(std::string_view text, std::size_t at) {
  constexpr int kMost = 99'999'999;
  int number = 0;
  for (; at < text.size() && number <= kMost; ++at) {
    if (!is_digit(text[at]) && !counts_for_nothing(text[at])) {
      break;
    }
    number = is_digit(text[at]) ? 10 * number + (text[at] - '0') : number;
  }
  return number <= kMost ? number : 0;
}

/// Sheets, tables, documents and pictures are called as the program that they belong to.
constexpr std::string_view kNoPrograms[] = {".toml", ".json", ".jsonl", ".csv", ".html",
                                            ".svg",  ".png",  ".glb",   ".gltf"};

bool is_named_otherwise(std::string_view name) {
  const std::string small = in_small_letters(name);
  return std::ranges::any_of(kNoPrograms,
                             [&](std::string_view ending) { return small.ends_with(ending); });
}

}  // namespace

std::optional<int> number_in_file_name(std::string_view name) {
  if (is_named_otherwise(name)) {
    return std::nullopt;
  }
  const std::string_view stem = name.substr(0, name.find('.'));
  const std::size_t skip = !stem.empty() && (stem[0] == 'O' || stem[0] == 'o') ? 1 : 0;
  const std::string_view digits = stem.substr(skip);
  int number = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = !digits.empty() && end.ec == std::errc() && end.ptr == digits.end();
  return whole && number > 0 ? std::optional(number) : std::nullopt;
}

WrittenHeads::WrittenHeads(std::string_view text) {
  if (is_document(text)) {
    return;
  }
  has_angles_ = text.find('<') != text.npos;
  constexpr std::string_view kBegins = "Oo:";
  for (std::size_t at = text.find_first_of(kBegins); at != text.npos;
       at = text.find_first_of(kBegins, at + 1)) {
    if (const int number = number_from(text, at + 1); number != 0) {
      numbers_.push_back(number);
    }
  }
  std::ranges::sort(numbers_);
  const auto twice = std::ranges::unique(numbers_);
  numbers_.erase(twice.begin(), twice.end());
  numbers_.shrink_to_fit();
}

bool WrittenHeads::may_have(const ProgramKey& key) const {
  return key.number != 0 ? std::ranges::binary_search(numbers_, key.number) : has_angles_;
}

}  // namespace g31::fanuc

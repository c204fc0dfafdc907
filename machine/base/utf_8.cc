#include "machine/base/utf_8.h"

#include <algorithm>

namespace g31 {
namespace {

using Byte = unsigned char;

/// How many bytes a character has that begins so; 0: none does.
std::size_t length_by_lead(Byte lead) {
  if (lead < 0x80) {
    return 1;
  }
  if (lead < 0xC2 || lead > 0xF4) {
    return 0;
  }
  return lead >= 0xF0 ? 4 : lead >= 0xE0 ? 3 : 2;
}

bool continues(Byte byte) {
  return byte >= 0x80 && byte <= 0xBF;
}

bool may_be_second(Byte lead, Byte second) {
  const Byte least = lead == 0xE0 ? 0xA0 : lead == 0xF0 ? 0x90 : 0x80;
  const Byte most = lead == 0xED ? 0x9F : lead == 0xF4 ? 0x8F : 0xBF;
  return second >= least && second <= most;
}

}  // namespace

Utf8Piece utf_8_piece(std::string_view bytes) {
  const auto lead = static_cast<Byte>(bytes.front());
  const std::size_t whole = length_by_lead(lead);
  if (whole == 0) {
    return {1, false};
  }
  for (std::size_t i = 1; i < whole; ++i) {
    const auto next = i < bytes.size() ? static_cast<Byte>(bytes[i]) : Byte{0};
    if (!(i == 1 ? may_be_second(lead, next) : continues(next))) {
      return {i, false};
    }
  }
  return {whole, true};
}

std::size_t character_count(std::string_view bytes) {
  const auto is_ascii = [](char c) { return static_cast<Byte>(c) < 0x80; };
  const auto first = std::ranges::find_if_not(bytes, is_ascii);
  auto count = static_cast<std::size_t>(first - bytes.begin());
  bytes.remove_prefix(count);
  while (!bytes.empty()) {
    const auto [length, is_character] = utf_8_piece(bytes);
    count += is_character ? 1 : length;
    bytes.remove_prefix(length);
  }
  return count;
}

int column_behind(std::string_view text) {
  return 1 + static_cast<int>(character_count(text));
}

std::size_t bytes_of_characters(std::string_view bytes, std::size_t characters) {
  std::size_t begin = 0;
  while (characters > 0 && begin < bytes.size()) {
    const auto [length, is_character] = utf_8_piece(bytes.substr(begin));
    const std::size_t count = is_character ? 1 : std::min(length, characters);
    begin += is_character ? length : count;
    characters -= count;
  }
  return begin;
}

std::string as_valid_utf_8(std::string_view bytes) {
  constexpr std::string_view kReplacement = "\xEF\xBF\xBD";
  std::string text;
  text.reserve(bytes.size());
  while (!bytes.empty()) {
    const auto [length, is_character] = utf_8_piece(bytes);
    text += is_character ? bytes.substr(0, length) : kReplacement;
    bytes.remove_prefix(length);
  }
  return text;
}

}  // namespace g31

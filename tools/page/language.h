#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace g31::page {

/// Of the words that the page itself says; programs and messages stay as they are.
enum class Language : std::uint8_t { English, Japanese };

/// "en" or "ja".
std::optional<Language> language_named(std::string_view name);
std::string_view name_of(Language language);

/// Rows of words.def.
enum class Word : std::uint16_t {
#define WORD(name, english, japanese) name,
#include "tools/page/words.def"
};

std::string_view text_of(Word word, Language language);

}  // namespace g31::page

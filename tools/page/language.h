#pragma once

#include <cstdint>
#include <string_view>

#include "tools/plot/language.h"

namespace g31::page {

/// Pages and the drawings on them speak the same ones.
using plot::Language;
using plot::language_named;

/// Rows of words.def.
enum class Word : std::uint16_t {
#define WORD(name, english, japanese) name,
#include "tools/page/words.def"
};

std::string_view text_of(Word word, Language language);

}  // namespace g31::page

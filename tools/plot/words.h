#pragma once

#include <cstdint>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tools/plot/language.h"

namespace g31::plot {

/// Rows of words.def.
enum class Word : std::uint8_t {
#define PLOT_WORD(name, english, japanese) name,
#include "tools/plot/words.def"
};

std::string_view text_of(Word word, Language language);

/// A row of words.def with its {names} filled in.
/// @param named  fmt::arg("name", value) each
template <typename... Named>
std::string said(Language language, Word word, const Named&... named) {
  return fmt::format(fmt::runtime(text_of(word, language)), named...);
}

}  // namespace g31::plot

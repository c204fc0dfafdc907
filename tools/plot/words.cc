#include "tools/plot/words.h"

#include <cstddef>

namespace g31::plot {
namespace {

struct Texts {
  std::string_view english;
  std::string_view japanese;
};

constexpr Texts kTexts[] = {
#define PLOT_WORD(name, english, japanese) {english, japanese},
#include "tools/plot/words.def"
};

}  // namespace

std::optional<Language> language_named(std::string_view name) {
  if (name == "en") {
    return Language::English;
  }
  return name == "ja" ? std::optional(Language::Japanese) : std::nullopt;
}

std::string_view name_of(Language language) {
  return language == Language::English ? "en" : "ja";
}

std::string_view text_of(Word word, Language language) {
  const Texts& texts = kTexts[static_cast<std::size_t>(word)];
  return language == Language::English ? texts.english : texts.japanese;
}

}  // namespace g31::plot

#include "tools/page/language.h"

#include <array>
#include <cstddef>

namespace g31::page {
namespace {

struct Texts {
  std::string_view english;
  std::string_view japanese;
};

constexpr Texts kTexts[] = {
#define WORD(name, english, japanese) {english, japanese},
#include "tools/page/words.def"
};

}  // namespace

std::string_view text_of(Word word, Language language) {
  const Texts& texts = kTexts[static_cast<std::size_t>(word)];
  return language == Language::English ? texts.english : texts.japanese;
}

}  // namespace g31::page

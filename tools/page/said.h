#pragma once

#include <string>

#include <fmt/format.h>

#include "tools/page/language.h"

namespace g31::page {

/// A sentence of words.def with its {names} filled in.
/// @param named  fmt::arg("name", value) each
template <typename... Named>
std::string said(Language language, Word sentence, const Named&... named) {
  return fmt::format(fmt::runtime(text_of(sentence, language)), named...);
}

}  // namespace g31::page

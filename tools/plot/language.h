#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

namespace g31::plot {

/// Of the words that drawings and pages say themselves; programs and messages stay as they are.
enum class Language : std::uint8_t { English, Japanese };

/// "en" or "ja".
std::optional<Language> language_named(std::string_view name);
std::string_view name_of(Language language);

}  // namespace g31::plot

#pragma once

#include <string>
#include <string_view>

#include "tools/page/report.h"

// The parts of a page as HTML, each of the report alone; "" where the report has nothing for it.

namespace g31::page {

std::string summary_part(const Report& report);
std::string ending_part(const Report& report);
std::string results_part(const Report& report);
/// Frames of plan, scene and time line, which the script draws.
std::string motion_part(const Report& report);
std::string drawings_part(const Report& report);
std::string touches_part(const Report& report);
std::string listing_part(const Report& report);
std::string variables_part(const Report& report);
std::string inputs_part(const Report& report);

/// A table or a file of more rows than this is filled in by the script, as far as it is seen.
inline constexpr std::size_t kMostRows = 2000;

// What several parts need.

/// Text of messages and tables that is English on pages of every language, for HTML: marked as
/// such.
std::string english(const Report& report, std::string_view text);
/// The label of a table: its name and that it is one.
std::string table_label(const Report& report, std::string_view name);
inline std::string_view word(const Report& report, Word word) {
  return text_of(word, report.language);
}
/// A table of a report that has nothing for it: people and programs that look for it find why.
/// @param heading_id  of its name
std::string empty_table(std::string_view id, std::string_view heading_id, std::string_view name,
                        std::string_view why);
/// A link to a line of the listing; "" for no place.
std::string link_to(const Place& place);
/// A button that chooses a touch.
std::string badge_of(const Report& report, std::size_t touch);

}  // namespace g31::page

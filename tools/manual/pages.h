#pragma once

#include <span>
#include <string>
#include <string_view>

namespace g31::manual {

/// A file of docs that is made from the tables; a test compares the file with what is made.
struct Page {
  std::string_view name;  ///< below docs
  std::string_view text;  ///< what is on it
  std::string (*make)();
};

/// All pages, in the order that help lists them.
std::span<const Page> pages();

// The makers: whole files that end with a line break.

/// Markdown: every key of a set-up sheet, every shape, the units, the errors.
std::string sheet_page();
/// A JSON Schema (draft 7) for what editors complete and check in set-up sheets.
std::string sheet_schema();
/// Markdown: every key of a study file.
std::string study_page();
/// Markdown: every code of a message.
std::string codes_page();
/// Markdown: what of world and controls is not there.
std::string not_simulated_page();

}  // namespace g31::manual

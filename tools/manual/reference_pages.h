#pragma once

#include <span>
#include <string>
#include <string_view>

#include "interpreter/runtime/reference.h"
#include "tools/session/control.h"

namespace g31::manual {

/// A page that is a list of what the tables of controls have.
struct ReferencePage {
  std::string_view name;  ///< below docs
  std::string_view title;
  std::string_view about;  ///< sentences below the title
  bool is_fanuc;           ///< of all controls of that dialect; else of the SINUMERIK
  std::span<const std::string_view> kinds;  ///< of entries, in this order
};

std::span<const ReferencePage> reference_pages();

/// Markdown: the page of this name.
std::string reference_page(std::string_view name);

/// Markdown: every control of the Fanuc dialect beside the others.
std::string controls_page();
/// Markdown: every rule of `g31 check`.
std::string rules_page();
/// Markdown: measuring cycles with their parameters, other cycles, macros.
std::string cycles_page();

/// Of a kind, what a reader looks up: nothing that is local to a program that comes with g31.
runtime::Entries entries_of_kind(const session::Control& control, std::string_view kind);

/// A text as it stands in a cell: nothing in it is Markdown.
std::string plain(std::string_view text);

}  // namespace g31::manual

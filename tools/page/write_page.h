#pragma once

#include <string>

#include "machine/base/result.h"
#include "tools/page/report.h"

namespace g31::page {

/// What all pages share: made of tools/page/web when g31 is built, and installed with it.
struct PageAssets {
  std::string css;
  std::string script;
};

/// Reads them from where they come with g31.  @returns one line that says why they are not there
Result<PageAssets, std::string> read_assets();

/// One HTML file that needs nothing beside it: tables and listing stand in it, figures are drawn by
/// its script.
std::string page_of(const Report& report, const PageAssets& assets);

}  // namespace g31::page

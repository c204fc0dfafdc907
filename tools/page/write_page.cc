#include "tools/page/write_page.h"

#include <fmt/format.h>

#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/page/embedded.h"
#include "tools/page/html.h"
#include "tools/page/parts.h"

namespace g31::page {
namespace {

std::string head_of(const Report& report, const PageAssets& assets) {
  const bool is_served = report.edition != 0;
  return fmt::format(
      R"(<!doctype html>
<html lang="{0}"{4}><head><meta charset="utf-8"><meta name="viewport" content="width=device-width,initial-scale=1"><meta http-equiv="Content-Security-Policy" content="default-src 'none'; style-src 'unsafe-inline'; script-src 'unsafe-inline'; img-src data: blob:{5}"><title>{1}: {2} – {3}</title><style>
{6}</style></head>
)",
      name_of(report.language), escaped(report.title), escaped(report.verdict.state),
      word(report, Word::RunReport),
      is_served ? fmt::format(R"( data-edition="{}")", report.edition) : std::string(),
      is_served ? "; connect-src 'self'" : "", assets.css);
}

std::string bar_of(const Report& report) {
  return fmt::format(
      R"(<header class="top"><span class="brand">g31</span><h1 id="doc">{}</h1><span class="what" id="what">{}</span><span class="tools noprint"><button class="btn" type="button" id="theme">{}</button><button class="btn" type="button" id="print">{}</button></span></header>
)",
      escaped(report.title), escaped(report.what), word(report, Word::LightOrDark),
      word(report, Word::Print));
}

}  // namespace

Result<PageAssets, std::string> read_assets() {
  const auto folder = disk::shipped_folder("page");
  disk::Disk disk;
  const auto css = folder ? disk.read(*folder + "/page.css") : std::nullopt;
  const auto script = folder ? disk.read(*folder + "/page.js") : std::nullopt;
  if (!css || !script) {
    return std::string(
        "the page's script is not there: this g31 was built without node and npm; build it with "
        "both, or install a package of it");
  }
  return PageAssets{*css, *script};
}

std::string page_of(const Report& report, const PageAssets& assets) {
  std::string html = head_of(report, assets);
  html += fmt::format(R"(<body><a class="skip" href="#results">{}</a>
<div class="wrap" id="main">
)",
                      word(report, Word::SkipToResults));
  html += bar_of(report);
  html += "<main>\n" + summary_part(report) + ending_part(report) + results_part(report);
  html += motion_part(report) + drawings_part(report) + touches_part(report);
  const std::string listing = listing_part(report);
  const std::string variables = variables_part(report);
  if (!listing.empty() || !variables.empty()) {
    html += fmt::format(R"(<div class="two text">{}<div>{}</div></div>
)",
                        listing, variables);
  }
  html += inputs_part(report) + "</main></div>\n";
  html += embedded("g31-document", report.document, report.growth);
  html += report.figures.empty() ? "" : embedded("g31-figures", report.figures);
  return html + fmt::format("<script>\n{}</script>\n</body></html>\n", assets.script);
}

}  // namespace g31::page

#include <algorithm>
#include <set>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/parts.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

std::vector<std::string_view> lines_of(std::string_view text) {
  std::vector<std::string_view> lines;
  while (!text.empty()) {
    const std::size_t end = std::min(text.find('\n'), text.size());
    lines.push_back(text.substr(0, end));
    text.remove_prefix(std::min(end + 1, text.size()));
  }
  for (std::string_view& line : lines) {
    if (line.ends_with('\r')) {
      line.remove_suffix(1);
    }
  }
  return lines;
}

/// x: ran; p: a condition of it went one way only; z: never ran; "": has no block.
std::string_view class_of_line(const Listing& listing, int line) {
  const auto count = listing.counts.find(line);
  if (count == listing.counts.end()) {
    return "";
  }
  if (count->second == 0) {
    return "z";
  }
  const auto condition = listing.conditions.find(line);
  const bool is_partly = condition != listing.conditions.end() &&
                         (condition->second[0] == 0 || condition->second[1] == 0);
  return is_partly ? "p" : "x";
}

std::string condition_title(const Report& report, const Listing& listing, int line) {
  const auto condition = listing.conditions.find(line);
  return condition == listing.conditions.end()
             ? ""
             : fmt::format(R"( title="{}")", said(report.language, Word::SaysCondition,
                                                  fmt::arg("met", condition->second[1]),
                                                  fmt::arg("unmet", condition->second[0])));
}

/// The touches that a line made, as buttons.
using BadgesByLine = std::map<int, std::string>;

BadgesByLine badges_of(const Report& report, const Listing& listing) {
  constexpr std::size_t kMostBadges = 6;
  std::map<int, std::vector<std::size_t>> found;
  for (std::size_t i = 0; i < report.touches.size(); ++i) {
    const TouchRow& touch = report.touches[i];
    if (touch.is_triggered && touch.place.file == listing.file) {
      found[touch.place.line].push_back(i + 1);
    }
  }
  BadgesByLine badges;
  for (const auto& [line, numbers] : found) {
    for (std::size_t i = 0; i < std::min(numbers.size(), kMostBadges); ++i) {
      badges[line] += badge_of(report, numbers[i]);
    }
    if (numbers.size() > kMostBadges) {
      badges[line] += fmt::format("<span>+{}</span>", numbers.size() - kMostBadges);
    }
  }
  return badges;
}

/// One line of a listing, and how it is shown.
struct ShownLine {
  int number;
  std::string_view text;
  bool is_end;  ///< the run ended here
};

std::string line_of(const Report& report, const Listing& listing, const ShownLine& shown,
                    const BadgesByLine& badges) {
  const auto& [line, text, is_end] = shown;
  const auto count = listing.counts.find(line);
  std::string kind(class_of_line(listing, line));
  kind += is_end ? " err" : "";
  std::string html = fmt::format(
      R"(<li id="L-{}-{}" data-l="{}"{}><span class="ct"{}>{}</span><span class="no">{}</span><span class="tx">{}</span><span class="tb">)",
      escaped(listing.file), line, line,
      kind.empty() ? std::string() : fmt::format(R"( class="{}")", kind),
      condition_title(report, listing, line),
      count == listing.counts.end() ? std::string() : std::to_string(count->second), line,
      text.empty() ? " " : escaped(text));
  if (const auto here = badges.find(line); here != badges.end()) {
    html += here->second;
  }
  return html + "</span></li>\n";
}

std::string file_of(const Report& report, const Listing& listing, bool is_shown) {
  const std::vector<std::string_view> lines = lines_of(listing.text);
  const std::string start =
      fmt::format(R"(<h3 class="vh">{0}</h3><ol data-file="{0}" aria-label="{0}"{1})",
                  escaped(listing.file), is_shown ? "" : " data-waits");
  if (lines.size() > kMostRows) {
    return fmt::format(R"({} data-virtual data-rows="{}"></ol>)", start, lines.size());
  }
  const BadgesByLine badges = badges_of(report, listing);
  const Place end =
      report.ending && !report.ending->stack.empty() ? report.ending->stack.front().place : Place();
  std::string html = start + ">";
  for (std::size_t i = 0; i < lines.size(); ++i) {
    const int line = static_cast<int>(i) + 1;
    html += line_of(report, listing, {line, lines[i], end.file == listing.file && end.line == line},
                    badges);
  }
  return html + "</ol>";
}

}  // namespace

std::string listing_part(const Report& report) {
  if (report.listings.empty()) {
    return {};
  }
  std::size_t run = 0;
  std::size_t all = 0;
  std::string tabs;
  for (const Listing& listing : report.listings) {
    tabs +=
        fmt::format(R"(<button type="button" data-file="{0}" aria-pressed="{1}">{0}</button>)",
                    escaped(listing.file), &listing == &report.listings.front() ? "true" : "false");
    all += listing.counts.size();
    run += static_cast<std::size_t>(
        std::ranges::count_if(listing.counts, [](const auto& line) { return line.second > 0; }));
  }
  std::string html = fmt::format(
      R"(<section class="card flow" id="listcard" aria-labelledby="hli"><header><h2 id="hli">{0}</h2><span class="seg noprint" role="group" aria-label="{1}" id="ltabs">{2}</span><span class="right key" id="lcov">{3} / {4} {5}</span></header><div class="lst" id="listing" tabindex="0" role="region" aria-label="{6}">)",
      word(report, Word::ProgramListing), word(report, Word::File), tabs, run, all,
      word(report, Word::BlocksRun), word(report, Word::ListingRegion));
  for (const Listing& listing : report.listings) {
    html += file_of(report, listing, &listing == &report.listings.front());
  }
  return html + "</div></section>\n";
}

}  // namespace g31::page

#include <algorithm>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/parts.h"

namespace g31::page {
namespace {

/// Over it the ball slides along the wall rather than meet it.
constexpr double kSteepDeg = 30.0;
/// Ways without a signal are folded away where there are more skip moves.
constexpr std::size_t kFewRows = 16;

std::string three(const std::optional<std::array<double, 3>>& place, int decimals) {
  std::string cells;
  for (std::size_t i = 0; i < 3; ++i) {
    cells += fmt::format(R"(<td class="n">{}</td>)",
                         number(place ? std::optional((*place)[i]) : std::nullopt, decimals));
  }
  return cells;
}

std::string row_of(const Report& report, std::size_t number_of_touch, bool is_folded) {
  const TouchRow& touch = report.touches[number_of_touch - 1];
  const bool is_steep = touch.angle_deg && *touch.angle_deg > kSteepDeg;
  std::string html = fmt::format(
      R"(<tr data-touch="{0}"{1}{2}><td class="stick">{3}</td><td>{4} {5}</td>)", number_of_touch,
      touch.is_triggered ? "" : R"( class="un")", is_folded ? " hidden" : "",
      badge_of(report, number_of_touch), link_to(touch.place), escaped(touch.block));
  html += fmt::format(R"(<td class="n">{}</td><td class="n">{}</td>)", number(touch.time_s, 3),
                      number(touch.feed, 0));
  html += three(touch.commanded, 3) + three(touch.latched, 4);
  html += fmt::format("<td>{}</td>", touch.part.empty() ? "–" : escaped(touch.part));
  html += three(touch.contact, 4);
  html += fmt::format(R"(<td class="n dev">{}</td><td class="n{}">{}</td><td>{}</td></tr>)",
                      micrometres(touch.deviation_mm), is_steep ? " no" : "",
                      number(touch.angle_deg, 1), escaped(touch.caller));
  return html;
}

std::string head_of(const Report& report) {
  const auto say = [&](Word name) { return word(report, name); };
  const std::string frame =
      report.frame.empty() ? "mm" : fmt::format("{}, mm", escaped(report.frame));
  std::string html = fmt::format(
      R"(<thead><tr class="g"><td></td><td></td><td></td><td></td><th class="grp" scope="colgroup" colspan="3">{}, {}</th><th class="grp" scope="colgroup" colspan="3">{}, {}</th><th class="grp" scope="colgroup" colspan="4">{}, mm</th><td></td><td></td><td></td></tr><tr>)",
      say(Word::Commanded), frame, say(Word::Latched), frame, say(Word::ContactOnPart));
  html += fmt::format(
      R"(<th scope="col" class="stick">{}</th><th scope="col">{}</th><th scope="col" class="n">{}</th><th scope="col" class="n">{}</th>)",
      say(Word::Number), say(Word::Block), say(Word::TimeS), say(Word::Feed));
  constexpr std::string_view kAxes =
      R"(<th scope="col" class="n">X</th><th scope="col" class="n">Y</th><th scope="col" class="n">Z</th>)";
  return html +
         fmt::format(
             R"({0}{0}<th scope="col">{1}</th>{0}<th scope="col" class="n">{2}</th><th scope="col" class="n">{3}</th><th scope="col">{4}</th></tr></thead>)",
             kAxes, say(Word::Part), say(Word::DeviationUm), say(Word::AngleDeg),
             say(Word::CalledFor));
}

}  // namespace

std::string touches_part(const Report& report) {
  const auto say = [&](Word name) { return word(report, name); };
  if (report.touches.empty()) {
    return report.frame.empty()
               ? std::string()
               : empty_table("touches", "hto", say(Word::Touches), say(Word::NoTouches));
  }
  const auto without =
      std::ranges::count_if(report.touches, [](const TouchRow& row) { return !row.is_triggered; });
  const bool folds = report.touches.size() > kFewRows && without > 0;
  std::string html = fmt::format(
      R"(<section class="card flow" aria-labelledby="hto"><header><h2 id="hto">{}</h2><span class="sub">{}</span>)",
      say(Word::Touches),
      report.motion_of.empty()
          ? std::string(say(Word::EverySkipMove))
          : fmt::format("{}; {}", escaped(report.motion_of), say(Word::EverySkipMove)));
  if (folds) {
    html += fmt::format(
        R"(<span class="right noprint"><label class="key"><input type="checkbox" id="allt"> {} ({})</label></span>)",
        say(Word::AlsoWithout), without);
  }
  html += fmt::format(
      R"(</header><div class="tw tall" tabindex="0" role="region" aria-label="{}"><table id="touches">)",
      table_label(report, say(Word::Touches)));
  html += head_of(report);
  if (report.touches.size() > kMostRows) {
    html += "<tbody data-virtual>";
  } else {
    html += "<tbody>";
    for (std::size_t i = 0; i < report.touches.size(); ++i) {
      html += row_of(report, i + 1, folds && !report.touches[i].is_triggered);
    }
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace g31::page

#include "tools/page/parts.h"

#include <algorithm>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

/// Rows of a table that stands there whole; a longer one scrolls by itself.
constexpr std::size_t kMostWhole = 40;

std::string drawing(const Drawing& drawing) {
  return fmt::format(
      R"(<section class="card"><header><h2>{0}</h2></header><div class="drawing" tabindex="0" role="region" aria-label="{0}">{1}</div>{2}</section>)",
      escaped(drawing.title), drawing.svg,
      drawing.caption.empty()
          ? std::string()
          : fmt::format(R"(<div class="cap">{}</div>)", escaped(drawing.caption)));
}

std::string table(const Report& report, const Table& table) {
  std::string html = fmt::format(
      R"(<section class="card"><header><h2>{0}</h2></header><div class="tw{3}" tabindex="0" role="region" aria-label="{1}"><table{2}><thead><tr>)",
      escaped(table.title), escaped(table_label(report, table.title)),
      table.is_results ? R"( id="results")" : "", table.rows.size() > kMostWhole ? " tall" : "");
  for (std::size_t i = 0; i < table.head.size(); ++i) {
    html += fmt::format(R"(<th scope="col"{}>{}</th>)", i > 0 ? R"( class="n")" : "",
                        escaped(table.head[i]));
  }
  html += "</tr></thead><tbody>";
  for (const auto& row : table.rows) {
    html += "<tr>";
    for (std::size_t i = 0; i < row.size(); ++i) {
      html += fmt::format("<td{}>{}</td>", i > 0 ? R"( class="n")" : "",
                          i == table.english_column ? english(report, row[i]) : escaped(row[i]));
    }
    html += "</tr>";
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace

std::string english(const Report& report, std::string_view text) {
  return report.language == Language::English
             ? escaped(text)
             : fmt::format(R"(<span lang="en">{}</span>)", escaped(text));
}

std::string empty_table(std::string_view id, std::string_view heading_id, std::string_view name,
                        std::string_view why) {
  return fmt::format(
      R"html(<section class="card" aria-labelledby="{0}"><header><h2 id="{0}">{1}</h2></header><div class="tw"><table id="{2}"><tbody><tr><td class="wrapcell mut">{3}</td></tr></tbody></table></div></section>
)html",
      heading_id, name, id, why);
}

std::string table_label(const Report& report, std::string_view name) {
  return said(report.language, Word::TableOf, fmt::arg("name", name));
}

std::string link_to(const Place& place) {
  if (place.file.empty()) {
    return {};
  }
  const std::string file = escaped(place.file);
  return place.line > 0 ? fmt::format(R"(<a href="#L-{0}-{1}" data-go="{0}:{1}">{0}:{1}</a>)", file,
                                      place.line)
                        : file;
}

std::string badge_of(const Report& report, std::size_t touch) {
  return fmt::format(
      R"(<button class="badge" type="button" data-t="{0}" aria-label="{1}">{0}</button>)", touch,
      said(report.language, Word::TouchNumber, fmt::arg("number", touch)));
}

std::string drawings_part(const Report& report) {
  std::string html;
  bool is_open = false;
  for (const Drawing& one : report.drawings) {
    if (one.is_half != is_open) {
      html += one.is_half ? R"(<div class="two charts">)" : "</div>";
      is_open = one.is_half;
    }
    html += drawing(one);
  }
  html += is_open ? "</div>\n" : "";
  for (const Table& one : report.tables) {
    html += table(report, one);
  }
  return html;
}

std::string motion_part(const Report& report) {
  if (!report.has_motion) {
    return {};
  }
  const auto say = [&](Word name) { return word(report, name); };
  const std::string_view waiting = say(Word::WithoutScript);
  const double step_s = report.duration_s > 10.0 ? 0.01 : 0.001;
  return fmt::format(
             R"(<div class="two"><section class="card" aria-label="{}"><header id="planhead"><h2>{}</h2></header><div id="plan"><p class="limits">{}</p></div><div class="cap" id="plancap"></div></section>
<section class="card" aria-labelledby="hsc"><header id="scenehead"><h2 id="hsc">{}</h2></header><div id="scenebox"><p class="limits">{}</p></div><div class="cap" id="scenecap"></div></section></div>
<section class="card" aria-labelledby="htl"><header id="charthead"><h2 id="htl">{}</h2></header><div id="chart"><p class="limits">{}</p></div></section>
)",
             say(Word::PlanView), say(Word::PlanView), waiting, say(Word::Scene), waiting,
             say(Word::TimeLine), waiting) +
         fmt::format(
             R"(<div class="transport noprint" role="group" aria-label="{}"><div class="ctl"><button class="btn" type="button" id="prev" aria-label="{}"><svg viewBox="0 0 16 16" aria-hidden="true"><path d="M2 2h2v12H2zM14 1.5v13L5 8z"/></svg></button><button class="btn" type="button" id="play" aria-label="{}"><svg viewBox="0 0 16 16" aria-hidden="true"><path d="M3 1.5l11 6.5-11 6.5z"/></svg></button><button class="btn" type="button" id="next" aria-label="{}"><svg viewBox="0 0 16 16" aria-hidden="true"><path d="M12 2h2v12h-2zM2 1.5v13L11 8z"/></svg></button><select class="btn" id="rate" aria-label="{}"><option value="0.25">¼×</option><option value="1">1×</option><option value="4" selected>4×</option><option value="16">16×</option></select></div><input type="range" id="timeline" min="0" max="{}" step="{}" value="0" aria-label="{}"><div class="now" id="now"></div></div>
)",
             say(Word::PlayTheRun), say(Word::TouchBefore), say(Word::Play), say(Word::NextTouch),
             say(Word::Speed), report.duration_s, step_s, say(Word::TimeOfRun));
}

std::string inputs_part(const Report& report) {
  const auto say = [&](Word name) { return word(report, name); };
  const bool says_what =
      std::ranges::any_of(report.inputs, [](const Input& input) { return !input.what.empty(); });
  std::string html = fmt::format(
      R"(<section class="card" id="inputs" aria-labelledby="hin"><header><h2 id="hin">{0}</h2></header><div class="tw tall" tabindex="0" role="region" aria-label="{3}"><table><thead><tr><th scope="col">{1}</th>{2}<th scope="col">SHA-256</th></tr></thead><tbody>)",
      say(Word::InputsLimits), say(Word::File),
      says_what ? fmt::format(R"(<th scope="col">{}</th>)", say(Word::What)) : "",
      table_label(report, say(Word::InputsLimits)));
  for (const Input& input : report.inputs) {
    html += fmt::format(
        R"(<tr><td><code>{}</code></td>{}<td class="hash">{}</td></tr>)", escaped(input.file),
        says_what ? fmt::format("<td>{}</td>", escaped(input.what)) : "", input.sha256);
  }
  html += R"(</tbody></table></div><div class="limits">)";
  for (const std::string& limit : report.limits) {
    html += fmt::format("<p>{}</p>", escaped(limit));
  }
  return html + fmt::format("<p>{}</p></div></section>\n", say(report.caution));
}

}  // namespace g31::page

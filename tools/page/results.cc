#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/parts.h"
#include "tools/page/said.h"
#include "tools/page/signs.h"

namespace g31::page {
namespace {

/// The tolerance as a zone with quarter ticks, the measured value from the nominal, the true size.
class ToleranceBar {
 public:
  /// @pre the row has a tolerance
  ToleranceBar(const Characteristic& row, Language language)
      : row_(row),
        language_(language),
        limits_(*row.tolerance),
        largest_(std::max({std::abs(limits_.lower), std::abs(limits_.upper), 1e-9})) {}

  [[nodiscard]] std::string svg() const {
    const auto deviation = deviation_of(row_);
    std::string text = fmt::format(
        R"(<svg class="fig" style="width:{0}px" viewBox="0 0 {0} 26" role="img" aria-label="{1}">)",
        kWidth, label());
    text += fmt::format(
        R"html(<rect x="{:.1f}" y="5" width="{:.1f}" height="16" fill="var({})"/>)html",
        x(limits_.lower), x(limits_.upper) - x(limits_.lower), deviation ? "--good2" : "--mat");
    text += ticks();
    text += fmt::format(
        R"html(<path d="M4 13H{}" stroke="var(--line2)"/><path d="M{:.1f} 3V23" stroke="var(--ink3)" stroke-dasharray="2 2"/>)html",
        kWidth - 4, x(0.0));
    return text + (deviation ? measured(*deviation) : "") + true_size() + "</svg>";
  }

 private:
  static constexpr double kWidth = 216.0;
  static constexpr double kMargin = 7.0;
  static constexpr double kShown = 1.6;  // of the larger limit

  [[nodiscard]] std::string label() const {
    const auto deviation = deviation_of(row_);
    return deviation ? said(language_, Word::SaysDeviation,
                            fmt::arg("deviation", difference_text(row_, deviation)),
                            fmt::arg("lower", difference_text(row_, limits_.lower)),
                            fmt::arg("upper", difference_text(row_, limits_.upper)))
                     : std::string(text_of(Word::NotReached, language_));
  }

  [[nodiscard]] double x(double deviation) const {
    const double share = std::clamp(deviation / (largest_ * kShown), -1.0, 1.0);
    return kWidth / 2.0 + share * (kWidth / 2.0 - kMargin);
  }

  [[nodiscard]] std::string ticks() const {
    std::string text;
    for (int quarter = -4; quarter <= 4; ++quarter) {
      const double at = quarter / 4.0 * largest_;
      if (at < limits_.lower || at > limits_.upper) {
        continue;
      }
      const bool is_limit = std::abs(quarter) == 4;
      text += fmt::format(R"html(<path d="M{:.1f} {}V{}" stroke="var({})" stroke-width="{}"/>)html",
                          x(at), is_limit ? 2 : 18, is_limit ? 24 : 21,
                          is_limit ? "--good" : "--line2", is_limit ? "1.5" : "1");
    }
    return text;
  }

  static std::string band(double from, double to, std::string_view colour) {
    return fmt::format(
        R"html(<rect x="{:.1f}" y="10" width="{:.1f}" height="6" fill="var({})"/>)html",
        std::min(from, to), std::abs(to - from), colour);
  }

  [[nodiscard]] std::string measured(double deviation) const {
    const double inside = std::clamp(deviation, limits_.lower, limits_.upper);
    std::string text = band(x(0.0), x(inside), "--ink");
    if (is_out(row_)) {
      text += band(x(inside), x(deviation), "--bad");
    }
    return text +
           fmt::format(R"html(<path d="M{:.1f} 3V23" stroke="var({})" stroke-width="2.5"/>)html",
                       x(deviation), is_out(row_) ? "--bad" : "--ink");
  }

  [[nodiscard]] std::string true_size() const {
    return row_.true_size && row_.nominal
               ? fmt::format(
                     R"html(<path d="M{:.1f} 7.5l5 5.5-5 5.5-5-5.5z" fill="var(--paper)" stroke="var(--accent)" stroke-width="1.6"/>)html",
                     x(*row_.true_size - *row_.nominal))
               : "";
  }

  const Characteristic& row_;
  Language language_;
  expect::Limits limits_;
  double largest_;
};

std::string tolerance_text(const Characteristic& row) {
  if (!row.tolerance) {
    return "–";
  }
  const auto& [lower, upper] = *row.tolerance;
  const int decimals = decimals_of(row);
  return upper == -lower ? fmt::format("±{:.{}f}", upper, decimals)
                         : fmt::format("{} {}", number(lower, decimals, ShowSign::Always),
                                       number(upper, decimals, ShowSign::Always));
}

std::string share_text(const Characteristic& row) {
  const auto deviation = deviation_of(row);
  if (!deviation || !row.tolerance) {
    return "–";
  }
  // From the nominal or, where that is out itself, from the middle of what is allowed.
  const auto& [lower, upper] = *row.tolerance;
  const double from = lower > 0.0 || upper < 0.0 ? 0.5 * (lower + upper) : 0.0;
  const double limit = *deviation > from ? upper - from : from - lower;
  constexpr double kPercent = 100.0;
  if (limit <= 0.0) {
    return "–";
  }
  const double share = std::abs(*deviation - from) / limit * kPercent;
  return number(share, is_out(row) ? decimals_apart(share, kPercent, 0) : 0) + " %";
}

std::string verdict_text(const Report& report, const Characteristic& row) {
  const auto shown = [&](std::string_view colour, std::string_view sign, Word name) {
    return fmt::format(R"(<span class="verd {}">{}{}</span>)", colour, sign, word(report, name));
  };
  if (!row.measured && (row.unit || row.tolerance)) {
    return shown("mut", "", Word::NotReached);
  }
  if (row.is_as_expected) {
    return *row.is_as_expected ? shown("ok", svg_of(Sign::Good), Word::StateAsExpected)
                               : shown("no", svg_of(Sign::Bad), Word::StateNotAsExpected);
  }
  if (!row.tolerance) {
    return shown("mut", "", Word::Reported);
  }
  return is_out(row) ? shown("no", svg_of(Sign::Bad), Word::Out)
                     : shown("ok", svg_of(Sign::Good), Word::In);
}

/// Whether another run tells of any of the results.
bool compares(const Report& report) {
  return std::ranges::any_of(report.results,
                             [](const Characteristic& row) { return row.other.has_value(); });
}

/// Whether the true size of any result is known.
bool knows_true_sizes(const Report& report) {
  return std::ranges::any_of(report.results,
                             [](const Characteristic& row) { return row.true_size.has_value(); });
}

/// Whether touches were made for them; those of a run were, whatever came of it.
bool knows_touches(const Report& report) {
  return report.has_motion || !report.touches.empty();
}

/// What the sign of a true size means.
std::string true_size_key(const Report& report) {
  constexpr const char* kKey =
      R"html(<span class="key"><svg width="12" height="12" aria-hidden="true"><path d="M6 1l5 5-5 5-5-5z" fill="none" stroke="var(--accent)" stroke-width="1.6"/></svg>)html";
  return knows_true_sizes(report) ? kKey + std::string(word(report, Word::TrueSize)) + "</span>"
                                  : "";
}

std::string row_of(const Report& report, const Characteristic& row) {
  const auto cell = [&](Word label, std::string_view value, std::string_view kind = "n") {
    return fmt::format(R"(<td class="{}" data-l="{}">{}</td>)", kind, word(report, label), value);
  };
  const auto error =
      row.measured && row.true_size ? std::optional(*row.measured - *row.true_size) : std::nullopt;
  std::string touches;
  for (const std::size_t touch : row.touches) {
    touches += badge_of(report, touch) + " ";
  }
  const bool has_name = row.name != row.variable;
  std::string html = "<tr>";
  html += has_name ? fmt::format(
                         R"(<th scope="row" class="name">{} <code class="mut vr">{}</code></th>)",
                         escaped(row.name), escaped(row.variable))
                   : fmt::format(R"(<th scope="row" class="name"><code>{}</code></th>)",
                                 escaped(row.variable));
  const int decimals = decimals_of(row);
  const std::string_view unit = unit_name(row);
  html += cell(Word::Nominal, number(row.nominal, decimals));
  html += cell(Word::Tolerance, tolerance_text(row));
  html += cell(Word::Measured,
               row.tolerance ? number(row.measured, decimals) : significant(row.measured, decimals),
               "n big");
  if (knows_true_sizes(report)) {
    html += cell(Word::TrueSize, number(row.true_size, decimals));
  }
  html += cell(Word::Unit, unit.empty() ? "–" : unit, "");
  html += cell(Word::Deviation,
               fmt::format(R"(<span class="{}">{}</span>)", is_out(row) ? "no big" : "",
                           difference_text(row, deviation_of(row))));
  if (knows_true_sizes(report)) {
    html += cell(Word::MeasuringError, difference_text(row, error));
  }
  html += fmt::format(R"(<td class="bar">{}</td>)",
                      row.tolerance ? ToleranceBar(row, report.language).svg() : "");
  html += cell(Word::OfTolerance, share_text(row), is_out(row) ? "n no" : "n");
  if (compares(report)) {
    html += cell(Word::OtherRun, number(row.other, decimals));
    html +=
        cell(Word::Difference, difference_text(row, row.measured && row.other
                                                        ? std::optional(*row.measured - *row.other)
                                                        : std::nullopt));
  }
  if (knows_touches(report)) {
    html +=
        cell(Word::Touches,
             touches.empty() ? R"(<span class="mut">–</span>)"
                             : fmt::format(R"(<div class="many" tabindex="0">{}</div>)", touches),
             "touched");
  }
  return html + fmt::format(R"(<td class="vd">{}</td></tr>)", verdict_text(report, row));
}

/// Behind a heading: of which part.
std::string of_which(const std::string& what) {
  return what.empty() ? std::string()
                      : fmt::format(R"(<span class="sub">{}</span>)", escaped(what));
}

}  // namespace

std::string results_part(const Report& report) {
  if (report.results.empty()) {
    const bool are_elsewhere = std::ranges::any_of(report.tables, &Table::is_results);
    return are_elsewhere ? std::string()
                         : empty_table("results", "hres", word(report, Word::Results),
                                       word(report, Word::NoResults));
  }
  const auto say = [&](Word name) { return word(report, name); };
  std::string html = fmt::format(
      R"html(<section class="card" aria-labelledby="hres"><header><h2 id="hres">{0}</h2>{4}<span class="right"><span class="key"><svg width="18" height="10" aria-hidden="true"><path d="M9 0v10" stroke="var(--ink)" stroke-width="2.5"/></svg>{1}</span>{2}</span></header><div class="tw" tabindex="0" role="region" aria-label="{3}"><table id="results" class="judged"><thead><tr>)html",
      say(Word::Results), say(Word::Measured), true_size_key(report),
      table_label(report, say(Word::Results)), of_which(report.results_of));
  std::vector<std::pair<Word, std::string_view>> heads = {
      {Word::Characteristic, ""}, {Word::Nominal, "n"},     {Word::Tolerance, "n"},
      {Word::Measured, "n"},      {Word::Unit, ""},         {Word::Deviation, "n"},
      {Word::Limits, "mid"},      {Word::OfTolerance, "n"},
  };
  if (knows_true_sizes(report)) {
    heads.insert(heads.begin() + 4, {Word::TrueSize, "n"});
    heads.insert(heads.begin() + 7, {Word::MeasuringError, "n"});
  }
  if (compares(report)) {
    heads.insert(heads.end(), {{Word::OtherRun, "n"}, {Word::Difference, "n"}});
  }
  if (knows_touches(report)) {
    heads.emplace_back(Word::TouchesOfCall, "");
  }
  heads.emplace_back(Word::VerdictHead, "");
  for (const auto& [name, kind] : heads) {
    html += fmt::format(R"(<th scope="col" class="{}">{}</th>)", kind, say(name));
  }
  html += "</tr></thead><tbody>";
  for (const Characteristic& row : report.results) {
    html += row_of(report, row);
  }
  return html + "</tbody></table></div></section>\n";
}

}  // namespace g31::page

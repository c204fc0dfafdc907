#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/parts.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

/// A name that may break behind its underlines.
std::string breakable(const std::string& name) {
  std::string html;
  for (const char c : name) {
    html += escaped(std::string_view(&c, 1));
    html += c == '_' ? "<wbr>" : "";
  }
  return html;
}

/// The values of a variable over the run as steps.
class Spark {
 public:
  Spark(const VariableRow& row, double duration_s) : duration_s_(std::max(duration_s, 1e-9)) {
    for (const auto& [time_s, value] : row.values) {
      if (value && std::isfinite(*value)) {
        points_.emplace_back(time_s, *value);
        least_ = std::min(least_, *value);
        most_ = std::max(most_, *value);
      }
    }
  }

  [[nodiscard]] std::string svg(Language language) const {
    if (points_.empty()) {
      return {};
    }
    std::string steps = fmt::format("M{:.1f} {:.1f}", x(points_[0].first), y(points_[0].second));
    std::string dots;
    for (std::size_t i = 0; i < points_.size(); ++i) {
      const auto& [time_s, value] = points_[i];
      steps += i > 0 ? fmt::format("H{:.1f}V{:.1f}", x(time_s), y(value)) : "";
      dots +=
          points_.size() > kMostDots
              ? ""
              : fmt::format(R"(<circle cx="{:.1f}" cy="{:.1f}" r="1.9"/>)", x(time_s), y(value));
    }
    const std::string label = fmt::format(
        "{}: {}, {}", text_of(Word::Writes, language), points_.size(),
        said(language, Word::FromTo, fmt::arg("from", number(points_.front().second, 3)),
             fmt::arg("to", number(points_.back().second, 3))));
    return fmt::format(
        R"html(<svg class="spark" width="{0}" height="{1}" viewBox="0 0 {0} {1}" role="img" aria-label="{2}"><path d="M2 {3:.1f}H{4}" stroke="var(--line2)" stroke-dasharray="2 3"/><path d="{5}H{4}" fill="none" stroke="var(--ink)" stroke-width="1.4"/><g fill="var(--accent)">{6}</g></svg>)html",
        kWidth, kHeight, label, y(0.0), kWidth - 2, steps, dots);
  }

 private:
  static constexpr double kWidth = 150.0;
  static constexpr double kHeight = 26.0;
  static constexpr std::size_t kMostDots = 40;

  [[nodiscard]] double x(double time_s) const {
    return 2.0 + std::clamp(time_s / duration_s_, 0.0, 1.0) * (kWidth - 4.0);
  }
  [[nodiscard]] double y(double value) const {
    return most_ > least_ ? kHeight - 4.0 - (value - least_) / (most_ - least_) * (kHeight - 8.0)
                          : kHeight / 2.0;
  }

  double duration_s_;
  double least_ = 0.0;  // 0 is always shown
  double most_ = 0.0;
  std::vector<std::pair<double, double>> points_;
};

std::string printouts_part(const Report& report) {
  std::string html = fmt::format(
      R"(<section class="card" id="printouts" aria-labelledby="hpr"><header><h2 id="hpr">{}</h2></header>)",
      word(report, Word::Printouts));
  if (report.printouts.empty()) {
    return html +
           fmt::format(R"(<p class="limits">{}</p></section>)", word(report, Word::NothingPrinted));
  }
  html += R"(<pre class="out" tabindex="0">)";
  for (const Printout& one : report.printouts) {
    html +=
        one.kind.empty() ? "" : fmt::format("<b>{}</b> {} ", escaped(one.kind), link_to(one.place));
    html += escaped(one.text);
    html += one.text.ends_with('\n') ? "" : "\n";
  }
  return html + "</pre></section>";
}

}  // namespace

std::string variables_part(const Report& report) {
  if (report.variables.empty() && !report.has_printouts) {
    return {};
  }
  const auto say = [&](Word name) { return word(report, name); };
  std::string html;
  if (!report.variables.empty()) {
    html += fmt::format(
        R"(<section class="card flow" id="variables" aria-labelledby="hva"><header><h2 id="hva">{0}</h2><span class="sub">{1}</span></header><div class="tw tall" tabindex="0" role="region" aria-label="{8}"><table><thead><tr><th scope="col">{2}</th><th scope="col">{3}</th><th scope="col">{4}, 0 – {5} s</th><th scope="col" class="n">{6}</th><th scope="col" class="n">{7}</th></tr></thead><tbody>)",
        say(Word::Variables), say(Word::WrittenByRun), say(Word::Variable), say(Word::Meaning),
        say(Word::OverTheRun), number(report.duration_s, 1), say(Word::Writes),
        say(Word::LastValue), table_label(report, say(Word::Variables)));
    // What a program says of them is in a language that nobody knows: lang="".
    for (const VariableRow& row : report.variables) {
      html += fmt::format(
          R"(<tr><th scope="row" class="vn"><code>{}</code></th><td class="wrapcell" lang="">{}</td><td>{}</td><td class="n">{}</td><td class="n last">{}</td></tr>)",
          breakable(row.name), escaped(row.meaning),
          Spark(row, report.duration_s).svg(report.language), row.writes, escaped(row.last));
    }
    html += "</tbody></table></div></section>\n";
  }
  return html + (report.has_printouts ? printouts_part(report) : "");
}

}  // namespace g31::page

#include <algorithm>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/parts.h"
#include "tools/page/signs.h"

namespace g31::page {
namespace {

Word word_of(source::Severity severity) {
  switch (severity) {
    case source::Severity::Error:
      return Word::SeverityError;
    case source::Severity::Warning:
      return Word::SeverityWarning;
    case source::Severity::Note:
      break;
  }
  return Word::SeverityNote;
}

/// Messages are English on every page.
std::string finding(const Report& report, const Finding& one) {
  std::string html =
      fmt::format(R"(<div class="find {}">{}<div><span class="vh">{}: </span>{}</div>)",
                  source::name_of(one.severity), svg_of(one.severity),
                  word(report, word_of(one.severity)), english(report, one.text));
  if (!one.excerpt.empty()) {
    html += fmt::format(R"(<pre class="excerpt">{}</pre>)", english(report, one.excerpt));
  }
  for (const std::string& remark : one.remarks) {
    html += fmt::format(R"(<p class="remark">{}</p>)", english(report, remark));
  }
  html += R"(<div class="loc">)";
  if (!one.code.empty()) {
    html += fmt::format(R"(<span class="mono">{}</span>)", escaped(one.code));
  }
  if (const std::string link = link_to(one.place); !link.empty()) {
    html += fmt::format("<span>{}</span>", link);
  }
  return html + "</div></div>";
}

/// What is merely told is no finding.
std::string findings_head(const Report& report) {
  if (report.findings.empty()) {
    return std::string(word(report, Word::NoFindings));
  }
  const bool are_notes = std::ranges::all_of(
      report.findings, [](const Finding& one) { return one.severity == source::Severity::Note; });
  return fmt::format("{}: {}", word(report, are_notes ? Word::Notes : Word::Findings),
                     report.findings.size());
}

/// Rows below a head; nothing without rows.
std::string column(std::string_view head,
                   const std::vector<std::pair<std::string, std::string>>& rows) {
  if (rows.empty()) {
    return {};
  }
  std::string html = fmt::format("<div><h3>{}</h3><table><tbody>", head);
  for (const auto& [name, value] : rows) {
    html += fmt::format(R"(<tr><th scope="row"><code>{}</code></th><td class="n">{}</td></tr>)",
                        escaped(name), escaped(value));
  }
  return html + "</tbody></table></div>";
}

}  // namespace

std::string summary_part(const Report& report) {
  const Verdict& verdict = report.verdict;
  std::string html = fmt::format(
      R"(<section id="summary" class="card verdict-card" aria-labelledby="headline"><div class="verdict {}"><div class="vmain">{}<div><div class="state">{}</div><h2 class="headline" id="headline">{}</h2></div><p>{}</p></div><div class="findings"><h3>{}</h3>)",
      class_of(verdict.sign), svg_of(verdict.sign), escaped(verdict.state),
      escaped(verdict.headline), escaped(verdict.sentence), findings_head(report));
  for (const Finding& one : report.findings) {
    html += finding(report, one);
  }
  html += R"(</div></div><dl class="facts">)";
  for (const auto& [name, value] : report.facts) {
    html += fmt::format("<div><dt>{}</dt><dd>{}</dd></div>", escaped(name), escaped(value));
  }
  return html +
         fmt::format(
             R"(</dl><div class="cmd"><span class="lab">{}</span><pre id="command">{}</pre><button class="btn noprint" type="button" id="copy">{}</button></div></section>
)",
             word(report, Word::RepeatIt), escaped(report.command), word(report, Word::Copy));
}

std::string ending_part(const Report& report) {
  if (!report.ending) {
    return {};
  }
  const Ending& ending = *report.ending;
  std::string html = fmt::format(
      R"(<section id="alarm" class="card" aria-labelledby="hal"><header><h2 id="hal">{}</h2><span class="sub">{}</span></header><div class="frames"><div><h3>{}</h3>)",
      word(report, Word::WhereItEnded), english(report, ending.title),
      word(report, Word::CallStack));
  for (std::size_t i = 0; i < ending.stack.size(); ++i) {
    const Frame& frame = ending.stack[i];
    html += fmt::format(
        R"(<div class="frame"><span class="ix">{}</span><span><b>{}</b> {}</span><code>{}</code></div>)",
        i, escaped(frame.program), link_to(frame.place), escaped(frame.text));
  }
  html += "</div>" + column(word(report, Word::VariablesThere), ending.variables) +
          column(word(report, Word::Positions), ending.facts);
  return html + "</div></section>\n";
}

}  // namespace g31::page

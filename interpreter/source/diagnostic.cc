#include "interpreter/source/diagnostic.h"

#include <algorithm>
#include <array>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "interpreter/source/readable_text.h"
#include "machine/base/contract.h"

namespace g31::source {
namespace {

constexpr auto kDiagnosticRows = std::to_array<DiagnosticInfo>({
#define DIAGNOSTIC(name, code, severity, text, remedy) {code, Severity::severity, text, remedy},
#include "interpreter/source/diagnostics.def"
#undef DIAGNOSTIC
});

/// Longest piece of a source line that is shown.
constexpr std::size_t kShownColumns = 120;

/// The source line and the marker under it; empty where the text is not to be had.
std::string excerpt(const ShownPlace& place, std::size_t length) {
  if (place.line == 0) {
    return {};
  }
  const std::string_view whole = place.text;
  const std::size_t before = bytes_before(place);
  const std::size_t cut = before > kShownColumns / 2 ? before - kShownColumns / 2 : 0;
  const std::size_t from = whole.size() > kShownColumns ? std::min(cut, whole.size()) : 0;
  const std::string_view line = whole.substr(from, kShownColumns);

  const std::size_t column = before - std::min(from, before);
  const std::size_t room = line.size() > column ? line.size() - column : 1;
  const std::size_t width = std::clamp<std::size_t>(length, 1, room);
  const auto shown = [writing = writing_of(whole)](std::string_view piece) {
    return printable(read_as(writing, piece));
  };
  const std::string in_front = shown(line.substr(0, column));
  const std::string marked = shown(line.substr(std::min(column, line.size()), width));
  const std::size_t tildes = std::max<std::size_t>(cell_count(marked), 1) - 1;
  const std::size_t blanks = cell_count(in_front) + (column - std::min(column, line.size()));
  return fmt::format("{:5} | {}\n{:5} | {}^{}\n", place.line, shown(line), "",
                     std::string(blanks, ' '), std::string(tildes, '~'));
}

std::string prefix(const ShownPlace& place) {
  if (place.file.empty()) {
    return {};
  }
  return place.line == 0
             ? fmt::format("{}: ", printable(place.file))
             : fmt::format("{}:{}:{}: ", printable(place.file), place.line, place.column);
}

}  // namespace

std::string_view name_of(Severity severity) {
  switch (severity) {
    case Severity::Note:
      return "note";
    case Severity::Warning:
      return "warning";
    case Severity::Error:
      return "error";
  }
  contract_violated("every Severity has a name", __FILE__, __LINE__);
}

std::span<const DiagnosticInfo> diagnostics() {
  return kDiagnosticRows;
}

const DiagnosticInfo& info(DiagnosticId id) {
  return kDiagnosticRows.at(static_cast<std::size_t>(id));
}

Diagnostic make_diagnostic(DiagnosticId id, Location where, std::string_view detail) {
  const DiagnosticInfo& row = info(id);
  return {row.severity,
          std::string(row.code),
          where,
          fmt::format(fmt::runtime(row.text), detail),
          std::string(row.remedy),
          {}};
}

ShownPlace place_of(const Diagnostic& diagnostic, const SourceMap& sources) {
  return diagnostic.where.is_known() ? sources.show(diagnostic.where) : diagnostic.in_sheet;
}

std::string excerpt_of(const Diagnostic& diagnostic, const SourceMap& sources) {
  return excerpt(place_of(diagnostic, sources), diagnostic.where.length);
}

std::string text_of(const Note& note, const SourceMap& sources) {
  return fmt::format("{}note: {}", prefix(sources.show(note.where)), printable(note.message));
}

std::string render_text(const Diagnostic& diagnostic, const SourceMap& sources) {
  const ShownPlace place = place_of(diagnostic, sources);
  std::string text = fmt::format("{}{}: {} [{}]\n", prefix(place), name_of(diagnostic.severity),
                                 printable(diagnostic.message), diagnostic.code);
  text += excerpt(place, diagnostic.where.length);
  if (!diagnostic.remedy.empty()) {
    text += fmt::format("{:5} = {}\n", "", diagnostic.remedy);
  }
  for (const Note& note : diagnostic.notes) {
    text += text_of(note, sources) + "\n";
  }
  return text;
}

}  // namespace g31::source

#pragma once

#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/source/location.h"
#include "interpreter/source/source_map.h"

namespace g31::source {

enum class Severity { Note, Warning, Error };

/// "note", "warning", "error".
std::string_view name_of(Severity severity);

/// One line that belongs to a diagnostic: the call that led to it, the place of an earlier label.
struct Note {
  Location where;
  std::string message;
};

/// A problem in the user's program: data, not an exception and not a printed line.  Whoever runs
/// the program decides whether it becomes text, JSON, SARIF or a squiggle.
struct Diagnostic {
  Severity severity = Severity::Error;
  std::string code;     ///< the control's alarm number, or a row of diagnostics.def
  Location where;       ///< not known: the message stands alone
  std::string message;  ///< one line, no final full stop
  std::string remedy;   ///< what would be right; may be empty
  std::vector<Note> notes;
  /// Instead of `where`: what it is about in the set-up sheet, as RefusedSetting::key.
  std::string setting = {};
  ShownPlace in_sheet = {};  ///< where that stands, once it is looked up; file empty: nowhere
};

/// Rows of diagnostics.def: what g31 itself says, beside the alarms of the controls.
enum class DiagnosticId {
#define DIAGNOSTIC(name, code, severity, text, remedy) name,
#include "interpreter/source/diagnostics.def"
#undef DIAGNOSTIC
};

/// The fixed part of a message: the row of diagnostics.def.
struct DiagnosticInfo {
  std::string_view code;
  Severity severity;
  std::string_view text;  ///< fmt format with one {} per detail, or none
  std::string_view remedy;
};

/// All rows.
std::span<const DiagnosticInfo> diagnostics();

const DiagnosticInfo& info(DiagnosticId id);

/// A diagnostic of row `id`; `detail` fills the row's {}.
[[gnu::cold]] Diagnostic make_diagnostic(DiagnosticId id, Location where,
                                         std::string_view detail = {});

/// The place of a diagnostic, in a program or in the sheet.
ShownPlace place_of(const Diagnostic& diagnostic, const SourceMap& sources);

/// The line of a diagnostic and a marker under it; empty where the text is not to be had.  Long
/// lines are cut around the marker; control characters show as `?`.
std::string excerpt_of(const Diagnostic& diagnostic, const SourceMap& sources);

/// A note behind its place.
std::string text_of(const Note& note, const SourceMap& sources);

/// The compiler-style form: `file:line:col: error: text [CODE]`, its excerpt, the remedy and the
/// notes.  Where the text is no longer to be had, the file stands alone.
/// @param sources  of the programs that the places are in
std::string render_text(const Diagnostic& diagnostic, const SourceMap& sources);

}  // namespace g31::source

#include "interpreter/dialects/sinumerik/code/program_file.h"

#include <algorithm>
#include <string_view>
#include <utility>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "machine/base/utf_8.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kHeader = "_N_";  // behind %

std::string_view first_word(std::string_view line) {
  const std::size_t end = line.find_first_of(" \t\r;(");
  return line.substr(0, end);
}

/// Where one program of a text stands.
struct Piece {
  std::string header;  ///< without %; empty: the text has none
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Whether only blanks stand before it in its line.
bool is_first_of_line(std::string_view text, std::size_t at) {
  const std::size_t before = text.substr(0, at).find_last_not_of(' ');
  return before == text.npos || text[before] == '\n';
}

/// Cuts a text at its headers, which may have blanks before them.  Any other line that begins with
/// % is a header without a name; a byte order mark is in no piece.
std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  Piece now;
  now.begin = text.starts_with(kByteOrderMark) ? kByteOrderMark.size() : 0;
  const std::string_view behind_mark = text.substr(now.begin);
  const std::size_t mark = now.begin;
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1)) {
    if (!is_first_of_line(behind_mark, at - mark)) {
      continue;
    }
    const std::size_t end = std::min(text.find('\n', at), text.size());
    now.end = at;
    pieces.push_back(now);
    now = {};
    now.header = upper(first_word(text.substr(at + 1, end - at - 1)));
    now.begin = std::min(end + 1, text.size());
  }
  now.end = text.size();
  pieces.push_back(now);
  return pieces;
}

/// What `;$PATH=/_N_WKS_DIR/_N_PART_WPD` in the first line says.
std::string folder_in(std::string_view body) {
  constexpr std::string_view kPath = ";$PATH=";
  const std::size_t end = std::min(body.find_first_of("\r\n"), body.size());
  return body.starts_with(kPath) ? folder_name(body.substr(kPath.size(), end - kPath.size()))
                                 : std::string();
}

bool is_blank(std::string_view text) {
  return text.find_first_not_of(" \t\r\n") == std::string_view::npos;
}

}  // namespace

const CompiledProgram& FiledProgram::code(const Globals& globals) {
  std::call_once(once_, [&] {
    code_ = is_data(name_) ? compile_data(source_, globals) : compile(source_, globals);
  });
  return *code_;
}

void FiledProgram::lead(Globals& globals) {
  source_.leads = true;
  for (Variable& variable : variables_of_head(source_, globals)) {
    globals.offer_of_main(std::move(variable));
  }
}

const CompiledProgram& FiledProgram::define_in(Globals& globals) {
  std::call_once(once_, [&] { code_ = compile_definitions(source_, globals); });
  return *code_;
}

ProgramFile::ProgramFile(const source::SourceFile& text, bool is_shipped) : text_(text) {
  const ProgramName of_file = name_of_text(text.name(), ".");
  for (const Piece& piece : pieces_of(text.text())) {
    const std::string_view body = text.text().substr(piece.begin, piece.end - piece.begin);
    if (piece.header.empty() && is_blank(body)) {
      continue;
    }
    ProgramName name =
        piece.header.starts_with(kHeader) ? name_of_text(piece.header, "_") : of_file;
    name.folder = folder_in(body);
    ProgramSource source{
        name.stem,
        &text_,
        {static_cast<std::uint32_t>(piece.begin), static_cast<std::uint32_t>(piece.end)},
        name.folder,
        name.suffix,
        is_shipped};
    programs_.push_back(std::make_unique<FiledProgram>(std::move(name), std::move(source)));
  }
}

}  // namespace g31::sinumerik

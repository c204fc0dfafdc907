#include "interpreter/dialects/sinumerik/code/library.h"

#include <algorithm>

namespace g31::sinumerik {
namespace {

constexpr std::string_view kHeader = "_N_";  // behind %
std::string_view first_word(std::string_view line) {
  const std::size_t end = line.find_first_of(" \t\r;(");
  return line.substr(0, end);
}

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
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

/// Cuts a text at its headers, which may have blanks before them: a byte order mark has become
/// such.  Any other line that begins with % is a header without a name.
std::vector<Piece> pieces_of(std::string_view text) {
  std::vector<Piece> pieces;
  Piece now;
  for (std::size_t at = text.find('%'); at != text.npos; at = text.find('%', at + 1)) {
    if (!is_first_of_line(text, at)) {
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

ProgramLibrary::Added ProgramLibrary::add_file(const std::string& path) {
  auto text = files_.read(path);
  if (!text) {
    return Added::Unreadable;
  }
  loaded_.insert(path);
  take(path, std::move(*text), Wanted::Everything);
  return Added::Yes;
}

void ProgramLibrary::add_folder(const std::string& folder) {
  std::multimap<std::string, std::string> known;
  for (const std::string& name : files_.list(folder)) {
    const ProgramName parts = program_name(name);
    const std::string path = joined(folder, name);
    if (is_definition(parts)) {
      // As with programs, the first one of a name counts: a copy of shipped definitions replaces
      // them.
      if (!loaded_.contains(path) && find_entry(parts, Near()) == nullptr) {
        add_file(path);
      }
    } else if (parts.suffix == "ARC") {
      archives_.push_back(path);
      auto text = loaded_.contains(path) ? std::nullopt : files_.read(path);
      if (text) {
        take(path, std::move(*text), Wanted::Definitions);
      }
    } else if (!parts.suffix.empty()) {
      known.emplace(parts.stem, path);
    }
  }
  folders_.push_back(std::move(known));
}

/// Keeps the programs of a file.
void ProgramLibrary::take(std::string path, std::string text, Wanted wanted) {
  constexpr std::string_view kByteOrderMark = "\xEF\xBB\xBF";
  if (text.starts_with(kByteOrderMark)) {
    text.replace(0, kByteOrderMark.size(), kByteOrderMark.size(), ' ');
  }
  const ProgramName of_file = name_of_text(path, ".");
  texts_.push_back(std::make_unique<source::SourceFile>(std::move(path), std::move(text)));
  const source::SourceFile& file = *texts_.back();
  for (const Piece& piece : pieces_of(file.text())) {
    const std::string_view body = file.text().substr(piece.begin, piece.end - piece.begin);
    if (piece.header.empty() && is_blank(body)) {
      continue;
    }
    const bool has_name = piece.header.starts_with(kHeader);
    const ProgramName name = has_name ? name_of_text(piece.header, "_") : of_file;
    const bool is_new_definition = is_definition(name) && find_entry(name, Near()) == nullptr;
    if (wanted == Wanted::Definitions && !is_new_definition) {
      continue;
    }
    auto entry = std::make_unique<Entry>();
    entry->name = name;
    entry->name.folder = folder_in(body);
    entry->source = {
        entry->name.stem,
        &file,
        {static_cast<std::uint32_t>(piece.begin), static_cast<std::uint32_t>(piece.end)},
        entry->name.folder};
    by_stem_[entry->name.stem].push_back(entry.get());
    entries_.push_back(std::move(entry));
  }
}

std::vector<const CompiledProgram*> ProgramLibrary::define() {
  std::vector<const CompiledProgram*> all;
  for (const auto& entry : entries_) {
    if (is_definition(entry->name) && entry->compiled == nullptr) {
      entry->compiled = compile_definitions(entry->source, globals_);
      all.push_back(entry->compiled.get());
    }
  }
  return all;
}

std::vector<const CompiledProgram*> ProgramLibrary::initial_data() {
  std::vector<const CompiledProgram*> all;
  for (const auto& entry : entries_) {
    if (is_data(entry->name)) {
      all.push_back(compiled(*entry));
    }
  }
  return all;
}

const source::SourceFile* ProgramLibrary::main_text() const {
  return texts_.empty() ? nullptr : texts_.front().get();
}

const CompiledProgram* ProgramLibrary::main_program() {
  const source::SourceFile* const text = main_text();
  Entry* first = nullptr;
  for (const auto& entry : entries_) {
    if (entry->source.file != text || !is_callable(entry->name)) {
      continue;
    }
    if (entry->name.suffix == "MPF") {
      return begun(*entry);
    }
    first = first == nullptr ? entry.get() : first;
  }
  return first != nullptr ? begun(*first) : nullptr;
}

const CompiledProgram* ProgramLibrary::begun(Entry& main) {
  const ShortSpan text = main.source.text;
  if (main.compiled != nullptr || text.end - text.begin <= kWholeProgramBytes) {
    return compiled(main);
  }
  windows_ = std::make_unique<ProgramWindows>(main.source, globals_);
  return windows_->next().program;
}

const CompiledProgram* ProgramLibrary::compiled(Entry& entry) {
  if (entry.compiled == nullptr) {
    entry.compiled = is_data(entry.name) ? compile_data(entry.source, globals_)
                                         : compile(entry.source, globals_);
  }
  return entry.compiled.get();
}

ProgramLibrary::Entry* ProgramLibrary::find_entry(const ProgramName& name, const Near& near) {
  const auto found = by_stem_.find(name.stem);
  if (found == by_stem_.end()) {
    return nullptr;
  }
  // From the best place to the worst; the last one takes any.
  const std::string places[] = {name.folder, near.caller, "SPF_DIR", near.call_path};
  const auto rank = [&](const Entry& entry) {
    const auto* const place = std::ranges::find_if(places, [&](const std::string& folder) {
      return !folder.empty() && folder == entry.name.folder;
    });
    return place - std::begin(places);
  };
  Entry* best = nullptr;
  for (Entry* const entry : found->second) {
    const bool fits =
        name.suffix.empty() ? is_callable(entry->name) : entry->name.suffix == name.suffix;
    if (fits && (best == nullptr || rank(*entry) < rank(*best))) {
      best = entry;
    }
  }
  return best;
}

/// Reads the next file that may hold the program.  @returns whether there was one
bool ProgramLibrary::load_for(const ProgramName& name) {
  for (const auto& folder : folders_) {
    const auto [first, last] = folder.equal_range(name.stem);
    for (auto file = first; file != last; ++file) {
      if (!loaded_.contains(file->second)) {
        add_file(file->second);
        loaded_.insert(file->second);
        return true;
      }
    }
  }
  if (archives_.empty()) {
    return false;
  }
  const std::string archive = archives_.front();
  archives_.erase(archives_.begin());
  if (!loaded_.contains(archive)) {
    add_file(archive);
  }
  return true;
}

const CompiledProgram* ProgramLibrary::find(std::string_view written, const Near& near) {
  const ProgramName name = program_name(written);
  do {
    if (Entry* const entry = find_entry(name, near)) {
      return compiled(*entry);
    }
  } while (load_for(name));
  return nullptr;
}

const CompiledProgram* ProgramLibrary::written(const std::string& name, const std::string& text) {
  texts_.push_back(std::make_unique<source::SourceFile>(name, text));
  const ProgramSource source{
      program_name(name).stem, texts_.back().get(), {0, static_cast<std::uint32_t>(text.size())}};
  others_.push_back(compile(source, globals_));
  return others_.back().get();
}

ProgramSource ProgramLibrary::loose_source(const std::string& text) {
  texts_.push_back(std::make_unique<source::SourceFile>("command line", text));
  return {"", texts_.back().get(), {0, static_cast<std::uint32_t>(text.size())}};
}

const CompiledProgram* ProgramLibrary::snippet(const std::string& text,
                                               const CompiledProgram& home) {
  others_.push_back(compile_among(loose_source(text), globals_, home));
  return others_.back().get();
}

const CompiledProgram* ProgramLibrary::expression(const std::string& text,
                                                  const CompiledProgram& home) {
  others_.push_back(compile_expression(loose_source(text), globals_, home));
  return others_.back().get();
}

}  // namespace g31::sinumerik

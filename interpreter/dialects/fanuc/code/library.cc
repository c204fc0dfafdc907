#include "interpreter/dialects/fanuc/code/library.h"

#include <algorithm>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/dialects/fanuc/text/tape_code.h"
#include "interpreter/source/line_starts.h"

namespace g31::fanuc {
namespace {

/// So much of a long file tells its code.
constexpr std::size_t kLook = 4096;

/// Longer files are not read only to see whether they hold a program that was found already.
constexpr std::size_t kLongestSubprogram = std::size_t{1} << 20;

/// Whether a program without a head has this name by its file: BORE, or BORE.NC.
bool is_file_of(std::string_view path, std::string_view name) {
  const std::string_view file = path.substr(path.find_last_of("/\\") + 1);
  return !name.empty() && (file == name || file.substr(0, file.rfind('.')) == name);
}

/// `./` is how people and programs write "this folder"; messages are better off without it.
std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() || folder == "." ? name : folder + "/" + name;
}

/// Whether a text has a program of this key.
bool has_program_of(std::string_view text, const ProgramKey& key) {
  const syntax::Tree tree = parse(text);
  return std::ranges::any_of(
      tree.programs, [&](const syntax::Program& program) { return key_in(text, program) == key; });
}

/// The text of a file as a control reads it.
std::string as_read(std::string text) {
  source::use_line_feeds(text);
  return from_tape_code(std::move(text));
}

}  // namespace

ProgramLibrary::File* ProgramLibrary::load(const std::string& path) {
  if (const auto known = loaded_.find(path); known != loaded_.end()) {
    return known->second.get();
  }
  auto text = files_->read(path);
  if (!text || text->size() >= std::numeric_limits<std::uint32_t>::max()) {
    return nullptr;
  }
  auto file = std::make_unique<File>();
  file->path = path;
  file->source = &sources_->whole(path, as_read(*std::move(text)));
  read_tree(*file);
  return loaded_.emplace(path, std::move(file)).first->second.get();
}

void ProgramLibrary::read_tree(File& file) {
  file.tree = parse(file.source->text());
  for (std::size_t i = 0; i < file.tree.programs.size(); ++i) {
    file.places.emplace(key_in(file.source->text(), file.tree.programs[i]), i);
  }
}

ProgramLibrary::Added ProgramLibrary::add_file(const std::string& path) {
  const bool is_main = main_path_.empty();
  if (is_main) {
    main_path_ = path;
    main_bytes_ = files_->size(path).value_or(0);
    if (main_bytes_ > kWholeFileBytes &&
        !is_tape_code(files_->read_part(path, 0, kLook).value_or(""))) {
      windows_ = std::make_unique<ProgramWindows>(*sources_, path, main_bytes_);
      return Added::Yes;
    }
  }
  File* const file = load(path);
  if (file == nullptr) {
    return Added::Unreadable;
  }
  if (!is_main) {
    further_files_.push_back(path);
    for (const auto& [key, place] : file->places) {
      in_further_files_.emplace(key, file);
    }
  }
  return Added::Yes;
}

void ProgramLibrary::start_over() {
  ProgramLibrary fresh(*sources_);
  fresh.profile_ = profile_;
  fresh.loaded_ = std::move(loaded_);
  *this = std::move(fresh);
}

void ProgramLibrary::add_folder(const std::string& folder) {
  Folder added;
  added.path = folder;
  for (const std::string& name : files_->list(folder)) {
    if (const auto number = number_in_file_name(name)) {
      added.by_name.emplace(*number, name);
    } else {
      added.unnamed.push_back({name, std::nullopt});
    }
  }
  folders_.push_back(std::move(added));
}

CompiledProgram* ProgramLibrary::compiled(File& file, std::size_t which) {
  auto& slot = file.compiled[which];
  if (slot == nullptr) {
    slot = std::make_unique<CompiledProgram>(compile(*file.source, file.tree, which, *profile_));
  }
  return slot.get();
}

const CompiledProgram* ProgramLibrary::main_program() {
  if (windows_ != nullptr) {
    if (const CompiledProgram* const first = windows_->next(*profile_)) {
      main_key_ = first->key;
      main_name_ = location_in(*first, first->tree->programs.front().name);
      return first;
    }
  }
  return whole_main();
}

const source::SourceFile* ProgramLibrary::main_text() {
  return main_path_.empty() ? nullptr : text_of(main_path_);
}

const source::SourceFile* ProgramLibrary::text_of(const std::string& path) {
  const File* const loaded = load(path);
  return loaded != nullptr ? loaded->source : nullptr;
}

std::vector<const CompiledProgram*> ProgramLibrary::programs_of(const std::string& path) {
  std::vector<const CompiledProgram*> all;
  if (File* const file = load(path)) {
    for (std::size_t i = 0; i < file->tree.programs.size(); ++i) {
      all.push_back(compiled(*file, i));
    }
  }
  return all;
}

const CompiledProgram* ProgramLibrary::whole_main() {
  File* const loaded = main_path_.empty() ? nullptr : load(main_path_);
  return loaded != nullptr ? first_of(*loaded) : nullptr;
}

/// The first program of a file; nullptr: there is none.
CompiledProgram* ProgramLibrary::first_of(File& file) {
  const auto& programs = file.tree.programs;
  // An O number without blocks before the real program is what some editors leave behind.
  const auto real = std::ranges::find_if(programs, [](const auto& p) { return p.block_count > 1; });
  if (real != programs.end()) {
    return compiled(file, static_cast<std::size_t>(real - programs.begin()));
  }
  return programs.empty() ? nullptr : compiled(file, 0);
}

std::optional<ProgramPlace> ProgramLibrary::behind(const CompiledProgram& program) {
  if (program.extent == Extent::Whole) {
    return std::nullopt;
  }
  const auto steps = static_cast<syntax::Index>(program.steps.size());
  if (const CompiledProgram* const next = windows_->next(*profile_)) {
    return ProgramPlace{next, 0};
  }
  if (windows_->must_be_whole()) {
    return in_whole({&program, steps});
  }
  return std::nullopt;
}

std::optional<ProgramPlace> ProgramLibrary::in_whole(const ProgramPlace& place) {
  if (place.program->extent == Extent::Whole) {
    return place;
  }
  const CompiledProgram* const whole = whole_main();
  return whole != nullptr
             ? std::optional(ProgramPlace{whole, windows_->steps_before() + place.step})
             : std::nullopt;
}

void ProgramLibrary::look_behind_main() {
  const bool may_be_there =
      windows_ != nullptr && (windows_->has_more() || windows_->must_be_whole());
  if (!may_be_there || main_key_.is_empty() || known_.contains(main_key_)) {
    return;
  }
  const auto& all = main_beginnings();
  const auto second = all.empty() ? all.end()
                                  : std::ranges::find(std::next(all.begin()), all.end(), main_key_,
                                                      &ProgramBeginning::key);
  if (second != all.end()) {
    reports_.push_back(
        make_diagnostic(source::DiagnosticId::ProgramTwice, main_name_,
                        fmt::format("{} appears twice: this one is used, not that of line {}",
                                    to_text(main_key_), second->line)));
  }
}

/// Says which of two programs of one number or name is taken.
/// @param name  where that one says it
void ProgramLibrary::report_twice(const CompiledProgram& taken, syntax::ShortSpan name,
                                  const std::string& other) {
  reports_.push_back(make_diagnostic(
      source::DiagnosticId::ProgramTwice, location_in(taken, name),
      fmt::format("{} appears twice: this one is used, not {}", to_text(taken.key), other)));
}

const CompiledProgram* ProgramLibrary::find_in(File& file, const ProgramKey& key) {
  const auto& programs = file.tree.programs;
  const auto [first, end] = file.places.equal_range(key);
  if (first == end) {
    return nullptr;
  }
  const CompiledProgram* const found = compiled(file, first->second);
  if (const auto second = std::next(first); second != end) {
    const auto other = sources_->show(file.source->at(programs[second->second].name.widened()));
    report_twice(*found, programs[first->second].name, fmt::format("that of line {}", other.line));
  }
  return found;
}

/// The first program of a file that has this name.
const CompiledProgram* ProgramLibrary::find_by_file(const std::string& path,
                                                    const std::string& name) {
  File* const file = is_file_of(path, name) ? load(path) : nullptr;
  CompiledProgram* const found = file != nullptr ? first_of(*file) : nullptr;
  if (found != nullptr && found->key.is_empty()) {
    found->key.name = name;
  }
  return found;
}

/// The program of this number in a file whose name says so; one without an O word has it by that.
const CompiledProgram* ProgramLibrary::load_from(Folder& folder, const std::string& name,
                                                 int number) {
  File* const file = load(joined(folder.path, name));
  if (file == nullptr) {
    return nullptr;
  }
  const CompiledProgram* const found = find_in(*file, {number, {}});
  const bool is_unnumbered =
      found == nullptr && file->tree.programs.size() == 1 && file->tree.programs[0].number == 0;
  return is_unnumbered ? compiled(*file, 0) : found;
}

const CompiledProgram* ProgramLibrary::find_in(Folder& folder, const ProgramKey& key) {
  const auto named = folder.by_name.equal_range(key.number);
  const CompiledProgram* found = nullptr;
  for (auto it = named.first; it != named.second; ++it) {
    const CompiledProgram* const here = load_from(folder, it->second, key.number);
    if (here != nullptr && found != nullptr) {
      report_twice(*found, {0, 1}, it->second);
    }
    found = found == nullptr ? here : found;
  }
  found = found != nullptr ? found : find_in_unnamed(folder, key);
  for (std::size_t i = 0; i < folder.unnamed.size() && found == nullptr; ++i) {
    found = find_by_file(joined(folder.path, folder.unnamed[i].name), key.name);
  }
  return found;
}

/// Whether a file whose name says no number has such a program.  It is read as a program only for
/// those that it writes.
bool ProgramLibrary::has_program(UnnamedFile& file, const std::string& path,
                                 const ProgramKey& key) {
  if (file.heads && !file.heads->may_have(key)) {
    return false;
  }
  const auto bytes = files_->size(path);
  auto text = bytes ? files_->read_part(path, 0, *bytes) : std::nullopt;
  if (!text) {
    return true;  // whether it can be read whole is seen when it is loaded
  }
  *text = as_read(*std::move(text));
  if (!file.heads) {
    file.heads.emplace(*text);
  }
  return file.heads->may_have(key) && has_program_of(*text, key);
}

/// The program of this number or name in files whose names say none.  A second one is told, where
/// its file is no longer than subprograms are.
const CompiledProgram* ProgramLibrary::find_in_unnamed(Folder& folder, const ProgramKey& key) {
  const CompiledProgram* found = nullptr;
  for (UnnamedFile& unnamed : folder.unnamed) {
    const std::string path = joined(folder.path, unnamed.name);
    const bool is_too_long =
        found != nullptr && files_->size(path).value_or(0) > kLongestSubprogram;
    File* const file = !is_too_long && has_program(unnamed, path, key) ? load(path) : nullptr;
    if (file == nullptr || !file->places.contains(key)) {
      continue;
    }
    if (found != nullptr) {
      report_twice(*found, {0, 1}, unnamed.name);
      break;
    }
    found = find_in(*file, key);
  }
  return found;
}

const std::vector<ProgramBeginning>& ProgramLibrary::main_beginnings() {
  if (!main_beginnings_) {
    main_beginnings_ = program_beginnings(*files_, main_path_, main_bytes_);
  }
  return *main_beginnings_;
}

/// A further program of a long main file, by itself, so that the file need not be in memory for it.
/// @returns nullptr: only the whole file tells
const CompiledProgram* ProgramLibrary::find_alone(const ProgramKey& key) {
  const auto& all = main_beginnings();
  const auto here = std::ranges::find(all, key, &ProgramBeginning::key);
  const bool is_there_once = std::ranges::count(all, key, &ProgramBeginning::key) == 1;
  if (!is_there_once || here == all.begin() || here->is_behind_percent_sign) {
    return nullptr;
  }
  const std::uint64_t end = here + 1 == all.end() ? main_bytes_ : (here + 1)->offset;
  const std::uint64_t length = end - here->offset;
  auto text = length < std::numeric_limits<std::uint32_t>::max()
                  ? files_->read_part(main_path_, here->offset, length)
                  : std::nullopt;
  if (!text) {
    return nullptr;
  }
  auto alone = std::make_unique<Alone>(
      Alone{sources_->window(main_path_, here->offset, here->line, *std::move(text)), {}});
  alone->file.source = &alone->text;
  read_tree(alone->file);
  const auto& programs = alone->file.tree.programs;
  if (programs.size() != 1 || key_in(alone->text.text(), programs.front()) != key) {
    return nullptr;
  }
  alone_.push_back(std::move(alone));
  return compiled(alone_.back()->file, 0);
}

const CompiledProgram* ProgramLibrary::find_in_main(const ProgramKey& key) {
  const bool is_long = windows_ != nullptr;
  if (is_long && main_beginnings().size() < 2 && main_key_ != key) {
    return find_by_file(main_path_, key.name);
  }
  if (const CompiledProgram* const alone = is_long ? find_alone(key) : nullptr) {
    return alone;
  }
  return main_path_.empty() ? nullptr : find_in(main_path_, key);
}

/// By what a program of a file says, or by the name of the file.
const CompiledProgram* ProgramLibrary::find_in(const std::string& path, const ProgramKey& key) {
  File* const file = load(path);
  const CompiledProgram* const found = file != nullptr ? find_in(*file, key) : nullptr;
  return found != nullptr ? found : find_by_file(path, key.name);
}

/// The first of them that has the program; one has a name as its file's, too.
const CompiledProgram* ProgramLibrary::find_in_further_files(const ProgramKey& key) {
  if (key.name.empty()) {
    const auto file = in_further_files_.find(key);
    return file != in_further_files_.end() ? find_in(*file->second, key) : nullptr;
  }
  const CompiledProgram* found = nullptr;
  for (std::size_t i = 0; i < further_files_.size() && found == nullptr; ++i) {
    found = find_in(further_files_[i], key);
  }
  return found;
}

const CompiledProgram* ProgramLibrary::find(const ProgramKey& key) {
  if (key.is_empty()) {
    return nullptr;  // O0000 may begin a text, and nothing can call it
  }
  const auto known = known_.find(key);
  if (known != known_.end()) {
    return known->second;
  }
  const CompiledProgram* found = find_in_main(key);
  found = found != nullptr ? found : find_in_further_files(key);
  for (std::size_t i = 0; i < folders_.size() && found == nullptr; ++i) {
    found = find_in(folders_[i], key);
  }
  known_[key] = found;
  return found;
}

}  // namespace g31::fanuc

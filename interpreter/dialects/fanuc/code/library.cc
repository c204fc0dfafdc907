#include "interpreter/dialects/fanuc/code/library.h"

#include <algorithm>
#include <charconv>
#include <iterator>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/dialects/fanuc/text/scanner.h"
#include "interpreter/dialects/fanuc/text/tape_code.h"

namespace g31::fanuc {
namespace {

/// So much of a long file tells its code.
constexpr std::size_t kLook = 4096;

/// Longer files are not read only to see whether they hold a program that was found already.
constexpr std::size_t kLongestSubprogram = std::size_t{1} << 20;

/// The program number that a file name says: optional O, digits, optional ending.
std::optional<int> number_in_name(std::string_view name) {
  const std::string_view stem = name.substr(0, name.find('.'));
  const std::size_t skip = !stem.empty() && (stem[0] == 'O' || stem[0] == 'o') ? 1 : 0;
  const std::string_view digits = stem.substr(skip);
  int number = 0;
  const auto end = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool whole = !digits.empty() && end.ec == std::errc() && end.ptr == digits.end();
  return whole && number > 0 ? std::optional(number) : std::nullopt;
}

/// Whether a text has this number behind an O or a colon anywhere.  Where it has not, no program of
/// it has the number.
bool writes_number(std::string_view text, int number) {
  constexpr std::string_view kBegins = "Oo:";
  constexpr int kMost = 99'999'999;
  for (std::size_t at = text.find_first_of(kBegins); at != std::string_view::npos;
       at = text.find_first_of(kBegins, at + 1)) {
    int here = 0;
    for (std::size_t i = at + 1; i < text.size() && here <= kMost; ++i) {
      if (!is_digit(text[i]) && !counts_for_nothing(text[i])) {
        break;
      }
      here = is_digit(text[i]) ? 10 * here + (text[i] - '0') : here;
    }
    if (here == number) {
      return true;
    }
  }
  return false;
}

/// JSON and HTML, as g31 itself leaves them beside programs whose numbers they name.
bool is_document(std::string_view text) {
  const std::size_t first = text.find_first_not_of(" \t\r\n");
  return first != std::string_view::npos && (text[first] == '{' || text[first] == '<');
}

/// `./` is how people and programs write "this folder"; messages are better off without it.
std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() || folder == "." ? name : folder + "/" + name;
}

/// A file whose lines end with CR alone, as old computers and EIA readers leave it: a control knows
/// LF only, so without this the whole file would be one block.
void use_line_feeds(std::string& text) {
  if (text.find('\n') == std::string::npos) {
    std::ranges::replace(text, '\r', '\n');
  }
}

/// Whether a file of this text has a program of this number.
bool has_program(std::string text, int number) {
  if (is_document(text)) {
    return false;
  }
  use_line_feeds(text);
  text = from_tape_code(std::move(text));
  const auto has_number = [number](const syntax::Program& p) { return p.number == number; };
  return writes_number(text, number) && std::ranges::any_of(parse(text).programs, has_number);
}

}  // namespace

ProgramLibrary::File* ProgramLibrary::load(const std::string& path) {
  for (const auto& file : loaded_) {
    if (file->path == path) {
      return file.get();
    }
  }
  auto text = files_.read(path);
  if (!text || text->size() >= std::numeric_limits<std::uint32_t>::max()) {
    return nullptr;
  }
  use_line_feeds(*text);
  auto file = std::make_unique<File>();
  file->path = path;
  file->source = &sources_.whole(path, from_tape_code(*std::move(text)));
  file->tree = parse(file->source->text());
  loaded_.push_back(std::move(file));
  return loaded_.back().get();
}

ProgramLibrary::Added ProgramLibrary::add_file(const std::string& path) {
  const bool is_main = main_path_.empty();
  if (is_main) {
    main_path_ = path;
    main_bytes_ = files_.size(path).value_or(0);
    if (main_bytes_ > kWholeFileBytes &&
        !is_tape_code(files_.read_part(path, 0, kLook).value_or(""))) {
      windows_ = std::make_unique<ProgramWindows>(sources_, path, main_bytes_);
      return Added::Yes;
    }
  }
  if (load(path) == nullptr) {
    return Added::Unreadable;
  }
  if (!is_main) {
    further_files_.push_back(path);
  }
  return Added::Yes;
}

void ProgramLibrary::add_folder(const std::string& folder) {
  Folder added;
  added.path = folder;
  for (const std::string& name : files_.list(folder)) {
    if (const auto number = number_in_name(name)) {
      added.by_name.emplace(*number, name);
    } else {
      added.unnamed.push_back(name);
    }
  }
  folders_.push_back(std::move(added));
}

const CompiledProgram* ProgramLibrary::compiled(File& file, std::size_t which) {
  auto& slot = file.compiled[which];
  if (slot == nullptr) {
    slot = std::make_unique<CompiledProgram>(compile(*file.source, file.tree, which, *profile_));
  }
  return slot.get();
}

const CompiledProgram* ProgramLibrary::main_program() {
  if (windows_ != nullptr) {
    if (const CompiledProgram* const first = windows_->next(*profile_)) {
      main_number_ = first->number;
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
  if (loaded == nullptr) {
    return nullptr;
  }
  File& file = *loaded;
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
  if (!may_be_there || main_number_ == 0 || known_.contains(main_number_)) {
    return;
  }
  const auto& all = main_beginnings();
  const auto second = all.empty() ? all.end()
                                  : std::ranges::find(std::next(all.begin()), all.end(),
                                                      main_number_, &ProgramBeginning::number);
  if (second != all.end()) {
    reports_.push_back(
        make_diagnostic(source::DiagnosticId::ProgramTwice, main_name_,
                        fmt::format("O{:04} appears twice: this one is used, not that of line {}",
                                    main_number_, second->line)));
  }
}

/// Says which of two programs of one number is taken.
/// @param name  where that one says its number
void ProgramLibrary::report_twice(const CompiledProgram& taken, syntax::ShortSpan name,
                                  const std::string& other) {
  reports_.push_back(make_diagnostic(
      source::DiagnosticId::ProgramTwice, location_in(taken, name),
      fmt::format("O{:04} appears twice: this one is used, not {}", taken.number, other)));
}

const CompiledProgram* ProgramLibrary::find_in(File& file, int number) {
  const auto& programs = file.tree.programs;
  const auto has_number = [number](const syntax::Program& p) { return p.number == number; };
  const auto first = std::ranges::find_if(programs, has_number);
  if (first == programs.end()) {
    return nullptr;
  }
  const CompiledProgram* const found =
      compiled(file, static_cast<std::size_t>(first - programs.begin()));
  const auto second = std::find_if(first + 1, programs.end(), has_number);
  if (number != 0 && second != programs.end()) {
    const auto other = sources_.show(file.source->at(second->name.widened()));
    report_twice(*found, first->name, fmt::format("that of line {}", other.line));
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
  const CompiledProgram* const found = find_in(*file, number);
  const bool is_unnumbered =
      found == nullptr && file->tree.programs.size() == 1 && file->tree.programs[0].number == 0;
  return is_unnumbered ? compiled(*file, 0) : found;
}

const CompiledProgram* ProgramLibrary::find_in(Folder& folder, int number) {
  const auto named = folder.by_name.equal_range(number);
  const CompiledProgram* found = nullptr;
  for (auto it = named.first; it != named.second; ++it) {
    const CompiledProgram* const here = load_from(folder, it->second, number);
    if (here != nullptr && found != nullptr) {
      report_twice(*found, {0, 1}, it->second);
    }
    found = found == nullptr ? here : found;
  }
  return found != nullptr ? found : find_in_unnamed(folder, number);
}

/// The program of this number in files whose names say none.  A second one is told, where its file
/// is no longer than subprograms are.
const CompiledProgram* ProgramLibrary::find_in_unnamed(const Folder& folder, int number) {
  const CompiledProgram* found = nullptr;
  for (const std::string& name : folder.unnamed) {
    const std::string path = joined(folder.path, name);
    if (found != nullptr && files_.size(path).value_or(0) > kLongestSubprogram) {
      continue;
    }
    // Looked into first: a file that does not have it is not read as a program.
    const auto bytes = files_.size(path);
    auto look = bytes ? files_.read_part(path, 0, *bytes) : std::nullopt;
    if (look && !has_program(*std::move(look), number)) {
      continue;
    }
    File* const file = load(path);
    if (file == nullptr) {
      continue;
    }
    const auto& programs = file->tree.programs;
    const auto here = std::ranges::find(programs, number, &syntax::Program::number);
    if (here == programs.end()) {
      continue;
    }
    if (found != nullptr) {
      report_twice(*found, {0, 1}, name);
      break;
    }
    found = find_in(*file, number);
  }
  return found;
}

const std::vector<ProgramBeginning>& ProgramLibrary::main_beginnings() {
  if (!main_beginnings_) {
    main_beginnings_ = program_beginnings(files_, main_path_, main_bytes_);
  }
  return *main_beginnings_;
}

/// A further program of a long main file, by itself, so that the file need not be in memory for it.
/// @returns nullptr: only the whole file tells
const CompiledProgram* ProgramLibrary::find_alone(int number) {
  const auto& all = main_beginnings();
  const auto here = std::ranges::find(all, number, &ProgramBeginning::number);
  const bool is_there_once = std::ranges::count(all, number, &ProgramBeginning::number) == 1;
  if (!is_there_once || here == all.begin() || here->is_behind_percent_sign) {
    return nullptr;
  }
  const std::uint64_t end = here + 1 == all.end() ? main_bytes_ : (here + 1)->offset;
  const std::uint64_t length = end - here->offset;
  auto text = length < std::numeric_limits<std::uint32_t>::max()
                  ? files_.read_part(main_path_, here->offset, length)
                  : std::nullopt;
  if (!text) {
    return nullptr;
  }
  auto alone = std::make_unique<Alone>(
      Alone{sources_.window(main_path_, here->offset, here->line, *std::move(text)), {}});
  alone->file.source = &alone->text;
  alone->file.tree = parse(alone->text.text());
  const auto& programs = alone->file.tree.programs;
  if (programs.size() != 1 || programs.front().number != number) {
    return nullptr;
  }
  alone_.push_back(std::move(alone));
  return compiled(alone_.back()->file, 0);
}

const CompiledProgram* ProgramLibrary::find_in_main(int number) {
  const bool is_long = windows_ != nullptr;
  if (is_long && main_beginnings().size() < 2 && main_number_ != number) {
    return nullptr;
  }
  if (const CompiledProgram* const alone = is_long ? find_alone(number) : nullptr) {
    return alone;
  }
  File* const file = main_path_.empty() ? nullptr : load(main_path_);
  return file != nullptr ? find_in(*file, number) : nullptr;
}

const CompiledProgram* ProgramLibrary::find(int number) {
  const auto known = known_.find(number);
  if (known != known_.end()) {
    return known->second;
  }
  const CompiledProgram* found = find_in_main(number);
  for (std::size_t i = 0; i < further_files_.size() && found == nullptr; ++i) {
    found = find_in(*load(further_files_[i]), number);
  }
  for (std::size_t i = 0; i < folders_.size() && found == nullptr; ++i) {
    found = find_in(folders_[i], number);
  }
  known_[number] = found;
  return found;
}

}  // namespace g31::fanuc

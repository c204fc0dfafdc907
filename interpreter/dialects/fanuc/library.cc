#include "interpreter/dialects/fanuc/library.h"

#include <algorithm>
#include <charconv>
#include <limits>

#include "interpreter/dialects/fanuc/parse.h"

namespace g31::fanuc {
namespace {

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

/// `./` is how people and programs write "this folder"; messages are better off without it.
std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() || folder == "." ? name : folder + "/" + name;
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
  auto file = std::make_unique<File>();
  file->path = path;
  file->source = std::make_unique<source::SourceFile>(path, *std::move(text));
  file->tree = parse(file->source->text());
  loaded_.push_back(std::move(file));
  return loaded_.back().get();
}

const source::SourceFile* ProgramLibrary::add_file(const std::string& path) {
  const File* const file = load(path);
  return file != nullptr ? file->source.get() : nullptr;
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
  if (loaded_.empty()) {
    return nullptr;
  }
  File& file = *loaded_.front();
  const auto& programs = file.tree.programs;
  // An O number without blocks before the real program is what some editors leave behind.
  const auto real = std::ranges::find_if(programs, [](const auto& p) { return p.block_count > 1; });
  if (real != programs.end()) {
    return compiled(file, static_cast<std::size_t>(real - programs.begin()));
  }
  return programs.empty() ? nullptr : compiled(file, 0);
}

const CompiledProgram* ProgramLibrary::find_in(File& file, int number) {
  const auto& programs = file.tree.programs;
  for (std::size_t i = 0; i < programs.size(); ++i) {
    if (programs[i].number == number) {
      return compiled(file, i);
    }
  }
  return nullptr;
}

const CompiledProgram* ProgramLibrary::find_in(Folder& folder, int number) {
  const auto named = folder.by_name.equal_range(number);
  for (auto it = named.first; it != named.second; ++it) {
    if (File* const file = load(joined(folder.path, it->second))) {
      if (const CompiledProgram* const found = find_in(*file, number)) {
        return found;
      }
      if (file->tree.programs.size() == 1 && file->tree.programs[0].number == 0) {
        return compiled(*file, 0);  // no O word inside: the name is the number
      }
    }
  }
  for (const std::string& name : folder.unnamed) {
    if (File* const file = load(joined(folder.path, name))) {
      if (const CompiledProgram* const found = find_in(*file, number)) {
        return found;
      }
    }
  }
  return nullptr;
}

const CompiledProgram* ProgramLibrary::find(int number) {
  const auto known = known_.find(number);
  if (known != known_.end()) {
    return known->second;
  }
  const CompiledProgram* found = nullptr;
  const std::size_t given = loaded_.size();
  for (std::size_t i = 0; i < given && found == nullptr; ++i) {
    found = find_in(*loaded_[i], number);
  }
  for (std::size_t i = 0; i < folders_.size() && found == nullptr; ++i) {
    found = find_in(folders_[i], number);
  }
  known_[number] = found;
  return found;
}

}  // namespace g31::fanuc

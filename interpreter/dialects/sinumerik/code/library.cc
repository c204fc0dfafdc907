#include "interpreter/dialects/sinumerik/code/library.h"

#include <algorithm>
#include <iterator>
#include <system_error>
#include <utility>

namespace g31::sinumerik {
namespace {

std::string joined(const std::string& folder, const std::string& name) {
  return folder.empty() ? name : folder + "/" + name;
}

/// SMAC, MMAC, UMAC: read before SGUD, MGUD, UGUD and GUD4 to GUD9, which may use their macros
/// (Programming Manual Job Planning, user-defined data).
bool is_of_macros(const FiledProgram* program) {
  return program->name().stem.ends_with("MAC");
}

/// In one folder of the control's memory, and their files in one folder.
bool lie_beside(const FiledProgram& one, const FiledProgram& other) {
  return one.name().folder == other.name().folder &&
         folder_of(one.source().file->name()) == folder_of(other.source().file->name());
}

}  // namespace

std::filesystem::path folder_of(const std::string& path) {
  std::error_code unknown;
  return std::filesystem::absolute(path, unknown).lexically_normal().parent_path();
}

FiledProgram* best_of(const ProgramList& programs, const ProgramName& name,
                      const std::vector<std::string>& folders) {
  const auto rank = [&](const FiledProgram& program) {
    return std::ranges::find_if(folders, [&](const std::string& folder) {
      return !folder.empty() && folder == program.name().folder;
    });
  };
  const auto goes_before = [&](const FiledProgram& program, const FiledProgram& other) {
    const auto place = rank(program) - rank(other);
    return place < 0 || (place == 0 && is_subprogram(program) && !is_subprogram(other) &&
                         lie_beside(program, other));
  };
  FiledProgram* best = nullptr;
  for (FiledProgram* const program : programs) {
    const bool fits =
        name.suffix.empty() ? is_callable(program->name()) : program->name().suffix == name.suffix;
    if (fits && (best == nullptr || goes_before(*program, *best))) {
      best = program;
    }
  }
  return best;
}

bool is_subprogram(const FiledProgram& program) {
  return program.name().suffix == "SPF";
}

ProgramFile* ProgramLibrary::file(const std::string& path) {
  const std::lock_guard lock(read_mutex_);
  const auto [place, is_new] = read_.try_emplace(path);
  if (is_new) {
    if (auto text = source::read_program(sources_.files(), path)) {
      place->second =
          std::make_unique<ProgramFile>(sources_.whole(path, *std::move(text)), is_shipped(path));
    }
  }
  return place->second.get();
}

bool ProgramLibrary::is_shipped(const std::string& path) const {
  return !shipped_folder_.empty() && path.starts_with(shipped_folder_ + "/");
}

ProgramLibrary::Added ProgramLibrary::add_file(const std::string& path) {
  ProgramFile* const added = file(path);
  if (added == nullptr) {
    return Added::Unreadable;
  }
  main_text_ = main_text_ == nullptr ? &added->text() : main_text_;
  opened_.insert(path);
  open(*added, false);
  return Added::Yes;
}

void ProgramLibrary::add_folder(const std::string& folder) {
  std::multimap<std::string, std::string> known;
  for (const std::string& name : sources_.files().list(folder)) {
    const ProgramName parts = program_name(name);
    const std::string path = joined(folder, name);
    if (is_definition(parts)) {
      // A user's PGUD seldom has all that the shipped one has: that fills in what is missing.
      const bool counts = !is_opened(path) && (is_shipped(path) || is_new_definition(parts));
      ProgramFile* const added = counts ? file(path) : nullptr;
      if (added != nullptr && holds_definitions(parts, added->text().text())) {
        add_file(path);
      }
    } else if (parts.suffix == "ARC") {
      archives_.push_back(path);
      ProgramFile* const archive = is_opened(path) ? nullptr : file(path);
      if (archive != nullptr) {
        open(*archive, true);
      }
    } else if (!parts.suffix.empty()) {
      known.emplace(parts.stem, path);
    }
  }
  folders_.push_back(std::move(known));
}

void ProgramLibrary::add_definitions(std::span<const std::string> files) {
  for (const std::string& path : files) {
    ProgramFile* const added = is_opened(path) ? nullptr : file(path);
    if (added != nullptr) {
      open(*added, true);
    }
  }
}

void ProgramLibrary::add_shipped_folder(const std::string& folder) {
  shipped_folder_ = folder;
  add_folder(folder);
}

/// As with programs, the first one of a name counts.
bool ProgramLibrary::is_new_definition(const ProgramName& name) const {
  return is_definition(name) && best_of(opened(name.stem), name, {}) == nullptr;
}

void ProgramLibrary::open(ProgramFile& file, bool only_definitions) {
  for (const auto& program : file.programs()) {
    if (!only_definitions || is_new_definition(program->name())) {
      by_stem_[program->name().stem].push_back(program.get());
      programs_.push_back(program.get());
    }
  }
}

const std::vector<const CompiledProgram*>& ProgramLibrary::definitions() {
  std::call_once(defined_, [&] {
    ProgramList files;
    std::ranges::copy_if(programs_, std::back_inserter(files), [](const FiledProgram* program) {
      return is_definition(program->name());
    });
    std::stable_partition(files.begin(), files.end(), is_of_macros);
    // What a user's files define is known when those that come with the control have their turn.
    std::stable_partition(files.begin(), files.end(), [](const FiledProgram* program) {
      return !program->source().is_shipped;
    });
    for (FiledProgram* const file : files) {
      definitions_.push_back(&file->define_in(globals_));
    }
    define_missing(data_, globals_);
    shorten_memory(data_, globals_);
    if (are_main_variables_global(data_)) {
      offer_main_variables();
    }
  });
  return definitions_;
}

void ProgramLibrary::offer_main_variables() {
  FiledProgram* const main = any_leads_ ? nullptr : main_program();
  for (FiledProgram* const program : programs_) {
    const bool may_lead = any_leads_ && program->name().suffix == "MPF";
    if (program == main || may_lead) {
      program->lead(globals_);
    }
  }
}

void ProgramLibrary::expect_axes(const std::map<std::string, char>& names) {
  for (const auto& [name, letter] : names) {
    globals_.axis_names[upper(name)] = axis_named(std::string_view(&letter, 1));
  }
}

std::vector<const CompiledProgram*> ProgramLibrary::initial_data() {
  std::vector<const CompiledProgram*> all;
  for (FiledProgram* const program : programs_) {
    if (is_data(program->name())) {
      all.push_back(&program->code(globals_));
    }
  }
  return all;
}

const source::SourceFile* ProgramLibrary::main_text() const {
  return main_text_;
}

FiledProgram* ProgramLibrary::main_program() const {
  FiledProgram* first = nullptr;
  for (FiledProgram* const program : programs_) {
    if (program->source().file != main_text_ || !is_callable(program->name())) {
      continue;
    }
    if (program->name().suffix == "MPF") {
      return program;
    }
    first = first == nullptr ? program : first;
  }
  return first;
}

const ProgramList& ProgramLibrary::opened(std::string_view stem) const {
  static const ProgramList kNone;
  const auto found = by_stem_.find(stem);
  return found != by_stem_.end() ? found->second : kNone;
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/callable_programs.h"

namespace g31::sinumerik {

const CompiledProgram* CallablePrograms::main_program() {
  FiledProgram* const main = library_.main_program();
  if (main == nullptr) {
    return nullptr;
  }
  const ShortSpan text = main->source().text;
  if (text.end - text.begin <= kWholeProgramBytes) {
    return &main->code(globals());
  }
  windows_ = std::make_unique<ProgramWindows>(*main, globals());
  return windows_->next().program;
}

bool CallablePrograms::is_loaded(const std::string& path) const {
  return library_.is_opened(path) || loaded_.contains(path);
}

void CallablePrograms::load(const std::string& path) {
  loaded_.insert(path);
  if (ProgramFile* const file = library_.file(path)) {
    for (const auto& program : file->programs()) {
      by_stem_[program->name().stem].push_back(program.get());
    }
  }
}

/// Reads the next file that may hold the program.  @returns whether there was one
bool CallablePrograms::load_for(const ProgramName& name) {
  for (const auto& folder : library_.folders()) {
    const auto [first, last] = folder.equal_range(name.stem);
    for (auto file = first; file != last; ++file) {
      if (!is_loaded(file->second)) {
        load(file->second);
        return true;
      }
    }
  }
  if (next_archive_ == library_.archives().size()) {
    return false;
  }
  const std::string& archive = library_.archives()[next_archive_++];
  if (!is_loaded(archive)) {
    load(archive);
  }
  return true;
}

FiledProgram* CallablePrograms::find_loaded(const ProgramName& name, const Near& near) {
  // From the best place to the worst; where none fits, any does.
  const std::vector<std::string> folders = {name.folder, near.caller, "SPF_DIR", near.call_path};
  const auto own = by_stem_.find(name.stem);
  if (own == by_stem_.end()) {
    return best_of(library_.opened(name.stem), name, folders);
  }
  ProgramList all = library_.opened(name.stem);
  all.insert(all.end(), own->second.begin(), own->second.end());
  return best_of(all, name, folders);
}

/// What ends as a suffix may be the name itself: LASER_ARC of LASER_ARC.SPF.
const CompiledProgram* CallablePrograms::find(std::string_view written, const Near& near) {
  const ProgramName name = program_name(written);
  const CompiledProgram* const program = find_named(name, near);
  if (program != nullptr || name.suffix.empty()) {
    return program;
  }
  return find_named({name.stem + "_" + name.suffix, "", name.folder}, near);
}

/// Reads the files of that stem in the folder of a program.
void CallablePrograms::load_beside(const FiledProgram& program) {
  const std::filesystem::path here = folder_of(program.source().file->name());
  for (const auto& folder : library_.folders()) {
    const auto [first, last] = folder.equal_range(program.name().stem);
    for (auto file = first; file != last; ++file) {
      if (folder_of(file->second) == here && !is_loaded(file->second)) {
        load(file->second);
      }
    }
  }
}

const CompiledProgram* CallablePrograms::find_named(const ProgramName& name, const Near& near) {
  do {
    FiledProgram* program = find_loaded(name, near);
    if (program != nullptr && name.suffix.empty() && !is_subprogram(*program)) {
      load_beside(*program);
      program = find_loaded(name, near);
    }
    if (program != nullptr) {
      return &program->code(globals());
    }
  } while (load_for(name));
  return nullptr;
}

const CompiledProgram* CallablePrograms::written(const std::string& name, const std::string& text) {
  texts_.push_back(library_.sources().passing(name, text));
  const ProgramName parts = program_name(name);
  ProgramSource source{
      parts.stem, texts_.back().get(), {0, static_cast<std::uint32_t>(text.size())}};
  source.type = parts.suffix;
  made_.push_back(compile(source, globals()));
  return made_.back().get();
}

ProgramSource CallablePrograms::loose_source(const std::string& text, const std::string& name) {
  texts_.push_back(library_.sources().passing(name, text));
  return {name, texts_.back().get(), {0, static_cast<std::uint32_t>(text.size())}};
}

const CompiledProgram* CallablePrograms::snippet(const std::string& text,
                                                 const CompiledProgram& home,
                                                 const std::string& name) {
  made_.push_back(compile_among(loose_source(text, name), globals(), home));
  return made_.back().get();
}

const CompiledProgram* CallablePrograms::expression(const std::string& text,
                                                    const CompiledProgram& home) {
  made_.push_back(compile_expression(loose_source(text, kCommandLine), globals(), home));
  return made_.back().get();
}

const CompiledProgram* CallablePrograms::looked_at(const std::string& text,
                                                   const CompiledProgram& home) {
  texts_.push_back(std::make_shared<const source::SourceFile>("", text));
  const ProgramSource source{"", texts_.back().get(), {0, static_cast<std::uint32_t>(text.size())}};
  made_.push_back(compile_expression(source, globals(), home));
  return made_.back().get();
}

}  // namespace g31::sinumerik

#pragma once

#include <filesystem>
#include <map>
#include <memory>
#include <mutex>
#include <set>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/code/program_file.h"
#include "interpreter/dialects/sinumerik/code/sheet_data.h"
#include "interpreter/source/source_map.h"

namespace g31::sinumerik {

/// Programs in the order of their files.
using ProgramList = std::vector<FiledProgram*>;

/// The program with the best place among those of one stem, the first one of equals, a subprogram
/// before a main program that lies beside it (NC programming 12/2019, 3.4.1.4); nullptr: none has
/// the suffix that the name says.
FiledProgram* best_of(const ProgramList& programs, const ProgramName& name,
                      const std::vector<std::string>& folders);

/// Whether it is one by its type, which calls take first.
bool is_subprogram(const FiledProgram& program);
/// The folder of a file, in one spelling.
std::filesystem::path folder_of(const std::string& path);

/// The files of a control's memory, their texts and the code of their programs: what is the same
/// for all sessions.  Files are added first; from then on any number of threads may ask.
///
/// Opened are the files that were added, and of folders what holds definitions and the definitions
/// in archives.  All other files of folders are read when a session first needs them.
class ProgramLibrary {
 public:
  /// @param sources  must outlive the library
  explicit ProgramLibrary(source::SourceMap& sources) : sources_(sources) {}

  enum class Added { Yes, Unreadable };
  Added add_file(const std::string& path);
  /// @returns nothing: a folder that cannot be read has no programs
  void add_folder(const std::string& folder);
  /// Of these files the definitions alone, of names that there are none of yet.
  void add_definitions(std::span<const std::string> files);
  /// As add_folder(), of what comes with the control, behind all others.  Its definition files
  /// leave alone what those of the user define, and count beside files of their name.
  void add_shipped_folder(const std::string& folder);

  /// Reads the definition files, when it is asked for the first time, which ends the adding of
  /// files.  @returns programs that set initial values, to be run first in every session
  const std::vector<const CompiledProgram*>& definitions();

  /// Data of the set-up sheet, to be known before the first session: those that no definition file
  /// brings are defined by their values.
  void expect_data(SheetData data) { data_ = std::move(data); }
  /// Each main program that was added may be the one that runs: for those who look at programs.
  void expect_any_main() { any_leads_ = true; }
  /// What the sheet calls axes beside their letters: "SP1" to 'C'.
  void expect_axes(const std::map<std::string, char>& names);
  /// The INI files: %_N_UFR_INI in an archive that was added, or UFR.INI given by itself.  Loading
  /// them is running them, behind the definitions.
  std::vector<const CompiledProgram*> initial_data();

  /// The first main program of the first file, else its first program; nullptr: there is none.
  [[nodiscard]] FiledProgram* main_program() const;
  /// The text of the first file; nullptr when there is none.
  [[nodiscard]] const source::SourceFile* main_text() const;

  /// The opened programs of this stem.
  [[nodiscard]] const ProgramList& opened(std::string_view stem) const;
  [[nodiscard]] bool is_opened(const std::string& path) const { return opened_.contains(path); }
  /// Files by the stem that their name says, for each folder.
  [[nodiscard]] const std::vector<std::multimap<std::string, std::string>>& folders() const {
    return folders_;
  }
  /// Archives of folders.
  [[nodiscard]] const std::vector<std::string>& archives() const { return archives_; }
  [[nodiscard]] source::SourceMap& sources() const { return sources_; }
  /// A file, read once; nullptr: it cannot be read.
  ProgramFile* file(const std::string& path);

  /// Behind definitions() the same for ever.
  [[nodiscard]] const Globals& globals() const { return globals_; }

 private:
  void open(ProgramFile& file, bool only_definitions);
  void offer_main_variables();
  [[nodiscard]] bool is_shipped(const std::string& path) const;
  [[nodiscard]] bool is_new_definition(const ProgramName& name) const;

  source::SourceMap& sources_;
  Globals globals_;
  ProgramList programs_;  ///< opened
  std::map<std::string, ProgramList, std::less<>> by_stem_;
  const source::SourceFile* main_text_ = nullptr;
  std::set<std::string> opened_;  ///< paths
  std::vector<std::multimap<std::string, std::string>> folders_;
  std::string shipped_folder_;
  std::vector<std::string> archives_;
  SheetData data_;
  bool any_leads_ = false;
  std::once_flag defined_;
  std::vector<const CompiledProgram*> definitions_;
  std::mutex read_mutex_;
  std::map<std::string, std::unique_ptr<ProgramFile>> read_;  ///< nullptr: unreadable
};

}  // namespace g31::sinumerik

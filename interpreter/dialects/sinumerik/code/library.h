#pragma once

#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/program_name.h"
#include "interpreter/dialects/sinumerik/code/program_windows.h"
#include "interpreter/source/file_system.h"

namespace g31::sinumerik {

/// The programs that a run can call, in this order: those of the main file, further files, then
/// folders as they were added.  A file holds one program, or many behind headers %_N_NAME_SPF.
/// Files of a folder are read when they are first needed; definitions at once, those in archives
/// too; INI files never.
///
/// Programs of one name may lie in several folders of the control's memory, which `;$PATH=` behind
/// a header names.  A call takes the one in the folder that it names; else that of the calling
/// program's folder, of SPF_DIR, of CALLPATH, in this order; else the first one.
class ProgramLibrary {
 public:
  /// @param files  must outlive the library
  explicit ProgramLibrary(source::FileSystem& files) : files_(files) {}

  enum class Added { Yes, Unreadable };
  Added add_file(const std::string& path);
  /// @returns nothing: a folder that cannot be read has no programs
  void add_folder(const std::string& folder);

  /// Reads the definition files; to be called once, before anything is run.
  /// @returns programs that set initial values, to be run first
  std::vector<const CompiledProgram*> define();
  /// The INI files: %_N_UFR_INI in an archive that was read, or UFR.INI given by itself.  Loading
  /// them is running them; to be called behind define().
  std::vector<const CompiledProgram*> initial_data();

  /// The first main program of the first file, else its first program; nullptr: there is none.  Of
  /// a long one this is the first window: its EndWindow asks for the next one.
  const CompiledProgram* main_program();
  /// Ends the life of the window before.
  ProgramWindows::Place next_window() { return windows_->next(); }
  /// The text of the first file; nullptr when there is none.
  [[nodiscard]] const source::SourceFile* main_text() const;

  /// Where a call looks beside SPF_DIR.
  struct Near {
    std::string caller;     ///< folder of the calling program
    std::string call_path;  ///< CALLPATH
  };
  /// A program by any form of its name, or nullptr.
  const CompiledProgram* find(std::string_view name, const Near& near);

  /// A file that the run wrote itself, as a program; lives as long as the library.
  const CompiledProgram* written(const std::string& name, const std::string& text);

  /// `text` as blocks among the local variables of `home`; lives as long as the library.
  const CompiledProgram* snippet(const std::string& text, const CompiledProgram& home);
  /// The same of one expression.
  const CompiledProgram* expression(const std::string& text, const CompiledProgram& home);

  [[nodiscard]] const Globals& globals() const { return globals_; }

 private:
  struct Entry {
    ProgramName name;  ///< with the folder of $PATH
    ProgramSource source;
    std::unique_ptr<CompiledProgram> compiled;
  };

  enum class Wanted { Everything, Definitions };
  void take(std::string path, std::string text, Wanted wanted);
  ProgramSource loose_source(const std::string& text);
  const CompiledProgram* begun(Entry& main);
  Entry* find_entry(const ProgramName& name, const Near& near);
  bool load_for(const ProgramName& name);
  const CompiledProgram* compiled(Entry& entry);

  source::FileSystem& files_;
  Globals globals_;
  std::vector<std::unique_ptr<source::SourceFile>> texts_;
  std::vector<std::unique_ptr<Entry>> entries_;
  std::unique_ptr<ProgramWindows> windows_;  ///< of the main program, if it is a long one
  std::map<std::string, std::vector<Entry*>, std::less<>> by_stem_;
  std::vector<std::multimap<std::string, std::string>> folders_;  ///< stem to path
  std::vector<std::string> archives_;                             ///< of folders, not yet read
  std::set<std::string> loaded_;
  std::vector<std::unique_ptr<CompiledProgram>> others_;
};

}  // namespace g31::sinumerik

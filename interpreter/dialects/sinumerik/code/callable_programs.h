#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/sinumerik/code/library.h"
#include "interpreter/dialects/sinumerik/code/program_windows.h"

namespace g31::sinumerik {

/// The programs that one session can call, in this order: those of the main file, further files,
/// then folders as they were added; and those that it makes itself.
///
/// Which program a name means depends on the files that this session has needed before, never on
/// other sessions: texts and code are the library's, the order of looking is the session's own.
///
/// Programs of one name may lie in several folders of the control's memory, which `;$PATH=` behind
/// a header names.  A call takes the one in the folder that it names; else that of the calling
/// program's folder, of SPF_DIR, of CALLPATH, in this order; else the first one.  Of PART.SPF and
/// PART.MPF side by side PART calls the first.
class CallablePrograms {
 public:
  /// @param library  must outlive the programs
  explicit CallablePrograms(ProgramLibrary& library) : library_(library) {}

  /// The main program of the library.  Of a long one this is the first window: its EndWindow asks
  /// for the next one.
  const CompiledProgram* main_program();
  /// Ends the life of the window before.
  ProgramWindows::Place next_window() { return windows_->next(); }
  [[nodiscard]] const source::SourceFile* main_text() const { return library_.main_text(); }

  /// Where a call looks beside SPF_DIR.
  struct Near {
    std::string caller;     ///< folder of the calling program
    std::string call_path;  ///< CALLPATH
  };
  /// A program by any form of its name, or nullptr.
  const CompiledProgram* find(std::string_view name, const Near& near);

  /// A file that the run wrote itself, as a program; lives as long as the session.
  const CompiledProgram* written(const std::string& name, const std::string& text);

  /// What a text is called that no program calls: of [machine_data], [variables] or --set.
  static constexpr const char* kCommandLine = "sheet or command line";

  /// `text` as blocks among the local variables of `home`; lives as long as the session.
  /// @param name  what places in it are shown with
  const CompiledProgram* snippet(const std::string& text, const CompiledProgram& home,
                                 const std::string& name);
  /// The same of one expression.
  const CompiledProgram* expression(const std::string& text, const CompiledProgram& home);
  /// That of who looks from outside: nothing shows places in it, and nothing of the run depends on
  /// its having been read.
  const CompiledProgram* looked_at(const std::string& text, const CompiledProgram& home);

  [[nodiscard]] const Globals& globals() const { return library_.globals(); }

 private:
  ProgramSource loose_source(const std::string& text, const std::string& name);
  const CompiledProgram* find_named(const ProgramName& name, const Near& near);
  FiledProgram* find_loaded(const ProgramName& name, const Near& near);
  bool load_for(const ProgramName& name);
  void load(const std::string& path);
  void load_beside(const FiledProgram& program);
  [[nodiscard]] bool is_loaded(const std::string& path) const;

  ProgramLibrary& library_;
  std::unique_ptr<ProgramWindows> windows_;  ///< of the main program, if it is a long one
  std::map<std::string, ProgramList, std::less<>>
      by_stem_;                   ///< of files that the library has not opened
  std::set<std::string> loaded_;  ///< their paths
  std::size_t next_archive_ = 0;
  std::vector<std::shared_ptr<const source::SourceFile>> texts_;  ///< made by the session
  std::vector<std::unique_ptr<CompiledProgram>> made_;
};

}  // namespace g31::sinumerik

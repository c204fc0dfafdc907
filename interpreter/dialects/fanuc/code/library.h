#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/code/compile.h"
#include "interpreter/dialects/fanuc/code/program_windows.h"
#include "interpreter/dialects/fanuc/code/written_heads.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/source_map.h"

namespace g31::fanuc {

/// A step of a program.
struct ProgramPlace {
  const CompiledProgram* program = nullptr;
  syntax::Index step = 0;
};

/// The programs that a run can call: those of its main file first, then further files, then folders
/// in the order given.  Files are read and compiled when they are first needed.  A long main file
/// is read window by window (ProgramWindows).
class ProgramLibrary {
 public:
  /// @param sources  must outlive the library
  explicit ProgramLibrary(source::SourceMap& sources)
      : sources_(&sources), files_(&sources.files()) {}

  /// Programs are compiled for this control; to be called before any is asked for.
  void compile_for(const Profile& profile) { profile_ = &profile; }

  enum class Added { Yes, Unreadable };

  /// Makes the programs of a file callable.
  Added add_file(const std::string& path);
  /// Files and folders are added anew from here on; what was read of them is kept.
  void start_over();

  /// Programs of this folder become callable.  A file is taken for O1234 when the digits of its
  /// name say so (O1234.nc, 1234, o01234.txt); failing that, when its text begins with O1234.  One
  /// is taken for <BORE> when its text begins so; failing that, when it is called BORE or BORE.NC.
  void add_folder(const std::string& folder);
  /// The same of what comes with g31.
  void add_shipped_folder(const std::string& folder) { add_folder(folder); }

  /// The text of the first file; nullptr when there is none.
  const source::SourceFile* main_text();

  /// The first program of the first file that has blocks or a number; nullptr when there is none.
  const CompiledProgram* main_program();

  /// The text of a file as the control reads it; nullptr: it cannot be read.
  const source::SourceFile* text_of(const std::string& path);

  /// All programs of a file, compiled whole; none of one that cannot be read.
  std::vector<const CompiledProgram*> programs_of(const std::string& path);

  /// Where a program goes on behind its last step: in its next window, or, when windows end here,
  /// in the whole program; nullopt: nowhere.
  std::optional<ProgramPlace> behind(const CompiledProgram& program);

  /// The same place in the whole program, whose labels are all known.
  /// nullopt: the file is too long to be kept whole, or can no longer be read.
  std::optional<ProgramPlace> in_whole(const ProgramPlace& place);

  /// The program O`number` or <`name`>, or nullptr.  @pre !key.is_empty()
  const CompiledProgram* find(const ProgramKey& key);

  /// Looks for a second program of the number or name of a long main program, behind a run that has
  /// ended.
  void look_behind_main();

  /// What has been found twice since the last call: in one file, or in one folder.
  std::vector<source::Diagnostic> take_reports() { return std::exchange(reports_, {}); }
  [[nodiscard]] bool has_reports() const { return !reports_.empty(); }

 private:
  struct File {
    std::string path;
    const source::SourceFile* source = nullptr;
    syntax::Tree tree;
    std::map<std::size_t, std::unique_ptr<CompiledProgram>> compiled;
    std::multimap<ProgramKey, std::size_t> places;  ///< of programs in the tree, by what they say
  };
  /// One program of a long main file.
  struct Alone {
    source::SourceFile text;
    File file;
  };
  /// A file whose name says no number.
  struct UnnamedFile {
    std::string name;
    std::optional<WrittenHeads> heads;  ///< none before it has been looked into
  };
  struct Folder {
    std::string path;
    std::multimap<int, std::string> by_name;
    std::vector<UnnamedFile> unnamed;
  };

  CompiledProgram* compiled(File& file, std::size_t which);
  CompiledProgram* first_of(File& file);
  const CompiledProgram* find_in(File& file, const ProgramKey& key);
  const CompiledProgram* find_in(const std::string& path, const ProgramKey& key);
  const CompiledProgram* find_in(Folder& folder, const ProgramKey& key);
  bool has_program(UnnamedFile& file, const std::string& path, const ProgramKey& key);
  const CompiledProgram* find_in_unnamed(Folder& folder, const ProgramKey& key);
  const CompiledProgram* find_by_file(const std::string& path, const std::string& name);
  File* load(const std::string& path);
  /// Its programs from its source.
  static void read_tree(File& file);
  const CompiledProgram* whole_main();
  const CompiledProgram* find_in_main(const ProgramKey& key);
  const CompiledProgram* find_in_further_files(const ProgramKey& key);
  const CompiledProgram* find_alone(const ProgramKey& key);
  const std::vector<ProgramBeginning>& main_beginnings();
  const CompiledProgram* load_from(Folder& folder, const std::string& name, int number);
  void report_twice(const CompiledProgram& taken, syntax::ShortSpan name, const std::string& other);

  source::SourceMap* sources_;
  source::FileSystem* files_;
  const Profile* profile_ = &profiles().front();
  std::unordered_map<std::string, std::unique_ptr<File>> loaded_;  ///< by path
  std::vector<Folder> folders_;
  std::vector<std::string> further_files_;
  std::map<ProgramKey, File*> in_further_files_;  ///< the first of them that has it
  std::string main_path_;
  std::uint64_t main_bytes_ = 0;
  ProgramKey main_key_;                      ///< of a long main program
  source::Location main_name_;               ///< where it says that
  std::unique_ptr<ProgramWindows> windows_;  ///< of the main file, if it is a long one
  /// Of a long main file, once they are asked for.
  std::optional<std::vector<ProgramBeginning>> main_beginnings_;
  std::vector<std::unique_ptr<Alone>> alone_;
  std::map<ProgramKey, const CompiledProgram*> known_;
  std::vector<source::Diagnostic> reports_;
};

}  // namespace g31::fanuc

#pragma once

#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/fanuc/compile.h"
#include "interpreter/source/file_system.h"

namespace g31::fanuc {

/// The programs that a run can call: those of its main file first, then further files, then folders
/// in the order given.  Files are read and compiled when they are first needed.
class ProgramLibrary {
 public:
  /// @param files  must outlive the library
  explicit ProgramLibrary(source::FileSystem& files) : files_(files) {}

  /// Programs are compiled for this control; to be called before any is asked for.
  void compile_for(const Profile& profile) { profile_ = &profile; }

  /// Reads a file and makes its programs callable; nullptr when it cannot be read.
  const source::SourceFile* add_file(const std::string& path);

  /// Programs of this folder become callable.  A file is taken for O1234 when the digits of its
  /// name say so (O1234.nc, 1234, o01234.txt); failing that, when its text begins with O1234.
  void add_folder(const std::string& folder);

  /// The first program of the first file that has blocks or a number; nullptr when there is none.
  const CompiledProgram* main_program();

  /// The program O`number`, or nullptr.
  const CompiledProgram* find(int number);

 private:
  struct File {
    std::string path;
    std::unique_ptr<source::SourceFile> source;
    syntax::Tree tree;
    std::map<std::size_t, std::unique_ptr<CompiledProgram>> compiled;
  };
  struct Folder {
    std::string path;
    std::multimap<int, std::string> by_name;
    std::vector<std::string> unnamed;  ///< files whose name says no number, not yet read
  };

  const CompiledProgram* compiled(File& file, std::size_t which);
  const CompiledProgram* find_in(File& file, int number);
  const CompiledProgram* find_in(Folder& folder, int number);
  File* load(const std::string& path);

  source::FileSystem& files_;
  const Profile* profile_ = &profiles().front();
  std::vector<std::unique_ptr<File>> loaded_;
  std::vector<Folder> folders_;
  std::map<int, const CompiledProgram*> known_;
};

}  // namespace g31::fanuc

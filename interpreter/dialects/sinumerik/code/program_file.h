#pragma once

#include <cstddef>
#include <memory>
#include <mutex>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/compile.h"
#include "interpreter/dialects/sinumerik/code/program_name.h"
#include "interpreter/source/source_file.h"

namespace g31::sinumerik {

/// A program of a file.  Its code is made once, by the first thread that asks for it.
class FiledProgram {
 public:
  FiledProgram(ProgramName name, ProgramSource source)
      : name_(std::move(name)), source_(std::move(source)) {}

  [[nodiscard]] const ProgramName& name() const { return name_; }  ///< with the folder of $PATH
  [[nodiscard]] const ProgramSource& source() const { return source_; }

  /// @param globals  of the library that the file belongs to
  const CompiledProgram& code(const Globals& globals);

  /// Of a main program, before anything of its subprograms is compiled: they see its variables.
  void lead(Globals& globals);

  /// Of a definition file, before anything else is compiled: what it defines goes into `globals`.
  const CompiledProgram& define_in(Globals& globals);

 private:
  ProgramName name_;
  ProgramSource source_;
  std::once_flag once_;
  std::unique_ptr<CompiledProgram> code_;
};

/// A file of programs: one, or many behind headers %_N_NAME_SPF.
class ProgramFile {
 public:
  /// @param text        outlives the file
  /// @param is_shipped  comes with the control
  explicit ProgramFile(const source::SourceFile& text, bool is_shipped = false);

  [[nodiscard]] const source::SourceFile& text() const { return text_; }
  [[nodiscard]] const std::vector<std::unique_ptr<FiledProgram>>& programs() const {
    return programs_;
  }

 private:
  const source::SourceFile& text_;
  std::vector<std::unique_ptr<FiledProgram>> programs_;
};

}  // namespace g31::sinumerik

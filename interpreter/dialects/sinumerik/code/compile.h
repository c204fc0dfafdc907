#pragma once

#include <memory>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/code/globals.h"

namespace g31::sinumerik {

/// Where a program stands.
struct ProgramSource {
  std::string name;
  const source::SourceFile* file = nullptr;
  ShortSpan text;           ///< without its header
  std::string folder = {};  ///< of $PATH; empty: not said
  std::string type = {};    ///< "MPF", "SPF"; empty: not said
  bool is_shipped = false;  ///< comes with the control: macros of others do not reach into it
  bool leads = false;       ///< a main program: variables of another one do not reach into it
};

/// Compiles a program.  Nothing in it can make this fail: a block that is wrong becomes a step that
/// raises the alarm when the program gets there, as the control does.
std::unique_ptr<CompiledProgram> compile(const ProgramSource& source, const Globals& globals);

/// The same of an INI file: it may assign to system data that g31 does not have, which goes into
/// CompiledProgram::unknown_data.
std::unique_ptr<CompiledProgram> compile_data(const ProgramSource& source, const Globals& globals);

/// The variables that a program defines before its first block that does something.
std::vector<Variable> variables_of_head(const ProgramSource& source, const Globals& globals);

/// A piece of a program that can be run before what follows is known.
struct CompiledWindow {
  std::unique_ptr<CompiledProgram> program;
  std::uint32_t end = 0;  ///< the line behind it
};

/// Compiles the blocks from `begin` on up to the first one that says something of others (a jump,
/// label, call or definition), some hundred kilobytes of text at most.  The steps of such pieces
/// are those that compile() makes, one piece behind the other, but for the EndWindow behind each;
/// at the end of the program stands its EndProgram.
CompiledWindow compile_window(const ProgramSource& source, const Globals& globals,
                              std::uint32_t begin);

/// Compiles `text` as blocks that run among the local variables of `home`: what --set says, and the
/// text of EXECSTRING.
std::unique_ptr<CompiledProgram> compile_among(const ProgramSource& source, const Globals& globals,
                                               const CompiledProgram& home);

/// Compiles one expression in the same way; CompiledProgram::result says where its value stands.
std::unique_ptr<CompiledProgram> compile_expression(const ProgramSource& source,
                                                    const Globals& globals,
                                                    const CompiledProgram& home);

/// Reads a definition file: DEF and DEFINE of it become global.  Initial values are blocks of the
/// program returned, to be run once at the start.
std::unique_ptr<CompiledProgram> compile_definitions(const ProgramSource& source, Globals& globals);

}  // namespace g31::sinumerik

#pragma once

#include <cstddef>
#include <map>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "interpreter/dialects/sinumerik/code/callable_programs.h"
#include "interpreter/dialects/sinumerik/code/code.h"
#include "interpreter/dialects/sinumerik/run/call_stack.h"
#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/dialects/sinumerik/state/failure.h"

namespace g31::sinumerik {

/// The programs and texts that a run calls, found or compiled once.
class CalledPrograms {
 public:
  /// All must outlive it.
  CalledPrograms(CallablePrograms& programs, const CallStack& stack, Channel& channel)
      : programs_(programs), stack_(stack), channel_(channel) {}

  /// The program of a call: alarm 12550 where a name is unknown, 14011 where a text names a file.
  /// @param text  what the call's text says, where it has no name
  Result<const CompiledProgram*, Failure> called(const CallSite& site, const std::string& text);
  /// What the running level would call by this name; nullptr: nothing.
  const CompiledProgram* find(std::string_view name);
  /// Whether the run has a file of this name.
  [[nodiscard]] bool is_written(std::string_view path) const;
  /// CALLPATH: calls by name may find other programs from now on.
  void set_call_path(std::string path);

  /// Blocks for EXECSTRING among the variables of `home`.
  Result<const CompiledProgram*, Failure> text_of(const CompiledProgram& home,
                                                  const std::string& source);
  /// What follows in a long program.
  ProgramWindows::Place next_window() { return programs_.next_window(); }

 private:
  Result<const CompiledProgram*, Failure> written_program(std::string_view name);

  CallablePrograms& programs_;
  const CallStack& stack_;
  Channel& channel_;
  /// What calls by name have found: programs stay, so it counts until CALLPATH, or until a file
  /// was made or removed, which may have the name of a program.
  std::unordered_map<const CallSite*, const CompiledProgram*> found_calls_;
  std::size_t files_seen_ = 0;  ///< changes of files until then
  /// What EXECSTRING compiled, by program and text.
  std::map<std::pair<const CompiledProgram*, std::string>, const CompiledProgram*> texts_run_;
  /// The same of files that the run wrote, by name and text.
  std::map<std::pair<std::string, std::string>, const CompiledProgram*> written_;
  std::size_t written_bytes_ = 0;  ///< of their texts
};

}  // namespace g31::sinumerik

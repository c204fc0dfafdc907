#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <set>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/run/call_stack.h"
#include "interpreter/dialects/sinumerik/run/called_programs.h"
#include "interpreter/dialects/sinumerik/run/missed_results.h"
#include "interpreter/dialects/sinumerik/run/operands.h"

namespace g31::sinumerik {

/// Calls of programs and returns from them.
class Calls {
 public:
  /// All must outlive the calls.
  Calls(CallStack& stack, Operands& operands, Channel& channel, CalledPrograms& programs,
        MissedResults& missed)
      : stack_(stack),
        operands_(operands),
        channel_(channel),
        programs_(programs),
        missed_(missed) {}

  MaybeFailure find_called(const Op& op);
  MaybeFailure call(const Op& op);
  /// RET and the like: behind the call, or once more; RET(target) goes on at a label there.
  MaybeFailure return_from(const Op& op);
  /// The end of what EXECSTRING or the command line brought.
  MaybeFailure end_text();
  /// What follows in a long program.  Windows have no local variables that could be lost.
  MaybeFailure begin_window();
  /// What nobody calls has its preset values, and nothing to refer to.
  MaybeFailure take_no_arguments();
  /// MCALL: behind a block that moves.
  MaybeFailure modal_call();
  /// The blocks from one label to another of the nearest calling program that has both.
  MaybeFailure call_part(const std::string& first, const std::string& last);
  /// EXECSTRING: the text sees the variables of the level; behind it the program goes on.
  MaybeFailure execute_text(const std::string& source);
  /// Whether a path means one of the programs that the run was given, and no file.
  bool is_given_program(const std::string& path);
  /// Alarm 12140 where a procedure would look into one: only files have their text there.
  MaybeFailure expect_no_program(const std::string& path, const char* procedure);
  void set_call_path(std::string path) { programs_.set_call_path(std::move(path)); }

 private:
  struct ReturnTarget {
    std::size_t levels = 1;
    std::optional<std::int32_t> step;  ///< there; nullopt: behind the call
  };
  std::vector<BoundValue> bound(const CallSite& site);
  bool passes_over(const CallSite& site);
  MaybeFailure enter_part(const CallSite& site, const CompiledProgram& program);
  MaybeFailure enter(const CompiledProgram& program, const std::vector<BoundValue>& values);
  void begin_level(Level& into);
  Result<ReturnTarget, Failure> return_target(const Op& op);
  void leave_level();
  void save_codes(Level& into);
  void restore_codes(const Level& from);
  void tell_level();
  Level& level() { return stack_.level(); }

  CallStack& stack_;
  Operands& operands_;
  Channel& channel_;
  CalledPrograms& programs_;
  MissedResults& missed_;
  std::set<const CallSite*> told_cycles_;  ///< that are not simulated
};

}  // namespace g31::sinumerik

#pragma once

#include <cstddef>
#include <cstdint>
#include <set>
#include <string>
#include <vector>

#include "tools/page/run_report.h"
#include "tools/session/message_comments.h"

namespace g31::page {

/// Names and touches of what variables came to, by what wrote them last.
class Writers {
 public:
  /// @param run  outlives it
  explicit Writers(const RunPage& run);

  /// What the program says of a variable: the comment, (DIAMETER) or ; diameter, of the line that
  /// wrote it last.
  /// @returns UTF-8; "": nothing
  [[nodiscard]] std::string meaning_of(const report::VariableHistory& history) const;
  [[nodiscard]] std::string meaning_of(const std::string& variable) const;
  /// Numbers of the touches that the last value of the variable rests on, rising: those in the call
  /// of the main program that it was written in; of one that the main program wrote itself those of
  /// the variables in that block, or the touch whose position it reads there.
  [[nodiscard]] std::vector<std::size_t> touches_of(const std::string& variable) const;
  /// The program that the main program called for what happened at a time; "": it did it itself.
  [[nodiscard]] std::string caller_at(double time_s) const;

 private:
  /// What is found while one variable leads to others.
  struct Found {
    std::set<std::size_t> touches;
    std::set<const report::VariableHistory*> variables;
  };

  /// The call of the main program that a number of a block is in; nullptr: it is the main
  /// program's.
  [[nodiscard]] const report::CallSpan* call_of_block(std::uint64_t number) const;
  [[nodiscard]] const report::VariableHistory* find(const std::string& variable) const;
  void add_touches(const report::VariableHistory& history, Found& found) const;
  /// @returns whether the variable was written in a call
  bool add_touches_of_call(const report::VariableHistory& history, Found& found) const;
  void add_last_touch(double time_s, Found& found) const;

  const RunPage& run_;
  session::CommentForm comments_ = session::CommentForm::Parentheses;
  std::vector<const report::CallSpan*> calls_;  ///< of the main program, one after the other
};

}  // namespace g31::page

#pragma once

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/text/word_values.h"
#include "machine/base/result.h"

namespace g31::fanuc {

/// The programs that a run calls.
class CalledPrograms {
 public:
  /// Both must outlive it.
  CalledPrograms(ProgramLibrary& library, Control& control)
      : library_(library), control_(control) {}

  /// The program of a number or name, and a word about a second one; nullptr: there is none.
  const CompiledProgram* find(const ProgramKey& key);
  [[nodiscard]] bool has(int number) { return library_.find({number, {}}) != nullptr; }
  /// That of P, or of the name in its place.  @param caller  in whose text it stands
  Result<const CompiledProgram*, Failure> called(const EvaluatedWord& p,
                                                 const CompiledProgram& caller);
  /// That of a code by which it is called.
  Result<const CompiledProgram*, Failure> called_by(const EvaluatedWord& code, int number);
  /// What the library has to say goes where the run's reports are.
  void take_reports();

 private:
  ProgramLibrary& library_;
  Control& control_;
};

/// L: how often.
Result<int, Failure> repeats_of(const BlockWords& words, const Profile& profile);

}  // namespace g31::fanuc

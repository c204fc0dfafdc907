#include "interpreter/dialects/fanuc/run/called_programs.h"

#include <string>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/execute/codes.h"

namespace g31::fanuc {
const CompiledProgram* CalledPrograms::find(const ProgramKey& key) {
  const CompiledProgram* const found = library_.find(key);
  take_reports();
  return found;
}

Result<const CompiledProgram*, Failure> CalledPrograms::called(const EvaluatedWord& p,
                                                               const CompiledProgram& caller) {
  if (p.form == syntax::ValueForm::Name) {
    const ProgramKey key = key_between_angles(caller.file->text(), p.span);
    const CompiledProgram* const named = find(key);
    return named != nullptr ? Result<const CompiledProgram*, Failure>(named)
                            : at_word(AlarmId::CalledNameNotFound, p, missing_program(key));
  }
  const auto number = integer_of(p, control_.profile);
  if (!number) {
    return number.error();
  }
  const ProgramKey key{number.value(), {}};
  const CompiledProgram* const program = find(key);
  if (program == nullptr) {
    return at_word(AlarmId::CalledNotFound, p, missing_program(key));
  }
  return program;
}

void CalledPrograms::take_reports() {
  if (!library_.has_reports()) {
    return;
  }
  for (source::Diagnostic& report : library_.take_reports()) {
    control_.diagnostics.push_back(std::move(report));
  }
}

Result<const CompiledProgram*, Failure> CalledPrograms::called_by(const EvaluatedWord& code,
                                                                  int number) {
  if (const CompiledProgram* const program = find({number, {}})) {
    return program;
  }
  return at_word(AlarmId::CalledNotFound, code,
                 fmt::format("O{:04}, which {}{} calls, is in none of the files and folders",
                             number, code.letter, code.number));
}

Result<int, Failure> repeats_of(const BlockWords& words, const Profile& profile) {
  const EvaluatedWord* const l = words.find('L');
  return l != nullptr ? integer_within(*l, profile, wrong_repeats) : Result<int, Failure>(1);
}

}  // namespace g31::fanuc

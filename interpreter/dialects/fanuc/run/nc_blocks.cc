#include "interpreter/dialects/fanuc/run/nc_blocks.h"

#include <algorithm>
#include <optional>
#include <string_view>
#include <utility>

#include "interpreter/dialects/fanuc/execute/execute.h"
#include "interpreter/dialects/fanuc/run/assignments.h"
#include "interpreter/source/readable_text.h"

namespace g31::fanuc {
namespace {

constexpr int kKeyPrompt = 109;

}  // namespace

NcBlocks::NcBlocks(CallStack& stack, Control& control, CalledPrograms& programs, Jumps& jumps)
    : stack_(stack),
      control_(control),
      running_(stack, control),
      arguments_(stack, running_, control),
      levels_(stack, control),
      subprograms_(control, running_, programs, jumps, levels_),
      macros_(control, running_, programs, arguments_, levels_),
      calls_(stack, control, running_, macros_, subprograms_) {}

[[gnu::hot]] MaybeFailure NcBlocks::run(const Step& step) {
  if (const auto halt = control_.watch.before_work()) {
    return halt_failure(*halt);
  }
  if (auto failure = running_.read(step)) {
    return failure;
  }
  if (control_.profile.keeps_all_words) {
    arguments_.keep_words();
  }
  const auto called = calls_.call_in_block();
  if (!called) {
    return called.error();
  }
  if (called.value()) {
    control_.touches.missed.passes_on();
    return std::nullopt;
  }
  if (calls_.ends_call()) [[unlikely]] {
    return end_of_call(stack_.here());
  }
  if (auto failure = own_words(stack_.here())) {
    return failure;
  }
  return modal_call();
}

MaybeFailure NcBlocks::modal_call() {
  return stack_.frame().modal_calls.empty() ? std::nullopt : macros_.modal_call();
}

/// A block with G67, or with M99, which is the last of it (FANUC B-64304EN, 13.3).
MaybeFailure NcBlocks::end_of_call(source::Location where) {
  if (running_.words().all().size() == 1) {  // M99 alone, at the end of every call
    control_.touches.missed.passes_on();
    return calls_.returns() ? subprograms_.return_from(running_.words()) : std::nullopt;
  }
  const BlockWords whole = running_.words();
  running_.leave_out_end_of_call(calls_.returns());
  const bool has_others = !running_.words().all().empty();
  if (!has_others) {
    control_.touches.missed.passes_on();
  } else if (auto failure = own_words(where)) {
    return failure;
  }
  if (calls_.returns()) {
    return stack_.has_ended() ? std::nullopt : subprograms_.return_from(whole);
  }
  return has_others ? modal_call() : std::nullopt;
}

/// What the words of a block do by themselves, calls apart.
[[gnu::hot]] MaybeFailure NcBlocks::own_words(source::Location where) {
  if (auto failure = execute_words(control_, running_.words(), where)) {
    return failure;
  }
  control_.touches.missed.moves();
  if (!running_.words().has('M')) {
    return std::nullopt;
  }
  if (auto failure = control_.profile.checks_skip_signal ? skip_check(where) : std::nullopt) {
    return failure;
  }
  return program_codes(where);
}

/// M codes that stop or end the program, and M109: each one of the block.
MaybeFailure NcBlocks::program_codes(source::Location where) {
  for (const EvaluatedWord& word : running_.words().all()) {
    if (word.letter != 'M') {
      continue;
    }
    const int code = nearest_integer(word.number);
    if (code == kKeyPrompt && control_.profile.asks_for_keys) {
      if (auto failure = ask_for_key(where)) {
        return failure;
      }
    }
    stop_program(code, where);
  }
  return std::nullopt;
}

/// M78 and M79 of a Haas: what the skip move of their block must come to.
MaybeFailure NcBlocks::skip_check(source::Location where) {
  constexpr double kMustBeMissing = 78.0;
  constexpr double kMustCome = 79.0;
  const auto is_here = [&](const std::optional<source::Location>& skip) {
    return skip && skip->file == where.file && skip->begin == where.begin;
  };
  for (const EvaluatedWord& word : running_.words().all()) {
    if (word.letter == 'M' && word.number == kMustBeMissing) {
      if (is_here(control_.stopped_skip)) {
        return at_word(AlarmId::SkipSignalFound, word, "M78");
      }
      control_.touches.missed.asks();
    }
    if (word.letter == 'M' && word.number == kMustCome && is_here(control_.touches.missed.last())) {
      return at_word(AlarmId::SkipSignalMissing, word, "M79");
    }
  }
  return std::nullopt;
}

/// The first comment in the line of the block that runs.
std::string NcBlocks::prompt() const {
  const CompiledProgram& program = *stack_.frame().program;
  const Step& step = program.steps[stack_.frame().current];
  std::string_view line = program.file->text().substr(program.tree->blocks[step.block].span.begin);
  line = line.substr(0, line.find('\n'));
  const std::size_t begin = std::min(line.find('('), line.size());
  const std::size_t end = std::min(line.find(')', begin), line.size());
  return begin < end ? source::readable_text(line.substr(begin + 1, end - begin - 1)) : "";
}

/// M109 of a Haas: the operator presses a key, whose ASCII number goes into the variable P.
MaybeFailure NcBlocks::ask_for_key(source::Location where) {
  const EvaluatedWord* const p = running_.words().find('P');
  if (p == nullptr) {
    return block_failure(AlarmId::NoDataAfterAddress, "M109 needs P, the variable for the key");
  }
  const auto number = integer_within(*p, control_.profile, wrong_key_variable);
  if (!number) {
    return number.error();
  }
  std::string text = prompt();
  control_.observer.on_stop({"M109", text, where});
  if (control_.keys_left.empty()) {
    Failure failure;
    failure.status = runtime::Status::Budget;
    failure.alarm_number = static_cast<int>(source::DiagnosticId::NoKeyLeft);
    failure.detail = text.empty() ? "" : ": " + text;
    return failure;
  }
  const auto key = static_cast<unsigned char>(control_.keys_left.front());
  control_.keys_left.erase(0, 1);
  const auto refused = write_variable(control_, stack_, number.value(), Cell(key));
  return refused ? MaybeFailure(at_word(*refused, *p, "the variable cannot be written"))
                 : std::nullopt;
}

/// M00, M01, M02, M30: recorded stops and the end.
void NcBlocks::stop_program(int m, source::Location where) {
  if (m == 0 || m == 1) {
    control_.observer.on_stop({m == 0 ? "M00" : "M01", "", where});
  }
  if (m == 2 || m == 30) {
    stack_.end();
  }
}

}  // namespace g31::fanuc

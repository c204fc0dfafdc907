#include "interpreter/dialects/fanuc/code/exits.h"

#include <algorithm>
#include <cstdint>

namespace g31::fanuc {
namespace {

using syntax::BlockKind;
using syntax::Index;
using syntax::kNone;

void add_exit(StepExits& exits, Index step) {
  exits.listed.at(exits.count++) = step;
}

/// What the words of an NC block end.
void follow_words(const CompiledProgram& program, Index step, StepExits& exits) {
  const syntax::Block& block = program.tree->blocks[program.steps[step].block];
  bool names_target = false;
  bool goes_to_label = false;
  bool may_be_skipped = false;
  for (Index i = block.first_word; i < block.first_word + block.word_count; ++i) {
    const syntax::Word& word = program.tree->words[i];
    may_be_skipped |= word.letter == '/';
    exits.ends |= !may_be_skipped && word.letter == 'M' &&
                  word.form == syntax::ValueForm::Integer &&
                  (word.number == 99.0 || word.number == 30.0 || word.number == 2.0);
    names_target |= word.letter == 'P';
    goes_to_label |=
        word.letter == 'M' && (word.number == kJumpByInput || word.number == kLocalCall);
  }
  if (!exits.ends) {
    add_exit(exits, step + 1);
    exits.any_label = goes_to_label && names_target;  // M96 P Q, M97 P
  } else {
    exits.any_label = names_target;  // M99 P in a main program goes on at any block of it
  }
}

/// A jump of a window may leave it.
void follow_jump(const CompiledProgram& program, Index step, StepExits& exits) {
  if (program.steps[step].jump != kNone) {
    add_exit(exits, program.steps[step].jump);
    return;
  }
  const auto target = program.constant_target(program.steps[step]);
  exits.any_label = program.extent == Extent::Whole || !target;
  if (exits.any_label) {
    return;
  }
  const auto behind = std::ranges::find_if(program.labels, [&](const Label& label) {
    return label.sequence == *target && label.step > step;
  });
  if (behind != program.labels.end()) {
    add_exit(exits, behind->step);
  }
}

}  // namespace

bool is_macro_alarm(const Step& step) {
  constexpr std::int32_t kMacroAlarm = 3000;
  return step.kind == BlockKind::Assign && step.target_kind == TargetKind::Numbered &&
         step.number == kMacroAlarm;
}

std::optional<double> constant_in(const CompiledProgram& program, Operand operand) {
  if (operand.bank != Bank::Constants) {
    return std::nullopt;
  }
  const Cell cell = program.constants[static_cast<std::size_t>(operand.place)];
  return cell.is_vacant() ? std::nullopt : std::optional(cell.raw());
}

std::optional<bool> constant_condition(const CompiledProgram& program, const Step& step) {
  const bool asks = step.kind == BlockKind::IfGoto || step.kind == BlockKind::IfThen ||
                    step.kind == BlockKind::While;
  if (!asks) {
    return std::nullopt;
  }
  const Op& op = program.ops[step.condition];
  const auto a = constant_in(program, op.a);
  if (op.code == OpCode::End) {
    return a ? std::optional(*a != 0.0) : std::nullopt;
  }
  const auto b = constant_in(program, op.b);
  if (!a || !b || program.ops[step.condition + 1].code != OpCode::End) {
    return std::nullopt;
  }
  return op.code == OpCode::Equal          ? std::optional(*a == *b)
         : op.code == OpCode::NotEqual     ? std::optional(*a != *b)
         : op.code == OpCode::Greater      ? std::optional(*a > *b)
         : op.code == OpCode::Less         ? std::optional(*a < *b)
         : op.code == OpCode::GreaterEqual ? std::optional(*a >= *b)
         : op.code == OpCode::LessEqual    ? std::optional(*a <= *b)
                                           : std::nullopt;
}

StepExits exits_of(const CompiledProgram& program, Index index) {
  const Step& step = program.steps[index];
  const auto condition = constant_condition(program, step);
  StepExits exits;
  if (step.skip_switch != 0) {
    add_exit(exits, index + 1);
  }
  switch (step.kind) {
    case BlockKind::Goto:
    case BlockKind::IfGoto:
      if (condition != false) {
        follow_jump(program, index, exits);
      }
      if (step.kind == BlockKind::IfGoto && condition != true) {
        add_exit(exits, index + 1);
      }
      break;
    case BlockKind::IfThen:
    case BlockKind::While:
      if (condition != true) {
        add_exit(exits, step.jump);
      }
      if (condition != false) {
        add_exit(exits, index + 1);
      }
      break;
    case BlockKind::End:
      add_exit(exits, step.jump);
      break;
    case BlockKind::Nc:
      follow_words(program, index, exits);
      break;
    case BlockKind::Bad:
      break;
    case BlockKind::Assign:
      exits.ends = is_macro_alarm(step);
      if (!exits.ends) {
        add_exit(exits, index + 1);
      }
      break;
    case BlockKind::Empty:
    case BlockKind::Do:
    case BlockKind::Output:
    case BlockKind::SetNames:
      add_exit(exits, index + 1);
      break;
  }
  return exits;
}

}  // namespace g31::fanuc

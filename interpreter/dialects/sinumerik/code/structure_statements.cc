#include "interpreter/dialects/sinumerik/code/structure_statements.h"

#include <utility>

#include <fmt/format.h>

namespace g31::sinumerik {

/// @param head, exit  as of a Structure
void StructureStatements::open(StructureKind kind, std::int32_t head, std::int32_t exit,
                               const Expr& counter) {
  if (open_.are_too_deep()) {
    fail(AlarmId::NestingTooDeep, block());
  }
  open_.open({kind, block(), failed() ? -1 : head, failed() ? -1 : exit, counter},
             code_.first_step());
}

/// The innermost structure, if it is of the kind that ends here.
std::optional<Structure> StructureStatements::close(StructureKind kind) {
  auto structure = open_.close(kind, code_.first_step());
  if (!structure) {
    fail(AlarmId::BadNesting, block(), text_of(block()));
  }
  return structure;
}

/// The innermost loop.  The end of one whose beginning is wrong can be reached by a jump into it.
std::optional<Structure> StructureStatements::close_loop(StructureKind kind) {
  auto loop = close(kind);
  if (loop && loop->head < 0) {
    reader_.fail_by_earlier(AlarmId::BadNesting, block(), text_of(block()));
    return std::nullopt;
  }
  return loop;
}

void StructureStatements::back_to(const Structure& loop) {
  code_.emit(OpCode::Jump, {}, {Bank::Constants, loop.head + 1}, {}, block());
  set_target(loop.exit, code_.here());
}

/// IF condition [jump]: with a jump it needs no ENDIF, even where the condition is wrong.
void StructureStatements::if_statement() {
  const bool is_jump = jumps_.jumps_behind();
  const Expr condition = operations_.boolean(expressions_.expression());
  const std::int32_t step = code_.emit(OpCode::JumpIfNot, {}, condition.value, {}, block());
  if (!failed() && jumps_.jump_statement()) {
    set_target(step, code_.here());
    return;
  }
  if (is_jump && failed()) {
    return;
  }
  expect_end();
  open(StructureKind::If, step, step);
}

void StructureStatements::else_statement() {
  expect_end();
  if (auto structure = close(StructureKind::If)) {
    const std::int32_t done = code_.emit(OpCode::Jump, {}, {}, {}, block());
    set_target(structure->exit, code_.here());
    structure->kind = StructureKind::Else;
    structure->exit = failed() ? -1 : done;
    open_.open(*std::move(structure), code_.first_step());
  }
}

/// An ENDIF more than there are IF changes nothing; shipped cycles have such ones.
void StructureStatements::endif_statement() {
  expect_end();
  if (!open_.are_in_branch()) {
    code_.emit(OpCode::SurplusEnd, {}, {}, {}, block());
    return;
  }
  const bool in_else = open_.are_in(StructureKind::Else);
  if (const auto structure = close(in_else ? StructureKind::Else : StructureKind::If)) {
    set_target(structure->exit, code_.here());
  }
}

void StructureStatements::loop_statement() {
  expect_end();
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  open(StructureKind::Loop, head, -1);
}

void StructureStatements::endloop_statement() {
  expect_end();
  if (const auto loop = close_loop(StructureKind::Loop)) {
    back_to(*loop);
  }
}

/// The element that FOR counts in, for the blocks behind it: what its index is made of may change.
void StructureStatements::keep_element(Expr& counter) {
  Variable element;
  element.name = fmt::format("element of FOR {}", code_.here());  // no name of a program
  element.type = Type::Int;
  const std::int32_t index = variables_.define_local(element);
  if (index >= 0) {
    const Variable& kept = program_.variables[static_cast<std::size_t>(index)];
    const Operand place = {Bank::Locals, kept.place};
    code_.emit(OpCode::Move, place, counter.element, {}, counter.where);
    counter.element = place;
  }
}

/// FOR variable = first TO last: the end value is asked for at each pass.  A REAL counter begins
/// with a whole number, too (job planning, counting loop: its value is rounded).
void StructureStatements::for_statement() {
  Expr counter = expressions_.primary();
  const bool counts = !failed() && counter.variable >= 0 &&
                      (counter.type == Type::Int || counter.type == Type::Real);
  if (!failed() && !counts) {
    fail(AlarmId::WrongType, counter.where, text_of(counter.where));
  }
  expect(Symbol::Assign);
  if (!failed() && counter.element.bank == Bank::Temporaries) {
    keep_element(counter);
  }
  counter.is_constant = counter.value.bank != Bank::Temporaries;
  if (!failed()) {
    assignments_.store(counter, operations_.convert(expressions_.expression(), Type::Int));
  }
  if (!failed() && !cursor_.accept_name("TO")) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
  }
  // The counter of a later pass is behind the condition's own steps: read it there again.
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  const Expr end = operations_.convert(expressions_.expression(), Type::Real);
  expect_end();
  Expr now = counter;
  if (!failed() && !counter.is_constant) {
    code_.emit(OpCode::Load, now.value, counter.element, {Bank::Constants, counter.variable},
               block());
  }
  const Operand inside = temporary(Type::Bool);
  code_.emit(OpCode::LessEqual, inside, now.value, end.value, block());
  const std::int32_t exit = code_.emit(OpCode::JumpIfNot, {}, inside, {}, block());
  open(StructureKind::For, head, exit, counter);
}

void StructureStatements::endfor_statement() {
  expect_end();
  const auto loop = close_loop(StructureKind::For);
  if (!loop) {
    return;
  }
  const Expr& counter = loop->counter;
  if (!counter.is_constant) {
    code_.emit(OpCode::Load, counter.value, counter.element, {Bank::Constants, counter.variable},
               block());
  }
  Expr more;
  more.type = Type::Real;
  more.where = block();
  more.value = temporary(Type::Real);
  code_.emit(OpCode::Add, more.value, counter.value, code_.number_constant(1.0), block());
  more.type = counter.type;
  if (counter.type == Type::Int) {
    operations_.keep_to_32_bits(more);
  }
  assignments_.store(counter, more);
  back_to(*loop);
}

void StructureStatements::while_statement() {
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  const Expr condition = operations_.boolean(expressions_.expression());
  expect_end();
  const std::int32_t exit = code_.emit(OpCode::JumpIfNot, {}, condition.value, {}, block());
  open(StructureKind::While, head, exit);
}

void StructureStatements::endwhile_statement() {
  expect_end();
  if (const auto loop = close_loop(StructureKind::While)) {
    back_to(*loop);
  }
}

/// REPEAT alone begins a loop, with a label it repeats a part of the program.
void StructureStatements::repeat_statement() {
  if (cursor_.peek().kind != TokenKind::End) {
    jumps_.repeat_part(false);
    return;
  }
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  open(StructureKind::Repeat, head, -1);
}

void StructureStatements::until_statement() {
  const Expr condition = operations_.boolean(expressions_.expression());
  expect_end();
  if (const auto loop = close_loop(StructureKind::Repeat)) {
    code_.emit(OpCode::JumpIfNot, {}, condition.value, {Bank::Constants, loop->head + 1}, block());
  }
}

}  // namespace g31::sinumerik

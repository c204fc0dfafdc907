#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {
namespace {

constexpr std::string_view kEndOfPart = "ENDLABEL";

struct Jump {
  std::string_view name;
  Direction direction;
};
constexpr Jump kJumps[] = {{"GOTOF", Direction::Forward},
                           {"GOTOB", Direction::Backward},
                           {"GOTO", Direction::Both},
                           {"GOTOC", Direction::BothQuiet}};
constexpr std::string_view kToStart = "GOTOS";

}  // namespace

/// @param head, exit  as of a Structure
void Compiler::open(StructureKind kind, std::int32_t head, std::int32_t exit, const Expr& counter) {
  if (structures_.are_too_deep()) {
    fail(AlarmId::NestingTooDeep, block());
  }
  structures_.open({kind, block(), failed() ? -1 : head, failed() ? -1 : exit, counter},
                   code_.first_step());
}

/// The innermost structure, if it is of the kind that ends here.
std::optional<Structure> Compiler::close(StructureKind kind) {
  auto structure = structures_.close(kind, code_.first_step());
  if (!structure) {
    fail(AlarmId::BadNesting, block(), text_of(block()));
  }
  return structure;
}

/// The innermost loop.  The end of one whose beginning is wrong can be reached by a jump into it.
std::optional<Structure> Compiler::close_loop(StructureKind kind) {
  auto loop = close(kind);
  if (loop && loop->head < 0) {
    fail(AlarmId::BadNesting, block(), text_of(block()));
    return std::nullopt;
  }
  return loop;
}

void Compiler::back_to(const Structure& loop) {
  code_.emit(OpCode::Jump, {}, {Bank::Constants, loop.head + 1}, {}, block());
  set_target(loop.exit, code_.here());
}

/// Whether a jump stands in what is left of the block.
bool Compiler::jumps_behind() const {
  for (std::size_t i = 0; cursor_.peek(i).kind != TokenKind::End; ++i) {
    const bool is_jump =
        cursor_.peek(i).is_name(kToStart) || std::ranges::any_of(kJumps, [&](const Jump& jump) {
          return cursor_.peek(i).is_name(jump.name);
        });
    if (is_jump) {
      return true;
    }
  }
  return false;
}

/// IF condition [jump]: with a jump it needs no ENDIF, even where the condition is wrong.
void Compiler::if_statement() {
  const bool is_jump = jumps_behind();
  const Expr condition = operations_.boolean(expressions_.expression());
  const std::int32_t step = code_.emit(OpCode::JumpIfNot, {}, condition.value, {}, block());
  if (!failed() && jump_statement()) {
    set_target(step, code_.here());
    return;
  }
  if (is_jump && failed()) {
    return;
  }
  expect_end();
  open(StructureKind::If, step, step);
}

void Compiler::else_statement() {
  expect_end();
  if (auto structure = close(StructureKind::If)) {
    const std::int32_t done = code_.emit(OpCode::Jump, {}, {}, {}, block());
    set_target(structure->exit, code_.here());
    structure->kind = StructureKind::Else;
    structure->exit = failed() ? -1 : done;
    structures_.open(*std::move(structure), code_.first_step());
  }
}

/// An ENDIF more than there are IF changes nothing; shipped cycles have such ones.
void Compiler::endif_statement() {
  expect_end();
  if (!structures_.are_in_branch()) {
    code_.emit(OpCode::SurplusEnd, {}, {}, {}, block());
    return;
  }
  const bool in_else = structures_.are_in(StructureKind::Else);
  if (const auto structure = close(in_else ? StructureKind::Else : StructureKind::If)) {
    set_target(structure->exit, code_.here());
  }
}

void Compiler::loop_statement() {
  expect_end();
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  open(StructureKind::Loop, head, -1);
}

void Compiler::endloop_statement() {
  expect_end();
  if (const auto loop = close_loop(StructureKind::Loop)) {
    back_to(*loop);
  }
}

/// The element that FOR counts in, for the blocks behind it: what its index is made of may change.
void Compiler::keep_element(Expr& counter) {
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

/// FOR variable = first TO last: the end value is asked for at each pass.
void Compiler::for_statement() {
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
    assignments_.store(counter, expressions_.expression());
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

void Compiler::endfor_statement() {
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
  assignments_.store(counter, more);
  back_to(*loop);
}

void Compiler::while_statement() {
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  const Expr condition = operations_.boolean(expressions_.expression());
  expect_end();
  const std::int32_t exit = code_.emit(OpCode::JumpIfNot, {}, condition.value, {}, block());
  open(StructureKind::While, head, exit);
}

void Compiler::endwhile_statement() {
  expect_end();
  if (const auto loop = close_loop(StructureKind::While)) {
    back_to(*loop);
  }
}

/// REPEAT alone begins a loop, with a label it repeats a part of the program.
void Compiler::repeat_statement() {
  if (cursor_.peek().kind != TokenKind::End) {
    repeat_part(false);
    return;
  }
  const std::int32_t head =
      code_.emit(OpCode::Jump, {}, {Bank::Constants, code_.here() + 1}, {}, block());
  open(StructureKind::Repeat, head, -1);
}

void Compiler::repeatb_statement() {
  repeat_part(true);
}

void Compiler::until_statement() {
  const Expr condition = operations_.boolean(expressions_.expression());
  expect_end();
  if (const auto loop = close_loop(StructureKind::Repeat)) {
    code_.emit(OpCode::JumpIfNot, {}, condition.value, {Bank::Constants, loop->head + 1}, block());
  }
}

/// A label or N and a number where one is expected.
std::optional<std::string> Compiler::label_name() {
  if (cursor_.peek().is_letter('N') && cursor_.peek(1).kind == TokenKind::Integer) {
    cursor_.next();
    return "N" + std::to_string(static_cast<std::int64_t>(cursor_.next().number));
  }
  if (cursor_.peek().kind != TokenKind::Name && cursor_.peek().kind != TokenKind::Letter) {
    return std::nullopt;
  }
  // A control wants two letters; one and a number leave no doubt either.
  const Token name = cursor_.next();
  std::string label(name.text);
  if (name.kind == TokenKind::Letter && cursor_.peek().kind == TokenKind::Integer) {
    label += cursor_.next().text;
  }
  return label;
}

void Compiler::repeat_part(bool one_block) {
  const auto first = label_name();
  if (!first) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    return;
  }
  LabelJumps::Part part;
  part.first = *first;
  part.one_block = one_block;
  part.end = kEndOfPart;
  if (!one_block && (cursor_.peek().kind == TokenKind::Name || cursor_.peek().is_letter('N'))) {
    part.end = label_name().value_or("");
  }
  Expr passes = operations_.constant(Type::Int, 1.0, block());
  if (cursor_.peek().is_letter('P')) {
    cursor_.next();
    cursor_.accept(Symbol::Assign);
    passes = operations_.convert(expressions_.expression(), Type::Int);
  }
  expect_end();
  emit_part(std::move(part), passes.value);
}

void Compiler::emit_part(LabelJumps::Part part, Operand passes) {
  part.site = program_.repeats.size();
  program_.repeats.emplace_back();
  part.step = code_.emit(OpCode::RepeatPart, {},
                         {Bank::Constants, static_cast<std::int32_t>(part.site)}, passes, block());
  if (!failed()) {
    jumps_.add(std::move(part));
  }
}

/// BLOCK first TO last behind CALL: the part of this program once, as REPEAT first last runs it.
void Compiler::call_block() {
  cursor_.next();
  LabelJumps::Part part;
  part.first = label_name().value_or("");
  const bool goes_to = cursor_.accept_name("TO");
  part.end = label_name().value_or("");
  if (part.first.empty() || !goes_to || part.end.empty()) {
    fail(AlarmId::SyntaxInText, block(), "CALL BLOCK first TO last");
  }
  expect_end();
  emit_part(std::move(part), code_.number_constant(1.0));
}

/// CASE (expression) OF value jump value jump DEFAULT jump.  A block ends with its line: the values
/// stand on it.
void Compiler::case_statement() {
  const Expr value = expressions_.expression();
  if (!failed() && !cursor_.accept_name("OF")) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
  }
  while (!failed() && cursor_.peek().kind != TokenKind::End && !cursor_.accept_name("DEFAULT")) {
    Expr wanted = expressions_.unary();
    if (failed()) {
      return;
    }
    const Expr equal = operations_.compare(OpCode::Equal, value, wanted, wanted.where);
    const std::int32_t past = code_.emit(OpCode::JumpIfNot, {}, equal.value, {}, block());
    if (!failed() && !jump_statement()) {
      fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    }
    set_target(past, code_.here());
  }
  if (!failed() && cursor_.peek().kind != TokenKind::End && !jump_statement()) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
  }
}

/// A jump at this place, if there is one.
bool Compiler::jump_statement() {
  for (const Jump& jump : kJumps) {
    if (cursor_.accept_name(jump.name)) {
      jump_to(jump.direction);
      return true;
    }
  }
  if (cursor_.accept_name(kToStart)) {
    code_.emit(OpCode::Jump, {}, {Bank::Constants, 0}, {}, block());
    return true;
  }
  return false;
}

/// To a label, a block number, or what a text says.
void Compiler::jump_to(Direction direction) {
  const bool is_text =
      cursor_.peek().kind == TokenKind::Text ||
      (cursor_.peek().kind == TokenKind::Name && variables_.find(cursor_.peek().text) >= 0);
  const ShortSpan where = cursor_.peek().where;
  if (is_text) {
    const Expr name = operations_.as_text(expressions_.expression());
    code_.emit(OpCode::JumpText, {}, name.value, {}, name.where);
    code_.last().detail = detail_of(direction);
    return;
  }
  const auto label = label_name();
  if (!label) {
    fail(AlarmId::SyntaxInText, where, text_of(where));
    return;
  }
  const std::int32_t step = code_.emit(OpCode::Jump, {}, {}, {}, where);
  jumps_.add(LabelJumps::Jump{step, *label, direction});
}

void Compiler::jump(Direction direction) {
  jump_to(direction);
  expect_end();
}

void Compiler::goto_statement() {
  jump(Direction::Both);
}

void Compiler::gotof_statement() {
  jump(Direction::Forward);
}

void Compiler::gotob_statement() {
  jump(Direction::Backward);
}

void Compiler::gotoc_statement() {
  jump(Direction::BothQuiet);
}

void Compiler::gotos_statement() {
  expect_end();
  code_.emit(OpCode::Jump, {}, {Bank::Constants, 0}, {}, block());
}

}  // namespace g31::sinumerik

#include "interpreter/dialects/sinumerik/code/jump_statements.h"

#include <algorithm>
#include <utility>

namespace g31::sinumerik {
namespace {

/// Source: programming manual, fundamentals, 10.2004, 2.2: identifiers, labels among them.
constexpr std::size_t kLongestLabel = 32;

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

/// Whether a jump stands in what is left of the block.
bool JumpStatements::jumps_behind() const {
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

/// A label or N and a number where one is expected.
std::optional<std::string> JumpStatements::label_name() {
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
  if (label.size() > kLongestLabel) {
    fail(AlarmId::NameTooLong, name.where, label);
  }
  return label;
}

void JumpStatements::repeat_part(bool one_block) {
  const auto first = label_name();
  if (!first) {
    fail(AlarmId::SyntaxInText, cursor_.peek().where, text_of(cursor_.peek().where));
    return;
  }
  LabelJumps::Part part;
  part.first = *first;
  part.one_block = one_block;
  part.end = LabelJumps::kEndOfPart;
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

void JumpStatements::repeatb_statement() {
  repeat_part(true);
}

void JumpStatements::emit_part(LabelJumps::Part part, Operand passes) {
  part.site = program_.repeats.size();
  program_.repeats.emplace_back();
  part.step = code_.emit(OpCode::RepeatPart, {},
                         {Bank::Constants, static_cast<std::int32_t>(part.site)}, passes, block());
  if (!failed()) {
    jumps_.add(std::move(part));
  }
}

JumpStatements::Label JumpStatements::label() {
  const std::int32_t variable =
      cursor_.peek().kind == TokenKind::Name ? variables_.find(cursor_.peek().text) : -1;
  const bool is_text =
      cursor_.peek().kind == TokenKind::Text ||
      (variable >= 0 &&
       program_.variables[static_cast<std::size_t>(variable)].type == Type::String);
  if (is_text) {
    return {"", operations_.as_text(expressions_.expression()).value};
  }
  const auto name = label_name();
  if (!name) {
    fail(AlarmId::SyntaxInText, block(), "CALL BLOCK first TO last");
  }
  return {name.value_or(""), {}};
}

/// BLOCK first TO last, to the end of the block.
std::pair<JumpStatements::Label, JumpStatements::Label> JumpStatements::labels_of_part() {
  cursor_.next();
  Label first = label();
  if (!failed() && !cursor_.accept_name("TO")) {
    fail(AlarmId::SyntaxInText, block(), "CALL BLOCK first TO last");
  }
  Label last = failed() ? Label() : label();
  expect_end();
  return {std::move(first), std::move(last)};
}

Operand JumpStatements::text_of_label(const Label& label) {
  return label.name.empty() ? label.text : code_.text_constant(label.name);
}

void JumpStatements::part_of(CallSite& site) {
  const auto [first, last] = labels_of_part();
  site.is_part = true;
  site.first_label = text_of_label(first);
  site.last_label = text_of_label(last);
}

/// BLOCK first TO last behind CALL: the part of this program once, as REPEAT first last runs it.
void JumpStatements::call_block() {
  const auto [first, last] = labels_of_part();
  if (failed()) {
    return;
  }
  if (first.name.empty() || last.name.empty()) {
    code_.emit(OpCode::RepeatText, {}, text_of_label(first), text_of_label(last), block());
    return;
  }
  LabelJumps::Part part;
  part.first = first.name;
  part.end = last.name;
  emit_part(std::move(part), code_.number_constant(1.0));
}

/// CASE (expression) OF value jump value jump DEFAULT jump.  A block ends with its line: the values
/// stand on it.
void JumpStatements::case_statement() {
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
bool JumpStatements::jump_statement() {
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
void JumpStatements::jump_to(Direction direction) {
  const bool is_text =
      cursor_.peek().kind == TokenKind::Text || cursor_.peek().is(Symbol::LeftParen) ||
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

void JumpStatements::jump(Direction direction) {
  jump_to(direction);
  expect_end();
}

void JumpStatements::goto_statement() {
  jump(Direction::Both);
}

void JumpStatements::gotof_statement() {
  jump(Direction::Forward);
}

void JumpStatements::gotob_statement() {
  jump(Direction::Backward);
}

void JumpStatements::gotoc_statement() {
  jump(Direction::BothQuiet);
}

void JumpStatements::gotos_statement() {
  expect_end();
  code_.emit(OpCode::Jump, {}, {Bank::Constants, 0}, {}, block());
}

}  // namespace g31::sinumerik

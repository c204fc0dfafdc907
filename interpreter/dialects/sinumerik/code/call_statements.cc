#include "interpreter/dialects/sinumerik/code/call_statements.h"

#include <utility>

namespace g31::sinumerik {

/// NAME, NAME(arguments), NAME P3
void CallStatements::call_by_name(std::string name, ShortSpan where) {
  CallSite site;
  site.name = std::move(name);
  call(site, where);
}

std::vector<Argument> CallStatements::argument_list() {
  std::vector<Argument> list;
  if (cursor_.accept(Symbol::RightParen)) {
    return list;
  }
  while (!failed()) {
    const bool omitted = cursor_.peek().is(Symbol::Comma) || cursor_.peek().is(Symbol::RightParen);
    if (omitted) {
      list.emplace_back();
    } else {
      list.push_back(argument_of(expressions_.expression()));
    }
    if (!cursor_.accept(Symbol::Comma)) {
      break;
    }
  }
  expect(Symbol::RightParen);
  return list;
}

void CallStatements::call(CallSite site, ShortSpan where) {
  std::vector<Argument> list;
  if (cursor_.accept(Symbol::LeftParen)) {
    site.has_arguments = true;
    list = argument_list();
  }
  site.passes = code_.number_constant(1.0);
  if (cursor_.peek().is_letter('P')) {
    cursor_.next();
    cursor_.accept(Symbol::Assign);
    site.passes = operations_.convert(expressions_.expression(), Type::Int).value;
  }
  if (const Token& behind = cursor_.peek(); !failed() && behind.kind != TokenKind::End) {
    fail(AlarmId::SyntaxInText, behind.where,
         text_of(behind.where) + " behind the call of " + text_of(where));
  }
  if (failed()) {
    return;
  }
  site.first_argument = keep_arguments(list);
  site.argument_count = static_cast<std::uint32_t>(list.size());
  program_.calls.push_back(std::move(site));
  const Operand which = {Bank::Constants, static_cast<std::int32_t>(program_.calls.size()) - 1};
  // The words before the call belong to the same block and come first; a slip of the pen in one of
  // them is a call, too, of a program that there is not.
  if (words_.has_words()) {
    code_.emit(OpCode::FindCalled, {}, which, {}, where);
  }
  words_.finish_block();
  code_.emit(OpCode::Call, {}, which, {}, where);
}

/// CALL text, CALL text BLOCK first TO last
void CallStatements::call_statement() {
  if (cursor_.peek().is_name("BLOCK")) {
    words_.finish_block();  // as before a call
    jumps_.call_block();
    return;
  }
  CallSite site;
  const Expr name = operations_.as_text(expressions_.expression());
  site.text = name.value;
  if (cursor_.peek().is_name("BLOCK")) {
    jumps_.part_of(site);
  }
  call(site, name.where);
}

void CallStatements::extcall_statement() {
  const bool bracket = cursor_.accept(Symbol::LeftParen);
  CallSite site;
  const Expr name = operations_.as_text(expressions_.expression());
  if (bracket) {
    expect(Symbol::RightParen);
  }
  site.text = name.value;
  call(site, name.where);
}

/// PCALL path/name(arguments): the path goes up to the bracket.
void CallStatements::pcall_statement() {
  const ShortSpan first = cursor_.peek().where;
  ShortSpan whole = first;
  while (cursor_.peek().kind != TokenKind::End && !cursor_.peek().is(Symbol::LeftParen)) {
    whole.end = cursor_.next().where.end;
  }
  CallSite site;
  site.text = code_.text_constant(std::string(reader_.source(whole)));
  call(site, whole);
}

/// MCALL name(arguments): each block that moves calls it; MCALL alone ends that.
void CallStatements::mcall_statement() {
  CallSite site;
  site.is_modal = true;
  const Token name = cursor_.peek();
  if (name.kind == TokenKind::End) {
    call(site, block());
    return;
  }
  cursor_.next();
  site.name = std::string(name.text);
  if (name.is_letter('L') && cursor_.peek().kind == TokenKind::Integer) {
    site.name += cursor_.next().text;
  } else if (name.kind != TokenKind::Name) {
    fail(AlarmId::SyntaxInText, name.where, text_of(name.where));
  }
  call(site, name.where);
}

/// RET, RET(target, behind, levels, from start): back to the caller or one further out, there to a
/// label or block number, or behind it.
void CallStatements::ret_statement() {
  std::vector<Argument> list;
  if (cursor_.accept(Symbol::LeftParen)) {
    list = expressions_.arguments("tiii", "RET");
  }
  return_to(list);
}

/// ENDPROC: as RET alone.
void CallStatements::endproc_statement() {
  return_to({});
}

void CallStatements::return_to(const std::vector<Argument>& list) {
  expect_end();
  if (list.size() == 4 && list[3].form != Argument::Form::Omitted) {
    fail(AlarmId::NotImplemented, list[3].where, "RET to the start of the program");
  }
  if (failed()) {
    return;
  }
  words_.finish_block();
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Return, {}, {}, {Bank::Constants, static_cast<std::int32_t>(first)}, block());
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

void CallStatements::procedure(ProcedureId id, ShortSpan where) {
  const ProcedureInfo& row = procedures()[static_cast<std::size_t>(id)];
  std::vector<Argument> list;
  if (cursor_.accept(Symbol::LeftParen)) {
    list = expressions_.arguments(row.parameters, row.name);
  } else if (!row.parameters.empty() && !may_be_missing(row.parameters.front())) {
    fail(AlarmId::ArgumentCount, where, std::string(row.name));
  }
  const std::uint32_t first = keep_arguments(list);
  code_.emit(OpCode::Procedure, {}, {}, {Bank::Constants, static_cast<std::int32_t>(first)}, where);
  code_.last().detail = detail_of(id);
  code_.last().count = static_cast<std::uint16_t>(list.size());
}

}  // namespace g31::sinumerik

#include <algorithm>
#include <array>
#include <string_view>

#include "interpreter/dialects/sinumerik/code/compiler.h"

namespace g31::sinumerik {

bool is_taken_by(char kind, const Argument& argument) {
  const bool is_element = argument.form == Argument::Form::Element;
  const bool is_whole = argument.form == Argument::Form::Whole;
  return kind == 'V'   ? is_element && is_number(argument.type)
         : kind == 'M' ? is_whole && argument.type == Type::Real
         : kind == 'W' ? (is_element || is_whole) && argument.type == Type::String
                       : true;
}

/// NAME, NAME(arguments), NAME P3
void Compiler::call_by_name(std::string name, ShortSpan where) {
  CallSite site;
  site.name = std::move(name);
  call(site, where);
}

std::vector<Argument> Compiler::argument_list() {
  std::vector<Argument> list;
  if (accept(Symbol::RightParen)) {
    return list;
  }
  while (!failed()) {
    const bool omitted = peek().is(Symbol::Comma) || peek().is(Symbol::RightParen);
    if (omitted) {
      list.emplace_back();
    } else {
      list.push_back(argument_of(expression()));
    }
    if (!accept(Symbol::Comma)) {
      break;
    }
  }
  expect(Symbol::RightParen);
  return list;
}

void Compiler::call(CallSite site, ShortSpan where) {
  std::vector<Argument> list;
  if (accept(Symbol::LeftParen)) {
    site.has_arguments = true;
    list = argument_list();
  }
  site.passes = number_constant(1.0);
  if (peek().is_letter('P')) {
    next();
    accept(Symbol::Assign);
    site.passes = convert(expression(), Type::Int).value;
  }
  if (failed()) {
    return;
  }
  // The words before the call belong to the same block and come first.
  finish_words();
  site.first_argument = keep_arguments(list);
  site.argument_count = static_cast<std::uint32_t>(list.size());
  program_->calls.push_back(std::move(site));
  emit(OpCode::Call, {}, {Bank::Constants, static_cast<std::int32_t>(program_->calls.size()) - 1},
       {}, where);
}

/// CALL text
void Compiler::call_statement() {
  if (peek().is_name("BLOCK")) {
    call_block();
    return;
  }
  CallSite site;
  const Expr name = as_text(expression());
  if (peek().is_name("BLOCK")) {
    fail(AlarmId::NotImplemented, block_,
         "CALL BLOCK of another program: make that part a program of its own");
    return;
  }
  site.text = name.value;
  call(site, name.where);
}

void Compiler::extcall_statement() {
  const bool bracket = accept(Symbol::LeftParen);
  CallSite site;
  const Expr name = as_text(expression());
  if (bracket) {
    expect(Symbol::RightParen);
  }
  site.text = name.value;
  call(site, name.where);
}

/// PCALL path/name(arguments): the path goes up to the bracket.
void Compiler::pcall_statement() {
  const ShortSpan first = peek().where;
  ShortSpan whole = first;
  while (peek().kind != TokenKind::End && !peek().is(Symbol::LeftParen)) {
    whole.end = next().where.end;
  }
  CallSite site;
  site.text = text_constant(std::string(text_.substr(whole.begin, whole.end - whole.begin)));
  call(site, whole);
}

/// MCALL name(arguments): each block that moves calls it; MCALL alone ends that.
void Compiler::mcall_statement() {
  CallSite site;
  site.is_modal = true;
  const Token name = peek();
  if (name.kind == TokenKind::End) {
    call(site, block_);
    return;
  }
  next();
  site.name = std::string(name.text);
  if (name.is_letter('L') && peek().kind == TokenKind::Integer) {
    site.name += next().text;
  } else if (name.kind != TokenKind::Name) {
    fail(AlarmId::SyntaxInText, name.where, text_of(name.where));
  }
  call(site, name.where);
}

/// RET, RET(target, behind, levels): back to the caller or one further out, there to a label or
/// block number, or behind it.
void Compiler::ret_statement() {
  std::vector<Argument> list;
  if (accept(Symbol::LeftParen)) {
    list = argument_list();
  }
  expect_end();
  if (list.size() > 4) {
    fail(AlarmId::ArgumentCount, list[4].where, "RET");
  } else if (list.size() == 4 && list[3].form != Argument::Form::Omitted) {
    fail(AlarmId::NotImplemented, list[3].where, "RET to the start of the program");
  }
  if (failed()) {
    return;
  }
  const std::uint32_t first = keep_arguments(list);
  emit(OpCode::Return, {}, {}, {Bank::Constants, static_cast<std::int32_t>(first)}, block_);
  last().count = static_cast<std::uint16_t>(list.size());
}

void Compiler::procedure(ProcedureId id, ShortSpan where) {
  const ProcedureInfo& row = procedures()[static_cast<std::size_t>(id)];
  std::vector<Argument> list;
  const bool bracket = accept(Symbol::LeftParen);
  const bool empty = !bracket || accept(Symbol::RightParen);
  for (std::size_t i = 0; i < row.parameters.size() && !failed(); ++i) {
    const char kind = row.parameters[i];
    const bool is_optional = (kind >= 'a' && kind <= 'z') || kind == '*';
    if (empty || peek().is(Symbol::RightParen)) {
      if (!is_optional) {
        fail(AlarmId::ArgumentCount, where, std::string(row.name));
      }
      break;
    }
    if (!list.empty()) {
      expect(Symbol::Comma);
    }
    if (kind == 'o' && (peek().is(Symbol::Comma) || peek().is(Symbol::RightParen))) {
      list.emplace_back();
    } else {
      function_argument(kind == 'o' ? '*' : kind, list);
    }
    i -= kind == '*' || kind == 'o' ? 1 : 0;  // any more of them
    if (!failed() && !is_taken_by(kind, list.back())) {
      fail(AlarmId::ReferenceMissing, where, std::string(row.name));
    }
  }
  if (!empty && !accept(Symbol::RightParen)) {
    fail(peek().is(Symbol::Comma) ? AlarmId::ArgumentCount : AlarmId::SyntaxInText, peek().where,
         std::string(row.name));
  }
  const std::uint32_t first = keep_arguments(list);
  emit(OpCode::Procedure, {}, {}, {Bank::Constants, static_cast<std::int32_t>(first)}, where);
  last().detail = detail_of(id);
  last().count = static_cast<std::uint16_t>(list.size());
}

/// What g31 knows the name of, and no more: the row of the word before says why.
void Compiler::refused_statement() {
  const std::string_view name = tokens_[at_ - 1].text;
  const auto row = std::ranges::find(keywords(), name, &KeywordInfo::name);
  const bool is_known = row != keywords().end();
  fail(AlarmId::NotImplemented, block_,
       is_known ? std::string(name) + ": " + std::string(row->text) : text_of(block_));
}

/// What makes no difference at a desk, to the end of its block.
void Compiler::idle_statement() {
  while (peek().kind != TokenKind::End) {
    next();
  }
}

/// WHEN $A_PROBE[n]==level DO DELDTG, the condition in brackets or not; another synchronised action
void Compiler::when_statement() {
  if (!peek().is_name("$A_PROBE") && !peek(1).is_name("$A_PROBE")) {
    action_statement();
    return;
  }
  const bool bracket = accept(Symbol::LeftParen);
  const bool of_probe = accept_name("$A_PROBE") && accept(Symbol::LeftBracket);
  const Expr probe = of_probe ? convert(expression(), Type::Int) : Expr();
  const bool compared = of_probe && accept(Symbol::RightBracket) && accept(Symbol::Equal);
  const Expr level = compared ? boolean(expression()) : Expr();
  const bool closed = compared && (!bracket || accept(Symbol::RightParen));
  const bool deletes =
      closed && accept_name("DO") && accept_name("DELDTG") && peek().kind == TokenKind::End;
  if (!deletes && !failed()) {
    refused_statement();
  }
  if (!failed()) {
    emit(OpCode::SkipAction, {}, probe.value, level.value, block_);
  }
}

Compiler::Handler Compiler::find_keyword(std::string_view name) {
  static const NameMap<Handler> kHandlers = [] {
    NameMap<Handler> map;
#define KEYWORD(name, handler, form, text) map.emplace(#name, &Compiler::handler);
#include "interpreter/dialects/sinumerik/vocabulary/keywords.def"
#undef KEYWORD
    return map;
  }();
  const auto found = kHandlers.find(name);
  return found != kHandlers.end() ? found->second : nullptr;
}

}  // namespace g31::sinumerik

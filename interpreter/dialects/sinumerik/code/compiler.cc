#include "interpreter/dialects/sinumerik/code/compiler.h"

#include <algorithm>

#include "interpreter/dialects/sinumerik/code/replaced_names.h"
#include "interpreter/source/printable.h"

namespace g31::sinumerik {
namespace {

/// Statements that say which block is next, by their part of the compiler.
constexpr bool directs_flow(std::string_view part) {
  return part == "structures" || part == "jumps";
}

}  // namespace

const Compiler::Handler* Compiler::find_handler(std::string_view name) {
  static const NameMap<Handler> kHandlers = [] {
    NameMap<Handler> map;
#define KEYWORD(name, part, statement, form, text)                                     \
  map.emplace(#name, Handler{[](Compiler& compiler) { compiler.part##_.statement(); }, \
                             directs_flow(#part)});
#include "interpreter/dialects/sinumerik/vocabulary/keywords.def"
#undef KEYWORD
    return map;
  }();
  const auto found = kHandlers.find(name);
  return found != kHandlers.end() ? &found->second : nullptr;
}

void Compiler::read_block(ShortSpan span) {
  std::vector<Token>& tokens = cursor_.tokens();
  scanner_.scan(span, tokens);
  const bool fits = expand_macros(tokens, seen_macros_);
  if (tokens.size() == 1) {
    return;  // nothing, or macros that stand for nothing
  }
  if (definitions_.have_letter_names()) {
    find_letter_names(tokens, program_.locals);
  }
  begin_block({tokens.front().where.begin, tokens[tokens.size() - 2].where.end});
  if (fits) {
    block_head();
    statement();
  } else {
    fail(AlarmId::TooComplex, block());
  }
  if (failed()) {
    program_.has_wrong_proc =
        program_.has_wrong_proc || (definitions_.is_first_block() && program_.has_proc);
    program_.ops[code_.first_step()].code = OpCode::Block;  // whatever words it had
    raise_from(code_.first_step() + 1);
  }
  end_block();
}

void Compiler::begin_block(ShortSpan block) {
  reader_.begin(block);
  definitions_.begin_block();
  code_.begin_block(block);
}

void Compiler::end_block() {
  program_.ops[code_.first_step()].a.place = code_.here();
  definitions_.end_block();
}

/// What the block has left so far is worth nothing.
void Compiler::take_back(std::size_t first_step) {
  code_.cut(first_step);
  jumps_.take_back(first_step);
  nc_.take_back();
}

/// The alarm takes the place of the block's steps.
void Compiler::raise_from(std::size_t first_step) {
  take_back(first_step);
  code_.emit(OpCode::Raise, {}, code_.error_constant(reader_.error()), {}, reader_.error_place());
}

void Compiler::block_head() {
  if (cursor_.accept(Symbol::Slash)) {
    double level = 0.0;
    if (cursor_.peek().kind == TokenKind::Integer) {
      level = cursor_.next().number;
    }
    if (!(level >= 0.0 && level <= 9.0)) {
      fail(AlarmId::BadSkipLevel, block());
      return;
    }
    code_.last().detail = static_cast<std::uint8_t>(1.0 + level);
  }
  label_or_number();
}

void Compiler::label_or_number() {
  const bool numbered = cursor_.peek().is_letter('N') && cursor_.peek(1).kind == TokenKind::Integer;
  const bool main = cursor_.peek().is(Symbol::Colon) && cursor_.peek(1).kind == TokenKind::Integer;
  if (numbered || main) {
    cursor_.next();
    program_.block_numbers.push_back(
        {static_cast<std::int32_t>(cursor_.next().number), code_.here() - 1});
  }
  const bool is_label =
      cursor_.peek(1).is(Symbol::Colon) ||
      (cursor_.peek().kind == TokenKind::Letter && cursor_.peek(2).is(Symbol::Colon));
  if (is_label) {
    if (const auto name = jumps_.label_name()) {
      program_.labels[*name].push_back(code_.here() - 1);
    }
    expect(Symbol::Colon);
  }
}

/// A single letter: R and its number, L a program, else a word.
void Compiler::letter_item() {
  const Token& letter = cursor_.peek();
  const bool numbered = cursor_.peek(1).kind == TokenKind::Integer;
  if (letter.is_letter('R') && (numbered || cursor_.peek(1).is(Symbol::LeftBracket))) {
    cursor_.next();
    assignments_.assign_variable(variables_.find("R"), letter.where);
    return;
  }
  cursor_.next();
  if (letter.is_letter('L') && numbered) {
    calls_.call_by_name("L" + std::string(cursor_.next().text), letter.where);
    return;
  }
  words_.letter_word(letter);
}

void Compiler::statement() {
  while (!failed() && cursor_.peek().kind != TokenKind::End) {
    const int before = definitions_.count_in_block();
    item();
    if (definitions_.count_in_block() == before) {
      definitions_.begin_program_part();
    }
  }
  if (!failed()) {
    words_.finish_block();
  }
}

/// One statement, assignment, word or call; most blocks have one, or words only.
void Compiler::item() {
  const Token& token = cursor_.peek();
  if (token.kind == TokenKind::Letter) {
    letter_item();
    return;
  }
  if (token.kind != TokenKind::Name) {
    fail(AlarmId::SyntaxInText, text_of(token.where));
    return;
  }
  if (purpose_ == Purpose::Data && (token.is_name("METRIC"))) {
    cursor_.next();  // the lengths of the file, as those of the basic system
    return;
  }
  if (const Handler* const handler = find_handler(token.text)) {
    cursor_.next();
    if (handler->directs_flow) {
      words_.finish_block();  // the words before a jump belong to the same block and come first
    }
    handler->compile(*this);
    return;
  }
  if (const auto id = find_procedure(token.text)) {
    calls_.procedure(*id, cursor_.next().where);
    return;
  }
  if (!program_.locals.contains(token.text) && words_.named_word()) {
    return;
  }
  const Token name = cursor_.next();
  if (const std::int32_t variable = variables_.find(name.text); variable >= 0) {
    assignments_.assign_variable(variable, name.where);
  } else if (const auto system = find_system_variable(name.text);
             system && (purpose_ != Purpose::Data || system->row->access != Access::Refused)) {
    assignments_.assign_system(*system, name.where);
  } else if (purpose_ == Purpose::Data && name.text.starts_with('$')) {
    assignments_.pass_over(name);
  } else if (cursor_.peek().is(Symbol::Assign) || cursor_.peek().is(Symbol::LeftBracket)) {
    fail(AlarmId::NotDefined, name.where, name.text);
  } else {
    calls_.call_by_name(std::string(name.text), name.where);
  }
}

}  // namespace g31::sinumerik

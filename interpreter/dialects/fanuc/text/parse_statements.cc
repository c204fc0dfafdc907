#include <algorithm>
#include <bit>
#include <charconv>
#include <cmath>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/dialects/fanuc/text/parser.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"

namespace g31::fanuc {
namespace {

using syntax::Block;
using syntax::BlockKind;
using syntax::Index;
using syntax::kNone;
using syntax::ShortSpan;

/// No control has loops of larger numbers; most have fewer (LoopRule).
constexpr double kLargestLoopNumber = 127.0;

/// IF THEN IF THEN...: more of them in one block is no program, but would fill the stack.
constexpr int kThenLimit = 10;

}  // namespace

void Parser::keyword(Block& block) {
  const std::uint32_t begin = scanner_.position();
  if (scanner_.accept_word("IF")) {
    if_statement(block);
  } else if (scanner_.accept_word("WHILE") || scanner_.accept_word("WH")) {
    while_statement(block);
  } else if (scanner_.accept_word("DO")) {
    block.kind = BlockKind::Do;
    block.number = loop_number();
  } else if (scanner_.accept_word("ENDIF")) {
    expressions_.fail_at(AlarmId::IllegalLoopNumber, {begin, scanner_.position()},
                         "there is no ENDIF: IF .. THEN rules one statement, IF .. GOTO jumps");
  } else if (scanner_.accept_word("END") || scanner_.accept_word("EN")) {
    block.kind = BlockKind::End;
    block.number = loop_number();
  } else if (scanner_.accept_word("SETVN") || scanner_.accept_word("SE")) {
    set_names(block);
  } else if (scanner_.peek() == 'G') {
    jump(block);
    block.kind = BlockKind::Goto;
  } else {
    const std::string name(scanner_.letters());
    if (const auto statement = find_output_statement(name)) {
      output_statement(block, *statement);
      return;
    }
    expressions_.fail_at(
        AlarmId::AddressNotFound, {begin, scanner_.position()},
        fmt::format("{} is neither a statement of Custom Macro B nor words", name));
  }
  if (!failed()) {
    expect_end();
  }
}

/// `G10L85P500(4008000000000000)`: #500 becomes the double of these digits, IEEE 754.
void Parser::punched_variable(Block& block) {
  constexpr std::size_t kDigits = 16;
  constexpr int kHexadecimal = 16;
  block.kind = BlockKind::Assign;
  scanner_.rewind(scanner_.position() + static_cast<std::uint32_t>(kPunchedVariable.size()));
  scanner_.forget_comment();
  syntax::Expr number;
  number.span.begin = scanner_.position();
  number.number = integer("P of G10 L85 is the number of a common variable");
  if (failed()) {
    return;
  }
  number.span.end = scanner_.position();
  expect_end();
  const ShortSpan comment = scanner_.last_comment();
  const std::string_view digits =
      scanner_.text().substr(comment.begin, comment.end - comment.begin);
  std::uint64_t bits = 0;
  const auto read =
      std::from_chars(digits.data(), digits.data() + digits.size(), bits, kHexadecimal);
  if (failed() || digits.size() != kDigits || read.ptr != digits.data() + digits.size()) {
    fail(AlarmId::DataInputFormat, "behind G10 L85 P stand 16 hexadecimal digits in ( )");
    return;
  }
  syntax::Expr target;
  target.kind = syntax::ExprKind::Variable;
  target.a = expressions_.add(number);
  target.span = number.span;
  block.target = expressions_.add(target);
  syntax::Expr value;
  value.number = std::bit_cast<double>(bits);
  value.span = comment;
  if (!std::isfinite(value.number)) {  // a vacant one: #0
    value.number = 0.0;
    syntax::Expr vacant;
    vacant.kind = syntax::ExprKind::Variable;
    vacant.a = expressions_.add(value);
    vacant.span = comment;
    value = vacant;
  }
  block.value = expressions_.add(value);
}

/// SETVN n[NAME,NAME]: the names stay text; the run gives them (MB-104).
void Parser::set_names(Block& block) {
  block.kind = BlockKind::SetNames;
  block.number = integer("SETVN needs the number of a common variable");
  if (block.number < 0) {
    return;
  }
  if (!scanner_.accept('[')) {
    fail(AlarmId::NameFormat, "names in brackets are expected here");
    return;
  }
  scanner_.peek();
  block.text = {scanner_.position(), scanner_.position()};
  if (scanner_.accept(']')) {
    return;  // no name: as a control punches those that have none
  }
  do {
    const ShortSpan name = scanner_.name();
    const std::string_view text = scanner_.text().substr(name.begin, name.end - name.begin);
    if (!is_variable_name(text) || text.size() > kLongestName) {
      expressions_.fail_at(AlarmId::NameFormat, {name.begin, std::max(name.begin + 1, name.end)},
                           "a name is a letter, then letters, digits and _, at most 31 in all");
      return;
    }
    block.text.end = name.end;
  } while (scanner_.accept(','));
  if (!scanner_.accept(']')) {
    fail(AlarmId::NameFormat, "a comma and a name, or ], is expected here");
  }
}

/// The format stays text: it has a syntax of its own, in which ( ) and blanks are no comment.
void Parser::output_statement(Block& block, OutputStatement statement) {
  block.kind = BlockKind::Output;
  block.number = static_cast<std::int32_t>(statement);
  if (info(statement).has_format == HasFormat::No) {
    expect_end();
    return;
  }
  if (scanner_.peek() != '[') {
    fail(AlarmId::OutputFormat, "a format in brackets is expected here");
    return;
  }
  const std::uint32_t begin = scanner_.position() + 1;
  std::uint32_t end = begin;
  int depth = 1;
  for (const char c : scanner_.text().substr(begin)) {
    depth += c == '[' ? 1 : c == ']' ? -1 : 0;
    if (depth == 0 || c == '\n') {
      break;
    }
    ++end;
  }
  block.text = {begin, end};
  const auto items = parse_output_format(scanner_.text().substr(begin, end - begin));
  if (depth != 0 || !items) {
    expressions_.fail_at(AlarmId::OutputFormat, {begin - 1, end},
                         depth != 0 ? "this [ has no ]" : items.error());
    return;
  }
  scanner_.rewind(end + 1);
  expect_end();
}

void Parser::jump(Block& block) {
  if (!scanner_.accept_word("GOTO") && !scanner_.accept_word("GO")) {
    fail(AlarmId::StatementFormat, "GOTO is expected here");
    return;
  }
  const char next = scanner_.peek();
  if (next == '#' || next == '[') {
    block.value = computed_value();
    return;
  }
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const bool negative = scanner_.accept('-');
  const auto number = scanner_.number();
  if (!number) {
    fail(AlarmId::StatementFormat, "GOTO needs a sequence number, a #variable or [an expression]");
    return;
  }
  syntax::Expr target;
  target.number = negative ? -number->value : number->value;
  target.span = {begin, scanner_.position()};
  block.value = expressions_.add(target);
}

Index Parser::condition() {
  if (scanner_.peek() != '[') {
    fail(AlarmId::StatementFormat, "a condition in brackets is expected here");
    return kNone;
  }
  return expressions_.bracketed();
}

void Parser::if_statement(Block& block) {
  block.condition = condition();
  if (failed()) {
    return;
  }
  const bool has_then = scanner_.accept_word("THEN") || scanner_.accept_word("TH");
  if (has_then || !jump_follows()) {
    block.is_bare = !has_then;
    block.kind = BlockKind::IfThen;
    then_statement(block);
    return;
  }
  block.kind = BlockKind::IfGoto;
  jump(block);
}

/// Whether GOTO comes, or nothing that could be a statement, of which jump() complains.
bool Parser::jump_follows() {
  const char next = scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const bool is_jump = scanner_.accept_word("GO");
  scanner_.rewind(begin);
  return is_jump || !((next >= 'A' && next <= 'Z') || next == '#' || expressions_.at_name());
}

/// The statement behind THEN becomes a block of its own, right behind this one.
void Parser::then_statement(Block& block) {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  block.span.end = begin;
  const std::size_t place = tree_.blocks.size();
  tree_.blocks.push_back(block);
  Block statement;
  statement.first_word = block.first_word;
  statement.skip_switch = block.skip_switch;
  if (scanner_.peek() == '\n') {
    fail(AlarmId::StatementFormat, "a macro statement is expected after THEN");
  } else if (++then_depth_ > kThenLimit) {
    fail(AlarmId::StatementFormat, "too many THEN in one block");
  } else {
    body(statement);
    const bool is_loop = statement.kind == BlockKind::While || statement.kind == BlockKind::Do ||
                         statement.kind == BlockKind::End;
    if (!failed() && is_loop) {
      expressions_.fail_at(AlarmId::StatementFormat, {begin, scanner_.position()},
                           "THEN takes a macro statement, not a loop or NC words");
    }
  }
  statement.span = {begin, scanner_.position()};
  if (failed()) {
    tree_.blocks.pop_back();
    return;
  }
  tree_.blocks[place] = block;
  block = statement;
}

void Parser::while_statement(Block& block) {
  block.kind = BlockKind::While;
  block.condition = condition();
  if (failed()) {
    return;
  }
  if (!scanner_.accept_word("DO")) {
    fail(AlarmId::StatementFormat, "DO and a loop number are expected after the condition");
    return;
  }
  block.number = loop_number();
}

int Parser::loop_number() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const auto number = scanner_.number();
  if (!number || number->has_point || number->value < 1.0 || number->value > kLargestLoopNumber) {
    expressions_.fail_at(AlarmId::IllegalLoopNumber,
                         {begin, std::max(begin + 1, scanner_.position())},
                         number ? fmt::format("a loop number is an integer from 1 to {}",
                                              static_cast<int>(kLargestLoopNumber))
                                : "a loop number is written as an integer");
    return 0;
  }
  return static_cast<int>(number->value);
}

}  // namespace g31::fanuc

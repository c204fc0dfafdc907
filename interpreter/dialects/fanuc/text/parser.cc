#include "interpreter/dialects/fanuc/text/parser.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/word_values.h"
#include "interpreter/dialects/fanuc/vocabulary/program_key.h"
#include "interpreter/source/printable.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::Block;
using syntax::BlockKind;
using syntax::Index;
using syntax::kNone;
using syntax::ShortSpan;
using syntax::ValueForm;
using syntax::Word;

constexpr std::int64_t kLargestInteger = 99'999'999;

}  // namespace

void Parser::open_program(std::int32_t number, ShortSpan name) {
  close_program();
  syntax::Program program;
  program.number = number;
  program.first_block = static_cast<Index>(tree_.blocks.size());
  program.name = name;
  tree_.programs.push_back(program);
}

void Parser::close_program() {
  if (!tree_.programs.empty()) {
    syntax::Program& last = tree_.programs.back();
    last.block_count = static_cast<Index>(tree_.blocks.size()) - last.first_block;
  }
}

/// `&F=/USER/PATH1/`, as a control writes before the programs of a folder when it punches all.
bool Parser::at_folder() const {
  constexpr std::string_view kFolder = "&F=";
  return scanner_.text().substr(scanner_.position()).starts_with(kFolder);
}

[[gnu::hot]] void Parser::block() {
  const char first = scanner_.peek();
  if ((first == '\n' && tree_.programs.empty()) || (first == '&' && at_folder())) {
    return;
  }
  const std::uint32_t begin = scanner_.position();
  Block block;
  block.span = {begin, begin};
  if (!program_number(block) && tree_.programs.empty()) {
    open_program(0, {begin, begin});
  }
  block.first_word = static_cast<Index>(tree_.words.size());
  head(block);
  if (block.kind != BlockKind::Bad) {
    body(block);
  }
  settle(block, begin);
}

/// A block as nearly every one of a long program is: words and their numbers, and nothing that
/// block() looks for before it reads words.
/// @returns false: it is otherwise, and nothing is stepped over
[[gnu::hot]] bool Parser::plain_block() {
  const std::uint32_t begin = scanner_.position();
  std::int32_t sequence = -1;
  if (tree_.programs.empty() || !scanner_.begins_plainly(sequence)) {
    return false;
  }
  const auto first_word = static_cast<Index>(tree_.words.size());
  if (!at_punched_variable()) {
    const PlainWords plain = scanner_.plain_words(tree_.words);
    if (scanner_.at_line_end() || scanner_.peek() == '\n') {
      Block& block = tree_.blocks.emplace_back();  // a copy would wait for its parts
      block.kind = BlockKind::Nc;
      block.is_plain = true;
      block.digits = static_cast<std::uint8_t>(plain.digits);
      block.letters = plain.letters;
      block.sequence = sequence;
      block.first_word = first_word;
      block.word_count = static_cast<Index>(tree_.words.size()) - first_word;
      block.span = {begin, scanner_.position()};
      return true;
    }
  }
  tree_.words.resize(first_word);
  scanner_.rewind(begin);
  scanner_.forget_comment();
  return false;
}

/// Gives the block its span and its error, and appends it (an IF THEN goes before its statement).
[[gnu::hot]] void Parser::settle(Block& block, std::uint32_t begin) {
  const std::uint32_t end = scanner_.position();
  if (failed()) {
    block.begins_loop = block.kind == BlockKind::While || block.kind == BlockKind::Do;
    block.kind = BlockKind::Bad;
    block.number = static_cast<std::int32_t>(tree_.errors.size());
    tree_.words.resize(block.first_word);
    tree_.errors.push_back(*expressions_.error());
  }
  expressions_.forget_error();
  then_depth_ = 0;
  // What is known last goes to its place by itself: a copy would wait for it.
  Block& settled = tree_.blocks.emplace_back(block);
  settled.span = {begin, end};
  settled.word_count = static_cast<Index>(tree_.words.size()) - settled.first_word;
}

[[gnu::hot]] bool Parser::program_number(Block& block) {
  const char next = scanner_.peek();
  if (next == '<') {
    return program_name(block);
  }
  if (next != 'O' && next != ':') {
    return false;
  }
  const std::uint32_t begin = scanner_.position();
  scanner_.step();
  const std::int32_t number = integer("a program number is O and 1 to 8 digits");
  if (number < 0) {
    block.kind = BlockKind::Bad;
    if (tree_.programs.empty()) {
      open_program(0, {begin, begin});
    }
    return true;
  }
  open_program(number, {begin, scanner_.position()});
  return true;
}

/// `<PROBE-BORE>` in place of O and a number (MB-002).
bool Parser::program_name(Block& block) {
  const ShortSpan name = name_in_angles();
  open_program(key_between_angles(scanner_.text(), name).number, name);
  block.kind = failed() ? BlockKind::Bad : block.kind;
  return true;
}

/// `<NAME>`, which begins here; empty where it has no end, which is an error.
ShortSpan Parser::name_in_angles() {
  const std::uint32_t begin = scanner_.position();
  const std::size_t end = scanner_.text().find_first_of(">\n", begin);
  if (end == std::string_view::npos || scanner_.text()[end] == '\n') {
    fail(AlarmId::IllegalAddress, "the name of a program stands between < and >");
    return {begin, begin};
  }
  scanner_.rewind(static_cast<std::uint32_t>(end + 1));
  return {begin, scanner_.position()};
}

/// `<NAME>` behind the code of a call, in the place of P.
bool Parser::called_name() {
  // A block begins with a letter, so the last word is one of this block.
  if (!calls_program(tree_.words.back())) {
    fail(AlarmId::CalledByNameFormat,
         "the name of a program stands right behind M98, M198, G65, G66 or G66.1");
    return false;
  }
  const ShortSpan name = name_in_angles();
  if (failed()) {
    return false;
  }
  Word& word = tree_.words.emplace_back();
  word.letter = 'P';
  word.form = ValueForm::Name;
  word.span = name;
  return true;
}

/// @returns -1 after a failure: an optional would wait for its parts
[[gnu::hot]] std::int32_t Parser::integer(const char* what) {
  if (const std::int32_t plain = scanner_.plain_integer(); plain >= 0) {
    return plain;
  }
  const auto found = scanner_.number();
  if (!found || found->has_point) {
    fail(found ? AlarmId::IllegalPoint : AlarmId::NoDataAfterAddress, what);
    return -1;
  }
  if (found->value > static_cast<double>(kLargestInteger)) {
    fail(AlarmId::TooManyDigits, what);
    return -1;
  }
  return static_cast<std::int32_t>(found->value);
}

/// n of `/n`; `/` alone is switch 1 (MB-005).
std::uint8_t Parser::switch_number() {
  const char digit = scanner_.peek();
  if (digit < '1' || digit > '9') {
    return 1;
  }
  scanner_.step();
  return static_cast<std::uint8_t>(digit - '0');
}

/// `/n` and `N..` in either order.
[[gnu::hot]] void Parser::head(Block& block) {
  for (;;) {
    if (scanner_.accept('/')) {
      block.skip_switch = switch_number();
    } else if (scanner_.peek() == 'N' && block.sequence < 0) {
      scanner_.step();
      block.sequence = integer("a sequence number is N and digits, without variables");
      if (block.sequence < 0) {
        block.kind = BlockKind::Bad;
        return;
      }
    } else {
      return;
    }
  }
}

[[gnu::hot]] void Parser::body(Block& block) {
  if (failed()) {
    return;
  }
  const char next = scanner_.peek();
  if (next == '\n') {
    return;
  }
  if (next == '#' || (next == '[' && expressions_.at_name())) {
    assignment(block);
    return;
  }
  if (next == '[') {
    condition_alone(block);
    return;
  }
  if (next == 'G' && at_punched_variable()) {
    punched_variable(block);
    return;
  }
  if (next < 'A' || next > 'Z') {
    fail(AlarmId::AddressNotFound, why_no_word(scanner_.text(), next));
    return;
  }
  const std::uint32_t begin = scanner_.position();
  scanner_.step();
  const char second = scanner_.peek();
  scanner_.rewind(begin);
  if (second >= 'A' && second <= 'Z') {
    keyword(block);
  } else {
    words(block);
  }
}

/// `[condition] M99 P10`
void Parser::condition_alone(Block& block) {
  block.condition = expressions_.bracketed();
  if (!failed()) {
    block.is_bare = true;
    block.kind = BlockKind::IfThen;
    then_statement(block);
  }
}

void Parser::assignment(Block& block) {
  block.kind = BlockKind::Assign;
  block.target = scanner_.peek() == '#' ? expressions_.variable() : expressions_.named_variable();
  if (failed()) {
    return;
  }
  if (!scanner_.accept('=')) {
    fail(AlarmId::ExpressionFormat,
         fmt::format("= is expected after the variable{}", letter_o_hint(scanner_.peek())));
    return;
  }
  scanner_.forget_comment();
  block.value = is_bare_message(block) ? bare_message(block) : expressions_.expression();
  if (!failed()) {
    scanner_.peek();
    block.text = scanner_.last_comment();
    expect_end();
  }
}

/// `#3006=(TEXT)`, which some controls take.
bool Parser::is_bare_message(const Block& block) {
  constexpr double kMessageStop = 3006.0;
  const syntax::Expr& target = tree_.exprs[block.target];
  return scanner_.peek() == '\n' && target.kind == syntax::ExprKind::Variable &&
         tree_.exprs[target.a].number == kMessageStop &&
         scanner_.last_comment().end > scanner_.last_comment().begin;
}

syntax::Index Parser::bare_message(Block& block) {
  block.is_bare = true;
  return expressions_.add({});
}

void Parser::expect_end() {
  const char next = scanner_.peek();
  if (next == '\n') {
    return;
  }
  const bool starts_word = next >= 'A' && next <= 'Z';
  fail(starts_word || next == '#' ? AlarmId::MixedStatement : AlarmId::ExpressionFormat,
       fmt::format("the statement ends before {}{}", source::quoted(next), letter_o_hint(next)));
}

[[gnu::hot]] void Parser::words(Block& block) {
  block.kind = BlockKind::Nc;
  block.is_plain = true;
  const PlainWords plain = scanner_.plain_words(tree_.words);
  block.letters = plain.letters;
  block.digits = static_cast<std::uint8_t>(plain.digits);
  while (!scanner_.at_line_end() && word()) {
    block.is_plain = false;
    scanner_.plain_words(tree_.words);
  }
  if (goes_on_) [[unlikely]] {
    statement_behind_words(block);
  }
}

/// GOTO, or a condition and what it rules: a block of its own, right behind that of the words.
void Parser::statement_behind_words(Block& block) {
  goes_on_ = false;
  const std::uint32_t begin = scanner_.position();
  Block words = block;
  words.span.end = begin;
  words.goes_on = true;
  words.word_count = static_cast<Index>(tree_.words.size()) - block.first_word;
  const std::size_t place = tree_.blocks.size();
  tree_.blocks.push_back(words);
  Block statement;
  statement.skip_switch = block.skip_switch;
  statement.first_word = static_cast<Index>(tree_.words.size());
  statement.span = {begin, begin};
  body(statement);
  if (failed()) {
    tree_.blocks.resize(place);
  } else {
    block = statement;
  }
}

/// A word that could not be read is no error if it is GOTO, which is to be read anew.
void Parser::forgive_jump(std::uint32_t begin) {
  const std::uint32_t end = scanner_.position();
  scanner_.rewind(begin);
  goes_on_ = scanner_.accept_word("GO");
  scanner_.rewind(goes_on_ ? begin : end);
  if (goes_on_) {
    expressions_.forget_error();
  }
}

/// However it is written; none where the block ends or goes on as a statement.
bool Parser::word() {
  const char next = scanner_.peek();
  if (next == '\n') {
    return false;
  }
  const std::uint32_t begin = scanner_.position();
  if (next == '[') {
    goes_on_ = true;
    return false;
  }
  if (next == '#') {
    fail(AlarmId::MixedStatement, "a macro statement needs a block of its own");
    return false;
  }
  const char letter = scanner_.address(next);
  if (letter == 0 && next == '<') {
    return called_name();
  }
  if (letter == 0) {
    fail(AlarmId::IllegalAddress, fmt::format("{} is not an address letter{}", source::quoted(next),
                                              next == ',' ? " (the decimal sign is a point)" : ""));
    return false;
  }
  Word& word = tree_.words.emplace_back();
  word.letter = letter;
  if (letter == '/') {
    word.form = ValueForm::Integer;
    word.number = switch_number();
  } else {
    word_value(word);
  }
  if (failed()) {
    tree_.words.pop_back();
    forgive_jump(begin);
    return false;
  }
  word.span = {begin, scanner_.position()};
  return true;
}

/// `#n`, `#[expression]`, `[#NAME]` or `[expression]`, which begins here.
Index Parser::computed_value() {
  if (scanner_.peek() == '#') {
    return expressions_.variable();
  }
  return expressions_.at_name() ? expressions_.named_variable() : expressions_.bracketed();
}

void Parser::word_value(Word& word) {
  char next = scanner_.peek();
  const bool negative = next == '-';
  if (next == '-' || next == '+') {
    scanner_.step();
    next = scanner_.peek();
  }
  if (next == '#' || next == '[') {
    word.form = ValueForm::Computed;
    word.expr = computed_value();
    if (negative && word.expr != kNone) {
      syntax::Expr negate;
      negate.kind = syntax::ExprKind::Negate;
      negate.a = word.expr;
      negate.span = tree_.exprs[word.expr].span;
      word.expr = expressions_.add(negate);
    }
    const std::uint32_t end = scanner_.position();
    if (word.expr != kNone &&
        std::string_view("+-*").find(scanner_.peek()) != std::string_view::npos) {
      word.is_bare = true;
      word.expr = expressions_.continued(word.expr);
    } else {
      scanner_.rewind(end);  // what stands behind it is no part of it
    }
    return;
  }
  const auto number = scanner_.number();
  if (!number) {
    const bool is_mixed = next >= 'A' && next <= 'Z';
    fail(is_mixed ? AlarmId::MixedStatement : AlarmId::NoDataAfterAddress,
         fmt::format("{} needs a number, a #variable or [an expression]",
                     syntax::letter_text(word.letter)));
    return;
  }
  word.form = number->has_point ? ValueForm::Decimal : ValueForm::Integer;
  word.digits = number->digits;
  word.decimals = number->decimals;
  word.number = negative ? -number->value : number->value;
}

syntax::Tree parse(std::string_view text, TextBegins begins) {
  G31_EXPECTS(text.size() < std::numeric_limits<std::uint32_t>::max());
  return Parser(text).run(begins);
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/text/parse.h"

#include <algorithm>
#include <limits>
#include <optional>
#include <string>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/output_format.h"
#include "interpreter/dialects/fanuc/text/parse_expression.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"
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

/// No control has loops of larger numbers; most have fewer (LoopRule).
constexpr double kLargestLoopNumber = 127.0;

/// IF THEN IF THEN...: more of them in one block is no program, but would fill the stack.
constexpr int kThenLimit = 10;

/// Reads the blocks of a tape one by one.
class Parser {
 public:
  explicit Parser(std::string_view text) : scanner_(text), expressions_(scanner_, tree_) {}

  syntax::Tree run(TextBegins begins) {
    reserve();
    if (begins == TextBegins::AtFile) {
      scanner_.skip_leader();
    } else {
      open_program(0, {});
    }
    while (!scanner_.at_end_of_text() && !scanner_.at_tape_end()) {
      block();
      scanner_.skip_block();
    }
    close_program();
    tree_.end = scanner_.position();
    return std::move(tree_);
  }

 private:
  /// Room for what a text of this size holds as a rule.
  void reserve() {
    tree_.blocks.reserve(scanner_.text().size() / 32);
    tree_.words.reserve(scanner_.text().size() / 6);
  }
  void block();
  bool program_number(Block& block);
  bool program_name(Block& block);
  void head(Block& block);
  std::uint8_t switch_number();
  void body(Block& block);
  void condition_alone(Block& block);
  void assignment(Block& block);
  void words(Block& block);
  bool word();
  void word_value(Word& word);
  Index computed_value();
  void keyword(Block& block);
  void if_statement(Block& block);
  bool jump_follows();
  void while_statement(Block& block);
  void then_statement(Block& block);
  void jump(Block& block);
  void set_names(Block& block);
  void output_statement(Block& block, OutputStatement statement);
  int loop_number();
  Index condition();
  std::optional<std::int32_t> integer(const char* what);
  void expect_end(Block& block);
  void open_program(std::int32_t number, ShortSpan name);
  void close_program();
  void settle(Block& block, std::uint32_t begin);

  bool failed() const { return expressions_.error().has_value(); }
  void fail(AlarmId id, std::string message) { expressions_.fail(id, std::move(message)); }

  syntax::Tree tree_;
  Scanner scanner_;
  ExpressionParser expressions_;
  int then_depth_ = 0;
};

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

void Parser::block() {
  if (scanner_.peek() == '\n' && tree_.programs.empty()) {
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

/// Gives the block its span and its error, and appends it (an IF THEN goes before its statement).
void Parser::settle(Block& block, std::uint32_t begin) {
  const std::uint32_t end = scanner_.position();
  if (failed()) {
    block.kind = BlockKind::Bad;
    block.number = static_cast<std::int32_t>(tree_.errors.size());
    block.word_count = 0;
    tree_.words.resize(block.first_word);
    tree_.errors.push_back(*expressions_.error());
  }
  expressions_.forget_error();
  then_depth_ = 0;
  block.span = {begin, end};
  tree_.blocks.push_back(block);
}

bool Parser::program_number(Block& block) {
  const char next = scanner_.peek();
  if (next == '<') {
    return program_name(block);
  }
  if (next != 'O' && next != ':') {
    return false;
  }
  const std::uint32_t begin = scanner_.position();
  scanner_.step();
  const auto number = integer("a program number is O and 1 to 8 digits");
  if (!number) {
    block.kind = BlockKind::Bad;
    if (tree_.programs.empty()) {
      open_program(0, {begin, begin});
    }
    return true;
  }
  open_program(*number, {begin, scanner_.position()});
  return true;
}

/// `<PROBE-BORE>` in place of O and a number (MB-002).
bool Parser::program_name(Block& block) {
  const std::uint32_t begin = scanner_.position();
  const std::size_t end = scanner_.text().find_first_of(">\n", begin);
  open_program(0, {begin, begin});
  if (end == std::string_view::npos || scanner_.text()[end] == '\n') {
    fail(AlarmId::IllegalAddress, "the name of a program stands between < and >");
    block.kind = BlockKind::Bad;
    return true;
  }
  scanner_.rewind(static_cast<std::uint32_t>(end + 1));
  tree_.programs.back().name = {begin, scanner_.position()};
  return true;
}

std::optional<std::int32_t> Parser::integer(const char* what) {
  const auto found = scanner_.number();
  if (!found || found->has_point) {
    fail(found ? AlarmId::IllegalPoint : AlarmId::NoDataAfterAddress, what);
    return std::nullopt;
  }
  if (found->value > static_cast<double>(kLargestInteger)) {
    fail(AlarmId::TooManyDigits, what);
    return std::nullopt;
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
void Parser::head(Block& block) {
  for (;;) {
    if (scanner_.accept('/')) {
      block.skip_switch = switch_number();
    } else if (scanner_.peek() == 'N' && block.sequence < 0) {
      scanner_.step();
      const auto number = integer("a sequence number is N and digits, without variables");
      if (!number) {
        block.kind = BlockKind::Bad;
        return;
      }
      block.sequence = *number;
    } else {
      return;
    }
  }
}

void Parser::body(Block& block) {
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
    fail(AlarmId::ExpressionFormat, "= is expected after the variable");
    return;
  }
  scanner_.forget_comment();
  block.value = expressions_.expression();
  if (!failed()) {
    scanner_.peek();
    block.text = scanner_.last_comment();
    expect_end(block);
  }
}

void Parser::expect_end(Block& block) {
  const char next = scanner_.peek();
  if (next == '\n') {
    return;
  }
  const bool starts_word = next >= 'A' && next <= 'Z';
  fail(starts_word || next == '#' ? AlarmId::MixedStatement : AlarmId::ExpressionFormat,
       fmt::format("the statement ends before {}", source::quoted(next)));
  block.kind = BlockKind::Bad;
}

void Parser::words(Block& block) {
  block.kind = BlockKind::Nc;
  while (!failed() && word()) {
  }
  block.word_count = static_cast<Index>(tree_.words.size()) - block.first_word;
}

bool Parser::word() {
  const char next = scanner_.peek();
  if (next == '\n') {
    return false;
  }
  const std::uint32_t begin = scanner_.position();
  if (next == '#') {
    fail(AlarmId::MixedStatement, "a macro statement needs a block of its own");
    return false;
  }
  const char letter = scanner_.address(next);
  if (letter == 0) {
    fail(AlarmId::IllegalAddress, fmt::format("{} is not an address letter", source::quoted(next)));
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
    if (word.expr != kNone &&
        std::string_view("+-*").find(scanner_.peek()) != std::string_view::npos) {
      word.is_bare = true;
      word.expr = expressions_.continued(word.expr);
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

void Parser::keyword(Block& block) {
  const std::uint32_t begin = scanner_.position();
  if (scanner_.accept_word("IF")) {
    if_statement(block);
  } else if (scanner_.accept_word("WHILE") || scanner_.accept_word("WH")) {
    while_statement(block);
  } else if (scanner_.accept_word("DO")) {
    block.kind = BlockKind::Do;
    block.number = loop_number();
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
    expect_end(block);
  }
}

/// SETVN n[NAME,NAME]: the names stay text; the run gives them (MB-104).
void Parser::set_names(Block& block) {
  block.kind = BlockKind::SetNames;
  const auto first = integer("SETVN needs the number of a common variable");
  if (!first) {
    return;
  }
  block.number = *first;
  if (!scanner_.accept('[')) {
    fail(AlarmId::NameFormat, "names in brackets are expected here");
    return;
  }
  scanner_.peek();
  block.text.begin = scanner_.position();
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
    expect_end(block);
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
  expect_end(block);
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
  block.condition = condition();
  if (failed()) {
    return;
  }
  if (!scanner_.accept_word("DO")) {
    fail(AlarmId::StatementFormat, "DO and a loop number are expected after the condition");
    return;
  }
  block.kind = BlockKind::While;
  block.number = loop_number();
}

int Parser::loop_number() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const auto number = scanner_.number();
  if (!number || number->has_point || number->value < 1.0 || number->value > kLargestLoopNumber) {
    expressions_.fail_at(AlarmId::IllegalLoopNumber,
                         {begin, std::max(begin + 1, scanner_.position())},
                         "a loop number is an integer from 1");
    return 0;
  }
  return static_cast<int>(number->value);
}

}  // namespace

syntax::Tree parse(std::string_view text, TextBegins begins) {
  G31_EXPECTS(text.size() < std::numeric_limits<std::uint32_t>::max());
  return Parser(text).run(begins);
}

}  // namespace g31::fanuc

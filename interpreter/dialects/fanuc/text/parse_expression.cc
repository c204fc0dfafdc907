#include "interpreter/dialects/fanuc/text/parse_expression.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/dialects/fanuc/vocabulary/functions.h"
#include "interpreter/source/printable.h"

namespace g31::fanuc {
namespace {

using syntax::Expr;
using syntax::ExprKind;
using syntax::Index;
using syntax::kNone;
using syntax::Operator;

struct OperatorWord {
  std::string_view text;
  Operator op;
};

constexpr OperatorWord kComparisons[] = {
    {"EQ", Operator::Equal}, {"NE", Operator::NotEqual},     {"GT", Operator::Greater},
    {"LT", Operator::Less},  {"GE", Operator::GreaterEqual}, {"LE", Operator::LessEqual}};
constexpr OperatorWord kJunctions[] = {{"&&", Operator::And}, {"||", Operator::Or}};
/// Signs of other languages, longer ones first, and the operator that Custom Macro B has for them.
struct ForeignSign {
  std::string_view sign;
  std::string_view word;
};
constexpr ForeignSign kForeignSigns[] = {{">=", "GE"}, {"<=", "LE"}, {"<>", "NE"}, {"!=", "NE"},
                                         {"==", "EQ"}, {">", "GT"},  {"<", "LT"},  {"=", "EQ"}};

/// "; GT is what Custom Macro B has for it" where such a sign stands, else "".
std::string hint_of_sign(std::string_view rest) {
  for (const ForeignSign& row : kForeignSigns) {
    if (rest.starts_with(row.sign)) {
      return fmt::format("; {} is what Custom Macro B has for '{}'", row.word, row.sign);
    }
  }
  return {};
}

/// Words come before their two-letter forms (MB-077).
constexpr OperatorWord kSums[] = {{"+", Operator::Add},
                                  {"-", Operator::Subtract},
                                  {"XOR", Operator::Xor},
                                  {"XO", Operator::Xor},
                                  {"OR", Operator::Or}};
constexpr OperatorWord kProducts[] = {{"*", Operator::Multiply}, {"/", Operator::Divide},
                                      {"AND", Operator::And},    {"AN", Operator::And},
                                      {"MOD", Operator::Modulo}, {"MO", Operator::Modulo}};

template <std::size_t N>
std::optional<Operator> accept_operator(Scanner& scanner, const OperatorWord (&rows)[N]) {
  for (const OperatorWord& row : rows) {
    if (scanner.accept_word(row.text)) {
      return row.op;
    }
  }
  return std::nullopt;
}

}  // namespace

Index ExpressionParser::add(const Expr& expr) {
  tree_.exprs.push_back(expr);
  return static_cast<Index>(tree_.exprs.size() - 1);
}

Index ExpressionParser::fail_at(AlarmId id, syntax::ShortSpan where, std::string message) {
  if (!error_) {
    // What is missing at the end of the text has no character to point to.
    const auto end_of_text = static_cast<std::uint32_t>(scanner_.text().size());
    where.end = std::min(where.end, end_of_text);
    error_ = syntax::SyntaxError{static_cast<int>(id), where, std::move(message)};
  }
  return kNone;
}

Index ExpressionParser::fail(AlarmId id, std::string message) {
  scanner_.peek();
  std::uint32_t here = scanner_.position();
  // A line that ends with CR LF ends before the CR.
  here -= here > 0 && scanner_.text().substr(here - 1, 2) == "\r\n" ? 1U : 0U;
  return fail_at(id, {here, here + 1}, std::move(message));
}

Index ExpressionParser::binary(Operator op, Index a, Index b) {
  if (a == kNone || b == kNone) {
    return kNone;
  }
  Expr node;
  node.kind = ExprKind::Binary;
  node.op = op;
  node.a = a;
  node.b = b;
  node.span = {tree_.exprs[a].span.begin, tree_.exprs[b].span.end};
  return add(node);
}

Index ExpressionParser::expression() {
  Index left = sum();
  if (left == kNone) {
    return kNone;
  }
  left = comparison_from(left);
  while (left != kNone) {
    const auto op = accept_operator(scanner_, kJunctions);
    if (!op) {
      break;
    }
    left = binary(*op, left, comparison_from(sum()));
    if (left != kNone) {
      tree_.exprs[left].kind = ExprKind::Logic;
    }
  }
  return left;
}

Index ExpressionParser::comparison_from(Index left) {
  if (left == kNone) {
    return kNone;
  }
  const auto op = accept_operator(scanner_, kComparisons);
  return op ? binary(*op, left, sum()) : left;
}

Index ExpressionParser::continued(Index first) {
  return sum_from(product_from(first));
}

Index ExpressionParser::sum() {
  return sum_from(product());
}

Index ExpressionParser::sum_from(Index left) {
  while (left != kNone) {
    const auto op = accept_operator(scanner_, kSums);
    if (!op) {
      return left;
    }
    left = binary(*op, left, product());
  }
  return left;
}

Index ExpressionParser::product() {
  return product_from(operand());
}

Index ExpressionParser::product_from(Index left) {
  while (left != kNone) {
    const auto op = accept_operator(scanner_, kProducts);
    if (!op) {
      return left;
    }
    left = binary(*op, left, operand());
  }
  return left;
}

Index ExpressionParser::operand() {
  const char sign = scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  if (sign != '-' && sign != '+') {
    return primary();
  }
  scanner_.step();
  const Index inner = primary();
  if (sign == '+' || inner == kNone) {
    return inner;
  }
  Expr node;
  node.kind = ExprKind::Negate;
  node.a = inner;
  node.span = {begin, tree_.exprs[inner].span.end};
  return add(node);
}

Index ExpressionParser::primary() {
  const char next = scanner_.peek();
  if (next == '#') {
    return variable();
  }
  if (next == '[') {
    return at_name() ? named_variable() : bracketed();
  }
  if ((next >= '0' && next <= '9') || next == '.') {
    return number();
  }
  if (next >= 'A' && next <= 'Z') {
    return function();
  }
  return fail(AlarmId::ExpressionFormat,
              next == '\n' ? "the block ends where a value is expected"
                           : fmt::format("a value is expected here, not {}", source::quoted(next)));
}

Index ExpressionParser::number() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const auto found = scanner_.number();
  if (!found) {
    return fail(AlarmId::ExpressionFormat, "a decimal point without digits");
  }
  Expr node;
  node.kind = ExprKind::Number;
  node.number = found->value;
  node.digits = found->digits;
  node.span = {begin, scanner_.position()};
  return add(node);
}

bool ExpressionParser::open_bracket() {
  if (scanner_.peek() != '[') {
    fail(AlarmId::ExpressionFormat, "a [ is expected here");
    return false;
  }
  if (++depth_ > kBracketLimit) {
    fail(AlarmId::BracketNesting, fmt::format("the bracket nests {} deep", depth_));
    return false;
  }
  scanner_.step();
  return true;
}

bool ExpressionParser::close_bracket(std::uint32_t opened_at) {
  if (error_) {
    return false;
  }
  if (!scanner_.accept(']')) {
    const char next = scanner_.peek();
    if (next == '\n') {
      fail_at(AlarmId::ExpressionFormat, {opened_at, opened_at + 1}, "this [ has no ]");
    } else {
      fail(AlarmId::ExpressionFormat,
           fmt::format("an operator or ] is expected here, not {}{}", source::quoted(next),
                       hint_of_sign(scanner_.text().substr(scanner_.position()))));
    }
    return false;
  }
  --depth_;
  return true;
}

Index ExpressionParser::bracketed() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  if (!open_bracket()) {
    return kNone;
  }
  const Index inner = expression();
  if (inner == kNone || !close_bracket(begin)) {
    return kNone;
  }
  tree_.exprs[inner].span = {begin, scanner_.position()};
  return inner;
}

Index ExpressionParser::variable() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  scanner_.step();
  const char next = scanner_.peek();
  Index inner = kNone;
  if (next == '[') {
    inner = bracketed();
  } else if (next >= '0' && next <= '9') {
    inner = number();
  } else {
    return fail(AlarmId::ExpressionFormat, "a variable is # and its number, or #[an expression]");
  }
  if (inner == kNone) {
    return kNone;
  }
  Expr node;
  node.kind = ExprKind::Variable;
  node.a = inner;
  node.span = {begin, scanner_.position()};
  return add(node);
}

bool ExpressionParser::at_name() {
  scanner_.peek();
  const std::uint32_t begin = scanner_.position();
  const bool opens = scanner_.accept('[') && scanner_.accept('#');
  const char next = scanner_.peek();
  scanner_.rewind(begin);
  return opens && ((next >= 'A' && next <= 'Z') || next == '_');
}

Index ExpressionParser::named_variable() {
  const std::uint32_t bracket = scanner_.position();
  if (!open_bracket()) {
    return kNone;
  }
  scanner_.accept('#');
  Expr node;
  node.kind = ExprKind::Name;
  node.span = scanner_.name();
  if (scanner_.peek() == '[') {
    node.a = bracketed();
    if (node.a == kNone) {
      return kNone;
    }
  }
  return close_bracket(bracket) ? add(node) : kNone;
}

Index ExpressionParser::function() {
  const std::uint32_t begin = scanner_.position();
  const std::string name(scanner_.letters());
  const auto id = find_function(name);
  if (!id) {
    return fail_at(AlarmId::ExpressionFormat, {begin, scanner_.position()},
                   fmt::format("{} is not a function of Custom Macro B", name));
  }
  scanner_.peek();
  const std::uint32_t bracket = scanner_.position();
  if (!open_bracket()) {
    return kNone;
  }
  Expr node;
  node.kind = ExprKind::Call;
  node.function = static_cast<std::uint8_t>(*id);
  node.a = expression();
  const Arguments arguments = info(*id).arguments;
  if (arguments != Arguments::One && node.a != kNone && scanner_.accept(',')) {
    node.b = expression();
  } else if (arguments == Arguments::Two && !error_) {
    return fail(AlarmId::ExpressionFormat, "a comma and a second argument are expected here");
  }
  if (!close_bracket(bracket)) {
    return kNone;
  }
  node.span = {begin, scanner_.position()};
  if (arguments == Arguments::OneOrTwo && node.b == kNone && scanner_.accept('/')) {
    node.op = Operator::Divide;
    node.b = bracketed();
    node.span.end = scanner_.position();
  } else if (arguments == Arguments::Parameter && scanner_.accept('/')) {
    node.c = bracketed();
    node.span.end = scanner_.position();
  }
  return error_ ? kNone : add(node);
}

}  // namespace g31::fanuc

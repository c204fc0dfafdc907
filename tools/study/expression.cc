#include "tools/study/expression.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <charconv>
#include <cmath>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "machine/base/nearest_name.h"
#include "tools/setup/variable_name.h"

namespace g31::study {
namespace {

constexpr auto kFunctionNames = std::to_array<std::string_view>({
#define RESULT_FUNCTION(name, arguments, text) #name,
#include "tools/study/result_functions.def"
#undef RESULT_FUNCTION
});

constexpr auto kFunctionArguments = std::to_array<int>({
#define RESULT_FUNCTION(name, arguments, text) (arguments),
#include "tools/study/result_functions.def"
#undef RESULT_FUNCTION
});

/// Brackets in brackets; more is no formula that a person wrote.
constexpr int kDeepest = 100;

}  // namespace

/// Recursive descent; leaves the steps in the order in which a stack computes them.
class ExpressionParser {
 public:
  explicit ExpressionParser(std::string_view text) : text_(text) {}

  Result<Expression, std::string> parse() {
    sum();
    skip_spaces();
    if (problem_.empty() && at_ < text_.size()) {
      fail(fmt::format("'{}' does not belong here", text_[at_]));
    }
    return problem_.empty() ? Result<Expression, std::string>(std::move(built_)) : problem_;
  }

 private:
  using Kind = Expression::Kind;

  void fail(std::string_view why) {
    if (problem_.empty()) {
      problem_ = fmt::format("at character {}: {}", at_ + 1, why);
    }
  }
  void skip_spaces() {
    while (at_ < text_.size() && text_[at_] == ' ') {
      ++at_;
    }
  }
  bool take(char wanted) {
    skip_spaces();
    const bool is_it = at_ < text_.size() && text_[at_] == wanted;
    at_ += is_it ? 1 : 0;
    return is_it;
  }
  void step(Kind kind) { built_.steps_.push_back({kind, 0.0, 0}); }

  void sum() {
    product();
    while (problem_.empty()) {
      if (take('+')) {
        product();
        step(Kind::Add);
      } else if (take('-')) {
        product();
        step(Kind::Subtract);
      } else {
        return;
      }
    }
  }

  void product() {
    signed_operand();
    while (problem_.empty()) {
      if (take('*')) {
        signed_operand();
        step(Kind::Multiply);
      } else if (take('/')) {
        signed_operand();
        step(Kind::Divide);
      } else {
        return;
      }
    }
  }

  void signed_operand() {
    const bool negative = take('-');
    operand();
    if (negative) {
      step(Kind::Negate);
    }
  }

  void operand() {
    skip_spaces();
    const char next = at_ < text_.size() ? text_[at_] : '\0';
    if (next == '#') {
      numbered_variable();
    } else if (next == '(' || next == '[') {
      ++at_;
      bracket(next == '(' ? ')' : ']', 1);
    } else if (std::isdigit(static_cast<unsigned char>(next)) == 0 && is_in_name(next)) {
      name();
    } else {
      number();
    }
  }

  void bracket(char end, int arguments) {
    if (++depth_ > kDeepest) {
      fail("too many brackets");
      return;
    }
    for (int i = 0; i < arguments && problem_.empty(); ++i) {
      if (i > 0 && !take(',')) {
        fail(fmt::format("{} values separated by commas are expected", arguments));
      }
      sum();
    }
    if (problem_.empty() && !take(end)) {
      fail(fmt::format("'{}' is missing", end));
    }
    --depth_;
  }

  void numbered_variable() {
    const std::size_t begin = at_++;
    while (at_ < text_.size() && std::isdigit(static_cast<unsigned char>(text_[at_])) != 0) {
      ++at_;
    }
    if (at_ == begin + 1) {
      fail("a variable is # and a number");
      return;
    }
    variable(std::string(text_.substr(begin, at_ - begin)));
  }

  void variable(const std::string& name) {
    const auto known = std::ranges::find(built_.variables_, name);
    const auto index = static_cast<std::size_t>(known - built_.variables_.begin());
    if (known == built_.variables_.end()) {
      built_.variables_.push_back(name);
    }
    built_.steps_.push_back({Kind::Variable, 0.0, index});
  }

  void number() {
    double value = 0.0;
    const char* const begin = text_.data() + at_;
    const auto end = std::from_chars(begin, text_.data() + text_.size(), value);
    if (end.ec != std::errc() || !std::isfinite(value)) {
      fail("a variable, a number or a bracket is expected");
      return;
    }
    at_ += static_cast<std::size_t>(end.ptr - begin);
    built_.steps_.push_back({Kind::Number, value, 0});
  }

  static bool is_in_name(char c) {
    return std::isalnum(static_cast<unsigned char>(c)) != 0 || c == '_' || c == '$';
  }

  /// A function, or a variable that has a name, perhaps with indices.
  void name() {
    const std::size_t begin = at_;
    while (at_ < text_.size() && is_in_name(text_[at_])) {
      ++at_;
    }
    const std::string_view name = text_.substr(begin, at_ - begin);
    const auto row = std::ranges::find(kFunctionNames, name);
    if (row != kFunctionNames.end()) {
      function(static_cast<int>(row - kFunctionNames.begin()));
      return;
    }
    const std::size_t end =
        at_ < text_.size() && text_[at_] == '[' ? text_.find(']', at_) : at_ - 1;
    const std::string_view whole = text_.substr(begin, end - begin + 1);
    const auto known = setup::normal_variable_name(whole);
    if (known && !take('(')) {
      at_ = begin + whole.size();
      variable(*known);
      return;
    }
    at_ = begin;
    const auto nearest = nearest_name(name, kFunctionNames);
    fail(fmt::format("there is no function {}, {}", name,
                     nearest ? fmt::format("did you mean {}?", *nearest)
                             : fmt::format("known are {}", fmt::join(kFunctionNames, ", "))));
  }

  void function(int index) {
    const bool square = take('[');
    if (!square && !take('(')) {
      fail("a function needs a bracket");
      return;
    }
    bracket(square ? ']' : ')', kFunctionArguments.at(static_cast<std::size_t>(index)));
    step(static_cast<Kind>(static_cast<int>(Kind::ABS) + index));
  }

  std::string_view text_;
  std::size_t at_ = 0;
  int depth_ = 0;
  std::string problem_;
  Expression built_;
};

Result<Expression, std::string> Expression::parse(std::string_view text) {
  return ExpressionParser(text).parse();
}

std::optional<double> Expression::value(const std::vector<std::optional<double>>& values) const {
  std::vector<double> stack;
  for (const Step& step : steps_) {
    if (step.kind == Kind::Number) {
      stack.push_back(step.number);
    } else if (step.kind == Kind::Variable) {
      if (!values.at(step.variable)) {
        return std::nullopt;
      }
      stack.push_back(*values.at(step.variable));
    } else if (takes_one(step.kind)) {
      stack.back() = of_one(step.kind, stack.back());
    } else {
      const double right = stack.back();
      stack.pop_back();
      stack.back() = of_two(step.kind, stack.back(), right);
    }
  }
  return std::isfinite(stack.back()) ? std::optional(stack.back()) : std::nullopt;
}

bool Expression::takes_one(Kind kind) {
  return kind == Kind::Negate || kind == Kind::ABS || kind == Kind::SQRT;
}

double Expression::of_one(Kind kind, double a) {
  if (kind == Kind::Negate) {
    return -a;
  }
  return kind == Kind::ABS ? std::fabs(a) : std::sqrt(a);
}

double Expression::of_two(Kind kind, double a, double b) {
  switch (kind) {
    case Kind::Add:
      return a + b;
    case Kind::Subtract:
      return a - b;
    case Kind::Multiply:
      return a * b;
    case Kind::Divide:
      return a / b;
    case Kind::MIN:
      return std::min(a, b);
    case Kind::MAX:
      return std::max(a, b);
    case Kind::Number:
    case Kind::Variable:
    case Kind::Negate:
    case Kind::ABS:
    case Kind::SQRT:
      break;
  }
  contract_violated("a step of two values", __FILE__, __LINE__);
}

}  // namespace g31::study

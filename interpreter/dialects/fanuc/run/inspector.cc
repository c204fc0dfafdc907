#include "interpreter/dialects/fanuc/run/inspector.h"

#include <algorithm>
#include <cstdint>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/text/parse.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

using syntax::BlockKind;

/// While it lives, the variables are those of a level and nobody hears of reads.
class Look {
 public:
  Look(Control& control, std::size_t level)
      : control_(control), level_(level), missed_(control.touches.missed), look_(control.touches) {
    control_.variables.swap_with_present(level_);
  }
  ~Look() {
    control_.touches.missed = std::move(missed_);
    control_.variables.swap_with_present(level_);
  }
  Look(const Look&) = delete;
  Look& operator=(const Look&) = delete;

 private:
  Control& control_;
  std::size_t level_;
  runtime::MissedTouches missed_;
  runtime::LookFromOutside look_;
};

void add(runtime::NamedValues& values, std::int32_t number, Cell value) {
  if (!value.is_vacant()) {
    values.emplace_back(fmt::format("#{}", number), value);
  }
}

}  // namespace

runtime::NamedValues common_values(const Control& control, std::int32_t first) {
  runtime::NamedValues values;
  for (std::int32_t number = first; number < kCommonEnd; ++number) {
    if (is_common(number)) {
      add(values, number, control.variables.common(number));
    }
  }
  for (const auto& [number, value] : control.further_commons) {
    add(values, number, value);
  }
  return values;
}

runtime::NamedValues Inspector::values(std::size_t level, runtime::Scope scope) {
  Control& control = runner_.control();
  if (scope == runtime::Scope::Common) {
    return common_values(control, 0);
  }
  runtime::NamedValues values;
  const Look look(control, runner_.stack().locals_of(level));
  for (std::int32_t number = 1; number <= kLocalCount; ++number) {
    add(values, number, control.variables.local(number));
  }
  return values;
}
Result<Cell, std::string> Inspector::evaluate(std::size_t level, const std::string& text) {
  if (std::ranges::any_of(text, [](unsigned char c) { return c < ' ' || c == '(' || c == ';'; })) {
    return std::string("is not an expression: it holds a comment or the end of a block");
  }
  const Look look(runner_.control(), runner_.stack().locals_of(level));
  Expression& condition = expression(fmt::format("IF[{}]GOTO1\n", text));
  if (condition.program.steps.front().kind == BlockKind::IfGoto) {
    return value_of(condition);
  }
  return value_of(expression(fmt::format("#1={}\n", text)));
}

/// The block as a program, read and compiled once.
Inspector::Expression& Inspector::expression(const std::string& block) {
  std::unique_ptr<Expression>& made = expressions_[block];
  if (made == nullptr) {
    made = std::make_unique<Expression>(block);
    made->tree = parse(made->source.text(), TextBegins::InProgram);
    made->program = compile(made->source, made->tree, 0, runner_.control().profile);
  }
  G31_EXPECTS(!made->program.steps.empty());
  return *made;
}

Result<Cell, std::string> Inspector::value_of(Expression& asked) {
  Evaluator& evaluator = runner_.control().evaluator;
  const Step& step = asked.program.steps.front();
  Cell value;
  if (step.kind == BlockKind::IfGoto) {
    value = Cell(evaluator.condition(asked.program, step.condition) ? 1.0 : 0.0);
  } else if (step.kind == BlockKind::Assign && asked.program.steps.size() == 1) {
    value = evaluator.evaluate(asked.program, step.value);
  } else {
    const auto& errors = asked.program.errors;
    return errors.empty() ? std::string("is not an expression") : errors.front().message;
  }
  const auto fault = evaluator.take_fault();
  return fault ? Result<Cell, std::string>(fmt::format("{}{}{}", info(fault->id).text,
                                                       fault->detail.empty() ? "" : ": ",
                                                       fault->detail))
               : value;
}

}  // namespace g31::fanuc

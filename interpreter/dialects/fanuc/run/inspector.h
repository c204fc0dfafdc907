#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <string>

#include "interpreter/dialects/fanuc/run/runner.h"
#include "interpreter/runtime/inspection.h"
#include "machine/base/result.h"

namespace g31::fanuc {

/// Common variables that are not vacant, by rising number.
/// @param first  the lowest number of interest
runtime::NamedValues common_values(const Control& control, std::int32_t first);

/// Looks at the variables of a run from outside, at a pause or behind its end.  Nothing of the run
/// changes for it: no time passes, no report is made, no variable is written.
class Inspector {
 public:
  /// @param runner  outlives the inspector
  explicit Inspector(Runner& runner) : runner_(runner) {}

  /// Variables that are not vacant, by rising number.
  /// @param level  of calls; 0: the innermost.  Common variables are the same at all of them.
  runtime::NamedValues values(std::size_t level, runtime::Scope scope);

  /// The value of an expression, or of a condition (1 or 0), among the variables of a level.
  /// @returns why it has none
  Result<Cell, std::string> evaluate(std::size_t level, const std::string& text);

 private:
  /// A program of one block that has the expression in it.
  struct Expression {
    source::SourceFile source;
    syntax::Tree tree;
    CompiledProgram program;
    explicit Expression(const std::string& block) : source("", block) {}
  };
  Expression& expression(const std::string& block);
  Result<Cell, std::string> value_of(Expression& asked);

  Runner& runner_;
  std::map<std::string, std::unique_ptr<Expression>> expressions_;  ///< by the text of the block
};

}  // namespace g31::fanuc

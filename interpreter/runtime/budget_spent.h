#pragma once

#include <exception>
#include <string>
#include <utility>

#include "interpreter/source/diagnostic.h"

namespace g31::runtime {

/// Thrown where the work of a block finds a budget of the run spent, or is interrupted; the run
/// ends at the block in hand.  What it did so far is told and kept.
class BudgetSpent final : public std::exception {
 public:
  /// @param message  of diagnostics.def, and what fills its {}
  BudgetSpent(source::DiagnosticId message, std::string detail)
      : message_(message), detail_(std::move(detail)) {}

  [[nodiscard]] source::DiagnosticId message() const { return message_; }
  [[nodiscard]] const std::string& detail() const { return detail_; }
  [[nodiscard]] const char* what() const noexcept override { return "a budget is spent"; }

 private:
  source::DiagnosticId message_;
  std::string detail_;
};

}  // namespace g31::runtime

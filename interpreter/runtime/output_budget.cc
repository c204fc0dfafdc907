#include "interpreter/runtime/output_budget.h"

#include <algorithm>

#include <fmt/format.h>

#include "interpreter/runtime/budget_spent.h"

namespace g31::runtime {
namespace {

constexpr std::string_view kOutputTexts[] = {
#define OUTPUT(name, text) text,
#include "interpreter/runtime/outputs.def"
#undef OUTPUT
};

}  // namespace

void OutputBudget::give_back(Output output, std::uint64_t bytes) {
  std::uint64_t& charged = charged_[static_cast<std::size_t>(output)];
  const std::uint64_t less = std::min(bytes, charged);
  charged -= less;
  total_ -= less;
}

/// Says which output was to grow first, then the others.
void OutputBudget::refuse(Output output, std::uint64_t bytes) {
  if (is_spent_) {
    return;
  }
  is_spent_ = true;
  const auto grown = static_cast<std::size_t>(output);
  std::string detail = fmt::format("more than {}: {} {}", shown_size(most_), kOutputTexts[grown],
                                   shown_size(charged_[grown] + bytes));
  for (std::size_t i = 0; i < kOutputs; ++i) {
    if (i != grown && charged_[i] > 0) {
      detail += fmt::format(", {} {}", kOutputTexts[i], shown_size(charged_[i]));
    }
  }
  throw BudgetSpent(source::DiagnosticId::BudgetOutput, std::move(detail));
}

std::uint64_t size_in_document(std::string_view latin_1) {
  constexpr std::string_view kShortEscapes = "\"\\\b\f\n\r\t";
  constexpr std::uint64_t kLongEscape = 6;  // \u0000
  std::uint64_t size = 0;
  for (const char c : latin_1) {
    const auto byte = static_cast<unsigned char>(c);
    const bool is_short = c != '\0' && kShortEscapes.find(c) != std::string_view::npos;
    const bool is_control = byte < 0x20 && !is_short;
    size += is_control ? kLongEscape : is_short || byte >= 0x80 ? 2 : 1;
  }
  return size;
}

std::string shown_size(std::uint64_t bytes) {
  constexpr struct {
    double bytes;
    std::string_view name;
  } kUnits[] = {{1e9, "GB"}, {1e6, "MB"}, {1e3, "kB"}};
  const auto size = static_cast<double>(bytes);
  for (const auto& unit : kUnits) {
    if (size >= unit.bytes) {
      return fmt::format("{:.1f} {}", size / unit.bytes, unit.name);
    }
  }
  return fmt::format("{} bytes", bytes);
}

}  // namespace g31::runtime

#include "interpreter/dialects/fanuc/vocabulary/statements.h"

#include <array>

namespace g31::fanuc {
namespace {

constexpr auto kStatementRows = std::to_array<OutputStatementInfo>({
#define OUTPUT_STATEMENT(name, has_format, text) {#name, HasFormat::has_format, text},
#include "interpreter/dialects/fanuc/vocabulary/statements.def"
#undef OUTPUT_STATEMENT
});

}  // namespace

std::span<const OutputStatementInfo> output_statements() {
  return kStatementRows;
}

const OutputStatementInfo& info(OutputStatement statement) {
  return kStatementRows.at(static_cast<std::size_t>(statement));
}

std::optional<OutputStatement> find_output_statement(std::string_view name) {
  for (std::size_t i = 0; i < kStatementRows.size(); ++i) {
    if (name.size() >= 2 && kStatementRows[i].name.starts_with(name)) {
      return static_cast<OutputStatement>(i);
    }
  }
  return std::nullopt;
}

}  // namespace g31::fanuc

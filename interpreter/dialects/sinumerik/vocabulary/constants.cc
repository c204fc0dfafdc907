#include "interpreter/dialects/sinumerik/vocabulary/constants.h"

#include <algorithm>
#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kConstantRows = std::to_array<ConstantInfo>({
#define CONSTANT(name, type, value, text) {#name, Type::type, value, text},
#include "interpreter/dialects/sinumerik/vocabulary/constants.def"
#undef CONSTANT
});

}  // namespace

std::span<const ConstantInfo> constants() {
  return kConstantRows;
}

const ConstantInfo* find_constant(std::string_view name) {
  const auto found = std::ranges::find(kConstantRows, name, &ConstantInfo::name);
  return found != kConstantRows.end() ? &*found : nullptr;
}

}  // namespace g31::sinumerik

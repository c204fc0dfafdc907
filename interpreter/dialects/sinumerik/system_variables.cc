#include "interpreter/dialects/sinumerik/system_variables.h"

#include <array>
#include <charconv>

#include "interpreter/dialects/sinumerik/names.h"

namespace g31::sinumerik {
namespace {

constexpr auto kRows = std::to_array<SystemVariable>({
#define SYSTEM_VARIABLE(id, name, type, indices, access, text) \
  {SystemId::id, name, Type::type, indices, Access::access, text},
#include "interpreter/dialects/sinumerik/system_variables.def"
#undef SYSTEM_VARIABLE
});

constexpr int kEdgeParameters = 25;

}  // namespace

std::span<const SystemVariable> system_variables() {
  return kRows;
}

std::optional<SystemName> find_system_variable(std::string_view name) {
  static const NameMap<const SystemVariable*> kByName = [] {
    NameMap<const SystemVariable*> map;
    for (const SystemVariable& row : kRows) {
      map.emplace(std::string(row.name), &row);
    }
    return map;
  }();
  const SystemVariable& edge = kRows[static_cast<std::size_t>(SystemId::EdgeParameter)];
  if (const auto found = kByName.find(name); found != kByName.end() && found->second != &edge) {
    return SystemName{found->second, 0};
  }
  if (!name.starts_with(edge.name)) {
    return std::nullopt;
  }
  const std::string_view digits = name.substr(edge.name.size());
  int number = 0;
  const auto read = std::from_chars(digits.data(), digits.data() + digits.size(), number);
  const bool right = read.ec == std::errc() && read.ptr == digits.data() + digits.size() &&
                     number >= 1 && number <= kEdgeParameters;
  return right ? std::optional(SystemName{&edge, number}) : std::nullopt;
}

}  // namespace g31::sinumerik

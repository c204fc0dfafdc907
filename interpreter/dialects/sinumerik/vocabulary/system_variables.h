#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"

namespace g31::sinumerik {

/// Rows of system_variables.def.
enum class SystemId : std::uint8_t {
#define SYSTEM_VARIABLE(id, name, type, indices, work, text) id,
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.def"
#undef SYSTEM_VARIABLE
};

enum class Access : std::uint8_t { Read, Write, Refused };

struct SystemVariable {
  SystemId id;
  std::string_view name;
  Type type;
  std::string_view indices;
  Access access;
  std::string_view text;
};

std::span<const SystemVariable> system_variables();

/// A row and, for $TC_DPn, its n.
struct SystemName {
  const SystemVariable* row = nullptr;
  int parameter = 0;
};

/// @param name  upper case
std::optional<SystemName> find_system_variable(std::string_view name);

}  // namespace g31::sinumerik

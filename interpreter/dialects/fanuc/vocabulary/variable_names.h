#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <span>
#include <string>
#include <string_view>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/runtime/cell.h"
#include "machine/base/result.h"

namespace g31::fanuc {

/// One row of system_names.def.
struct SystemName {
  std::string_view name;
  std::int32_t first;
  int lowest;
  int highest;
  std::string_view text;
};

/// All rows.
std::span<const SystemName> system_names();

/// The longest name that SETVN gives (MB-104).
inline constexpr std::size_t kLongestName = 31;

/// Upper case, as names are compared.
std::string upper_case(std::string_view text);

/// Whether SETVN can give this name: a letter, then letters, digits and underscores.
bool is_variable_name(std::string_view name);

/// "#500" -> 500; "#30012.003" of a Haas -> 30012003.
std::optional<std::int32_t> variable_in_name(std::string_view name);

/// Names of variables: those of the system, and those that SETVN gave.
class VariableNames {
 public:
  void give(std::string name, std::int32_t number) { given_[std::move(name)] = number; }

  /// The variable has no name then.
  void take_name(std::int32_t number) {
    std::erase_if(given_, [number](const auto& row) { return row.second == number; });
  }

  /// The variable that [#name] or [#name[index]] means.
  /// @param name   upper case
  /// @param index  vacant: none is written
  [[nodiscard]] Result<std::int32_t, AlarmId> number(const std::string& name,
                                                     runtime::Cell index) const;

  bool operator==(const VariableNames&) const = default;

 private:
  std::map<std::string, std::int32_t> given_;
};

}  // namespace g31::fanuc

#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/alarms.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_names.h"
#include "interpreter/dialects/fanuc/vocabulary/variable_ranges.h"
#include "interpreter/runtime/cell.h"
#include "machine/base/result.h"

namespace g31::fanuc {

using runtime::Cell;

/// The variables that a program makes: locals by call level and commons, as a plain value.
class Variables {
 public:
  Variables() { locals_.emplace_back(); }

  /// Programs may not write #first to #last (parameters 6031 and 6032, MB-107).
  void protect(std::int32_t first, std::int32_t last) {
    first_protected_ = first;
    last_protected_ = last;
  }
  [[nodiscard]] bool is_protected(std::int32_t number) const {
    return number >= first_protected_ && number <= last_protected_;
  }

  /// Names, as SETVN gives them.
  VariableNames names;

  /// @pre is_local(number)
  [[nodiscard]] Cell local(std::int32_t number) const {
    return locals_.back()[static_cast<std::size_t>(number)];
  }
  void set_local(std::int32_t number, Cell value) {
    locals_.back()[static_cast<std::size_t>(number)] = value;
  }

  /// @pre is_common(number)
  [[nodiscard]] Cell common(std::int32_t number) const {
    return commons_[static_cast<std::size_t>(number)];
  }
  void set_common(std::int32_t number, Cell value) {
    commons_[static_cast<std::size_t>(number)] = value;
  }

  /// The locals of this call level and the commons, by variable number.  The locals stay where they
  /// are until the level changes.
  [[nodiscard]] const Cell* locals() const { return locals_.back().data(); }
  [[nodiscard]] const Cell* commons() const { return commons_.data(); }

  using Locals = std::array<Cell, kLocalCount + 1>;  ///< by variable number

  /// How many macro calls deep the present locals are; 0: those of the main program.
  [[nodiscard]] std::size_t depth() const { return locals_.size() - 1; }
  /// A macro call: all locals of the new level are vacant.
  void push_level() { locals_.emplace_back(); }
  [[nodiscard]] const Locals& level() const { return locals_.back(); }
  void set_level(const Locals& locals) { locals_.back() = locals; }
  void pop_level() { locals_.pop_back(); }
  /// The locals of an outer level change places with those of the present one; 0: the first.
  void swap_with_present(std::size_t level) { std::swap(locals_[level], locals_.back()); }

  bool operator==(const Variables&) const = default;

 private:
  std::vector<Locals> locals_;
  std::array<Cell, kCommonEnd> commons_;
  std::int32_t first_protected_ = 1;
  std::int32_t last_protected_ = 0;
};

/// The system variables of a running control, by number.
class SystemVariables {
 public:
  SystemVariables() = default;
  SystemVariables(const SystemVariables&) = delete;
  SystemVariables& operator=(const SystemVariables&) = delete;
  virtual ~SystemVariables() = default;
  virtual Result<Cell, AlarmId> read(std::int32_t number) = 0;
  /// @returns why it cannot be written, or nullopt when it was
  virtual std::optional<AlarmId> write(std::int32_t number, Cell value) = 0;
  /// As the set-up sheet sets it before the start: inputs, too.
  virtual std::optional<AlarmId> preset(std::int32_t number, Cell value) = 0;
};

/// All variables that a program sees, by any number.
class AllVariables {
 public:
  /// Both outlive it.
  AllVariables(Variables& own, SystemVariables& system) : own_(own), system_(system) {}

  /// A fault for numbers the control does not have or does not let read.
  Result<Cell, AlarmId> read(std::int32_t number);
  std::optional<AlarmId> write(std::int32_t number, Cell value);
  /// As the set-up sheet sets it before the start: inputs and protected variables, too.
  std::optional<AlarmId> preset(std::int32_t number, Cell value);

 private:
  Variables& own_;
  SystemVariables& system_;
};

}  // namespace g31::fanuc

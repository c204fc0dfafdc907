#pragma once

#include "interpreter/dialects/fanuc/state/control.h"
#include "interpreter/dialects/fanuc/vocabulary/system_variables.h"

namespace g31::fanuc {

/// System variables as a running control answers them; lengths in the unit in force.
class ControlVariables final : public SystemVariables {
 public:
  /// The control whose state is shown; to be called once, before any access.
  void attach(Control& control) { control_ = &control; }

  Result<Cell, AlarmId> read(std::int32_t number) override;
  std::optional<AlarmId> write(std::int32_t number, Cell value) override;
  std::optional<AlarmId> preset(std::int32_t number, Cell value) override;

 private:
  std::optional<AlarmId> store(const SystemVariable& row, std::int32_t number, Cell value);

  Control* control_ = nullptr;
};

}  // namespace g31::fanuc

#pragma once

#include "interpreter/dialects/fanuc/control.h"
#include "interpreter/dialects/fanuc/system_variables.h"

namespace g31::fanuc {

/// System variables as a running control answers them; lengths in the unit in force.
class ControlVariables final : public SystemVariables {
 public:
  /// The control whose state is shown; to be called once, before any access.
  void attach(Control& control) { control_ = &control; }

  Result<Cell, AlarmId> read(std::int32_t number) override;
  std::optional<AlarmId> write(std::int32_t number, Cell value) override;

 private:
  [[nodiscard]] Result<Cell, AlarmId> read_axis(const SystemVariable& row, int axis) const;
  [[nodiscard]] double read_modal(std::int32_t number) const;
  [[nodiscard]] double tool_offset(const SystemVariable& row, std::int32_t number) const;
  std::optional<AlarmId> set_tool_offset(const SystemVariable& row, std::int32_t number,
                                         double value);
  std::optional<AlarmId> set_work_offset(const SystemVariable& row, std::int32_t number,
                                         double value);

  Control* control_ = nullptr;
};

}  // namespace g31::fanuc

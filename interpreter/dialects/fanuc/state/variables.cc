#include "interpreter/dialects/fanuc/state/variables.h"

namespace g31::fanuc {

Result<Cell, AlarmId> Variables::read(std::int32_t number) {
  if (number == 0) {
    return Cell();
  }
  if (is_local(number)) {
    return local(number);
  }
  if (is_common(number)) {
    return common(number);
  }
  return system_.read(number);
}

std::optional<AlarmId> Variables::write(std::int32_t number, Cell value) {
  if (number == 0) {
    return AlarmId::WriteProtected;
  }
  if (is_local(number)) {
    set_local(number, value);
    return std::nullopt;
  }
  if (is_common(number)) {
    if (is_protected(number)) {
      return AlarmId::WriteProtected;
    }
    set_common(number, value);
    return std::nullopt;
  }
  return system_.write(number, value);
}

std::optional<AlarmId> Variables::preset(std::int32_t number, Cell value) {
  if (is_common(number)) {
    set_common(number, value);
    return std::nullopt;
  }
  return number == 0 || is_local(number) ? write(number, value) : system_.preset(number, value);
}

}  // namespace g31::fanuc

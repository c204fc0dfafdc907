#include "interpreter/dialects/fanuc/state/variables.h"

namespace g31::fanuc {

Result<Cell, AlarmId> AllVariables::read(std::int32_t number) {
  if (number == 0) {
    return Cell();
  }
  if (is_local(number)) {
    return own_.local(number);
  }
  if (is_common(number)) {
    return own_.common(number);
  }
  return system_.read(number);
}

std::optional<AlarmId> AllVariables::write(std::int32_t number, Cell value) {
  if (number == 0) {
    return AlarmId::WriteProtected;
  }
  if (is_local(number)) {
    own_.set_local(number, value);
    return std::nullopt;
  }
  if (is_common(number)) {
    if (own_.is_protected(number)) {
      return AlarmId::WriteProtected;
    }
    own_.set_common(number, value);
    return std::nullopt;
  }
  return system_.write(number, value);
}

std::optional<AlarmId> AllVariables::preset(std::int32_t number, Cell value) {
  if (is_common(number)) {
    own_.set_common(number, value);
    return std::nullopt;
  }
  return number == 0 || is_local(number) ? write(number, value) : system_.preset(number, value);
}

}  // namespace g31::fanuc

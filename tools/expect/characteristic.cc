#include "tools/expect/characteristic.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::expect {
namespace {

std::optional<double> difference(const std::optional<double>& value,
                                 const std::optional<double>& from) {
  return value && from ? std::optional(*value - *from) : std::nullopt;
}

}  // namespace

double excess_of(double deviation, const Limits& limits) {
  if (deviation > limits.upper + std::abs(limits.upper) * kLimitSlack) {
    return deviation - limits.upper;
  }
  return deviation < limits.lower - std::abs(limits.lower) * kLimitSlack ? deviation - limits.lower
                                                                         : 0.0;
}

std::optional<double> Characteristic::true_value() const {
  if (!true_size || true_size->quantity != unit.quantity) {
    return std::nullopt;
  }
  return unit.quantity == Quantity::Length ? true_size->value / unit.mm : true_size->value;
}

std::string_view name_of(CharacteristicVerdict verdict) {
  switch (verdict) {
    case CharacteristicVerdict::Good:
      return "good";
    case CharacteristicVerdict::Bad:
      return "bad";
    case CharacteristicVerdict::Missing:
      return "missing";
    case CharacteristicVerdict::Reported:
      return "reported";
  }
  contract_violated("every verdict has a name", __FILE__, __LINE__);
}

std::optional<double> MeasuredCharacteristic::deviation() const {
  return difference(actual, what.nominal);
}

std::optional<double> MeasuredCharacteristic::measuring_error() const {
  return difference(actual, what.true_value());
}

CharacteristicVerdict MeasuredCharacteristic::verdict() const {
  if (!actual) {
    return CharacteristicVerdict::Missing;
  }
  if (!what.tolerance) {
    return CharacteristicVerdict::Reported;
  }
  return excess_of(deviation().value_or(0.0), *what.tolerance) == 0.0 ? CharacteristicVerdict::Good
                                                                      : CharacteristicVerdict::Bad;
}

}  // namespace g31::expect

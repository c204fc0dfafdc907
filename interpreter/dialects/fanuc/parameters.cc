#include "interpreter/dialects/fanuc/parameters.h"

#include <charconv>
#include <cmath>

#include "machine/units/axis_positions.h"

namespace g31::fanuc {

Result<Parameters, std::string> Parameters::from(const std::map<std::string, double>& entries) {
  Parameters parameters;
  for (const auto& [name, value] : entries) {
    const char* const end = name.data() + name.size();
    int number = 0;
    const auto after = std::from_chars(name.data(), end, number);
    if (after.ec != std::errc() || number <= 0) {
      return name;
    }
    if (after.ptr == end) {
      parameters.values_[number] = value;
      continue;
    }
    if (*after.ptr == '.' && after.ptr + 2 == end && axis_index(after.ptr[1]) >= 0) {
      parameters.set_axis_value(number, axis_index(after.ptr[1]), value);
      continue;
    }
    int bit = -1;
    const auto last = std::from_chars(after.ptr + 1, end, bit);
    if (*after.ptr != '.' || last.ptr != end || last.ec != std::errc() || bit < 0 || bit > 7) {
      return name;
    }
    parameters.bits_[{number, bit}] = value != 0.0;
  }
  return parameters;
}

double Parameters::value(int number, double otherwise) const {
  const auto found = values_.find(number);
  return found != values_.end() ? found->second : otherwise;
}

bool Parameters::bit(int number, int bit) const {
  const auto found = bits_.find({number, bit});
  return found != bits_.end() && found->second;
}

double Parameters::axis_value(int number, int axis) const {
  const auto found = axis_values_.find({number, axis});
  return found != axis_values_.end() ? found->second : value(number);
}

bool Parameters::selects(int number) const {
  for (int i = 0; i < 8; ++i) {
    if (bit(number, i)) {
      return true;
    }
  }
  return value(number) != 0.0;
}

void Parameters::set(int number, double value) {
  constexpr int kBits = 8;
  values_[number] = value;
  double rest = value;
  bool bits[kBits] = {};
  for (bool& bit : bits) {
    const double digit = std::fmod(rest, 10.0);
    if (digit != 0.0 && digit != 1.0) {
      return;
    }
    bit = digit == 1.0;
    rest = (rest - digit) / 10.0;
  }
  for (int bit = 0; bit < kBits && rest == 0.0; ++bit) {
    bits_[{number, bit}] = bits[bit];
  }
}

}  // namespace g31::fanuc

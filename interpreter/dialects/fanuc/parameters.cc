#include "interpreter/dialects/fanuc/parameters.h"

#include <array>
#include <charconv>

#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

constexpr auto kRows = std::to_array<ParameterInfo>({
#define BIT_PARAMETER(name, number, bit, text) {number, number, bit, "", 0.0, text},
#define VALUE_PARAMETER(name, first, last, unit, initial, text) \
  {first, last, std::nullopt, unit, initial, text},
#include "interpreter/dialects/fanuc/parameters.def"
#undef VALUE_PARAMETER
#undef BIT_PARAMETER
});

consteval bool rising() {
  for (std::size_t i = 1; i < kRows.size(); ++i) {
    const bool same_number = kRows[i].first == kRows[i - 1].last;
    if (kRows[i].first < kRows[i - 1].last ||
        (same_number && kRows[i].bit.value_or(0) <= kRows[i - 1].bit.value_or(0))) {
      return false;
    }
  }
  return true;
}
static_assert(rising(), "parameters.def: rows must rise");

}  // namespace

std::span<const ParameterInfo> parameter_rows() {
  return kRows;
}

const ParameterInfo& info(ParameterId id) {
  return kRows.at(static_cast<std::size_t>(id));
}

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
    int bit = -1;
    const auto last = std::from_chars(after.ptr + 1, end, bit);
    if (*after.ptr != '.' || last.ptr != end || last.ec != std::errc() || bit < 0 || bit > 7) {
      return name;
    }
    parameters.bits_[{number, bit}] = value != 0.0;
  }
  return parameters;
}

bool Parameters::is_on(ParameterId id) const {
  const ParameterInfo& row = info(id);
  G31_EXPECTS(row.bit.has_value());
  return bit(row.first, *row.bit);
}

double Parameters::get(ParameterId id, int index) const {
  const ParameterInfo& row = info(id);
  G31_EXPECTS(!row.bit && index >= 0 && index <= row.last - row.first);
  return value(row.first + index, row.initial);
}

void Parameters::switch_to(ParameterId id, bool on) {
  const ParameterInfo& row = info(id);
  G31_EXPECTS(row.bit.has_value());
  set_bit(row.first, *row.bit, on);
}

void Parameters::set(ParameterId id, double value) {
  G31_EXPECTS(!info(id).bit);
  set_value(info(id).first, value);
}

double Parameters::value(int number, double otherwise) const {
  const auto found = values_.find(number);
  return found != values_.end() ? found->second : otherwise;
}

bool Parameters::bit(int number, int bit) const {
  const auto found = bits_.find({number, bit});
  return found != bits_.end() && found->second;
}

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/vocabulary/parameters.h"

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "machine/base/contract.h"

namespace g31::fanuc {
namespace {

constexpr int kParameterBits = 8;

constexpr auto kParameterRows = std::to_array<ParameterInfo>({
#define BIT_PARAMETER(name, number, bit, text) {number, number, bit, "", 0.0, text, false},
#define VALUE_PARAMETER(name, first, last, unit, initial, text) \
  {first, last, std::nullopt, unit, initial, text, false},
#define IDLE_PARAMETER(name, first, last, unit, text) \
  {first, last, std::nullopt, unit, 0.0, text, true},
#include "interpreter/dialects/fanuc/vocabulary/parameters.def"
#undef IDLE_PARAMETER
#undef VALUE_PARAMETER
#undef BIT_PARAMETER
});

consteval bool parameters_rise() {
  for (std::size_t i = 1; i < kParameterRows.size(); ++i) {
    const bool same_number = kParameterRows[i].first == kParameterRows[i - 1].last;
    if (kParameterRows[i].first < kParameterRows[i - 1].last ||
        (same_number &&
         kParameterRows[i].bit.value_or(0) <= kParameterRows[i - 1].bit.value_or(0))) {
      return false;
    }
  }
  return true;
}
static_assert(kParameterRows.size() == kParameterCount);
static_assert(parameters_rise(), "parameters.def: rows must rise");

}  // namespace

std::span<const ParameterInfo> parameter_rows() {
  return kParameterRows;
}

const ParameterInfo& info(ParameterId id) {
  return kParameterRows.at(static_cast<std::size_t>(id));
}

const ParameterInfo* find_parameter(int number) {
  const auto* const row = std::ranges::find_if(kParameterRows, [&](const ParameterInfo& r) {
    return r.first <= number && number <= r.last;
  });
  return row != kParameterRows.end() ? row : nullptr;
}

bool has_effect(std::string_view name) {
  const char* const end = name.data() + name.size();
  int number = 0;
  const auto after = std::from_chars(name.data(), end, number);
  int bit = -1;
  if (after.ptr != end) {
    std::from_chars(after.ptr + 1, end, bit);
  }
  // What stands for all bits together is none of them; an axis has all of them.
  const bool is_of_axis = after.ptr != end && bit < 0;
  return std::ranges::any_of(kParameterRows, [&](const ParameterInfo& row) {
    const bool is_here = row.first <= number && number <= row.last && !row.is_idle;
    return is_here && (!row.bit || is_of_axis || *row.bit == bit);
  });
}

Result<Parameters, std::string> Parameters::from(const std::map<std::string, double>& entries) {
  Parameters parameters;
  for (const auto& [name, value] : entries) {
    const char* const end = name.data() + name.size();
    int number = 0;
    const auto after = std::from_chars(name.data(), end, number);
    if (after.ec != std::errc() || number < 0) {
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
    parameters.set_bit(number, bit, value != 0.0);
  }
  return parameters;
}

bool Parameters::is_on_for_axis(ParameterId id, int axis) const {
  const ParameterInfo& row = info(id);
  const auto found = axis_values_.find({row.first, axis});
  if (found == axis_values_.end()) {
    return is_on(id);
  }
  const double digits = std::trunc(found->second / std::pow(10.0, row.bit.value_or(0)));
  return std::fmod(digits, 10.0) == 1.0;
}

double Parameters::get(ParameterId id, int index) const {
  const ParameterInfo& row = info(id);
  G31_EXPECTS(!row.bit && index >= 0 && index <= row.last - row.first);
  return value(row.first + index, row.initial);
}

double Parameters::get_for_axis(ParameterId id, int index, int axis) const {
  const auto found = axis_values_.find({info(id).first + index, axis});
  return found != axis_values_.end() ? found->second : get(id, index);
}

unsigned Parameters::signals(ParameterId id, int index) const {
  constexpr double kAll = 255.0;
  const int number = info(id).first + index;
  unsigned on = static_cast<unsigned>(std::clamp(get(id, index), 0.0, kAll));
  for (int i = 0; i < kParameterBits; ++i) {
    on |= bit(number, i) ? 1U << i : 0U;
  }
  return on;
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

void Parameters::set_reference(const AxisPositions& q_M) {
  const int number = info(ParameterId::ReferencePoint).first;
  for (int axis = 0; axis < static_cast<int>(kAxisCount) && !values_.contains(number); ++axis) {
    axis_values_.try_emplace({number, axis}, q_M[axis]);
  }
}

double Parameters::shown(int number) const {
  const auto value = values_.find(number);
  if (value != values_.end()) {
    return value->second;
  }
  const ParameterInfo* const row = find_parameter(number);
  if (row != nullptr && !row->bit) {
    return row->initial;
  }
  double byte = 0.0;
  for (int place = 0; place < kParameterBits; ++place) {
    byte += bit(number, place) ? static_cast<double>(1 << place) : 0.0;
  }
  return byte;
}

double Parameters::shown_bit(int number, int place) const {
  const auto value = values_.find(number);
  if (value == values_.end()) {
    return bit(number, place) ? 1.0 : 0.0;
  }
  return std::fmod(std::trunc(std::abs(value->second) / static_cast<double>(1 << place)), 2.0);
}

double Parameters::shown_for_axis(int number, int axis) const {
  const auto found = axis_values_.find({number, axis});
  return found != axis_values_.end() ? found->second : shown(number);
}

double Parameters::value(int number, double otherwise) const {
  const auto found = values_.find(number);
  return found != values_.end() ? found->second : otherwise;
}

bool Parameters::is_given(ParameterId id) const {
  const ParameterInfo& row = info(id);
  return row.bit && bits_.contains({row.first, *row.bit});
}

bool Parameters::bit(int number, int bit) const {
  const auto found = bits_.find({number, bit});
  return found != bits_.end() && found->second;
}

void Parameters::set_bit(int number, int bit, bool on) {
  bits_[{number, bit}] = on;
  for (std::size_t i = 0; i < kParameterRows.size(); ++i) {
    if (kParameterRows[i].first == number && kParameterRows[i].bit == bit) {
      on_[i] = on;
    }
  }
}

void Parameters::set_value(int number, double value) {
  values_[number] = value;
  std::erase_if(axis_values_, [&](const auto& entry) { return entry.first.first == number; });
}

bool Parameters::enter(int number, double value) {
  const ParameterInfo* const row = find_parameter(number);
  if (row == nullptr || !row->bit) {
    set_value(number, value);
    return true;
  }
  double rest = value;
  for (int bit = 0; bit < kParameterBits; ++bit) {
    const double digit = std::fmod(rest, 10.0);
    if (digit != 0.0 && digit != 1.0) {
      return false;
    }
    set_bit(number, bit, digit == 1.0);
    rest = (rest - digit) / 10.0;
  }
  return rest == 0.0;
}

}  // namespace g31::fanuc

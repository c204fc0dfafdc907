#include "tools/setup/check_value.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <optional>
#include <span>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"
#include "parts/import/mesh_unit.h"
#include "probe/sensor/probe_setup.h"
#include "probe/tooling/tool_probe_setup.h"
#include "probe/tooling/tool_setup.h"
#include "tools/expect/characteristic.h"
#include "tools/setup/program_switch.h"
#include "tools/setup/value_words.h"
#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

using Checked = Result<SheetValue, ValueProblem>;

/// What is wrong with the size of a number of this unit; nullopt: nothing, or it has no bounds.
std::optional<std::string> out_of_bounds(double number, Limit limit, std::string_view unit) {
  const UnitBounds* const row = find_unit(unit);
  if (row == nullptr) {
    return std::nullopt;
  }
  const double size = std::abs(number);
  if (size > row->most) {
    return fmt::format("{:.15g} {} at most", row->most, unit);
  }
  const bool must_not_vanish = limit == Limit::Positive || limit == Limit::NotNegative;
  return must_not_vanish && size > 0.0 && size < row->least
             ? std::optional(fmt::format("{:.15g} {} at least", row->least, unit))
             : std::nullopt;
}

/// Whether `status` of [expect] may be that.
bool is_run_status(std::string_view text) {
  constexpr std::pair<std::string_view, bool> kRows[] = {
#define RUN_STATUS(status, name, may_be_expected) {name, may_be_expected},
#include "tools/expect/run_statuses.def"
#undef RUN_STATUS
  };
  return std::ranges::any_of(kRows,
                             [&](const auto& row) { return row.second && row.first == text; });
}

bool is_column_name(std::string_view text) {
  const auto serves = [](char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
           std::string_view("_.-+").find(c) != std::string_view::npos;
  };
  return !text.empty() && std::ranges::all_of(text, serves);
}

bool are_axis_letters(const std::string& text) {
  for (std::size_t i = 0; i < text.size(); ++i) {
    if (axis_index(text[i]) < 0 || text.find(text[i], i + 1) != std::string::npos) {
      return false;
    }
  }
  return true;
}

bool is_machine_code(const std::string& text) {
  const auto found = program_switch(text);
  return found && found->kind == probe::ProgramSwitch::Kind::Code;
}

/// Of a list of pairs; a single number has no place.
bool places_rise(const std::vector<double>& list) {
  for (std::size_t i = 2; i < list.size(); i += 2) {
    if (!(list[i - 2] < list[i])) {
      return false;
    }
  }
  return true;
}

/// One number for both sides, or the limits of each.
bool is_tolerance(const std::vector<double>& list) {
  return list.size() == 1 ? list[0] >= 0.0 : list.size() == 2 && list[0] < list[1];
}

template <typename Rows>
bool has_name(const Rows& rows, const std::string& text) {
  return std::ranges::any_of(rows, [&](const auto& row) { return row.name == text; });
}

/// Of a limit whose words are its choices.
bool is_choice(Limit limit, const std::string& text) {
  const std::vector<std::string> choices = choices_of(limit);
  return std::ranges::find(choices, text) != choices.end();
}

/// Of a probe's state, a kind of tools, a shape of tool probes.
bool is_word_of_probes(Limit limit, const std::string& text) {
  return limit == Limit::ProbeState ? has_name(probe::kProbeStateNames, text)
         : limit == Limit::ToolKind ? has_name(probe::kToolKindNames, text)
                                    : has_name(probe::kToolProbeShapeNames, text);
}

/// Of a limit that says which characters a text is made of.
bool are_characters(Limit limit, const std::string& text) {
  return limit == Limit::KeyPresses
             ? std::ranges::all_of(text, [](char key) { return key >= ' ' && key <= '~'; })
             : are_axis_letters(text) && (limit == Limit::AxisLetters || text.size() == 1);
}

bool text_within(Limit limit, const std::string& text) {
  switch (limit) {
    case Limit::NotEmpty:
      return !text.empty();
    case Limit::MeshUnit:
      return has_name(parts::kMeshUnits, text);
    case Limit::IncrementSystem:
    case Limit::RapidPath:
    case Limit::OffsetMemory:
    case Limit::StoppingKind:
    case Limit::ProbeType:
    case Limit::SeatKind:
    case Limit::ToolProbeSide:
      return is_choice(limit, text);
    case Limit::RunStatus:
      return is_run_status(text);
    case Limit::ProbeState:
    case Limit::ToolKind:
    case Limit::ToolProbeShape:
      return is_word_of_probes(limit, text);
    case Limit::AxisLetter:
    case Limit::AxisLetters:
    case Limit::KeyPresses:
      return are_characters(limit, text);
    case Limit::WorkOffsetName:
      return normal_name(NameForm::WorkOffset, text).has_value();
    case Limit::MachineCode:
      return is_machine_code(text);
    case Limit::ProgramSwitch:
      return program_switch(text).has_value();
    case Limit::ColumnName:
      return is_column_name(text);
    case Limit::VariableName:
      return normal_variable_name(text).has_value();
    case Limit::ResultUnit:
      return has_name(expect::kResultUnits, text);
    case Limit::Any:
    case Limit::Positive:
    case Limit::Resolution:
    case Limit::NotNegative:
    case Limit::Share:
    case Limit::Bit:
    case Limit::SwitchNumber:
    case Limit::ProgramNumber:
    case Limit::BlockCount:
    case Limit::MeasuringInput:
    case Limit::DigitalInput:
    case Limit::SensorWord:
    case Limit::ToolOfProbe:
    case Limit::EdgePosition:
    case Limit::TipAngle:
    case Limit::Rising:
    case Limit::NotAllZero:
    case Limit::NoneZero:
    case Limit::RisingPlaces:
    case Limit::Tolerance:
      return true;
  }
  contract_violated("every Limit judges texts", __FILE__, __LINE__);
}

bool within(Limit limit, const SheetValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return number_within(limit, *number);
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    return text_within(limit, *text);
  }
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    if (limit == Limit::Rising) {
      return list->at(0) < list->at(1);
    }
    if (limit == Limit::RisingPlaces) {
      return places_rise(*list);
    }
    if (limit == Limit::Tolerance) {
      return is_tolerance(*list);
    }
    if (limit == Limit::NotAllZero) {
      return std::ranges::any_of(*list, [](double n) { return n != 0.0; });
    }
    if (limit == Limit::NoneZero) {
      return std::ranges::all_of(*list, [](double n) { return n != 0.0; });
    }
    return std::ranges::all_of(*list, [&](double n) { return number_within(limit, n); });
  }
  return true;
}

std::span<const double> numbers_of(const SheetValue& value) {
  if (const auto* const number = std::get_if<double>(&value)) {
    return {number, 1};
  }
  const auto* const list = std::get_if<std::vector<double>>(&value);
  return list != nullptr ? std::span<const double>(*list) : std::span<const double>();
}

std::string shown(const SheetValue& value) {
  if (const auto* number = std::get_if<double>(&value)) {
    return fmt::format("{}", *number);
  }
  if (const auto* text = std::get_if<std::string>(&value)) {
    return fmt::format("\"{}\"", *text);
  }
  if (const auto* list = std::get_if<std::vector<double>>(&value)) {
    return fmt::format("[{}]", fmt::join(*list, ", "));
  }
  return "\"\"";
}

ValueProblem wrong_type(const Node& node, ValueType type) {
  return {SetupErrorId::WrongType, kind_of(node), std::string(words_for(type))};
}

/// A finite number; `type` says whether it must be whole and what an error asks for.
Result<double, ValueProblem> number_from(const Node& node, ValueType type) {
  if (const auto* whole = std::get_if<std::int64_t>(&node.value)) {
    if (*whole > kLargestExact || *whole < -kLargestExact) {
      return ValueProblem{SetupErrorId::OutOfRange, fmt::format("{}", *whole),
                          fmt::format("{} at most in size", kLargestExact)};
    }
    return static_cast<double>(*whole);
  }
  const bool must_be_whole = type == ValueType::WholeNumber || type == ValueType::WholeNumbers;
  const auto* number = std::get_if<double>(&node.value);
  if (number == nullptr || must_be_whole) {
    return wrong_type(node, type);
  }
  if (!std::isfinite(*number)) {
    return ValueProblem{SetupErrorId::OutOfRange, fmt::format("{}", *number), "a finite number"};
  }
  return *number;
}

/// An array of numbers; of `count` where that is given.
Checked list_from(const Node& node, ValueType type, std::optional<std::size_t> count) {
  const auto* array = std::get_if<Array>(&node.value);
  if (array == nullptr) {
    return wrong_type(node, type);
  }
  std::vector<double> list;
  for (const Node& element : *array) {
    const auto number = number_from(element, type);
    if (!number) {
      ValueProblem problem = number.error();
      if (problem.id == SetupErrorId::WrongType) {
        problem.is = fmt::format("an array that holds {}", problem.is);
      }
      return problem;
    }
    list.push_back(number.value());
  }
  if (count && list.size() != *count) {
    return ValueProblem{SetupErrorId::WrongType, fmt::format("an array of {}", list.size()),
                        std::string(words_for(type))};
  }
  return SheetValue(list);
}

/// One number, or an array of arrays of two; laid out one after the other.
Checked number_or_table(const Node& node, ValueType type) {
  const auto* array = std::get_if<Array>(&node.value);
  if (array == nullptr) {
    const auto number = number_from(node, type);
    return number ? Checked(SheetValue(std::vector<double>{number.value()}))
                  : Checked(number.error());
  }
  std::vector<double> list;
  for (const Node& row : *array) {
    const auto pair = list_from(row, type, 2);
    if (!pair) {
      ValueProblem problem = pair.error();
      if (problem.id == SetupErrorId::WrongType) {
        problem.is = fmt::format("an array that holds {}", problem.is);
      }
      return problem;
    }
    const auto& numbers = std::get<std::vector<double>>(pair.value());
    list.insert(list.end(), numbers.begin(), numbers.end());
  }
  return SheetValue(list);
}

Checked number_value(const Node& node, ValueType type) {
  const auto number = number_from(node, type);
  return number ? Checked(SheetValue(number.value())) : Checked(number.error());
}

/// One number is a list of one.
Checked number_or_list(const Node& node, ValueType type) {
  if (std::holds_alternative<Array>(node.value)) {
    return list_from(node, type, std::nullopt);
  }
  const auto number = number_from(node, type);
  return number ? Checked(SheetValue(std::vector<double>{number.value()}))
                : Checked(number.error());
}

Checked datum_value(const Node& node, ValueType type) {
  if (const auto* const text = std::get_if<std::string>(&node.value)) {
    return SheetValue(*text);
  }
  if (const auto* const flag = std::get_if<bool>(&node.value)) {
    return SheetValue(*flag ? 1.0 : 0.0);
  }
  return std::holds_alternative<Array>(node.value) ? list_from(node, type, std::nullopt)
                                                   : number_value(node, type);
}

/// A value and its tolerance; a number alone has none.
Checked expected_number(const Node& node, ValueType type) {
  if (!std::holds_alternative<Array>(node.value)) {
    const Checked number = number_value(node, type);
    return number ? Checked(SheetValue(std::vector<double>{std::get<double>(number.value()), 0.0}))
                  : number;
  }
  Checked pair = list_from(node, type, 2);
  if (pair && std::get<std::vector<double>>(pair.value()).back() < 0.0) {
    return ValueProblem{SetupErrorId::OutOfRange, shown(pair.value()),
                        "[value, tolerance] with a tolerance of 0 or more"};
  }
  return pair;
}

/// To the system a path ends at its first character 0.
Checked path_value(const std::string& path) {
  const std::size_t nul = path.find('\0');
  return nul == path.npos ? Checked(SheetValue(path))
                          : ValueProblem{SetupErrorId::OutOfRange,
                                         fmt::format("\"{}\\u0000...\"", path.substr(0, nul)),
                                         "a path without the character 0"};
}

Checked typed_value(const Node& node, ValueType type) {
  const auto* text = std::get_if<std::string>(&node.value);
  const auto* flag = std::get_if<bool>(&node.value);
  switch (type) {
    case ValueType::Text:
      return text != nullptr ? Checked(SheetValue(*text)) : Checked(wrong_type(node, type));
    case ValueType::Path:
      return text != nullptr ? path_value(*text) : Checked(wrong_type(node, type));
    case ValueType::NumberOrFlag:
      return flag != nullptr ? Checked(SheetValue(*flag ? 1.0 : 0.0)) : number_value(node, type);
    case ValueType::NumberOrVacant:
      return text != nullptr && text->empty() ? Checked(SheetValue()) : number_value(node, type);
    case ValueType::Number:
    case ValueType::WholeNumber:
      return number_value(node, type);
    case ValueType::WholeNumbers:
      return list_from(node, type, std::nullopt);
    case ValueType::TwoNumbers:
      return list_from(node, type, 2);
    case ValueType::ThreeNumbers:
      return list_from(node, type, 3);
    case ValueType::NumberOrNumbers:
      return number_or_list(node, type);
    case ValueType::NumberOrTable:
      return number_or_table(node, type);
    case ValueType::Datum:
      return datum_value(node, type);
    case ValueType::ExpectedValue:
      return text != nullptr ? Checked(SheetValue(*text)) : expected_number(node, type);
    case ValueType::ExpectedNumber:
      return expected_number(node, type);
  }
  contract_violated("every ValueType is read", __FILE__, __LINE__);
}

}  // namespace

std::string kind_of(const Node& node) {
  constexpr auto kKinds = std::to_array<std::string_view>(
      {"a true-or-false value", "a whole number", "a number with a decimal point", "a string",
       "a date or time", "an array", "a table"});
  static_assert(kKinds.size() == std::variant_size_v<decltype(Node::value)>);
  return std::string(kKinds.at(node.value.index()));
}

Checked checked_value(const Node& node, ValueType type, Limit limit, std::string_view unit) {
  Checked value = typed_value(node, type);
  if (!value) {
    return value;
  }
  if (!within(limit, value.value())) {
    return ValueProblem{SetupErrorId::OutOfRange, shown(value.value()),
                        std::string(words_for(limit))};
  }
  for (const double number : numbers_of(value.value())) {
    if (const auto bound = out_of_bounds(number, limit, unit)) {
      return ValueProblem{SetupErrorId::OutOfRange, fmt::format("{}", number), *bound};
    }
  }
  return value;
}

}  // namespace g31::setup

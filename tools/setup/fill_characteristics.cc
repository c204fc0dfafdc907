#include "tools/setup/fill_characteristics.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "tools/setup/table_keys.h"
#include "tools/setup/true_sizes.h"
#include "tools/setup/variable_name.h"

namespace g31::setup {
namespace {

expect::ResultUnit unit_from(const TableKeys& keys) {
  const std::string given = keys.get(KeyId::CharacteristicUnit, std::string("mm"));
  const auto* const row =
      std::ranges::find(expect::kResultUnits, std::string_view(given), &expect::ResultUnit::name);
  G31_EXPECTS(row != std::end(expect::kResultUnits));
  return *row;
}

expect::Limits limits_from(const Entry& tolerance) {
  const auto& list = std::get<std::vector<double>>(tolerance.value);
  return list.size() == 1 ? expect::Limits{-list.at(0), list.at(0)}
                          : expect::Limits{list.at(0), list.at(1)};
}

/// Tells what a table lacks.  @returns whether it has all that it needs
bool is_complete(const SheetTable& table, ErrorList& errors) {
  const TableKeys keys(table);
  if (!table.is_whole) {
    return false;  // what is wrong with it has been told
  }
  for (const auto& [id, name, example] :
       {std::tuple(KeyId::CharacteristicName, "name", "name = \"Bore, X\""),
        std::tuple(KeyId::CharacteristicVariable, "variable", "variable = \"#164\"")}) {
    if (keys.find(id) == nullptr) {
      errors.add(SetupErrorId::KeyMissing, table.where, {"a characteristic", name},
                 fmt::format("for example: {}", example));
      return false;
    }
  }
  const Entry* const tolerance = keys.find(KeyId::CharacteristicTolerance);
  if (tolerance != nullptr && keys.find(KeyId::CharacteristicNominal) == nullptr) {
    errors.add(SetupErrorId::KeyMissing, tolerance->where, {"characteristic.tolerance", "nominal"},
               "for example: nominal = 40.0");
    return false;
  }
  return true;
}

/// Tells where what a characteristic truly is cannot be in its unit.
void tell_wrong_unit(const expect::Characteristic& row, const TableKeys& keys, ErrorList& errors) {
  if (!row.true_size || row.true_size->quantity == row.unit.quantity) {
    return;
  }
  const Entry* const given = keys.find(KeyId::CharacteristicUnit);
  const Entry& named = given != nullptr ? *given : *keys.find(KeyId::CharacteristicTrue);
  const auto& [should_be, example] = [&]() -> std::pair<const char*, const char*> {
    switch (row.true_size->quantity) {
      case expect::Quantity::Length:
        return {"a unit of length where true says the size of a part", "mm"};
      case expect::Quantity::Angle:
        return {"\"deg\" where true says an angle of a part", "deg"};
      case expect::Quantity::Number:
        break;
    }
    return {"\"none\" where true says how many there are of a thing", "none"};
  }();
  errors.add(SetupErrorId::OutOfRange, named.where,
             {"characteristic.unit", fmt::format("\"{}\"", row.unit.name), should_be},
             fmt::format("for example: unit = \"{}\"", example));
}

/// @pre it is complete
expect::Characteristic characteristic_from(const SheetTable& table, const TrueSizes& sizes,
                                           ErrorList& errors) {
  const TableKeys keys(table);
  const Entry& variable = *keys.find(KeyId::CharacteristicVariable);
  expect::Characteristic row;
  row.name = std::get<std::string>(keys.find(KeyId::CharacteristicName)->value);
  row.variable = normal_variable_name(std::get<std::string>(variable.value)).value_or("");
  row.place = place_of(variable.where);
  row.unit = unit_from(keys);
  if (const Entry* const nominal = keys.find(KeyId::CharacteristicNominal)) {
    row.nominal = number_of(*nominal);
  }
  if (const Entry* const tolerance = keys.find(KeyId::CharacteristicTolerance)) {
    row.tolerance = limits_from(*tolerance);
  }
  if (const Entry* const truth = keys.find(KeyId::CharacteristicTrue)) {
    row.true_size = sizes.find(*truth);
    tell_wrong_unit(row, keys, errors);
  }
  return row;
}

}  // namespace

std::vector<expect::Characteristic> characteristics_from(const Sheet& sheet,
                                                         std::span<const parts::PartSetup> parts,
                                                         ErrorList& errors) {
  const TrueSizes sizes(parts, errors);
  std::vector<expect::Characteristic> rows;
  for (const SheetTable& table : list_of(sheet, SectionId::Characteristic)) {
    if (is_complete(table, errors)) {
      rows.push_back(characteristic_from(table, sizes, errors));
    }
  }
  return rows;
}

}  // namespace g31::setup

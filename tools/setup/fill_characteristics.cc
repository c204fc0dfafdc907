#include "tools/setup/fill_characteristics.h"

#include <algorithm>
#include <iterator>
#include <optional>
#include <string>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "parts/artefacts/artefact.h"
#include "tools/setup/table_keys.h"
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

/// What PART.KEY may be, in words.
std::string known_sizes(std::span<const parts::PartSetup> parts, const std::string& name) {
  std::vector<std::string> known;
  for (const parts::PartSetup& part : parts) {
    for (const parts::ShapeSize& size : parts::shape_sizes()) {
      if (part.shape == size.shape && (name.empty() || part.name == name)) {
        known.push_back(fmt::format("\"{}.{}\"", part.name, size.name));
      }
    }
  }
  return known.empty() ? "PART.KEY with a part of the sheet that has a shape"
                       : fmt::format("{}", fmt::join(known, " or "));
}

/// Finds the size that PART.KEY names.
class TrueSizes {
 public:
  TrueSizes(std::span<const parts::PartSetup> parts, ErrorList& errors)
      : parts_(parts), errors_(errors) {}

  /// nullopt: what is wrong with it is told.
  [[nodiscard]] std::optional<expect::TrueSize> find(const Entry& entry) const {
    const auto& given = std::get<std::string>(entry.value);
    const std::size_t dot = given.rfind('.');
    const std::string name = dot == std::string::npos ? std::string() : given.substr(0, dot);
    const auto is_it = [&](const parts::PartSetup& part) { return part.name == name; };
    const auto part = std::ranges::find_if(parts_, is_it);
    if (dot == std::string::npos || part == parts_.end()) {
      return refuse(entry, given, known_sizes(parts_, ""));
    }
    if (std::ranges::count_if(parts_, is_it) > 1) {
      return refuse(entry, given, "PART.KEY with a name that no other part has");
    }
    const std::string key = given.substr(dot + 1);
    if (const auto size_mm = parts::size_of(*part, key)) {
      return expect::TrueSize{name, key, *size_mm};
    }
    const auto sizes = parts::shape_sizes();
    if (std::ranges::none_of(sizes, [&](const parts::ShapeSize& size) {
          return size.shape == part->shape && size.name == key;
        })) {
      return refuse(entry, given, known_sizes(parts_, name));
    }
    errors_.add(SetupErrorId::KeyMissing, entry.where,
                {"characteristic.true", fmt::format("{} of part {}", key, name)},
                "the shape works it out from its other sizes: give it in [[part]]");
    return std::nullopt;
  }

 private:
  std::optional<expect::TrueSize> refuse(const Entry& entry, const std::string& given,
                                         const std::string& should_be) const {
    errors_.add(SetupErrorId::OutOfRange, entry.where,
                {"characteristic.true", fmt::format("\"{}\"", given), should_be});
    return std::nullopt;
  }

  std::span<const parts::PartSetup> parts_;
  ErrorList& errors_;
};

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

/// @pre it is complete
expect::Characteristic characteristic_from(const SheetTable& table, const TrueSizes& sizes,
                                           ErrorList& errors) {
  const TableKeys keys(table);
  const Entry& variable = *keys.find(KeyId::CharacteristicVariable);
  const SheetPlace place = place_of(variable.where);
  expect::Characteristic row;
  row.name = std::get<std::string>(keys.find(KeyId::CharacteristicName)->value);
  row.variable = normal_variable_name(std::get<std::string>(variable.value)).value_or("");
  row.place = {place.file, place.line, place.column, place.source_line};
  row.unit = unit_from(keys);
  if (const Entry* const nominal = keys.find(KeyId::CharacteristicNominal)) {
    row.nominal = number_of(*nominal);
  }
  if (const Entry* const tolerance = keys.find(KeyId::CharacteristicTolerance)) {
    row.tolerance = limits_from(*tolerance);
  }
  if (const Entry* const truth = keys.find(KeyId::CharacteristicTrue)) {
    if (row.unit.mm == 0.0) {
      errors.add(SetupErrorId::OutOfRange, keys.find(KeyId::CharacteristicUnit)->where,
                 {"characteristic.unit", fmt::format("\"{}\"", row.unit.name),
                  "a unit of length where true says the size of a part"},
                 "for example: unit = \"mm\"");
    }
    row.true_size = sizes.find(*truth);
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

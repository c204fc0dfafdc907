#include <cmath>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/contract.h"
#include "parts/artefacts/artefact.h"
#include "tools/manual/entries.h"
#include "tools/manual/pages.h"
#include "tools/setup/value_words.h"

namespace g31::manual {
namespace {

using Json = nlohmann::ordered_json;
using setup::KeyRow;
using setup::Limit;
using setup::NameForm;
using setup::SectionForm;
using setup::SectionRow;
using setup::ValueType;

constexpr std::string_view kWorkOffset =
    "^(G0*5[4-9]|EXT|G54\\.1 P[0-9]+|G154 P[0-9]+|G0*5(0[5-9]|[1-9][0-9]))$";

/// A free name as a regular expression.
std::string_view pattern_of(NameForm form) {
  switch (form) {
    case NameForm::AxisLetter:
      return "^[XYZABC]$";
    case NameForm::AnyAxisLetter:
      return "^[XYZABCUVW]$";
    case NameForm::RotaryLetter:
      return "^[ABC]$";
    case NameForm::ParameterNumber:
      return "^[0-9]+(\\.([0-7]|[XYZABC]))?$";
    case NameForm::MacroCallCode:
      return "^[GM][0-9]+$";
    case NameForm::VariableName:
      return "^(#|[A-Za-z_$])";
    case NameForm::WorkOffset:
      return kWorkOffset;
    case NameForm::ToolNumber:
      return "^[0-9]+$";
    case NameForm::ErrorName:
      return "^E[XYZABC][XYZ]$";
    case NameForm::CompensationName:
      return "^E[XYZ][XYZ]$";
    case NameForm::Exact:
    case NameForm::SizeName:
      return "";
  }
  contract_violated("every NameForm has a pattern", __FILE__, __LINE__);
}

/// The same of a text, or "".
std::string_view pattern_of(Limit limit) {
  static constexpr std::pair<Limit, std::string_view> kPatterns[] = {
      {Limit::AxisLetters, "^[XYZABC]*$"},       {Limit::MachineCode, "^M[0-9]+$"},
      {Limit::KeyPresses, "^[ -~]*$"},           {Limit::WorkOffsetName, kWorkOffset},
      {Limit::ColumnName, "^[A-Za-z0-9_.+-]+$"}, {Limit::VariableName, "^ *(#|[A-Za-z_$])"}};
  for (const auto& [of, pattern] : kPatterns) {
    if (of == limit) {
      return pattern;
    }
  }
  return "";
}

Json text_schema(const KeyRow& row) {
  Json schema = {{"type", "string"}};
  if (const auto choices = setup::choices_of(row.limit); !choices.empty()) {
    schema["enum"] = choices;
  } else if (const std::string_view pattern = pattern_of(row.limit); !pattern.empty()) {
    schema["pattern"] = pattern;
  } else if (row.limit == Limit::NotEmpty) {
    schema["minLength"] = 1;
  }
  return schema;
}

/// A bound as the number it is: 1 rather than 1.0.
Json bound(double number) {
  return std::floor(number) == number && std::abs(number) < 1e15
             ? Json(static_cast<std::int64_t>(number))
             : Json(number);
}

Json number_schema(const KeyRow& row, const char* type) {
  const setup::UnitBounds* const unit = setup::find_unit(row.unit);
  Json schema = {{"type", type}};
  if (unit != nullptr) {
    schema["minimum"] = bound(-unit->most);
    schema["maximum"] = bound(unit->most);
  }
  const auto ranges = setup::ranges_of(row.limit);
  Json either = Json::array();
  for (const setup::NumberRange& range : ranges) {
    Json one = Json::object();
    one[range.without_least ? "exclusiveMinimum" : "minimum"] = bound(range.least);
    if (std::isfinite(range.most)) {
      one["maximum"] = bound(range.most);
    }
    either.push_back(std::move(one));
  }
  if (either.size() == 1) {
    schema.erase("minimum");
    schema.update(either.front());
  } else if (!either.empty()) {
    schema["anyOf"] = std::move(either);
  }
  return schema;
}

Json list_schema(Json item, std::size_t count = 0) {
  Json schema = {{"type", "array"}, {"items", std::move(item)}};
  if (count > 0) {
    schema["minItems"] = schema["maxItems"] = count;
  }
  return schema;
}

Json either_schema(Json one, Json other) {
  return {{"anyOf", Json::array({std::move(one), std::move(other)})}};
}

/// A number, or a list of them; a tolerance has two at most.
Json numbers_schema(const KeyRow& row) {
  Json number = number_schema(row, "number");
  if (row.limit != Limit::Tolerance) {
    return either_schema(number, list_schema(number));
  }
  Json one_side = number;
  one_side["minimum"] = 0;
  Json list = list_schema(std::move(number));
  list["minItems"] = 1;
  list["maxItems"] = 2;
  return either_schema(std::move(one_side), std::move(list));
}

Json value_schema(const KeyRow& row) {
  const auto number = [&] { return number_schema(row, "number"); };
  switch (row.type) {
    case ValueType::Text:
    case ValueType::Path:
      return text_schema(row);
    case ValueType::Number:
      return number();
    case ValueType::NumberOrFlag:
      return either_schema(number(), {{"type", "boolean"}});
    case ValueType::NumberOrVacant:
      return either_schema(number(), {{"const", ""}});
    case ValueType::WholeNumber:
      return number_schema(row, "integer");
    case ValueType::WholeNumbers:
      return list_schema(number_schema(row, "integer"));
    case ValueType::TwoNumbers:
      return list_schema(number(), 2);
    case ValueType::ThreeNumbers:
      return list_schema(number(), 3);
    case ValueType::NumberOrNumbers:
      return numbers_schema(row);
    case ValueType::NumberOrTable:
      return either_schema(number(), list_schema(list_schema(number(), 2)));
    case ValueType::ExpectedNumber:
      return either_schema(number(), list_schema(number(), 2));
    case ValueType::ExpectedValue:
      return either_schema({{"type", "string"}}, either_schema(number(), list_schema(number(), 2)));
    case ValueType::Datum:
      return {{"type", Json::array({"number", "boolean", "string", "array"})},
              {"items", {{"type", "number"}}}};
  }
  contract_violated("every ValueType has a schema", __FILE__, __LINE__);
}

Json key_schema(const KeyRow& row) {
  Json schema = value_schema(row);
  const std::string unit = row.unit.empty() ? "" : fmt::format(" Unit: {}.", row.unit);
  schema["description"] = fmt::format("{}.{} Without it: {}. For example: {}", row.text, unit,
                                      row.default_text, row.example);
  return schema;
}

/// The sizes of all shapes as keys; which of them a shape has says `rules_of_shapes`.
void add_sizes(Json& properties, const KeyRow& row) {
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    const std::string line = fmt::format("{}: {}", size.shape, size.text);
    const std::string name(size.name);
    if (properties.contains(name)) {
      properties[name]["description"] =
          fmt::format("{}; {}", properties[name]["description"].get<std::string>(), line);
    } else {
      properties[name] = value_schema(row);
      properties[name]["description"] = line;
    }
  }
}

/// Of each shape: the keys that a part of it may have.
Json rules_of_shapes(const std::vector<std::string>& keys_of_part) {
  Json rules = Json::array();
  for (const parts::Shape& shape : parts::shapes()) {
    Json names = keys_of_part;
    for (const parts::ShapeSize& size : parts::shape_sizes()) {
      if (size.shape == shape.name) {
        names.push_back(size.name);
      }
    }
    rules.push_back({{"if",
                      {{"properties", {{"shape", {{"const", shape.name}}}}},
                       {"required", Json::array({"shape"})}}},
                     {"then", {{"propertyNames", {{"enum", std::move(names)}}}}}});
  }
  return rules;
}

void add_rules_of_parts(Json& table, const std::vector<std::string>& exact_keys) {
  Json names = Json::array();
  for (const parts::Shape& shape : parts::shapes()) {
    names.push_back(shape.name);
  }
  table["properties"]["shape"]["enum"] = std::move(names);
  table["oneOf"] =
      Json::array({{{"required", Json::array({"file"})}}, {{"required", Json::array({"shape"})}}});
  table["allOf"] = rules_of_shapes(exact_keys);
}

Json section_schema(const SectionRow& section);

/// One table of a section.
Json table_schema(const SectionRow& section) {
  Json table = {{"type", "object"}, {"additionalProperties", false}};
  table["properties"] = Json::object();
  std::vector<std::string> exact_keys;
  for (const KeyRow& key : setup::key_rows()) {
    if (key.section != section.id) {
      continue;
    }
    if (key.name_form == NameForm::SizeName) {
      add_sizes(table["properties"], key);
    } else if (key.name_form == NameForm::Exact) {
      exact_keys.emplace_back(key.name);
      table["properties"][exact_keys.back()] = key_schema(key);
    } else {
      table["patternProperties"][std::string(pattern_of(key.name_form))] = key_schema(key);
    }
  }
  for (const std::string_view inner : setup::inner_sections(section.id)) {
    table["properties"][std::string(inner)] =
        section_schema(*setup::find_section(fmt::format("{}.{}", section.path, inner)));
  }
  if (section.id == setup::SectionId::Part) {
    add_rules_of_parts(table, exact_keys);
  }
  return table;
}

Json section_schema(const SectionRow& section) {
  Json schema = table_schema(section);
  switch (section.form) {
    case SectionForm::One:
      break;
    case SectionForm::Named: {
      Json named = {{"type", "object"}, {"additionalProperties", false}};
      named["patternProperties"][std::string(pattern_of(section.name_form))] = std::move(schema);
      schema = std::move(named);
      break;
    }
    case SectionForm::List:
      schema = list_schema(std::move(schema));
      break;
  }
  schema["description"] = section.text;
  return schema;
}

}  // namespace

std::string sheet_schema() {
  Json schema = {{"$schema", "http://json-schema.org/draft-07/schema#"},
                 {"title", "Set-up sheet of g31"},
                 {"description",
                  "made from the tables of g31: g31 explain --page "
                  "schema/g31.sheet.schema.json"},
                 {"type", "object"},
                 {"additionalProperties", false}};
  for (const SectionRow& section : setup::section_rows()) {
    if (section.path.find('.') == std::string_view::npos) {
      schema["properties"][std::string(section.path)] = section_schema(section);
    }
  }
  return schema.dump(1) + "\n";
}

}  // namespace g31::manual

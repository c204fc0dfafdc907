#include "tools/study/check_study.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "machine/base/nearest_name.h"

namespace g31::study {
namespace {

using setup::Location;
using setup::Member;
using setup::Node;
using setup::SetupErrorId;
using setup::ValueProblem;
using Names = std::vector<std::string_view>;

setup::Limit limit_of(StudyLimit limit) {
  switch (limit) {
    case StudyLimit::Any:
    case StudyLimit::Reading:
    case StudyLimit::Choice:
      return setup::Limit::Any;
    case StudyLimit::NotEmpty:
      return setup::Limit::NotEmpty;
    case StudyLimit::Positive:
      return setup::Limit::Positive;
    case StudyLimit::Resolution:
      return setup::Limit::Resolution;
    case StudyLimit::NotNegative:
      return setup::Limit::NotNegative;
  }
  contract_violated("every StudyLimit is one of the sheet's", __FILE__, __LINE__);
}

using Checked = Result<StudyValue, ValueProblem>;

Checked text_from(const Node& node, const StudyKeyRow& row) {
  const auto text = setup::checked_value(node, setup::ValueType::Text, limit_of(row.limit), "");
  if (!text) {
    return text.error();
  }
  const auto& word = std::get<std::string>(text.value());
  if (row.limit == StudyLimit::Choice) {
    const Names choices = choices_of(row);
    if (std::ranges::find(choices, word) == choices.end()) {
      return ValueProblem{SetupErrorId::OutOfRange, fmt::format("\"{}\"", word),
                          fmt::format("\"{}\"", fmt::join(choices, "\" or \""))};
    }
  }
  return StudyValue(word);
}

/// One string, or an array of them.
Checked texts_from(const Node& node, const StudyKeyRow& row) {
  std::vector<std::string> texts;
  const auto* array = std::get_if<setup::Array>(&node.value);
  const std::size_t count = array != nullptr ? array->size() : 1;
  for (std::size_t i = 0; i < count; ++i) {
    const auto text = text_from(array != nullptr ? (*array)[i] : node, row);
    if (!text) {
      ValueProblem problem = text.error();
      problem.should_be = "a string or an array of strings, none empty";
      return problem;
    }
    texts.push_back(std::get<std::string>(text.value()));
  }
  return StudyValue(texts);
}

Checked values_from(const Node& node) {
  const auto* array = std::get_if<setup::Array>(&node.value);
  if (array == nullptr || array->empty()) {
    return ValueProblem{SetupErrorId::WrongType,
                        array == nullptr ? setup::kind_of(node) : "an empty array",
                        "an array of values"};
  }
  return StudyValue(*array);
}

Checked value_from(const Node& node, const StudyKeyRow& row) {
  switch (row.type) {
    case StudyType::Text:
      return text_from(node, row);
    case StudyType::Texts:
      return texts_from(node, row);
    case StudyType::Values:
      return values_from(node);
    case StudyType::Number:
    case StudyType::WholeNumber: {
      const auto number = number_of(node, row);
      return number ? Checked(StudyValue(number.value())) : Checked(number.error());
    }
  }
  contract_violated("every StudyType is read", __FILE__, __LINE__);
}

/// Walks one study file.
class StudyCheck {
 public:
  StudyCheck(const setup::Document& document, setup::ErrorList& errors)
      : document_(document), errors_(errors) {}

  CheckedStudy check() {
    Names known;
    for (const StudySectionRow& row : study_sections()) {
      known.push_back(row.path);
    }
    for (const Member& member : document_.root) {
      const auto row = std::ranges::find(study_sections(), member.key, &StudySectionRow::path);
      if (row == study_sections().end()) {
        unknown_key(member, "the study file", known);
      } else {
        check_section(*row, member);
      }
    }
    if (checked_.study.where.document == nullptr) {
      checked_.study.where = {&document_, 1, 1};
      check_complete(checked_.study, StudySection::Study, "[study]");
    }
    if (checked_.results.empty() && errors_.empty()) {
      errors_.add(SetupErrorId::KeyMissing, {&document_, 1, 1}, {"the study", "a result"},
                  "for example: [results.diameter] value = \"#164\"");
    }
    return std::move(checked_);
  }

 private:
  [[nodiscard]] Location at(const Node& node) const { return {&document_, node.line, node.column}; }

  void unknown_key(const Member& member, std::string_view header, const Names& known) {
    const auto nearest = nearest_name(member.key, known);
    const std::string advice = nearest ? fmt::format("did you mean {}?", *nearest)
                                       : fmt::format("which takes {}", fmt::join(known, ", "));
    errors_.add(SetupErrorId::UnknownKey, {&document_, member.line, member.column},
                {member.key, header, advice});
  }

  void refused(const Node& node, std::string_view path, const ValueProblem& problem,
               std::string_view example) {
    errors_.add(problem.id, at(node), {path, problem.is, problem.should_be},
                fmt::format("for example: {}", example));
  }

  const setup::Table* table_or_error(const Node& node, std::string_view path,
                                     std::string_view example) {
    const auto* table = std::get_if<setup::Table>(&node.value);
    if (table == nullptr) {
      refused(node, path, {SetupErrorId::WrongType, setup::kind_of(node), "a table"}, example);
    }
    return table;
  }

  void check_section(const StudySectionRow& row, const Member& member) {
    switch (row.form) {
      case StudySectionForm::One:
        if (const auto* table = table_or_error(member.node, row.path, row.example)) {
          StudyTable& into =
              row.id == StudySection::Study ? checked_.study : checked_.evaluation.emplace();
          into.where = {&document_, member.line, member.column};
          check_table(*table, row.id, row.example, into);
        }
        return;
      case StudySectionForm::Named:
        if (const auto* tables = table_or_error(member.node, row.path, row.example)) {
          for (const Member& named : *tables) {
            check_result(row, named);
          }
        }
        return;
      case StudySectionForm::List: {
        const auto* array = std::get_if<setup::Array>(&member.node.value);
        if (array == nullptr) {
          refused(member.node, row.path,
                  {SetupErrorId::WrongType, setup::kind_of(member.node), "an array of tables"},
                  row.example);
          return;
        }
        for (const Node& element : *array) {
          if (const auto* table = table_or_error(element, row.path, row.example)) {
            StudyTable& into = checked_.variations.emplace_back();
            into.where = at(element);
            check_table(*table, row.id, row.example, into);
          }
        }
        return;
      }
    }
  }

  void check_result(const StudySectionRow& row, const Member& named) {
    const std::string header = fmt::format("[{}.{}]", row.path, named.key);
    if (const auto* table = table_or_error(named.node, header, row.example)) {
      StudyTable& into = checked_.results.emplace_back();
      into.name = named.key;
      into.where = {&document_, named.line, named.column};
      check_table(*table, row.id, header, into);
    }
  }

  void check_table(const setup::Table& members, StudySection section, std::string_view header,
                   StudyTable& into) {
    for (const Member& member : members) {
      const auto row = std::ranges::find_if(study_keys(), [&](const StudyKeyRow& candidate) {
        return candidate.section == section && candidate.name == member.key;
      });
      if (row == study_keys().end()) {
        unknown_key(member, header, key_names(section));
        continue;
      }
      const auto value = value_from(member.node, *row);
      if (!value) {
        refused(member.node, member.key, value.error(), row->example);
        continue;
      }
      into.entries.emplace(row->id, StudyEntry{value.value(), at(member.node)});
    }
    check_complete(into, section, header);
  }

  void check_complete(const StudyTable& table, StudySection section, std::string_view header) {
    for (const StudyKeyRow& row : study_keys()) {
      if (errors_.empty() && row.section == section && row.default_text.empty() &&
          table.find(row.id) == nullptr) {
        errors_.add(SetupErrorId::KeyMissing, table.where, {header, row.name},
                    fmt::format("for example: {}", row.example));
      }
    }
  }

  const setup::Document& document_;
  setup::ErrorList& errors_;
  CheckedStudy checked_;
};

}  // namespace

Result<double, ValueProblem> number_of(const Node& node, const StudyKeyRow& row) {
  const auto type =
      row.type == StudyType::WholeNumber ? setup::ValueType::WholeNumber : setup::ValueType::Number;
  const std::string_view unit = row.limit == StudyLimit::Reading ? "that of unit" : "";
  const auto number = setup::checked_value(node, type, limit_of(row.limit), unit);
  if (!number) {
    return number.error();
  }
  return std::get<double>(number.value());
}

CheckedStudy check_study(const setup::Document& document, setup::ErrorList& errors) {
  return StudyCheck(document, errors).check();
}

}  // namespace g31::study

#include "tools/setup/fill_expectations.h"

#include <algorithm>
#include <tuple>
#include <utility>
#include <vector>

#include "tools/setup/setup_error.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

/// The expectations of a sheet while they are read.
class ExpectationList {
 public:
  void add(const Entry& entry, expect::What what) {
    rows_.push_back({entry.where, {std::move(what), place_of(entry.where)}});
  }

  /// Sheets in the order of reading, inside each by line and column.
  expect::Expectations in_order() {
    std::ranges::stable_sort(rows_, {}, [](const Row& row) {
      return std::tuple(row.where.document->order, row.where.line, row.where.column);
    });
    expect::Expectations all;
    for (Row& row : rows_) {
      all.rows.push_back(std::move(row.expectation));
    }
    return all;
  }

 private:
  struct Row {
    Location where;
    expect::Expectation expectation;
  };
  std::vector<Row> rows_;
};

expect::Within within_of(const Entry& entry) {
  const auto& pair = std::get<std::vector<double>>(entry.value);
  return {pair.at(0), pair.at(1)};
}

expect::ExpectedValue value_of(const Entry& entry) {
  const auto* const text = std::get_if<std::string>(&entry.value);
  if (text == nullptr) {
    return within_of(entry);
  }
  return *text == "vacant" ? runtime::ShownValue() : runtime::ShownValue(*text);
}

std::size_t count_of(const Entry& entry) {
  return static_cast<std::size_t>(number_of(entry));
}

void add_endings(ExpectationList& list, const TableKeys& keys) {
  if (const Entry* const entry = keys.find(KeyId::ExpectStatus)) {
    list.add(*entry, expect::Status{std::get<std::string>(entry->value)});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectAlarm)) {
    list.add(*entry, expect::Alarm{static_cast<int>(number_of(*entry))});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectTouches)) {
    list.add(*entry, expect::Touches{count_of(*entry)});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectFindings)) {
    list.add(*entry, expect::Findings{count_of(*entry)});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectMachineTime)) {
    const auto& range = std::get<std::vector<double>>(entry->value);
    list.add(*entry, expect::MachineTime{{range.at(0), range.at(1)}});
  }
}

void add_outputs(ExpectationList& list, const TableKeys& keys) {
  if (const Entry* const entry = keys.find(KeyId::ExpectOutput)) {
    list.add(*entry, expect::Output{std::get<std::string>(entry->value)});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectOutputContains)) {
    list.add(*entry, expect::OutputPart{std::get<std::string>(entry->value)});
  }
  if (const Entry* const entry = keys.find(KeyId::ExpectOutputFile)) {
    list.add(*entry, expect::OutputFile{std::get<std::string>(entry->value)});
  }
}

}  // namespace

expect::Expectations expectations_from(const Sheet& sheet) {
  ExpectationList list;
  for (const auto& [place, table] : sheet.tables) {
    const auto& [section, name] = place;
    if (section == SectionId::Expect) {
      add_endings(list, TableKeys(table));
      add_outputs(list, TableKeys(table));
    } else if (section == SectionId::ExpectVariables) {
      for (const auto& [variable, entry] : table.entries) {
        list.add(entry, expect::Variable{variable, value_of(entry)});
      }
    } else if (section == SectionId::ExpectOffsets) {
      for (const auto& [letter, entry] : table.entries) {
        list.add(entry, expect::WorkOffset{name, letter.front(), within_of(entry)});
      }
    }
  }
  return list.in_order();
}

}  // namespace g31::setup

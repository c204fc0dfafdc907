#include <algorithm>
#include <set>

#include <fmt/format.h>

#include "tools/page/run_parts.h"

namespace g31::page {
namespace {

/// Whether a variable is to hold nothing.
bool is_vacant(const expect::ExpectedValue& expected) {
  const auto* const shown = std::get_if<runtime::ShownValue>(&expected);
  const auto* const cell = shown == nullptr ? nullptr : std::get_if<runtime::Cell>(shown);
  return cell != nullptr && cell->is_vacant();
}

/// Fills the table of results, each variable once.
class ResultRows {
 public:
  ResultRows(const RunPage& run, const Writers& writers) : run_(run), writers_(writers) {}

  void add(const expect::MeasuredCharacteristic& measured) {
    const expect::Characteristic& what = measured.what;
    Characteristic row = begin(what.variable, measured.actual);
    row.name = what.name;
    row.unit = what.unit;
    row.nominal = what.nominal;
    row.tolerance = what.tolerance;
    row.true_size = what.true_value();
    rows_.push_back(std::move(row));
  }

  void add(const std::string& variable, const expect::Within& within,
           std::optional<double> measured) {
    Characteristic row = begin(variable, measured);
    row.nominal = within.value;
    row.tolerance = expect::Limits{-within.tolerance, within.tolerance};
    rows_.push_back(std::move(row));
  }

  /// What is to be vacant has no nominal: its verdict is that of what was expected.
  void add_vacant(const std::string& variable, std::optional<double> measured) {
    Characteristic row = begin(variable, measured);
    row.is_as_expected = std::ranges::none_of(
        run_.result.expectations,
        [&](const expect::Judged& judged) { return judged.name == variable && !judged.holds; });
    rows_.push_back(std::move(row));
  }

  void add_reported(const std::string& variable, std::optional<double> measured) {
    if (!known_.contains(variable)) {
      rows_.push_back(begin(variable, measured));
    }
  }

  std::vector<Characteristic> take() { return std::move(rows_); }

 private:
  Characteristic begin(const std::string& variable, std::optional<double> measured) {
    Characteristic row;
    row.variable = variable;
    const std::string meaning = writers_.meaning_of(variable);
    row.name = meaning.empty() ? variable : meaning;
    row.measured = measured;
    row.touches = writers_.touches_of(variable);
    if (run_.other != nullptr) {
      const auto there = run_.other->variables.find(variable);
      row.other =
          there == run_.other->variables.end() ? std::nullopt : std::optional(there->second);
    }
    known_.insert(variable);
    return row;
  }

  const RunPage& run_;
  const Writers& writers_;
  std::set<std::string> known_;
  std::vector<Characteristic> rows_;
};

}  // namespace

std::vector<Characteristic> results_of(const RunPage& run, const Writers& writers) {
  ResultRows rows(run, writers);
  for (const expect::MeasuredCharacteristic& measured : run.result.characteristics) {
    rows.add(measured);
  }
  for (const expect::Expectation& expectation : run.expectations.rows) {
    if (const auto* const variable = std::get_if<expect::Variable>(&expectation.what)) {
      if (const auto* const within = std::get_if<expect::Within>(&variable->value)) {
        rows.add(variable->name, *within, run.value(expectation.what));
      } else if (is_vacant(variable->value)) {
        rows.add_vacant(variable->name, run.value(expectation.what));
      }
    } else if (const auto* const offset = std::get_if<expect::WorkOffset>(&expectation.what)) {
      rows.add(fmt::format("{} {}", offset->name, offset->axis), offset->value,
               run.value(expectation.what));
    }
  }
  for (const auto& [name, value] : run.result.variables) {
    if (const auto* const cell = std::get_if<runtime::Cell>(&value)) {
      rows.add_reported(name, cell->is_vacant() ? std::nullopt : std::optional(cell->raw()));
    }
  }
  return rows.take();
}

}  // namespace g31::page

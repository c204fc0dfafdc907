#include "tools/study/fill_study.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/setup/byte_count.h"
#include "tools/study/fill_evaluation.h"

namespace g31::study {
namespace {

namespace fs = std::filesystem;
using setup::SetupErrorId;
using Texts = std::vector<std::string>;

/// Whether two keys name the same value of a sheet, or one a part of the other's.
bool varies_the_same(const setup::VariedKey& a, const setup::VariedKey& b) {
  const bool may_overlap = !a.component || !b.component || a.component == b.component;
  return a.section == b.section && a.name == b.name && a.key == b.key && may_overlap;
}

/// Fills one study from its tables.
class StudyFill {
 public:
  StudyFill(const setup::Document& document, setup::ErrorList& errors)
      : folder_(fs::path(document.path).parent_path()), errors_(errors) {}

  Study fill(const CheckedStudy& checked) {
    fill_head(checked.study);
    if (checked.evaluation) {
      study_.evaluation = fill_evaluation(*checked.evaluation, errors_);
      has_evaluation_ = true;
    }
    for (const StudyTable& table : checked.results) {
      add_result(table);
    }
    for (const StudyTable& table : checked.variations) {
      add_variation(table);
    }
    check_size(checked.study);
    return std::move(study_);
  }

 private:
  [[nodiscard]] std::string resolved(const std::string& path) const {
    return (folder_ / path).string();
  }

  [[nodiscard]] Texts resolved(const Texts& paths) const {
    Texts all;
    for (const std::string& path : paths) {
      all.push_back(resolved(path));
    }
    return all;
  }

  void fill_head(const StudyTable& table) {
    study_.program = resolved(table.get(StudyKey::Program, std::string()));
    study_.name = table.get(StudyKey::Name, fs::path(study_.program).filename().string());
    study_.setups = resolved(table.get(StudyKey::Setup, Texts()));
    study_.control = table.get(StudyKey::Control, std::string());
    study_.libraries = resolved(table.get(StudyKey::Libraries, Texts()));
    study_.before = resolved(table.get(StudyKey::Before, Texts()));
    study_.before_when = table.get(StudyKey::BeforeWhen, std::string("once")) == "each"
                             ? BeforeWhen::Each
                             : BeforeWhen::Once;
    study_.repeats = static_cast<std::size_t>(table.number(StudyKey::Repeats).value_or(1.0));
    study_.seed = static_cast<std::uint64_t>(table.number(StudyKey::Seed).value_or(0.0));
    study_.confidence_percent =
        table.number(StudyKey::Confidence).value_or(study_.confidence_percent);
    const std::string form = table.get(StudyKey::Table, std::string("summary"));
    study_.table = form == "readings"     ? TableForm::Readings
                   : form == "comparison" ? TableForm::Comparison
                                          : TableForm::Summary;
    study_.assumes = table.get(StudyKey::Assumes, Texts());
    study_.max_blocks =
        static_cast<std::uint64_t>(table.number(StudyKey::MaxBlocks).value_or(50'000'000.0));
    study_.max_time_s = table.number(StudyKey::MaxTime).value_or(study_.max_time_s);
    fill_output(table);
    if (study_.confidence_percent >= 100.0) {
      errors_.add(SetupErrorId::OutOfRange, table.find(StudyKey::Confidence)->where,
                  {"confidence", fmt::format("{}", study_.confidence_percent), "below 100"});
    }
  }

  void fill_output(const StudyTable& table) {
    const StudyEntry* const entry = table.find(StudyKey::MaxOutput);
    if (entry == nullptr) {
      return;
    }
    const auto& text = std::get<std::string>(entry->value);
    const auto bytes = setup::parse_byte_count(text);
    if (bytes) {
      study_.max_output = bytes.value();
    } else {
      errors_.add(SetupErrorId::OutOfRange, entry->where,
                  {"max_output", fmt::format("\"{}\"", text), "a size such as \"64M\""});
    }
  }

  void add_result(const StudyTable& table) {
    StudyResult result;
    result.form.name = table.name;
    result.form.unit = table.get(StudyKey::Unit, result.form.unit);
    result.form.expected = table.number(StudyKey::Expected);
    result.form.resolution = table.number(StudyKey::Resolution);
    result.form.nominal = table.get(StudyKey::Nominal, std::string());
    result.form.tolerance = table.get(StudyKey::Tolerance, std::string());
    result.form.published = numbers_of(table, StudyKey::Published);
    const StudyEntry* const given = table.find(StudyKey::Value);
    const StudyEntry* const evaluated = table.find(StudyKey::Evaluated);
    if ((given == nullptr) == (evaluated == nullptr)) {
      errors_.add(SetupErrorId::KeyMissing, given == nullptr ? table.where : evaluated->where,
                  {fmt::format("[results.{}]", table.name),
                   given == nullptr ? "value or evaluated" : "one of value and evaluated"},
                  "for example: value = \"#164\"");
      return;
    }
    if (evaluated != nullptr) {
      if (study_.evaluation || !has_evaluation_) {
        fill_evaluated(table, study_.evaluation, result, errors_);
      }
      study_.results.push_back(std::move(result));
      return;
    }
    const StudyEntry& value = *given;
    const auto& text = std::get<std::string>(value.value);
    const auto expression = Expression::parse(text);
    if (!expression) {
      errors_.add(SetupErrorId::BadExpression, value.where, {text, expression.error()},
                  "for example: value = \"#164\"");
      return;
    }
    result.expression = expression.value();
    study_.results.push_back(std::move(result));
  }

  /// Of a key that takes nothing but numbers.
  std::vector<double> numbers_of(const StudyTable& table, StudyKey key) {
    std::vector<double> numbers;
    const StudyEntry* const entry = table.find(key);
    if (entry == nullptr) {
      return numbers;
    }
    for (const setup::Node& node : std::get<std::vector<setup::Node>>(entry->value)) {
      const auto number = number_of(node, row_of(key));
      if (!number) {
        const setup::ValueProblem& problem = number.error();
        errors_.add(problem.id, at(table, node),
                    {std::string(row_of(key).name), problem.is, problem.should_be});
        return numbers;
      }
      numbers.push_back(number.value());
    }
    return numbers;
  }

  void add_variation(const StudyTable& table) {
    const StudyEntry& key = *table.find(StudyKey::VaryKey);
    const auto& path = std::get<std::string>(key.value);
    const bool is_listed = table.find(StudyKey::Values) != nullptr;
    const bool is_drawn = table.find(StudyKey::Distribution) != nullptr;
    if (is_listed == is_drawn) {
      errors_.add(SetupErrorId::BadVariation, table.where,
                  {is_listed ? "has both values and a distribution"
                             : "has neither values nor a distribution"},
                  "for example: values = [0.0, 0.001]");
      return;
    }
    if (has_stray_keys(table, is_listed)) {
      return;
    }
    if (path == "setup" && is_listed) {
      if (std::exchange(varies_setup_, true)) {
        tell_second(key, path);
      } else {
        add_sheets(table);
      }
      return;
    }
    const auto target = setup::find_varied_key(path);
    if (!target) {
      errors_.add(SetupErrorId::NothingToVary, key.where, {path, target.error()});
      return;
    }
    const auto first = std::ranges::find_if(varied_, [&](const setup::VariedKey& other) {
      return varies_the_same(other, target.value());
    });
    if (first != varied_.end()) {
      tell_second(key, first->path);
      return;
    }
    varied_.push_back(target.value());
    if (is_listed) {
      add_list(table, target.value());
    } else {
      add_drawn(table, target.value());
    }
  }

  void tell_second(const StudyEntry& key, const std::string& path) {
    errors_.add(SetupErrorId::BadVariation, key.where, {fmt::format("is a second one of {}", path)},
                "keep one [[vary]] of it");
  }

  /// Keys of the other ways to vary, which would have no effect.
  bool has_stray_keys(const StudyTable& table, bool is_listed) {
    const bool is_normal = table.get(StudyKey::Distribution, std::string()) == "normal";
    const std::string_view way = is_listed   ? "a list of values"
                                 : is_normal ? "a normal distribution"
                                             : "a uniform distribution";
    for (const StudyKey key :
         {StudyKey::Low, StudyKey::High, StudyKey::Mean, StudyKey::Deviation}) {
      const bool is_of_normal = key == StudyKey::Mean || key == StudyKey::Deviation;
      const StudyEntry* const entry = table.find(key);
      if (entry != nullptr && (is_listed || is_of_normal != is_normal)) {
        errors_.add(SetupErrorId::BadVariation, entry->where,
                    {fmt::format("has {}, which {} does not take", row_of(key).name, way)});
        return true;
      }
    }
    return false;
  }

  /// What tables call the values; the labels given, if they are as many.
  Texts labels_of(const StudyTable& table, Texts values) {
    const StudyEntry* const given = table.find(StudyKey::Labels);
    if (given == nullptr) {
      return values;
    }
    const auto& labels = std::get<Texts>(given->value);
    if (labels.size() != values.size()) {
      errors_.add(SetupErrorId::BadVariation, given->where,
                  {fmt::format("has {} labels for {} values", labels.size(), values.size())});
      return values;
    }
    return labels;
  }

  void add_sheets(const StudyTable& table) {
    ListedAxis axis{"setup", std::nullopt, {}};
    Texts paths;
    for (const setup::Node& node : nodes_of(table)) {
      const auto* path = std::get_if<std::string>(&node.value);
      if (path == nullptr) {
        errors_.add(SetupErrorId::WrongType, at(table, node),
                    {"values", "an array that holds " + setup::kind_of(node), "names of sheets"});
        return;
      }
      paths.push_back(*path);
      axis.values.push_back({resolved(*path), {}, at(table, node)});
    }
    name_values(axis, labels_of(table, paths));
  }

  void add_list(const StudyTable& table, const setup::VariedKey& target) {
    ListedAxis axis{target.path, target, {}};
    Texts written;
    for (const setup::Node& node : nodes_of(table)) {
      const auto value = setup::value_for(target, node);
      if (!value) {
        const setup::ValueProblem& problem = value.error();
        errors_.add(problem.id, at(table, node), {target.path, problem.is, problem.should_be});
        return;
      }
      if (target.row->type == setup::ValueType::Path) {
        errors_.add(SetupErrorId::NothingToVary, at(table, node),
                    {target.path, "a list of sheets says it: key = \"setup\""});
        return;
      }
      axis.values.push_back({value.value(), {}, at(table, node)});
      written.push_back(written_as(value.value()));
    }
    name_values(axis, labels_of(table, written));
  }

  static std::string written_as(const setup::SheetValue& value) {
    if (const auto* number = std::get_if<double>(&value)) {
      return fmt::format("{}", *number);
    }
    if (const auto* text = std::get_if<std::string>(&value)) {
      return *text;
    }
    if (const auto* list = std::get_if<std::vector<double>>(&value)) {
      std::string text;
      for (const double number : *list) {
        text += fmt::format("{}{}", text.empty() ? "" : " ", number);
      }
      return text;
    }
    return "vacant";
  }

  void name_values(ListedAxis& axis, const Texts& labels) {
    std::set<std::string> seen;
    for (std::size_t i = 0; i < axis.values.size(); ++i) {
      axis.values[i].label = labels[i];
      if (!seen.insert(labels[i]).second) {
        errors_.add(SetupErrorId::BadVariation, axis.values[i].where,
                    {fmt::format("has two values called {}", labels[i])},
                    "tables could not tell them apart: leave one out, or give `labels`");
        break;  // one message says it
      }
    }
    study_.listed.push_back(std::move(axis));
  }

  void add_drawn(const StudyTable& table, const setup::VariedKey& target) {
    if (!setup::takes_any_number(target)) {
      errors_.add(SetupErrorId::NothingToVary, table.find(StudyKey::VaryKey)->where,
                  {target.path, "it takes no number of a range; list its values"});
      return;
    }
    const bool normal = table.get(StudyKey::Distribution, std::string()) == "normal";
    const StudyKey first = normal ? StudyKey::Mean : StudyKey::Low;
    const StudyKey second = normal ? StudyKey::Deviation : StudyKey::High;
    for (const StudyKey wanted : {first, second}) {
      if (table.find(wanted) == nullptr) {
        errors_.add(
            SetupErrorId::KeyMissing, table.find(StudyKey::Distribution)->where,
            {normal ? "a normal distribution" : "a uniform distribution", row_of(wanted).name},
            fmt::format("for example: {}", row_of(wanted).example));
        return;
      }
    }
    const DrawnAxis axis{target, normal ? Distribution::Normal : Distribution::Uniform,
                         *table.number(first), *table.number(second), table.where};
    if (!normal && axis.first > axis.second) {
      errors_.add(SetupErrorId::BadVariation, table.find(StudyKey::Low)->where,
                  {"has its low end above the high one"});
      return;
    }
    study_.drawn.push_back(axis);
  }

  void check_size(const StudyTable& table) {
    double runs = static_cast<double>(study_.repeats);
    for (const ListedAxis& axis : study_.listed) {
      runs *= static_cast<double>(axis.values.size());
    }
    if (runs > static_cast<double>(kMostRuns)) {
      errors_.add(SetupErrorId::OutOfRange, table.where,
                  {"the number of runs", fmt::format("{:.0f}", runs),
                   fmt::format("{} at most", kMostRuns)});
    }
    std::size_t points = 1;
    for (const ListedAxis& axis : study_.listed) {
      points = std::min(points, kMostRuns) * axis.values.size();
    }
    if (study_.table == TableForm::Comparison && points != 2) {
      errors_.add(SetupErrorId::OutOfRange, table.find(StudyKey::Table)->where,
                  {"table", fmt::format("\"comparison\" of {} set-ups", points),
                   "of two: one [[vary]] with two values"});
    }
  }

  static const std::vector<setup::Node>& nodes_of(const StudyTable& table) {
    return std::get<std::vector<setup::Node>>(table.find(StudyKey::Values)->value);
  }

  static setup::Location at(const StudyTable& table, const setup::Node& node) {
    return {table.where.document, node.line, node.column};
  }

  fs::path folder_;
  setup::ErrorList& errors_;
  Study study_;
  bool has_evaluation_ = false;  // right or wrong
  std::vector<setup::VariedKey> varied_;
  bool varies_setup_ = false;
};

}  // namespace

Study fill_study(const CheckedStudy& checked, const setup::Document& document,
                 setup::ErrorList& errors) {
  return StudyFill(document, errors).fill(checked);
}

}  // namespace g31::study

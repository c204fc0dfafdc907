#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/interruption.h"
#include "tools/evaluate/evaluate.h"
#include "tools/setup/document.h"
#include "tools/setup/sheet_stack.h"
#include "tools/study/expression.h"

namespace g31::study {

/// What the terminal shows of a study.
enum class TableForm {
  Summary,     ///< statistics of every result
  Readings,    ///< each reading, then mean and standard deviation
  Comparison,  ///< two set-ups side by side
};

/// When the programs of `before` run.
enum class BeforeWhen { Once, Each };

/// One result as it is reported.
struct ResultForm {
  std::string name;
  std::string unit = "mm";
  std::optional<double> expected;
  std::optional<double> resolution;
  std::string nominal;
  std::string tolerance;
  std::vector<double> published;  ///< by somebody else
};

struct StudyResult {
  ResultForm form;
  Expression expression;
  std::string evaluated;  ///< a result of the evaluation, in the place of the expression
};

/// `[evaluation]`: what the path of each run is asked.
struct StudyEvaluation {
  evaluate::Request request;
  double trace_period_s = 1e-3;
};

/// A value of a list, or a sheet of a list of sheets.
struct ListedValue {
  setup::SheetValue value;  ///< of a sheet: its path, resolved
  std::string label;
  setup::Location where;
};

/// `[[vary]]` with values: one dimension of the grid.
struct ListedAxis {
  std::string key;                         ///< as written
  std::optional<setup::VariedKey> target;  ///< none: whole sheets
  std::vector<ListedValue> values;
};

enum class Distribution { Normal, Uniform };

/// `[[vary]]` with a distribution: one random number a run.
struct DrawnAxis {
  setup::VariedKey target;
  Distribution distribution = Distribution::Normal;
  double first = 0.0;   ///< mean, or lower end
  double second = 0.0;  ///< standard deviation, or upper end
  setup::Location where;
};

/// A study file, checked.  Paths can be opened as they are.
struct Study {
  std::string name;
  std::string program;
  std::vector<std::string> setups;
  std::string control;
  std::vector<std::string> libraries;
  std::vector<std::string> before;
  BeforeWhen before_when = BeforeWhen::Once;
  std::size_t repeats = 1;
  std::uint64_t seed = 0;
  double confidence_percent = 95.0;
  TableForm table = TableForm::Summary;
  std::vector<std::string> assumes;
  std::uint64_t max_blocks = 50'000'000;
  double max_time_s = 600.0;
  const runtime::Interruption* interruption = nullptr;  ///< not of the file: who may end it
  std::uint64_t max_output = 256'000'000;               ///< bytes
  std::optional<StudyEvaluation> evaluation;
  std::vector<StudyResult> results;  ///< as they stand in the file
  std::vector<ListedAxis> listed;
  std::vector<DrawnAxis> drawn;
  std::shared_ptr<const setup::Document> document;  ///< what locations point to
};

/// No study has more runs: their rows have to fit into memory.
inline constexpr std::size_t kMostRuns = 10'000'000;

}  // namespace g31::study

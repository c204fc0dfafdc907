#pragma once

#include <array>
#include <optional>
#include <string>

#include "interpreter/runtime/output_budget.h"
#include "machine/port/trace.h"
#include "tools/evaluate/recorded_path.h"
#include "tools/study/study.h"

namespace g31::study {

/// Takes the path of a run as an evaluation wants it: in one plane, of the places of one kind.
class PathRecorder : public machine::TraceSink {
 public:
  /// @param budget  of the run; what is past it is not kept
  PathRecorder(const StudyEvaluation& evaluation, runtime::OutputBudget& budget);

  void on_sample(const machine::TraceSample& sample) override;
  void on_end(const machine::TraceSample& sample) override;

  /// What the path says; nothing, and why, where it cannot be evaluated.
  [[nodiscard]] Result<evaluate::Evaluation, std::string> evaluated() const;

 private:
  /// An axis of the plane, and which of its places counts.
  struct Column {
    Eigen::Index axis = 0;
    AxisPositions machine::TraceSample::*places = &machine::TraceSample::q_M_true;
  };
  [[nodiscard]] static Column column_of(const evaluate::Request& request, const std::string& axis);
  void add(const machine::TraceSample& sample);

  const StudyEvaluation& evaluation_;
  runtime::OutputBudget& budget_;
  std::array<Column, 2> columns_;
  evaluate::RecordedPath path_;
};

}  // namespace g31::study

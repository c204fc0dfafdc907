#include "tools/study/path_recorder.h"

#include "tools/evaluate/evaluate_path.h"

namespace g31::study {

PathRecorder::PathRecorder(const StudyEvaluation& evaluation, runtime::OutputBudget& budget)
    : evaluation_(evaluation),
      budget_(budget),
      columns_{column_of(evaluation.request, evaluation.request.plane[0]),
               column_of(evaluation.request, evaluation.request.plane[1])} {}

PathRecorder::Column PathRecorder::column_of(const evaluate::Request& request,
                                             const std::string& axis) {
  Column column;
  column.axis = axis.front() - 'X';
  const auto named = request.columns.names.find(axis);
  if (named != request.columns.names.end() && named->second == axis + "_encoder") {
    column.places = &machine::TraceSample::q_M_encoder;
  } else if (named != request.columns.names.end() && named->second == axis + "_commanded") {
    column.places = &machine::TraceSample::q_M_commanded;
  }
  return column;
}

void PathRecorder::on_sample(const machine::TraceSample& sample) {
  if (budget_.charge(runtime::Output::Trace, 3 * sizeof(double))) {
    add(sample);
  }
}

void PathRecorder::on_end(const machine::TraceSample& sample) {
  if (!budget_.is_spent()) {
    add(sample);
  }
}

void PathRecorder::add(const machine::TraceSample& sample) {
  path_.t.push_back(sample.time_s);
  path_.x.push_back((sample.*columns_[0].places)[columns_[0].axis]);
  path_.y.push_back((sample.*columns_[1].places)[columns_[1].axis]);
}

Result<evaluate::Evaluation, std::string> PathRecorder::evaluated() const {
  return evaluate::evaluate_path(path_, evaluation_.request);
}

}  // namespace g31::study

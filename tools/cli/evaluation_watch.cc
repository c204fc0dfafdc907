#include "tools/cli/evaluation_watch.h"

namespace g31::cli {

EvaluationWatch::EvaluationWatch(runtime::TimeBudget& time, std::size_t rows, bool shows)
    : time_(time), rows_left_(rows), shows_(shows) {
  progress_.emplace(rows, "rows", shows);
}

void EvaluationWatch::look() {
  time_.look();
  if (rows_left_ > 0 && --rows_left_ == 0) {
    progress_.emplace(0, "evaluating", shows_);
  }
  progress_->one_done();
}

}  // namespace g31::cli

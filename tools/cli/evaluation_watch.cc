#include "tools/cli/evaluation_watch.h"

namespace g31::cli {

EvaluationWatch::EvaluationWatch(runtime::TimeBudget& time, std::size_t rows, bool shows)
    : time_(time), rows_left_(rows), progress_(rows, "rows", shows) {}

void EvaluationWatch::look() {
  time_.look();
  if (rows_left_ > 0) {
    --rows_left_;
    progress_.one_done();
  }
}

}  // namespace g31::cli

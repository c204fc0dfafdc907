#pragma once

#include <cstddef>
#include <functional>
#include <vector>

#include "tools/study/record.h"

namespace g31::study {

/// A span of runs of a study.
struct RunSpan {
  std::size_t begin = 0;
  std::size_t end = 0;
};

/// Does the runs on `threads` threads, 0 for one a core; which thread does which is left to chance,
/// the rows stand in order.
///
/// @param run   one run by its number; called on many threads at once
/// @param done  called after each run, on its thread
std::vector<Row> run_all(const RunSpan& runs, std::size_t threads,
                         const std::function<Row(std::size_t)>& run,
                         const std::function<void()>& done);

}  // namespace g31::study

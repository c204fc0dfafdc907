#include "tools/study/run_all.h"

#include <optional>

#include <tbb/blocked_range.h>
#include <tbb/global_control.h>
#include <tbb/parallel_for.h>
#include <tbb/partitioner.h>
#include <tbb/task_arena.h>

#include "machine/base/contract.h"

namespace g31::study {

std::vector<Row> run_all(const RunSpan& runs, std::size_t threads,
                         const std::function<Row(std::size_t)>& run,
                         const std::function<void()>& done) {
  G31_EXPECTS(runs.begin <= runs.end);
  std::vector<Row> rows(runs.end - runs.begin);
  const int workers = threads == 0 ? tbb::task_arena::automatic : static_cast<int>(threads);
  // As many as are asked for, even where the machine has fewer cores.
  std::optional<tbb::global_control> allowed;
  if (threads > 0) {
    allowed.emplace(tbb::global_control::max_allowed_parallelism, threads);
  }
  tbb::task_arena arena(workers);
  arena.execute([&] {
    tbb::parallel_for(
        tbb::blocked_range<std::size_t>(runs.begin, runs.end),
        [&](const tbb::blocked_range<std::size_t>& piece) {
          for (std::size_t i = piece.begin(); i != piece.end(); ++i) {
            rows[i - runs.begin] = run(i);
            done();
          }
        },
        tbb::simple_partitioner());
  });
  return rows;
}

}  // namespace g31::study

#include "tools/study/record.h"

#include <algorithm>

#include <fmt/format.h>

#include "tools/study/record_json.h"

namespace g31::study {

std::size_t first_run_of(const Shard& shard, std::size_t runs) {
  // index <= 2^32 and runs <= kMostRuns: the product fits.
  return runs * (shard.index - 1) / shard.of;
}

Summary summary_of(const Record& record, std::size_t point, std::size_t result) {
  std::vector<double> readings;
  const std::size_t repeats = record.description.repeats;
  auto row = std::ranges::lower_bound(record.rows, point * repeats, {}, &Row::run);
  for (; row != record.rows.end() && row->run < (point + 1) * repeats; ++row) {
    if (row->results.at(result)) {
      readings.push_back(*row->results.at(result));
    }
  }
  return summarise(readings, record.description.confidence_percent / 100.0,
                   record.description.results.at(result).expected);
}

std::map<std::string, std::size_t> count_by_status(const Record& record) {
  std::map<std::string, std::size_t> counts;
  for (const Row& row : record.rows) {
    ++counts[row.status];
  }
  return counts;
}

Result<Record, std::string> merge(const std::vector<Record>& parts) {
  Record whole;
  whole.description = parts.front().description;
  for (const Record& part : parts) {
    if (!same_study(part.description, whole.description)) {
      return std::string(
          "the parts are not of the same study: study, sheets, programs, repeats and "
          "seed must be the same");
    }
    whole.rows.insert(whole.rows.end(), part.rows.begin(), part.rows.end());
  }
  std::ranges::sort(whole.rows, {}, &Row::run);
  const std::size_t runs = whole.description.points.size() * whole.description.repeats;
  for (std::size_t i = 0; i < std::max(runs, whole.rows.size()); ++i) {
    if (i < whole.rows.size() && i > 0 && whole.rows[i].run == whole.rows[i - 1].run) {
      return fmt::format("run {} appears twice", whole.rows[i].run + 1);
    }
    if (i >= whole.rows.size() || whole.rows[i].run != i) {
      return fmt::format("run {} of {} is in none of the parts", i + 1, runs);
    }
  }
  return whole;
}

}  // namespace g31::study

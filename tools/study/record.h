#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/study/statistics.h"
#include "tools/study/study.h"

namespace g31::study {

/// What the reports say about a study itself; enough to report on its rows without its file.
struct Description {
  std::string name;
  std::string program;
  std::string control;
  std::uint64_t seed = 0;
  std::size_t repeats = 1;
  double confidence_percent = 95.0;
  TableForm table = TableForm::Summary;
  std::vector<std::string> assumes;
  std::string inputs;  ///< a number made of the files that went in: shards must have the same
  std::vector<ResultForm> results;
  std::vector<std::string> listed;               ///< keys
  std::vector<std::vector<std::string>> points;  ///< for each combination its values in words
  std::vector<std::string> drawn;                ///< keys
};

/// One run.
struct Row {
  std::size_t run = 0;  ///< its number in the whole study, from 0
  std::uint64_t seed = 0;
  std::string status;  ///< as the result document of a run calls it
  int exit_code = 0;   ///< what `g31 run` would have returned
  std::vector<double> drawn;
  std::vector<std::optional<double>> results;  ///< all empty when the run did not complete
  std::string note;                            ///< one line: why it did not

  [[nodiscard]] bool has_completed() const { return status == "completed"; }
};

/// Which runs a part of a study holds: part `index` of `of`, from 1.
struct Shard {
  std::size_t index = 1;
  std::size_t of = 1;
};

/// The first run of a shard; that of index + 1 ends it.
std::size_t first_run_of(const Shard& shard, std::size_t runs);

/// A study, or a shard of one, that has run.
struct Record {
  Description description;
  std::optional<Shard> shard;  ///< none: all of it
  std::vector<Row> rows;       ///< by rising number
};

/// The statistics of one result at one point.  Runs that did not complete and results that are
/// vacant are left out.
Summary summary_of(const Record& record, std::size_t point, std::size_t result);

/// How many rows ended how, by status.
std::map<std::string, std::size_t> count_by_status(const Record& record);

/// Puts shards together.  Error: what is missing, there twice, or of another study.
Result<Record, std::string> merge(const std::vector<Record>& parts);

}  // namespace g31::study

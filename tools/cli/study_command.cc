#include "tools/cli/study_command.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/progress.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_page.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/study/read_study.h"
#include "tools/study/record.h"
#include "tools/study/record_csv.h"
#include "tools/study/record_json.h"
#include "tools/study/record_table.h"
#include "tools/study/run_all.h"
#include "tools/study/study_runs.h"

namespace g31::cli {
namespace {

/// "3/8".
std::optional<study::Shard> shard_from(std::string_view text) {
  study::Shard shard;
  const char* const end = text.data() + text.size();
  const auto index = std::from_chars(text.data(), end, shard.index);
  if (index.ec != std::errc() || index.ptr == end || *index.ptr != '/') {
    return std::nullopt;
  }
  const auto of = std::from_chars(index.ptr + 1, end, shard.of);
  constexpr std::size_t kMostShards = 1'000'000;
  const bool fits = of.ec == std::errc() && of.ptr == end && shard.index >= 1 &&
                    shard.index <= shard.of && shard.of <= kMostShards;
  return fits ? std::optional(shard) : std::nullopt;
}

using session::Refusal;
using Made = Result<study::Record, Refusal>;

Made run_study(const StudyOptions& options) {
  std::optional<study::Shard> shard;
  if (!options.shard.empty()) {
    shard = shard_from(options.shard);
    if (!shard) {
      return session::bad_input(
          fmt::format("--shard {}: write i/n, part i of n, for example 1/4", options.shard));
    }
    if (options.json.empty()) {
      return session::bad_input("--shard needs --json FILE, which --merge takes");
    }
  }
  const auto read = study::read_study(options.study);
  if (!read) {
    return session::refusal_of(read.error());
  }
  study::Study study = read.value();
  study.repeats = options.repeats.value_or(study.repeats);
  study.seed = options.seed.value_or(study.seed);
  study.interruption = options.interruption;
  if (study::run_count(study) > study::kMostRuns) {
    return session::bad_input(
        fmt::format("{} runs are too many: at most {}", study::run_count(study), study::kMostRuns));
  }
  const auto created = study::StudyRuns::create(study);
  if (!created) {
    return created.error();
  }
  study::StudyRuns& runs = *created.value();
  std::fputs(runs.part_findings().c_str(), stderr);
  study::RunSpan span{0, study::run_count(study)};
  if (shard) {
    span = {study::first_run_of(*shard, span.end),
            study::first_run_of({shard->index + 1, shard->of}, span.end)};
  }
  study::Record record{runs.description(), shard, {}};
  Progress progress(span.end - span.begin, "runs", shows_progress(false));
  record.rows = study::run_all(
      span, options.threads,
      [&](std::size_t number) {
        if (runtime::is_interrupted(options.interruption)) {
          return study::Row();
        }
        study::StudyRun run = runs.run(number);
        run.row.exit_code = static_cast<int>(exit_code_of(run.ending));
        return std::move(run.row);
      },
      [&] { progress.one_done(); });
  if (runtime::is_interrupted(options.interruption)) {
    return session::interrupted();
  }
  return record;
}

Made merge_shards(const StudyOptions& options) {
  if (!options.study.empty() || !options.shard.empty() || options.repeats || options.seed) {
    return session::bad_input(
        "--merge takes shards only, no study file, --shard, --repeats or --seed");
  }
  disk::Disk disk;
  std::vector<study::Record> parts;
  for (const std::string& path : options.merge) {
    const auto text = disk.read(path);
    if (!text) {
      return session::bad_input(fmt::format("cannot read the shard {}", path));
    }
    const auto part = study::parse_record(*text);
    if (!part) {
      return session::bad_input(
          fmt::format("{} is not a shard of a study: {}", path, part.error()));
    }
    parts.push_back(part.value());
  }
  const auto merged = study::merge(parts);
  return merged ? Made(merged.value())
                : Made(session::bad_input(fmt::format("--merge: {}", merged.error())));
}

ExitCode worst_of(const study::Record& record) {
  int worst = 0;
  for (const study::Row& row : record.rows) {
    worst = std::max(worst, row.exit_code);
  }
  return static_cast<ExitCode>(worst);
}

std::optional<Refusal> report_study(const StudyOptions& options, const study::Record& record) {
  ShownCommand command("g31 study");
  if (!options.study.empty()) {
    command.add(options.study);
  }
  command.add("--merge", options.merge);
  command.add("--repeats", options.repeats ? fmt::format("{}", *options.repeats) : "");
  command.add("--seed", options.seed ? fmt::format("{}", *options.seed) : "");
  command.add("--shard", options.shard);
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  std::vector<std::string> inputs = options.merge;
  if (!options.study.empty()) {
    inputs.push_back(options.study);
  }
  const page::PageOrigin origin{options.version, command.line(), page_inputs(inputs),
                                options.language, static_cast<int>(worst_of(record))};
  return write_page(options.report, page::report_of(record, study::record_json(record), origin));
}

std::optional<Refusal> deliver(const StudyOptions& options, const study::Record& record) {
  std::optional<Refusal> wrong;
  if (!options.json.empty()) {
    wrong = write_out(options.json, study::record_json(record));
  }
  if (!wrong && !options.csv.empty()) {
    wrong = write_out(options.csv, study::record_csv(record));
  }
  if (!wrong && !options.report.empty()) {
    wrong = report_study(options, record);
  }
  if (!wrong && options.json != "-" && options.csv != "-" && !record.shard) {
    wrong = write_out("-", study::record_table(record));
  }
  return wrong;
}

}  // namespace

ExitCode study_command(const StudyOptions& options) {
  constexpr std::string_view kSchema = "g31.study/1";
  if (options.study.empty() && options.merge.empty()) {
    return refuse(session::bad_input("a study file is missing: g31 study FILE.toml"), options.json,
                  kSchema);
  }
  if (options.json == "-" && options.csv == "-") {
    return refuse(session::bad_input("--json and --csv cannot both be standard output"));
  }
  if (const auto wrong = wrong_place(
          {{"--json", options.json}, {"--csv", options.csv}, {"--report", options.report}},
          {options.merge, {options.study}})) {
    return refuse(*wrong);
  }
  if (const auto wrong = wrong_report(options.report)) {
    return refuse(*wrong, options.json, kSchema);
  }
  const Made made = options.merge.empty() ? run_study(options) : merge_shards(options);
  if (!made) {
    return refuse(made.error(), options.json, kSchema);
  }
  const study::Record& record = made.value();
  if (const auto wrong = deliver(options, record)) {
    return refuse(*wrong);
  }
  const std::string warnings = study::record_warnings(record);
  for (std::size_t at = 0; at < warnings.size();) {
    const std::size_t end = warnings.find('\n', at);
    std::fputs(fmt::format("g31: warning: {}\n", warnings.substr(at, end - at)).c_str(), stderr);
    at = end + 1;
  }
  return worst_of(record);
}

}  // namespace g31::cli

#include "tools/cli/study_command.h"

#include <algorithm>
#include <charconv>
#include <cstdio>
#include <filesystem>
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

/// A study that has run, and the drawings of its runs.
struct MadeStudy {
  study::Record record;
  std::vector<std::string> drawings = {};
  std::vector<std::string> files = {};  ///< that decide what comes of it
};
using Made = Result<MadeStudy, Refusal>;

/// Of one drawing the file as given, of several one with its number before the ending.
std::string place_of_drawing(const std::string& file, std::size_t number, std::size_t of) {
  if (of == 1) {
    return file;
  }
  const std::filesystem::path path(file);
  const std::string name =
      fmt::format("{}-{}{}", path.stem().string(), number + 1, path.extension().string());
  return (path.parent_path() / name).string();
}

/// More files than these are no drawings to look at.
constexpr std::size_t kMostDrawings = 1000;

/// Whether numbers behind the name would make another thing of it: a stream, a device.
bool is_no_file(const std::string& path) {
  std::error_code error;
  const auto status = std::filesystem::status(path, error);
  return path == "-" || (std::filesystem::exists(status) && !is_regular_file(status));
}

/// What --svg wants of a study.
std::optional<Refusal> take_drawings(const StudyOptions& options, study::Study& study) {
  if (options.svg.empty()) {
    return std::nullopt;
  }
  if (!study.evaluation) {
    return session::bad_input("--svg draws what [evaluation] finds, which this study has not");
  }
  if (study::run_count(study) > kMostDrawings) {
    return session::bad_input(fmt::format("--svg makes a file for each of {} runs: at most {}",
                                          study::run_count(study), kMostDrawings));
  }
  if (study::run_count(study) > 1 && is_no_file(options.svg)) {
    return session::bad_input(fmt::format("--svg {} is for a study of one run", options.svg));
  }
  study.evaluation->request.wants_drawing = true;
  study.evaluation->request.language = options.language;
  return std::nullopt;
}

/// What --shard says; nothing: the whole study.
Result<std::optional<study::Shard>, Refusal> asked_shard(const StudyOptions& options) {
  std::optional<study::Shard> shard;
  if (options.shard.empty()) {
    return shard;
  }
  shard = shard_from(options.shard);
  if (!shard) {
    return session::bad_input(
        fmt::format("--shard {}: write i/n, part i of n, for example 1/4", options.shard));
  }
  if (options.json.empty()) {
    return session::bad_input("--shard needs --json FILE, which --merge takes");
  }
  return shard;
}

/// The study of the file with what the command line says.
Result<study::Study, Refusal> asked_study(const StudyOptions& options) {
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
  if (const auto wrong = take_drawings(options, study)) {
    return *wrong;
  }
  return study;
}

std::vector<OutputPlace> study_outputs(const StudyOptions& options) {
  return {{"--json", options.json, true},
          {"--csv", options.csv, true},
          {"--svg", options.svg, true},
          {"--report", options.report}};
}

/// Runs a study.
/// @param all_read  gets what it reads beside the files of the command line
Made run_study(const StudyOptions& options, InputLists& all_read) {
  const auto asked = asked_shard(options);
  if (!asked) {
    return asked.error();
  }
  const std::optional<study::Shard>& shard = asked.value();
  const auto given = asked_study(options);
  if (!given) {
    return given.error();
  }
  const study::Study& study = given.value();
  const auto created = study::StudyRuns::create(study);
  if (!created) {
    return created.error();
  }
  study::StudyRuns& runs = *created.value();
  const std::vector<std::string> files = runs.files();
  all_read.push_back(files);
  if (auto wrong = wrong_place(study_outputs(options), all_read)) {
    return *std::move(wrong);
  }
  std::fputs(runs.part_findings().c_str(), stderr);
  study::RunSpan span{0, study::run_count(study)};
  if (shard) {
    span = {study::first_run_of(*shard, span.end),
            study::first_run_of({shard->index + 1, shard->of}, span.end)};
  }
  MadeStudy made{{runs.description(), shard, {}}};
  made.files = files;
  if (!options.svg.empty()) {
    made.drawings.resize(span.end - span.begin);
  }
  Progress progress(span.end - span.begin, "runs", shows_progress(options.is_quiet));
  made.record.rows = study::run_all(
      span, options.threads,
      [&](std::size_t number) {
        if (runtime::is_interrupted(options.interruption)) {
          return study::Row();
        }
        study::StudyRun run = runs.run(number);
        run.row.exit_code = static_cast<int>(exit_code_of(run.ending));
        if (run.evaluation && !made.drawings.empty()) {
          made.drawings[number - span.begin] = std::move(run.evaluation->svg);
        }
        return std::move(run.row);
      },
      [&] {
        if (!runtime::is_interrupted(options.interruption)) {
          progress.one_done();
        }
      });
  if (runtime::is_interrupted(options.interruption)) {
    return session::interrupted();
  }
  all_read.push_back(runs.read_files());  // which programs are called shows while they run
  return made;
}

Made merge_shards(const StudyOptions& options) {
  if (!options.study.empty() || !options.shard.empty() || options.repeats || options.seed ||
      !options.svg.empty()) {
    return session::bad_input(
        "--merge takes shards only, no study file, --shard, --repeats, --seed or --svg");
  }
  disk::Disk disk;
  std::vector<study::Record> parts;
  for (const std::string& path : options.merge) {
    const auto text = disk.read(path);
    if (!text) {
      return session::unreadable("shard", path);
    }
    const auto part = study::parse_record(*text);
    if (!part) {
      return session::bad_input(
          fmt::format("{} is not a shard of a study: {}", path, part.error()));
    }
    parts.push_back(part.value());
  }
  const auto merged = study::merge(parts);
  return merged ? Made(MadeStudy{merged.value()})
                : Made(session::bad_input(fmt::format("--merge: {}", merged.error())));
}

/// A result that a run leaves vacant is a finding, too: what was asked for is not known of it.
ExitCode worst_of(const study::Record& record) {
  int worst = 0;
  for (const study::Row& row : record.rows) {
    const bool is_vacant =
        row.has_completed() &&
        std::ranges::any_of(row.results, [](const auto& result) { return !result.has_value(); });
    const auto least = is_vacant ? ExitCode::Findings : ExitCode::Completed;
    worst = std::max({worst, row.exit_code, static_cast<int>(least)});
  }
  return static_cast<ExitCode>(worst);
}

std::optional<Refusal> report_study(const StudyOptions& options, const MadeStudy& made) {
  const study::Record& record = made.record;
  ShownCommand command("g31 study");
  if (!options.study.empty()) {
    command.add(options.study);
  }
  command.add("--merge", options.merge);
  command.add("--repeats", options.repeats ? fmt::format("{}", *options.repeats) : "");
  command.add("--seed", options.seed ? fmt::format("{}", *options.seed) : "");
  command.add("--shard", options.shard);
  command.add("--json", options.json);
  command.add("--csv", options.csv);
  command.add("--svg", options.svg);
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  std::vector<std::string> inputs = options.merge;
  if (!options.study.empty()) {
    inputs.push_back(options.study);
  }
  inputs.insert(inputs.end(), made.files.begin(), made.files.end());
  const page::PageOrigin origin{options.version, command.line(), page_inputs(inputs),
                                options.language, static_cast<int>(worst_of(record))};
  return write_page(options.report, page::report_of(record, study::record_json(record), origin));
}

/// Where the drawing of a row goes.
std::string place_of_drawing(const StudyOptions& options, const study::Record& record,
                             std::size_t row) {
  return place_of_drawing(options.svg, record.rows[row].run,
                          record.description.repeats * record.description.points.size());
}

/// Why something that a study has to write may not be where it is wanted, drawings of single runs
/// included.
/// @param read  what the study has read
std::optional<Refusal> wrong_written_place(const StudyOptions& options, const MadeStudy& made,
                                           const InputLists& read) {
  std::vector<OutputPlace> outputs = study_outputs(options);
  std::optional<Refusal> wrong = wrong_place(outputs, read);
  const auto drawing = std::ranges::find(outputs, "--svg", &OutputPlace::option);
  std::rotate(drawing, drawing + 1, outputs.end());  // it is told of behind the others
  for (std::size_t i = 0; i < made.drawings.size() && !wrong; ++i) {
    outputs.back().path = place_of_drawing(options, made.record, i);
    wrong = wrong_place(outputs, read);
  }
  return wrong;
}

std::optional<Refusal> write_drawings(const StudyOptions& options, const MadeStudy& made) {
  std::optional<Refusal> wrong;
  for (std::size_t i = 0; i < made.drawings.size() && !wrong; ++i) {
    if (!made.drawings[i].empty()) {
      wrong = write_out(place_of_drawing(options, made.record, i), made.drawings[i]);
    }
  }
  return wrong;
}

std::optional<Refusal> deliver(const StudyOptions& options, const MadeStudy& made) {
  const study::Record& record = made.record;
  std::optional<Refusal> wrong = write_drawings(options, made);
  if (!wrong && !options.json.empty()) {
    wrong = write_out(options.json, study::record_json(record));
  }
  if (!wrong && !options.csv.empty()) {
    wrong = write_out(options.csv, study::record_csv(record));
  }
  if (!wrong && !options.report.empty()) {
    wrong = report_study(options, made);
  }
  if (!wrong && options.json != "-" && options.csv != "-" && options.svg != "-" && !record.shard) {
    wrong = write_out("-", study::record_table(record));
  }
  return wrong;
}

}  // namespace

ExitCode study_command(const StudyOptions& options) {
  constexpr std::string_view kStudySchema = "g31.study/1";
  if (options.study.empty() && options.merge.empty()) {
    return refuse(session::bad_input("a study file is missing: g31 study FILE.toml"), options.json,
                  kStudySchema);
  }
  InputLists read = {options.merge, {options.study}};
  const auto refused = [&](const Refusal& wrong) {
    return refuse(wrong, sound_place("--json", study_outputs(options), read), kStudySchema);
  };
  if (const auto wrong = wrong_outputs(study_outputs(options), read)) {
    return refused(*wrong);
  }
  if (const auto wrong = wrong_report(options.report)) {
    return refused(*wrong);
  }
  const Made made = options.merge.empty() ? run_study(options, read) : merge_shards(options);
  if (!made) {
    return refused(made.error());
  }
  if (const auto wrong = wrong_written_place(options, made.value(), read)) {
    return refused(*wrong);
  }
  const study::Record& record = made.value().record;
  if (const auto wrong = deliver(options, made.value())) {
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

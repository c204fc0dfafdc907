#include "tools/cli/evaluate_command.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/output_budget.h"
#include "interpreter/runtime/time_budget.h"
#include "tools/cli/evaluate_request.h"
#include "tools/cli/evaluation_watch.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/read_input.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_page.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/evaluate/compensation.h"
#include "tools/evaluate/evaluate.h"

namespace g31::cli {
namespace {

constexpr InputLimit kLargestRecord{kMostDataBytes, "leave out rows that say nothing new"};

/// What an option that names a file says; "": it was not given.
std::string file_given(const EvaluateOptions& options, evaluate::OptionId id) {
  const auto given = options.given.find(id);
  return given == options.given.end() ? std::string() : given->second;
}

/// A file that an evaluation makes.
struct MadeFile {
  std::string path;
  std::string text;
};
using MadeFiles = std::vector<MadeFile>;
using Wrong = std::optional<session::Refusal>;

Wrong make_compensation(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                        MadeFiles& files) {
  const std::string path = file_given(options, evaluate::OptionId::Compensation);
  if (path.empty()) {
    return std::nullopt;
  }
  const auto format =
      *evaluate::compensation_format(file_given(options, evaluate::OptionId::CompensationFormat));
  if (const auto wrong = evaluate::why_no_compensation(format, *evaluation.machine_error)) {
    return session::bad_input("--compensation: " + *wrong);
  }
  files.push_back({path, evaluate::compensation_text(format, *evaluation.machine_error)});
  return std::nullopt;
}

Wrong make_report(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                  MadeFiles& files) {
  if (options.report.empty()) {
    return std::nullopt;
  }
  ShownCommand command("g31 evaluate");
  command.add(options.kind);
  command.add(options.file);
  command.add("--columns", options.columns);
  command.add("--unit", options.unit);
  for (const evaluate::OptionRow& row : evaluate::options()) {
    command.add(row.option, file_given(options, row.id));
  }
  command.add("--magnify", options.magnify);
  const EvaluateOptions usual;
  if (options.max_time_s != usual.max_time_s) {
    command.add("--max-time", fmt::format("{}", options.max_time_s));
  }
  if (options.max_output != usual.max_output) {
    command.add("--max-output", fmt::format("{}", options.max_output));
  }
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  const page::PageOrigin origin{options.version, command.line(), page_inputs({options.file}),
                                options.language, 0};
  const std::string name = std::filesystem::path(options.file).filename().string();
  auto text = page_text(
      page::report_of(evaluation, name, evaluate::evaluation_document(evaluation, true), origin));
  if (!text) {
    return text.error();
  }
  files.push_back({options.report, std::move(text.value())});
  return std::nullopt;
}

/// The least that curves take of a document.
std::uint64_t least_size(const std::vector<evaluate::Curve>& curves) {
  constexpr std::uint64_t kLeastOfPoint = 16;
  std::uint64_t size = 0;
  for (const evaluate::Curve& curve : curves) {
    size += kLeastOfPoint * curve.points.size();
  }
  return size;
}

Wrong too_large(std::uint64_t size, const EvaluateOptions& options) {
  if (size <= options.max_output) {
    return std::nullopt;
  }
  return session::Refusal{
      session::Ending::Budget,
      fmt::format("the limit of output is reached: {} of {} to write; --max-output raises the "
                  "limit",
                  runtime::shown_size(size), runtime::shown_size(options.max_output))};
}

/// All that is to be written, made before the first of it is.
Wrong make_files(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                 MadeFiles& files) {
  Wrong wrong = make_compensation(options, evaluation, files);
  if (!wrong && !options.svg.empty()) {
    files.push_back({options.svg, evaluation.svg});
  }
  if (!wrong && (options.has_curves || !options.report.empty())) {
    wrong = too_large(least_size(evaluation.curves), options);
  }
  if (!wrong) {
    wrong = make_report(options, evaluation, files);
  }
  if (!wrong && !options.json.empty()) {
    files.push_back({options.json, evaluate::evaluation_document(evaluation, options.has_curves)});
  }
  if (!wrong && options.json != "-") {
    files.push_back({"-", evaluate::evaluation_table(evaluation)});
  }
  std::uint64_t size = 0;
  for (const MadeFile& file : files) {
    size += file.text.size();
  }
  return wrong ? wrong : too_large(size, options);
}

/// Reads a file for what reading and evaluating it may take.
Result<evaluate::Evaluation, session::Refusal> evaluated(const EvaluateOptions& options,
                                                         evaluate::Request& request,
                                                         runtime::TimeBudget& time) {
  disk::Disk disk;
  const std::string diameters = file_given(options, evaluate::OptionId::Diameters);
  std::optional<std::string> diameters_text;
  if (!diameters.empty()) {
    const auto read = read_input(disk, diameters, kLargestRecord);
    if (!read) {
      return read.error();
    }
    diameters_text = read.value();
    request.diameters = {diameters, *diameters_text};
  }
  const auto text = read_input(disk, options.file, kLargestRecord);
  if (!text) {
    return text.error();
  }
  const auto rows = static_cast<std::size_t>(std::ranges::count(text.value(), '\n'));
  EvaluationWatch watch(time, rows, shows_progress(options.is_quiet));
  auto evaluation = evaluate::evaluate({options.file, text.value(), &watch}, request);
  if (!evaluation) {
    return session::refusal_of({evaluation.error()});
  }
  return std::move(evaluation.value());
}

/// @throws runtime::BudgetSpent
Wrong evaluate_and_write(const EvaluateOptions& options, evaluate::Request& request) {
  runtime::TimeBudget time(options.max_time_s, options.interruption);
  const auto evaluation = evaluated(options, request, time);
  if (!evaluation) {
    return evaluation.error();
  }
  MadeFiles files;
  if (auto wrong = make_files(options, evaluation.value(), files)) {
    return wrong;
  }
  if (time.is_interrupted()) {
    return session::interrupted();
  }
  if (time.is_up()) {
    throw runtime::BudgetSpent(source::DiagnosticId::BudgetTime, {});
  }
  for (const MadeFile& file : files) {
    if (auto wrong = write_out(file.path, file.text)) {
      return wrong;
    }
  }
  return std::nullopt;
}

}  // namespace

ExitCode evaluate_command(const EvaluateOptions& options) {
  const auto refused = [&options](const session::Refusal& wrong) {
    return refuse(wrong, options.json, "g31.evaluation/1");
  };
  if (const auto wrong =
          wrong_place({{"--json", options.json},
                       {"--svg", options.svg},
                       {"--report", options.report},
                       {"--compensation", file_given(options, evaluate::OptionId::Compensation)}},
                      {{options.file, file_given(options, evaluate::OptionId::Diameters)}})) {
    return refuse(*wrong);
  }
  const auto asked = evaluate_request(options);
  if (!asked) {
    return refused(asked.error());
  }
  if (const auto wrong = wrong_report(options.report)) {
    return refused(*wrong);
  }
  evaluate::Request request = asked.value();
  request.wants_drawing = request.wants_drawing || !options.report.empty();
  request.wants_curves = request.wants_curves || !options.report.empty();
  try {
    const Wrong wrong = evaluate_and_write(options, request);
    return wrong ? refused(*wrong) : ExitCode::Completed;
  } catch (const runtime::BudgetSpent& spent) {
    return refused(spent.message() == source::DiagnosticId::Interrupted
                       ? session::interrupted()
                       : session::Refusal{session::Ending::Budget,
                                          "the limit of computing time is reached: --max-time "
                                          "raises the limit"});
  }
}

}  // namespace g31::cli

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
#include "tools/disk/waiting.h"
#include "tools/evaluate/compensation.h"
#include "tools/evaluate/evaluate.h"

namespace g31::cli {
namespace {

constexpr std::string_view kEvaluationSchema = "g31.evaluation/1";
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

/// What bounds the making of texts: time, and the bytes of all that is written together.
class TextLimits {
 public:
  TextLimits(runtime::TimeBudget& time, std::uint64_t most) : time_(time), most_(most) {}

  /// Of a text that is begun now and will be written, or a part of one: it is ended where it
  /// grows too large together with the files that there are.  Outlived by the limits.
  /// @throws runtime::BudgetSpent  the function, when it is told of a piece
  plot::Growth of_text() {
    return [this, size = written_](std::size_t bytes) mutable {
      look(bytes);
      size += bytes;
      check(size);
    };
  }

  /// Of a text that only makes another one.
  plot::Growth of_passing_text() {
    return [this](std::size_t bytes) { look(bytes); };
  }

  /// @throws runtime::BudgetSpent
  void add(MadeFiles& files, std::string path, std::string text) {
    written_ += text.size();
    check(written_);
    files.push_back({std::move(path), std::move(text)});
  }

 private:
  /// About as often as for rows of the record, however large a piece is.
  void look(std::size_t bytes) {
    constexpr std::size_t kRow = 64;
    for (std::size_t i = 0; i <= bytes / kRow; ++i) {
      time_.look();
    }
  }
  void check(std::uint64_t size) const {
    if (size > most_) {
      throw runtime::BudgetSpent(source::DiagnosticId::BudgetOutput,
                                 "more than " + runtime::shown_size(most_));
    }
  }

  runtime::TimeBudget& time_;
  std::uint64_t most_;
  std::uint64_t written_ = 0;
};

Wrong make_compensation(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                        TextLimits& limits, MadeFiles& files) {
  const std::string path = file_given(options, evaluate::OptionId::Compensation);
  if (path.empty()) {
    return std::nullopt;
  }
  const auto format =
      *evaluate::compensation_format(file_given(options, evaluate::OptionId::CompensationFormat));
  if (const auto wrong = evaluate::why_no_compensation(format, *evaluation.machine_error)) {
    return session::bad_input("--compensation: " + *wrong);
  }
  limits.add(files, path, evaluate::compensation_text(format, *evaluation.machine_error));
  return std::nullopt;
}

Wrong make_report(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                  TextLimits& limits, MadeFiles& files) {
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
  command.add("--json", options.json);
  if (options.has_curves) {
    command.add("--curves");
  }
  command.add("--svg", options.svg);
  const EvaluateOptions usual;
  if (options.max_time_s != usual.max_time_s) {
    command.add("--max-time", fmt::format("{}", options.max_time_s));
  }
  if (options.max_output != usual.max_output) {
    command.add("--max-output", fmt::format("{}", options.max_output));
  }
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  const page::PageOrigin origin{
      options.version, command.line(),
      page_inputs({options.file, file_given(options, evaluate::OptionId::Diameters)}),
      options.language, 0};
  const std::string name = std::filesystem::path(options.file).filename().string();
  page::Report report = page::report_of(
      evaluation, name, evaluate::evaluation_document(evaluation, true, limits.of_passing_text()),
      origin);
  report.growth = limits.of_text();
  auto text = page_text(report);
  if (!text) {
    return text.error();
  }
  limits.add(files, options.report, std::move(text.value()));
  return std::nullopt;
}

/// All that is to be written, made before the first of it is.
/// @throws runtime::BudgetSpent
Wrong make_files(const EvaluateOptions& options, const evaluate::Evaluation& evaluation,
                 TextLimits& limits, MadeFiles& files) {
  if (!options.svg.empty()) {
    limits.add(files, options.svg, evaluation.svg);
  }
  Wrong wrong = make_compensation(options, evaluation, limits, files);
  if (!wrong) {
    wrong = make_report(options, evaluation, limits, files);
  }
  if (!wrong && !options.json.empty()) {
    limits.add(files, options.json,
               evaluate::evaluation_document(evaluation, options.has_curves, limits.of_text()));
  }
  if (!wrong && options.json != "-") {
    limits.add(files, "-", evaluate::evaluation_table(evaluation, limits.of_text()));
  }
  return wrong;
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

session::Refusal refusal_of(const runtime::BudgetSpent& spent) {
  if (spent.message() == source::DiagnosticId::Interrupted) {
    return session::interrupted();
  }
  const bool is_output = spent.message() == source::DiagnosticId::BudgetOutput;
  return {session::Ending::Budget,
          is_output ? fmt::format("the limit of output is reached: {} to write; --max-output "
                                  "raises the limit",
                                  spent.detail())
                    : "the limit of computing time is reached: --max-time raises the limit"};
}

/// @throws runtime::BudgetSpent
Wrong evaluate_and_write(const EvaluateOptions& options, evaluate::Request& request) {
  runtime::TimeBudget time(options.max_time_s, options.interruption);
  TextLimits limits(time, options.max_output);
  request.growth = limits.of_text();
  const auto evaluation = evaluated(options, request, time);
  if (!evaluation) {
    return evaluation.error();
  }
  MadeFiles files;
  if (auto wrong = make_files(options, evaluation.value(), limits, files)) {
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
  const disk::WaitingLimit limit(options.max_time_s);
  const auto refused = [&options](const session::Refusal& wrong) {
    return refuse(wrong, options.json, kEvaluationSchema);
  };
  const std::vector<OutputPlace> outputs = {
      {"--json", options.json, true},
      {"--svg", options.svg, true},
      {"--report", options.report},
      {"--compensation", file_given(options, evaluate::OptionId::Compensation), true}};
  const InputLists inputs = {{options.file, file_given(options, evaluate::OptionId::Diameters)}};
  if (const auto wrong = wrong_outputs(outputs, inputs)) {
    return refuse(*wrong, sound_place("--json", outputs, inputs), kEvaluationSchema);
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
    return refused(refusal_of(spent));
  }
}

}  // namespace g31::cli

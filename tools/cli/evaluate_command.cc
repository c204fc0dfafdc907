#include "tools/cli/evaluate_command.h"

#include <algorithm>
#include <filesystem>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "tools/cli/evaluate_request.h"
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

std::optional<session::Refusal> write_compensation(const EvaluateOptions& options,
                                                   const evaluate::Evaluation& evaluation) {
  const std::string path = file_given(options, evaluate::OptionId::Compensation);
  if (path.empty()) {
    return std::nullopt;
  }
  const auto format =
      *evaluate::compensation_format(file_given(options, evaluate::OptionId::CompensationFormat));
  if (const auto wrong = evaluate::why_no_compensation(format, *evaluation.machine_error)) {
    return session::bad_input("--compensation: " + *wrong);
  }
  return write_out(path, evaluate::compensation_text(format, *evaluation.machine_error));
}

std::optional<session::Refusal> report_evaluation(const EvaluateOptions& options,
                                                  const evaluate::Evaluation& evaluation) {
  ShownCommand command("g31 evaluate");
  command.add(options.kind);
  command.add(options.file);
  command.add("--columns", options.columns);
  command.add("--unit", options.unit);
  for (const evaluate::OptionRow& row : evaluate::options()) {
    command.add(row.option, file_given(options, row.id));
  }
  command.add("--magnify", options.magnify);
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  const page::PageOrigin origin{options.version, command.line(), page_inputs({options.file}),
                                options.language, 0};
  const std::string name = std::filesystem::path(options.file).filename().string();
  return write_page(
      options.report,
      page::report_of(evaluation, name, evaluate::evaluation_document(evaluation, true), origin));
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
  disk::Disk disk;
  const std::string diameters = file_given(options, evaluate::OptionId::Diameters);
  std::optional<std::string> diameters_text;
  if (!diameters.empty()) {
    const auto read = read_input(disk, diameters, kLargestRecord);
    if (!read) {
      return refused(read.error());
    }
    diameters_text = read.value();
    request.diameters = {diameters, *diameters_text};
  }
  const auto text = read_input(disk, options.file, kLargestRecord);
  if (!text) {
    return refused(text.error());
  }
  const auto evaluation = evaluate::evaluate({options.file, text.value()}, request);
  if (!evaluation) {
    return refused(session::refusal_of({evaluation.error()}));
  }
  if (runtime::is_interrupted(options.interruption)) {
    return refused(session::interrupted());
  }
  auto wrong = write_compensation(options, evaluation.value());
  if (!wrong && !options.svg.empty()) {
    wrong = write_out(options.svg, evaluation.value().svg);
  }
  if (!wrong && !options.report.empty()) {
    wrong = report_evaluation(options, evaluation.value());
  }
  if (!wrong) {
    wrong = write_result(
        options.json, [&] { return evaluate::evaluation_table(evaluation.value()); },
        [&] { return evaluate::evaluation_document(evaluation.value(), options.has_curves); });
  }
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

}  // namespace g31::cli

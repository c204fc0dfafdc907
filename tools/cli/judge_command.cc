#include "tools/cli/judge_command.h"

#include <cstdio>
#include <filesystem>
#include <optional>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/read_input.h"
#include "tools/cli/read_results.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_page.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/plan/judgement_document.h"

namespace g31::cli {
namespace {

constexpr const char* kJudgementSchema = "g31.judgement/1";
constexpr InputLimit kLargestPlan{64'000'000, "a plan of g31 plan is far smaller"};

void print_remarks(const std::string& from, const plan::Judgement& judgement) {
  for (const plan::Remark& remark : judgement.remarks) {
    std::fputs(fmt::format("{}:{}: warning: {}\n", from, remark.line, remark.text).c_str(), stderr);
  }
}

std::string command_of(const JudgeOptions& options) {
  ShownCommand command("g31 judge");
  command.add(options.plan);
  command.add(options.results);
  command.add("--json", options.json);
  if (const JudgeOptions usual; options.wait_s != usual.wait_s) {
    command.add("--wait", fmt::format("{}", options.wait_s));
  }
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  return command.line();
}

/// @param from  what the results are called in messages
std::optional<session::Refusal> deliver_report(const JudgeOptions& options, const std::string& from,
                                               const plan::Judgement& judgement) {
  if (options.report.empty()) {
    return std::nullopt;
  }
  const auto name_of = [](const std::string& path) {
    return std::filesystem::path(path).filename().string();
  };
  const page::PageOrigin origin{options.version, command_of(options),
                                page_inputs({options.plan, options.results}), options.language, 0};
  return write_page(options.report,
                    page::report_of(judgement, {name_of(options.plan), name_of(from)}, origin));
}

}  // namespace

ExitCode judge_command(const JudgeOptions& options) {
  const auto refused = [&options](const session::Refusal& wrong) {
    return refuse(wrong, options.json, kJudgementSchema);
  };
  const std::vector<OutputPlace> outputs = {{"--json", options.json, true},
                                            {"--report", options.report}};
  const InputLists inputs = {{options.plan, options.results}};
  if (const auto wrong = wrong_outputs(outputs, inputs)) {
    return refuse(*wrong, sound_place("--json", outputs, inputs), kJudgementSchema);
  }
  if (const auto wrong = wrong_report(options.report)) {
    return refused(*wrong);
  }
  if (options.plan == "-" && options.results == "-") {
    return refused(
        session::bad_input("standard input cannot be both the plan and the results: name a file"));
  }
  disk::Disk disk;
  const auto text = read_input(disk, options.plan, kLargestPlan);
  if (!text) {
    return refused(text.error());
  }
  const auto measures = plan::read_measures(options.plan, text.value());
  if (!measures) {
    return refused(session::bad_input(measures.error()));
  }
  const auto results = read_results(options, measures.value(), disk);
  if (!results) {
    return refused(results.error());
  }
  const plan::Judgement judgement = plan::judged(measures.value(), results.value().text);
  print_remarks(results.value().from, judgement);
  if (const auto wrong = deliver_report(options, results.value().from, judgement)) {
    return refused(*wrong);
  }
  if (const auto wrong = write_result(
          options.json, [&] { return plan::judgement_table(judgement); },
          [&] { return plan::judgement_document(judgement); })) {
    return refuse(*wrong);
  }
  const bool all_good = plan::count(judgement, plan::Verdict::Good) == judgement.measures.size();
  return all_good ? ExitCode::Completed : ExitCode::Findings;
}

}  // namespace g31::cli

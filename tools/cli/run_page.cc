#include "tools/cli/run_page.h"

#include <string>
#include <string_view>
#include <system_error>

#include <fmt/format.h>

#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/page/run_report.h"
#include "tools/page/write_page.h"
#include "tools/picture/pictured_part.h"

namespace g31::cli {
namespace {

/// What of the limits is not as usual.
void add_limits(const RunOptions& options, ShownCommand& command) {
  const RunOptions usual;
  if (options.fail_on != usual.fail_on) {
    command.add("--fail-on", std::string(source::name_of(options.fail_on)));
  }
  if (options.budget.blocks != usual.budget.blocks) {
    command.add("--max-blocks", fmt::format("{}", options.budget.blocks));
  }
  if (options.budget.wall_seconds != usual.budget.wall_seconds) {
    command.add("--max-time", fmt::format("{}", options.budget.wall_seconds));
  }
  if (options.max_output != usual.max_output) {
    command.add("--max-output", fmt::format("{}", options.max_output));
  }
}

/// What it writes beside the report, and the printer, which may stop it.
void add_outputs(const RunOptions& options, ShownCommand& command) {
  const RunOptions usual;
  command.add("--printer", options.printer);
  if (options.printer_wait_s != usual.printer_wait_s) {
    command.add("--printer-wait", fmt::format("{}", options.printer_wait_s));
  }
  command.add("--trace", options.trace);
  if (options.trace_period != usual.trace_period) {
    command.add("--trace-period", options.trace_period);
  }
  command.add("--readings", options.readings);
  command.add("--json", options.json);
  command.add("--jsonl", options.jsonl);
  for (const auto& [flag, is_given] : {std::pair("--moves", options.moves),
                                       {"--touches", options.touches},
                                       {"--blocks", options.blocks},
                                       {"--changes", options.changes}}) {
    if (is_given) {
      command.add(flag);
    }
  }
}

/// The command line that repeats a run.
std::string command_of(const RunOptions& options) {
  ShownCommand command(options.watch != nullptr ? "g31 view" : "g31 run");
  for (const std::string& program : options.programs) {
    command.add(program);
  }
  command.add("-s", options.setups);
  command.add("--lib", options.libraries);
  command.add("--control", options.control);
  command.add("--set", options.assignments);
  if (options.seed != 0) {
    command.add("--seed", fmt::format("{}", options.seed));
  }
  if (options.optional_stop) {
    command.add("--optional-stop");
  }
  for (const int number : options.block_skip) {
    command.add("--block-skip", fmt::format("{}", number));
  }
  command.add("--print", options.prints);
  command.add("--expect", options.expects);
  command.add("--allow", options.allowed);
  add_limits(options, command);
  add_outputs(options, command);
  command.add("--report", options.report);
  command.add("--lang", language_given(options.language));
  command.add("--compare", options.compare);
  return command.line();
}

std::optional<double> number_in(const runtime::ShownValue& value) {
  const auto* const cell = std::get_if<runtime::Cell>(&value);
  return cell != nullptr && !cell->is_vacant() ? std::optional(cell->raw()) : std::nullopt;
}

std::optional<double> value_of(const OpenedRun& opened, const expect::What& what) {
  if (const auto* const offset = std::get_if<expect::WorkOffset>(&what)) {
    return opened.run.session().work_offset(offset->name, axis_index(offset->axis));
  }
  const auto* const variable = std::get_if<expect::Variable>(&what);
  const auto value = variable == nullptr ? Result<runtime::ShownValue, std::string>(std::string())
                                         : opened.run.session().variable(variable->name);
  return value ? number_in(value.value()) : std::nullopt;
}

/// Sends a page where it is wanted.  @returns why it could not be written
std::optional<session::Refusal> send(const RunOptions& options, page::Report report) {
  if (options.watch == nullptr) {
    return write_page(options.report, report);
  }
  if (const auto assets = page::read_assets()) {
    report.edition = options.watch->edition;
    options.watch->take(page::page_of(report, assets.value()));
  }
  return std::nullopt;
}

}  // namespace

Result<page::OtherRun, session::Refusal> compared_run(const std::string& path,
                                                      const setup::Job& job) {
  constexpr std::uint64_t kMostBytes = 512'000'000;
  disk::Disk disk;
  const auto size = disk.size(path);
  const auto text = size && *size <= kMostBytes ? disk.read(path) : std::nullopt;
  if (!text) {
    return session::unreadable("document", path);
  }
  auto other = page::other_run(*text, job);
  return other ? Result<page::OtherRun, session::Refusal>(other.value())
               : session::bad_input(fmt::format("--compare {}: {}", path, other.error()));
}

std::optional<session::Refusal> why_no_page(std::string_view wanted) {
  const auto assets = page::read_assets();
  return assets ? std::nullopt
                : std::optional(session::bad_input(fmt::format("{}: {}", wanted, assets.error())));
}

std::optional<session::Refusal> wrong_report(const std::string& report) {
  if (report.empty()) {
    return std::nullopt;
  }
  if (auto wrong = why_no_page("--report")) {
    return wrong;
  }
  const auto why = disk::why_not_begun(report);
  return why ? std::optional(
                   session::bad_input(fmt::format("--report {}: cannot write: {}", report, *why)))
             : std::nullopt;
}

std::string language_given(page::Language language) {
  return language == page::Language::English ? std::string() : std::string(name_of(language));
}

std::vector<page::Input> page_inputs(const std::vector<std::string>& paths) {
  RunInputs files;
  for (const std::string& path : paths) {
    if (!path.empty()) {
      files.add(path);
    }
  }
  std::vector<page::Input> inputs;
  for (const report::InputFile& file : files.files()) {
    inputs.push_back({file.file, "", file.sha256});
  }
  return inputs;
}

Result<std::string, session::Refusal> page_text(const page::Report& report) {
  const auto assets = page::read_assets();
  if (!assets) {
    return session::bad_input(fmt::format("--report: {}", assets.error()));
  }
  return page::page_of(report, assets.value());
}

std::optional<session::Refusal> write_page(const std::string& path, const page::Report& report) {
  const auto text = page_text(report);
  return text ? write_out(path, text.value()) : std::optional(text.error());
}

std::optional<session::Refusal> deliver_page(const OpenedRun& opened,
                                             const report::RunResult& result) {
  const page::RunPage run{
      result,
      opened.recorder,
      opened.sources,
      opened.prepared.job,
      opened.expectations,
      [&](const expect::What& what) { return value_of(opened, what); },
      opened.ways.ways(),
      opened.ways.track(),
      opened.ways.contacts(),
      opened.ways.collisions(),
      opened.ways.is_of_part(),
      picture::parts_of(opened.world, opened.prepared.job, opened.ways.shown().q_M),
      command_of(opened.options),
      opened.other};
  page::Report report = page::report_of(run, opened.options.language);
  if (opened.options.amend_page) {
    opened.options.amend_page(report);
  }
  return send(opened.options, std::move(report));
}

std::optional<session::Refusal> deliver_refusal_page(const RunOptions& options,
                                                     const report::RunResult& result,
                                                     const source::SourceMap& sources) {
  if (options.watch != nullptr ? why_no_page("g31 view") : wrong_report(options.report)) {
    return std::nullopt;  // it is why there is a refusal, or it comes with the next run
  }
  return send(options,
              page::refusal_report(result, sources, command_of(options), options.language));
}

}  // namespace g31::cli

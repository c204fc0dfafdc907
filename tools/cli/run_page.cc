#include "tools/cli/run_page.h"

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "tools/cli/write_out.h"
#include "tools/page/run_report.h"
#include "tools/page/write_page.h"
#include "tools/picture/pictured_part.h"

namespace g31::cli {
namespace {

/// A word of a command line as a shell takes it.
std::string quoted(const std::string& word) {
  constexpr std::string_view kPlain =
      "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789-_./=+,:%@";
  if (!word.empty() && word.find_first_not_of(kPlain) == std::string::npos) {
    return word;
  }
  std::string safe = "'";
  for (const char c : word) {
    safe += c == '\'' ? std::string("'\\''") : std::string(1, c);
  }
  return safe + "'";
}

/// The command line that repeats a run.
std::string command_of(const RunOptions& options) {
  std::string line = "g31 run";
  const auto add = [&](std::string_view option, const std::string& value) {
    line += fmt::format("{}{} {}", option.empty() ? "" : " ", option, quoted(value));
  };
  const auto add_all = [&](std::string_view option, const std::vector<std::string>& values) {
    for (const std::string& value : values) {
      add(option, value);
    }
  };
  add_all("", options.programs);
  add_all("-s", options.setups);
  add_all("--lib", options.libraries);
  if (!options.control.empty()) {
    add("--control", options.control);
  }
  add_all("--set", options.assignments);
  if (options.seed != 0) {
    add("--seed", fmt::format("{}", options.seed));
  }
  line += options.optional_stop ? " --optional-stop" : "";
  for (const int number : options.block_skip) {
    add("--block-skip", fmt::format("{}", number));
  }
  add_all("--print", options.prints);
  add_all("--expect", options.expects);
  add_all("--allow", options.allowed);
  add("--report", options.report);
  return line;
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

}  // namespace

std::optional<session::Refusal> wrong_report(const RunOptions& options) {
  if (options.report.empty()) {
    return std::nullopt;
  }
  const auto assets = page::read_assets();
  return assets ? std::nullopt
                : std::optional(session::bad_input(fmt::format("--report: {}", assets.error())));
}

std::optional<session::Refusal> deliver_page(const OpenedRun& opened,
                                             const report::RunResult& result) {
  const auto assets = page::read_assets();
  if (!assets) {
    return session::bad_input(fmt::format("--report: {}", assets.error()));
  }
  const page::RunPage run{result,
                          opened.recorder,
                          opened.sources,
                          opened.prepared.job,
                          opened.expectations,
                          [&](const expect::What& what) { return value_of(opened, what); },
                          opened.ways.ways(),
                          picture::parts_of(opened.world),
                          command_of(opened.options)};
  const page::Report report = page::report_of(run, opened.options.language);
  return write_out(opened.options.report, page::page_of(report, assets.value()));
}

}  // namespace g31::cli

#include "tools/cli/check_command.h"

#include <algorithm>
#include <optional>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/analysis/finding.h"
#include "machine/base/nearest_name.h"
#include "tools/check/check.h"
#include "tools/check/check_document.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/disk/shipped.h"
#include "tools/setup/toml_reader.h"

namespace g31::cli {
namespace {

using CheckFindings = std::vector<analysis::Finding>;

source::Severity level_of(const analysis::Finding& finding) {
  return analysis::info(finding.rule).level;
}

std::string list_of_rules() {
  std::string text;
  for (const analysis::Rule& rule : analysis::rules()) {
    text += fmt::format("{}  {:7}  {}: {}\n", rule.code, source::name_of(rule.level), rule.title,
                        rule.text);
  }
  return text;
}

/// What the command line says that is wrong; nullopt: nothing.
std::optional<session::Refusal> why_not(const CheckOptions& options) {
  std::vector<std::string_view> known;
  for (const analysis::Rule& rule : analysis::rules()) {
    known.push_back(rule.code);
  }
  for (const std::string& rule : options.disabled) {
    if (std::ranges::find(known, rule) == known.end()) {
      const auto nearest = nearest_name(rule, known);
      return session::bad_input(
          fmt::format("--disable {}: no such rule{}; g31 check --rules lists them", rule,
                      nearest ? fmt::format(", did you mean {}?", *nearest) : ""));
    }
  }
  disk::Disk disk;
  for (const std::string& folder : options.libraries) {
    if (!disk.has_folder(folder)) {
      return session::bad_input(fmt::format("--lib {}: no such folder", folder));
    }
  }
  return std::nullopt;
}

CheckFindings without_disabled(CheckFindings found, const std::vector<std::string>& disabled) {
  std::erase_if(found, [&](const analysis::Finding& finding) {
    return std::ranges::find(disabled, analysis::info(finding.rule).code) != disabled.end();
  });
  return found;
}

std::string text_of(const CheckFindings& found, const source::SourceMap& sources) {
  std::string text;
  for (const analysis::Finding& finding : found) {
    text += render_text(analysis::diagnostic_of(finding), sources);
  }
  return text;
}

/// What was asked for and could not be looked at.
std::vector<session::Refusal> left_out(const check::Request& request,
                                       const check::Findings& checked) {
  std::vector<session::Refusal> all;
  for (const std::string& path : request.paths.missing) {
    all.push_back(session::bad_input(fmt::format("{}: no such file or folder", path)));
  }
  for (const std::string& path : checked.unreadable) {
    all.push_back(session::bad_input(fmt::format("cannot read the program {}", path)));
  }
  return all;
}

/// The findings where they are wanted.
/// @param missing  files that were not there to be looked at
std::optional<session::Refusal> hand_out(const CheckOptions& options, const CheckFindings& found,
                                         const std::vector<session::Refusal>& missing,
                                         const source::SourceMap& sources) {
  std::vector<std::string> unread;
  for (const session::Refusal& one : missing) {
    unread.push_back(one.message);
  }
  const auto document = [&] { return check::check_document(found, unread, sources); };
  const auto for_people = [&] {
    if (options.format == CheckOptions::Format::Github) {
      return check::github_annotations(found, sources);
    }
    return options.format == CheckOptions::Format::Json ? document() : text_of(found, sources);
  };
  return write_result(options.json, for_people, document);
}

/// What is to be checked, and as what: by the command line, else by the sheets.
Result<check::Request, session::Refusal> request_of(const CheckOptions& options) {
  const auto job =
      setup::read_job(options.setups, disk::shipped_folder("machine/library").value_or(""));
  if (!job) {
    return session::refusal_of(job.error());
  }
  check::Request request;
  request.setup = job.value().control;
  const std::string& name = options.control.empty() ? request.setup.profile : options.control;
  if (!name.empty()) {
    const auto control = session::control_named(name);
    if (!control) {
      return session::bad_setup(control.error());
    }
    request.control = control.value();
  }
  request.paths = check::program_paths(options.files);
  request.libraries = options.libraries;
  return request;
}

}  // namespace

ExitCode check_command(const CheckOptions& options) {
  if (const auto wrong = why_not(options)) {
    return refuse(*wrong);
  }
  if (options.lists_rules) {
    const auto wrong = write_out("-", list_of_rules());
    return wrong ? refuse(*wrong) : ExitCode::Completed;
  }
  if (const auto wrong = wrong_place({{"--json", options.json}}, {options.files, options.setups})) {
    return refuse(*wrong);
  }
  const auto requested = request_of(options);
  if (!requested) {
    return refuse(requested.error(), options.json, "g31.check/1");
  }
  const check::Request& request = requested.value();
  disk::Disk disk;
  source::SourceMap sources(disk);
  check::Findings checked = check::check(request, sources);
  const std::vector<session::Refusal> missing = left_out(request, checked);
  const CheckFindings found = without_disabled(std::move(checked.found), options.disabled);
  if (const auto wrong = hand_out(options, found, missing, sources)) {
    return refuse(*wrong);
  }
  for (const session::Refusal& one : missing) {
    (void)refuse(one);
  }
  if (!missing.empty()) {
    return ExitCode::BadUsage;
  }
  const bool fails = std::ranges::any_of(found, [&](const analysis::Finding& finding) {
    return level_of(finding) >= options.fail_on;
  });
  return fails ? ExitCode::Findings : ExitCode::Completed;
}

}  // namespace g31::cli

#include "tools/cli/check_command.h"

#include <algorithm>
#include <optional>
#include <span>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "interpreter/analysis/finding.h"
#include "machine/base/letters.h"
#include "tools/check/baseline.h"
#include "tools/check/check.h"
#include "tools/check/check_document.h"
#include "tools/check/named_rule.h"
#include "tools/check/sarif.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/progress.h"
#include "tools/cli/read_input.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/disk/remembering_disk.h"
#include "tools/disk/shipped.h"
#include "tools/session/library_folders.h"
#include "tools/session/prepare.h"
#include "tools/setup/job_files.h"
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

constexpr std::string_view kCheckSchema = "g31.check/1";

/// What the command line says that is wrong, but for the place of the document; nullopt: nothing.
std::optional<session::Refusal> why_not(const CheckOptions& options) {
  for (const std::string& rule : options.disabled) {
    if (const auto wrong = check::why_no_rule(rule)) {
      return session::bad_input(fmt::format("--disable {}: {}", rule, *wrong));
    }
  }
  return session::asks_twice_for_standard_input(
      {options.files, options.setups, std::span(&options.baseline, 1)});
}

/// The earlier findings that nobody wants to hear again; without a baseline none.
Result<check::Baseline, session::Refusal> baseline_of(const CheckOptions& options) {
  if (options.baseline.empty()) {
    return check::Baseline();
  }
  constexpr InputLimit kLargestBaseline{256'000'000, "check fewer programs at a time"};
  disk::Disk disk;
  const auto text = read_input(disk, options.baseline, kLargestBaseline);
  if (!text) {
    return text.error();
  }
  const auto baseline = check::Baseline::read(options.baseline, text.value());
  if (!baseline) {
    return session::bad_input(baseline.error());
  }
  return baseline.value();
}

/// Without the rules that --disable names.
CheckFindings without_rules(CheckFindings found, const std::vector<std::string>& disabled) {
  std::erase_if(found, [&](const analysis::Finding& finding) {
    return std::ranges::any_of(disabled, [&](const std::string& rule) {
      return in_capitals(rule) == analysis::info(finding.rule).code;
    });
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
  for (const std::string& folder : request.paths.empty) {
    all.push_back(session::bad_input(fmt::format(
        "{}: no program is in this folder; g31 check --help says which files are programs",
        folder)));
  }
  for (const auto& [folder, why] : request.paths.closed) {
    all.push_back(session::closed_folder(folder, why));
  }
  for (const std::string& path : checked.unreadable) {
    all.push_back(session::unreadable("program", path));
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
    switch (options.format) {
      case CheckOptions::Format::Text:
        return text_of(found, sources);
      case CheckOptions::Format::Json:
        return document();
      case CheckOptions::Format::Sarif:
        return check::sarif_log(found, sources, options.version);
      case CheckOptions::Format::Github:
        return check::github_annotations(found, sources);
    }
    return std::string();
  };
  return write_result(options.json, for_people, document);
}

/// What is to be checked, and as what: by the command line, else by the sheets.
/// @param read  gets the files of the sheets, and those that they name
Result<check::Request, session::Refusal> request_of(const CheckOptions& options, InputLists& read) {
  const auto job =
      setup::read_job(options.setups, disk::shipped_folder("machine/library").value_or(""));
  if (!job) {
    return session::refusal_of(job.error());
  }
  read.push_back(setup::files_of(job.value()));
  check::Request request;
  request.setup = job.value().control;
  const auto control = session::named_control(options.control, job.value());
  if (!control) {
    return control.error();
  }
  request.control = control.value();
  request.paths = check::program_paths(options.files);
  disk::Disk disk;
  const auto libraries = session::library_folders(options.libraries, disk);
  if (!libraries) {
    return libraries.error();
  }
  request.libraries = libraries.value();
  return request;
}

ExitCode list_rules(const CheckOptions& options) {
  const auto document = [] { return check::rules_document(); };
  const bool as_json = options.format == CheckOptions::Format::Json;
  const auto wrong = write_result(
      options.json, [&] { return as_json ? document() : list_of_rules(); }, document);
  return wrong ? refuse(*wrong) : ExitCode::Completed;
}

std::vector<OutputPlace> check_outputs(const CheckOptions& options) {
  const bool is_for_people = options.format == CheckOptions::Format::Text;
  return {{"--json", options.json, true}, {"--format", is_for_people ? "" : "-"}};
}

/// Checks the programs and says what is wrong with them.
/// @param read  gets what is read beside the files of the command line
Result<ExitCode, session::Refusal> do_check(const CheckOptions& options, InputLists& read) {
  const auto baseline = baseline_of(options);
  if (!baseline) {
    return baseline.error();
  }
  const auto requested = request_of(options, read);
  if (!requested) {
    return requested.error();
  }
  check::Request request = requested.value();
  disk::Disk disk;
  disk::RememberingDisk remembering(disk);
  source::SourceMap sources(remembering);
  check::Findings checked;
  {
    Progress progress(request.paths.files.size(), "files", shows_progress(options.is_quiet));
    request.file_done = [&] { progress.one_done(); };
    request.interruption = options.interruption;
    checked = check::check(request, sources);
  }
  if (runtime::is_interrupted(options.interruption)) {
    return session::interrupted();
  }
  read.push_back(remembering.paths());
  if (const auto wrong = wrong_place(check_outputs(options), read)) {
    return *wrong;
  }
  const std::vector<session::Refusal> missing = left_out(request, checked);
  const CheckFindings found = without_rules(
      baseline.value().without_known(std::move(checked.found), sources), options.disabled);
  if (const auto wrong = hand_out(options, found, missing, sources)) {
    return *wrong;
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

}  // namespace

ExitCode check_command(const CheckOptions& options) {
  const std::vector<OutputPlace> outputs = check_outputs(options);
  InputLists read = {options.files, options.setups, {options.baseline}};
  const auto refused = [&](const session::Refusal& wrong) {
    return refuse(wrong, sound_place("--json", outputs, read), kCheckSchema);
  };
  if (const auto wrong = wrong_outputs(outputs, read)) {
    return refused(*wrong);
  }
  if (const auto wrong = why_not(options)) {
    return refused(*wrong);
  }
  if (options.lists_rules) {
    return list_rules(options);
  }
  const auto done = do_check(options, read);
  return done ? done.value() : refused(done.error());
}

}  // namespace g31::cli

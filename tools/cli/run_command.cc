#include "tools/cli/run_command.h"

#include <algorithm>
#include <cerrno>
#include <cstdio>
#include <cstring>
#include <filesystem>
#include <optional>
#include <utility>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/session.h"
#include "interpreter/source/diagnostic.h"
#include "machine/base/contract.h"
#include "tools/cli/chosen_profile.h"
#include "tools/cli/disk.h"
#include "tools/cli/scene.h"
#include "tools/cli/shipped.h"
#include "tools/cli/variables_file.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/setup/assignment.h"
#include "tools/setup/name_list.h"
#include "tools/setup/toml_reader.h"

namespace g31::cli {
namespace {

/// Why a run cannot begin.
struct Refusal {
  ExitCode code = ExitCode::BadUsage;
  std::string text;  ///< whole lines
};

Refusal refusal(ExitCode code, std::string_view message) {
  return {code, fmt::format("g31: error: {}\n", message)};
}

/// Everything that the command line and the sheets say, read and checked before anything runs.
struct Prepared {
  setup::Job job;
  const fanuc::Profile* profile = nullptr;
  std::vector<std::string> prints;
};

/// Prints on the terminal while the program runs, unless the document goes there.  Without a
/// document nothing is kept: an endless loop may print and stop for hours.
class EchoingRecorder final : public report::RunRecorder {
 public:
  explicit EchoingRecorder(const RunOptions& options)
      : RunRecorder({options.moves ? Keep::Yes : Keep::No, options.touches ? Keep::Yes : Keep::No}),
        echoes_(options.json != "-"),
        keeps_(!options.json.empty()) {}
  void on_output(std::string_view text) override {
    if (keeps_) {
      RunRecorder::on_output(text);
    }
    if (echoes_) {
      std::fwrite(text.data(), 1, text.size(), stdout);
    }
  }
  void on_stop(const runtime::StopEvent& event) override {
    if (keeps_) {
      RunRecorder::on_stop(event);
    }
  }

 private:
  using Keep = report::RecordWhat::Keep;
  bool echoes_;
  bool keeps_;
};

Result<const fanuc::Profile*, Refusal> chosen_profile(const RunOptions& options,
                                                      const setup::Job& job) {
  const std::string name = !options.control.empty()       ? options.control
                           : !job.control.profile.empty() ? job.control.profile
                                                          : std::string(kDefaultControl);
  const auto profile = profile_named(name);
  if (!profile) {
    return refusal(ExitCode::Setup, profile.error());
  }
  return profile.value();
}

/// `--set` after the variables file, the sheets' [variables] between them.
std::optional<Refusal> take_variables(const RunOptions& options, setup::Job& job) {
  auto& variables = job.control.variables;
  Disk disk;
  if (!job.control.variables_file.empty()) {
    if (const auto text = disk.read(job.control.variables_file)) {
      auto kept = parse_variables_text(*text);
      if (!kept) {
        return refusal(ExitCode::BadUsage,
                       fmt::format("{}: {}", job.control.variables_file, kept.error()));
      }
      auto merged = kept.value();
      for (const auto& [name, value] : variables) {
        merged[name] = value;
      }
      variables = std::move(merged);
    }
  }
  for (const std::string& text : options.assignments) {
    auto assignment = setup::parse_assignment(text);
    if (!assignment) {
      return refusal(ExitCode::BadUsage, fmt::format("--set {}: {}", text, assignment.error()));
    }
    variables[assignment.value().name] = assignment.value().value;
  }
  return std::nullopt;
}

Result<Prepared, Refusal> prepare(const RunOptions& options) {
  Prepared prepared;
  auto job = setup::read_job(options.setups);
  if (!job) {
    Refusal wrong;
    for (const setup::SetupError& error : job.error()) {
      wrong.text += setup::render(error);
      if (error.code == setup::code_of(setup::SetupErrorId::FileNotFound)) {
        wrong.code = ExitCode::Setup;
      }
    }
    return wrong;
  }
  prepared.job = job.value();
  const auto profile = chosen_profile(options, prepared.job);
  if (!profile) {
    return profile.error();
  }
  prepared.profile = profile.value();
  if (auto wrong = take_variables(options, prepared.job)) {
    return *wrong;
  }
  for (const std::string& list : options.prints) {
    auto names = setup::parse_name_list(list);
    if (!names) {
      return refusal(ExitCode::BadUsage, fmt::format("--print {}: {}", list, names.error()));
    }
    prepared.prints.insert(prepared.prints.end(), names.value().begin(), names.value().end());
  }
  return prepared;
}

std::optional<Refusal> fill_library(fanuc::ProgramLibrary& library, const RunOptions& options) {
  for (const std::string& program : options.programs) {
    if (library.add_file(program) == fanuc::ProgramLibrary::Added::Unreadable) {
      return refusal(ExitCode::BadUsage, fmt::format("cannot read the program {}", program));
    }
  }
  library.add_folder(std::filesystem::path(options.programs.front()).parent_path().string());
  for (const std::string& folder : options.libraries) {
    std::error_code unreadable;
    if (!std::filesystem::is_directory(folder, unreadable)) {
      return refusal(ExitCode::BadUsage, fmt::format("--lib {}: no such folder", folder));
    }
    library.add_folder(folder);
  }
  if (const auto shipped = shipped_folder("macros/fanuc")) {
    library.add_folder(*shipped);
  }
  return std::nullopt;
}

ExitCode exit_code_of(const runtime::Outcome& outcome) {
  switch (outcome.status) {
    case runtime::Status::Completed: {
      const bool findings =
          std::ranges::any_of(outcome.diagnostics, [](const source::Diagnostic& diagnostic) {
            return diagnostic.severity != source::Severity::Note;
          });
      return findings ? ExitCode::Findings : ExitCode::Completed;
    }
    case runtime::Status::Alarm:
      return ExitCode::Alarm;
    case runtime::Status::Collision:
      return ExitCode::Collision;
    case runtime::Status::Setup:
      return ExitCode::Setup;
    case runtime::Status::Budget:
      return ExitCode::Budget;
    case runtime::Status::SyntaxError:
      return ExitCode::BadUsage;
  }
  contract_violated("every status has an exit code", __FILE__, __LINE__);
}

/// Variables asked for by --print, with a refusal for names the control does not have.
Result<std::vector<std::pair<std::string, runtime::Cell>>, Refusal> read_prints(
    fanuc::Session& session, const std::vector<std::string>& names) {
  std::vector<std::pair<std::string, runtime::Cell>> values;
  for (const std::string& name : names) {
    const auto value = session.variable(name);
    if (!value) {
      return refusal(ExitCode::BadUsage, fmt::format("--print: {}", value.error()));
    }
    values.emplace_back(name, value.value());
  }
  return values;
}

ExitCode refuse(const Refusal& wrong) {
  std::fputs(wrong.text.c_str(), stderr);
  return wrong.code;
}

/// Where the result goes: the document, or the variables asked for as lines.
std::optional<Refusal> deliver(const RunOptions& options, const report::RunResult& result,
                               const report::RunRecorder& recorder) {
  std::string text;
  if (options.json == "-") {
    text = run_document(result, recorder);
  } else {
    for (const auto& [name, value] : result.variables) {
      text += fmt::format("{} = {}\n", name,
                          value.is_vacant() ? "null" : fmt::format("{}", value.raw()));
    }
  }
  std::fwrite(text.data(), 1, text.size(), stdout);
  if (std::fflush(stdout) != 0 || std::ferror(stdout) != 0) {
    return refusal(ExitCode::BadUsage,
                   fmt::format("cannot write standard output: {}", std::strerror(errno)));
  }
  if (options.json.empty() || options.json == "-") {
    return std::nullopt;
  }
  const auto problem = write_whole_file(options.json, run_document(result, recorder));
  return problem ? std::optional(refusal(ExitCode::BadUsage, *problem)) : std::nullopt;
}

}  // namespace

ExitCode run_command(const RunOptions& options) {
  auto prepared = prepare(options);
  if (!prepared) {
    return refuse(prepared.error());
  }
  const setup::Job& job = prepared.value().job;
  Disk disk;
  fanuc::ProgramLibrary library(disk);
  if (const auto wrong = fill_library(library, options)) {
    return refuse(*wrong);
  }
  const auto scene = build_scene(job, options.seed);
  if (!scene) {
    return refuse({ExitCode::Setup, setup::render(scene.error())});
  }
  EchoingRecorder recorder(options);
  machine::MachiningCentre& machine = *scene.value().machine;
  fanuc::Session session(*prepared.value().profile, library, machine, recorder);
  if (const auto refused = session.configure(job.control); !refused.empty()) {
    return refuse(refusal(ExitCode::Setup, fmt::format("{}", fmt::join(refused, "; "))));
  }
  report::RunResult result;
  result.outcome = session.run(options.budget);
  for (const source::Diagnostic& diagnostic : result.outcome.diagnostics) {
    std::fputs(render_text(diagnostic).c_str(), stderr);
  }
  if (result.outcome.status == runtime::Status::SyntaxError && !result.outcome.alarm) {
    return ExitCode::BadUsage;
  }
  const auto values = read_prints(session, prepared.value().prints);
  if (!values) {
    return refuse(values.error());
  }
  result.program = options.programs.front();
  result.control = prepared.value().profile->name;
  result.seed = options.seed;
  result.variables = values.value();
  result.machine_time_s = machine.time_s();
  if (const auto wrong = deliver(options, result, recorder)) {
    return refuse(*wrong);
  }
  if (!job.control.variables_file.empty()) {
    if (const auto problem = write_whole_file(job.control.variables_file,
                                              variables_text(session.permanent_variables()))) {
      return refuse(refusal(ExitCode::BadUsage, *problem));
    }
  }
  return exit_code_of(result.outcome);
}

}  // namespace g31::cli

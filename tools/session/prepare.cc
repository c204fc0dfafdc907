#include "tools/session/prepare.h"

#include <algorithm>
#include <cstddef>
#include <filesystem>
#include <map>
#include <utility>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "tools/disk/part_file.h"
#include "tools/disk/shipped.h"
#include "tools/disk/waiting.h"
#include "tools/session/variables_file.h"
#include "tools/setup/assignment.h"
#include "tools/setup/toml_reader.h"

namespace g31::session {

Result<std::optional<Control>, Refusal> named_control(const std::string& name,
                                                      const setup::Job& job) {
  const std::string& of_sheets = job.control.profile;
  if (name.empty() && of_sheets.empty()) {
    return std::optional<Control>();
  }
  const auto control = control_named(name.empty() ? of_sheets : name);
  if (control) {
    return std::optional(control.value());
  }
  if (!name.empty()) {
    return bad_setup(control.error());
  }
  const auto place = job.places.find("control.profile");
  G31_EXPECTS(place != job.places.end());
  return Refusal{Ending::Setup,
                 {},
                 {error_at(place->second, setup::SetupErrorId::UnknownControl, {control.error()})}};
}

Result<Control, Refusal> chosen_control(const Request& request, const setup::Job& job,
                                        source::FileSystem& files) {
  const auto named = named_control(request.control, job);
  if (!named) {
    return named.error();
  }
  if (named.value()) {
    return *named.value();
  }
  if (request.programs.empty()) {
    return default_control();
  }
  const auto beginning = files.read_part(request.programs.front(), 0, kProgramBeginning);
  return control_of_program(request.programs.front(), beginning.value_or(""));
}

/// Puts what the control has kept under the sheets' [variables].
std::optional<Refusal> take_kept_variables(source::FileSystem& files, setup::Job& job) {
  const std::string& path = job.control.variables_file;
  const auto text = path.empty() ? std::nullopt : files.read(path);
  if (!text) {
    std::error_code unknown;
    const bool is_there = !path.empty() && std::filesystem::exists(path, unknown);
    return is_there || disk::given_up_input() ? std::optional(unreadable("variables file", path))
                                              : std::nullopt;
  }
  const auto kept = parse_variables_text(path, *text);
  if (!kept) {
    return refusal_of(kept.error());
  }
  std::map<std::string, std::optional<double>> variables;
  std::map<std::string, source::ShownPlace> places;
  for (const KeptVariable& variable : kept.value()) {
    variables[variable.assignment.name] = variable.assignment.value;
    places["variables." + variable.assignment.name] = variable.place;
  }
  for (const auto& [name, value] : variables) {
    if (job.control.variables.emplace(name, value).second) {
      job.control.kept_variables.insert(name);
    }
  }
  job.places.merge(places);
  return std::nullopt;
}

std::optional<Refusal> take_variables(const std::vector<std::string>& assignments,
                                      source::FileSystem& files, setup::Job& job) {
  if (auto wrong = take_kept_variables(files, job)) {
    return wrong;
  }
  for (const std::string& text : assignments) {
    auto assignment = setup::parse_assignment(text);
    if (!assignment) {
      return bad_input(fmt::format("--set {}: {}", text, assignment.error()));
    }
    const std::string& name = assignment.value().name;
    job.control.variables[name] = assignment.value().value;
    job.control.kept_variables.erase(name);
    job.places["variables." + name] = {"--set " + text, 0, 0, {}};
  }
  return std::nullopt;
}

namespace {

/// @param why  in the system's words
Refusal not_savable(const std::string& path, const std::string& why) {
  return bad_input(
      fmt::format("{}: the run could not save its variables here ({}): there must be a folder "
                  "that can be written: make it so, or name a variables_file in another one",
                  path, why));
}

/// What lock_variables() says of a file that cannot be saved, without keeping it.
std::optional<Refusal> why_not_saved(const std::string& path) {
  const auto why = path.empty() ? std::nullopt : disk::why_not_begun(path);
  return why ? std::optional(not_savable(path, *why)) : std::nullopt;
}

/// Keeps the variables file for the run, or says why it does not.
std::optional<Refusal> lock_variables(Prepared& prepared) {
  constexpr double kPatienceS = 10.0;
  const std::string& path = prepared.job.control.variables_file;
  if (path.empty()) {
    return std::nullopt;
  }
  const auto lock = disk::FileLock::take(path, kPatienceS);
  if (lock) {
    prepared.lock = lock.value();
    return std::nullopt;
  }
  if (lock.error().kind == disk::LockRefusal::Kind::Held) {
    return bad_input(
        fmt::format("{}: another run has kept its variables here for {} s ({}): wait for it, or "
                    "give each run a variables_file of its own",
                    path, kPatienceS, lock.error().why));
  }
  if (lock.error().kind == disk::LockRefusal::Kind::Foreign) {
    return bad_input(
        fmt::format("{}: while a run keeps its variables there, {} says so, and that is a file of "
                    "yours: rename one of them",
                    path, lock.error().why));
  }
  if (lock.error().kind == disk::LockRefusal::Kind::Unwritable) {
    return not_savable(path, lock.error().why);
  }
  prepared.note = fmt::format(
      "{}: cannot be locked here ({}): of two runs at a time one would lose what the other saves",
      path, lock.error().why);
  return std::nullopt;
}

}  // namespace

std::optional<Refusal> asks_twice_for_standard_input(
    std::initializer_list<std::span<const std::string>> inputs) {
  std::ptrdiff_t times = 0;
  for (const auto& names : inputs) {
    times += std::ranges::count(names, "-");
  }
  if (times < 2) {
    return std::nullopt;
  }
  return bad_input(fmt::format("- is standard input, which can be one file; here it is {}", times));
}

Result<Prepared, Refusal> prepare(const Request& request, source::FileSystem& files,
                                  VariablesFile variables) {
  if (auto wrong = asks_twice_for_standard_input({request.programs, request.setups})) {
    return *wrong;
  }
  const auto job =
      setup::read_job(request.setups, disk::shipped_folder("machine/library").value_or(""));
  if (!job) {
    return refusal_of(job.error());
  }
  const auto control = chosen_control(request, job.value(), files);
  if (!control) {
    return control.error();
  }
  Prepared prepared{job.value(), control.value(), nullptr, {}};
  if (auto wrong = variables == VariablesFile::IsSaved ? lock_variables(prepared) : std::nullopt) {
    return *wrong;
  }
  if (auto wrong = variables == VariablesFile::WouldBeSaved
                       ? why_not_saved(prepared.job.control.variables_file)
                       : std::nullopt) {
    return *wrong;
  }
  if (auto wrong = take_variables(request.assignments, files, prepared.job)) {
    return *wrong;
  }
  return prepared;
}

}  // namespace g31::session

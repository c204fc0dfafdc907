#include "tools/session/prepare.h"

#include <utility>

#include <fmt/format.h>

#include "tools/disk/shipped.h"
#include "tools/session/variables_file.h"
#include "tools/setup/assignment.h"
#include "tools/setup/toml_reader.h"

namespace g31::session {

Result<Control, Refusal> chosen_control(const Request& request, const setup::Job& job,
                                        source::FileSystem& files) {
  const std::string& name = !request.control.empty() ? request.control : job.control.profile;
  if (!name.empty()) {
    const auto control = control_named(name);
    return control ? Result<Control, Refusal>(control.value()) : bad_setup(control.error());
  }
  if (request.programs.empty()) {
    return default_control();
  }
  constexpr std::size_t kBeginning = 64;  // bytes: a header stands first
  const auto beginning = files.read_part(request.programs.front(), 0, kBeginning);
  return control_of_program(request.programs.front(), beginning.value_or(""));
}

std::optional<Refusal> take_variables(const std::vector<std::string>& assignments,
                                      source::FileSystem& files, setup::Job& job) {
  auto& variables = job.control.variables;
  if (!job.control.variables_file.empty()) {
    if (const auto text = files.read(job.control.variables_file)) {
      auto kept = parse_variables_text(*text);
      if (!kept) {
        return bad_input(fmt::format("{}: {}", job.control.variables_file, kept.error()));
      }
      auto merged = kept.value();
      for (const auto& [name, value] : variables) {
        merged[name] = value;
      }
      variables = std::move(merged);
    }
  }
  for (const std::string& text : assignments) {
    auto assignment = setup::parse_assignment(text);
    if (!assignment) {
      return bad_input(fmt::format("--set {}: {}", text, assignment.error()));
    }
    variables[assignment.value().name] = assignment.value().value;
  }
  return std::nullopt;
}

Result<Prepared, Refusal> prepare(const Request& request, source::FileSystem& files) {
  const auto job =
      setup::read_job(request.setups, disk::shipped_folder("machine/library").value_or(""));
  if (!job) {
    return refusal_of(job.error());
  }
  const auto control = chosen_control(request, job.value(), files);
  if (!control) {
    return control.error();
  }
  Prepared prepared{job.value(), control.value()};
  if (auto wrong = take_variables(request.assignments, files, prepared.job)) {
    return *wrong;
  }
  return prepared;
}

}  // namespace g31::session

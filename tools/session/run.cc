#include "tools/session/run.h"

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "tools/disk/disk.h"
#include "tools/session/variables_file.h"

namespace g31::session {
namespace {

/// Of the folder of the program's files.
Refusal unreadable_folder(const setup::Job& job, const std::string& why) {
  const auto place = job.places.find("control.files");
  G31_EXPECTS(place != job.places.end());
  return {Ending::BadInput,
          {},
          {error_at(place->second, setup::SetupErrorId::FolderUnreadable,
                    {"control.files", job.control.files_folder, why},
                    "expected a folder that is there; paths start at the folder of the sheet")}};
}

}  // namespace

Result<std::shared_ptr<Run>, Refusal> Run::open(const setup::Job& job, Programs& programs,
                                                machine::MachinePort& machine,
                                                runtime::Observer& observer) {
  auto session = programs.session(machine, observer);
  const auto refused = session->configure(job.control);
  if (!refused.empty()) {
    return refused_settings(job, refused);
  }
  auto files = ProgramFiles::open(job.control.files_folder);
  if (!files) {
    return unreadable_folder(job, files.error());
  }
  session->give_files(files.value().at_start());
  return std::shared_ptr<Run>(new Run(job, std::move(session), files.value()));
}

std::optional<std::string> Run::wrong_name(const std::vector<std::string>& names) {
  for (const std::string& name : names) {
    if (auto wrong = session_->wrong_name(name)) {
      return wrong;
    }
  }
  return std::nullopt;
}

Run::Values Run::values(const std::vector<std::string>& names) {
  Values found;
  for (const std::string& name : names) {
    const auto value = session_->variable(name);
    found.values.emplace_back(name, value ? value.value() : runtime::ShownValue());
    if (!value && !found.wrong) {
      found.wrong = value.error();
    }
  }
  return found;
}

std::optional<Refusal> Run::keep_state() const {
  auto problem = files_.save(session_->files());
  const std::string& path = job_.control.variables_file;
  if (!problem && !path.empty()) {
    problem = disk::write_whole_file(path, variables_text(session_->permanent_variables()));
  }
  return problem ? std::optional(bad_input(*problem)) : std::nullopt;
}

}  // namespace g31::session

#pragma once

#include <memory>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/runtime/inspection.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/runtime/shown_value.h"
#include "machine/base/result.h"
#include "machine/port/machine_port.h"
#include "tools/session/program_files.h"
#include "tools/session/programs.h"
#include "tools/session/refusal.h"
#include "tools/session/session.h"
#include "tools/setup/job.h"

namespace g31::session {

/// One run of a job: a control set up with its programs and files, over a machine.  What it was is
/// a function of the job and the seed of the machine's surroundings alone.
class Run {
 public:
  /// Sets the control up.  All four outlive the run.
  /// @param machine  that of a World, or what stands between it and the program
  static Result<std::shared_ptr<Run>, Refusal> open(const setup::Job& job, Programs& programs,
                                                    machine::MachinePort& machine,
                                                    runtime::Observer& observer);

  [[nodiscard]] Session& session() { return *session_; }

  /// What is wrong with the first of these names that the control does not have.
  [[nodiscard]] std::optional<std::string> wrong_name(const std::vector<std::string>& names);

  /// Values by name, in the order asked for.
  struct Values {
    runtime::NamedValues values;       ///< vacant where one cannot be read
    std::optional<std::string> wrong;  ///< why the first of those cannot
  };
  [[nodiscard]] Values values(const std::vector<std::string>& names);

  /// What the program made or changed, by name; the texts live as long as the run.
  [[nodiscard]] ProgramFiles::Changes changed_files() const {
    return files_.changed(session_->files());
  }

  /// What keep_state() writes or removes of the program's files.
  [[nodiscard]] std::vector<std::string> kept_files() const {
    return files_.paths(session_->files());
  }

  /// Saves the program's files in their folder, and what the control keeps over power off in the
  /// variables file, where the job names them.
  [[nodiscard]] std::optional<Refusal> keep_state() const;

 private:
  Run(const setup::Job& job, std::unique_ptr<Session> session, ProgramFiles files)
      : job_(job), session_(std::move(session)), files_(std::move(files)) {}

  const setup::Job& job_;
  std::unique_ptr<Session> session_;
  ProgramFiles files_;
};

}  // namespace g31::session

#pragma once

#include <memory>
#include <string>
#include <vector>

#include "interpreter/runtime/control_setup.h"
#include "interpreter/runtime/observer.h"
#include "interpreter/source/file_system.h"
#include "interpreter/source/source_map.h"
#include "machine/base/result.h"
#include "machine/port/machine_port.h"
#include "tools/session/control.h"
#include "tools/session/refusal.h"
#include "tools/session/session.h"

namespace g31::session {

/// Where programs come from.
struct ProgramPaths {
  std::vector<std::string> programs;        ///< at least the main one; all are looked up first
  std::vector<std::string> libraries = {};  ///< folders of subprograms
};

/// The programs that a run on one control can call: the files, the folder of the first one, the
/// libraries and the programs shipped with g31, in this order.  Read and compiled when they are
/// first called, for all sessions.  Any number of threads may make and use sessions at a time.
class Programs {
 public:
  /// @param files  outlives the programs
  explicit Programs(source::FileSystem& files) : sources_(files) {}
  Programs(const Programs&) = delete;
  Programs& operator=(const Programs&) = delete;
  virtual ~Programs() = default;

  /// A control as after power on.  Programs, machine and observer must outlive it.
  virtual std::unique_ptr<Session> session(machine::MachinePort& machine,
                                           runtime::Observer& observer) = 0;

  /// Shows the places of all their sessions; those in texts that a session made, as long as it
  /// lives.
  [[nodiscard]] const source::SourceMap& sources() const { return sources_; }

 protected:
  source::SourceMap& own_sources() { return sources_; }

 private:
  source::SourceMap sources_;
};

/// @param files  must outlive the programs
/// @param setup  whose data programs may name
/// @returns what cannot be read
Result<std::shared_ptr<Programs>, Refusal> open_programs(const Control& control,
                                                         const ProgramPaths& paths,
                                                         source::FileSystem& files,
                                                         const runtime::ControlSetup& setup = {});

}  // namespace g31::session

#pragma once

#include <cstdint>
#include <initializer_list>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/source/file_system.h"
#include "machine/base/result.h"
#include "tools/disk/file_lock.h"
#include "tools/session/control.h"
#include "tools/session/programs.h"
#include "tools/session/refusal.h"
#include "tools/setup/job.h"

namespace g31::session {

/// What is to be run, as a command line, a test file or a debugger says it.
struct Request : ProgramPaths {
  std::vector<std::string> setups;       ///< sheets; later ones win key by key
  std::string control;                   ///< a name; empty: as the sheets or the program say
  std::vector<std::string> assignments;  ///< "#500=1.5": variables before the start
  std::uint64_t seed = 0;                ///< of every random model
};

/// Everything that a request and its sheets say, read and checked before anything runs.
struct Prepared {
  setup::Job job;  ///< its variables with those of the variables file and the assignments
  Control control;
  /// Of the variables file; to be held until the run has saved it.  Null: nobody will.
  std::shared_ptr<disk::FileLock> lock;
  std::string note;  ///< what is to be told beside the run; "" for nothing
};

/// What becomes of the variables file.
enum class VariablesFile {
  IsRead,
  WouldBeSaved,  ///< it is read; a run that could not save it is refused all the same
  IsSaved        ///< no other run that saves it may read it meanwhile
};

/// @param files  the program and the variables file; sheets come from the disk
/// @returns also a refusal where another run holds the variables file for too long
Result<Prepared, Refusal> prepare(const Request& request, source::FileSystem& files,
                                  VariablesFile variables = VariablesFile::IsRead);

/// Standard input brings one text: whoever else wants one of it would get nothing.
std::optional<Refusal> asks_twice_for_standard_input(
    std::initializer_list<std::span<const std::string>> inputs);

/// @param name  of the command line; empty: as the sheets say
/// @return nullopt: they do not say
Result<std::optional<Control>, Refusal> named_control(const std::string& name,
                                                      const setup::Job& job);

/// The control by the request, the sheets, the program's file ending or its text, in this order.
Result<Control, Refusal> chosen_control(const Request& request, const setup::Job& job,
                                        source::FileSystem& files);

/// Puts the variables file under the sheets' [variables], and assignments over them.
std::optional<Refusal> take_variables(const std::vector<std::string>& assignments,
                                      source::FileSystem& files, setup::Job& job);

}  // namespace g31::session

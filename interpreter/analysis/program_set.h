#pragma once

#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/analysis/flow.h"
#include "interpreter/dialects/fanuc/vocabulary/profile.h"
#include "interpreter/runtime/control_setup.h"
#include "interpreter/source/source_map.h"

namespace g31::analysis {

/// Programs of one control that may call each other, read and compiled but never run.  Looked up
/// are those of the files, then those of the folders, each in the order added.
class ProgramSet {
 public:
  ProgramSet() = default;
  ProgramSet(const ProgramSet&) = delete;
  ProgramSet& operator=(const ProgramSet&) = delete;
  virtual ~ProgramSet() = default;

  /// Files and folders are added anew from here on.  What was read of files may be kept: they are
  /// taken not to change.
  virtual void start_over() = 0;
  /// @returns whether the file could be read
  virtual bool add_file(const std::string& path) = 0;
  virtual void add_folder(const std::string& folder) = 0;
  /// The same of what comes with g31, behind all others.
  virtual void add_shipped_folder(const std::string& folder) = 0;
  /// Files that lie elsewhere and whose definitions hold for these programs, too: of names that
  /// there are none of yet, and before those that come with the control.
  virtual void add_definitions(std::span<const std::string> /*files*/) {}

  /// The text of a file that was added.
  virtual const source::SourceFile& text(const std::string& path) = 0;
  /// Why no program of a file that was added can run here at all; nullopt: nothing is against it.
  virtual std::optional<Finding> refusal(const std::string& /*path*/) { return std::nullopt; }
  /// All programs of a file that was added, in its order; behind the last file and folder.
  virtual std::vector<Flow> flows(const std::string& path) = 0;
  /// Programs of a file that was added which no call finds: one of their name stands before them.
  virtual std::vector<Finding> hidden_programs(const std::string& /*path*/) { return {}; }
  /// What is doubtful in a file that was added, whichever of its programs it stands in.
  virtual std::vector<Finding> doubts_of_text(const std::string& /*path*/) { return {}; }
  /// What every run begins with, wherever it stands; behind the last file and folder.
  virtual std::vector<Flow> definitions() { return {}; }
  /// Why a call of one of the flows cannot find its program; nullopt: it can, or only a run knows.
  virtual std::optional<Fault> missing_program(const Flow& caller, const Call& call) = 0;
  /// Whether the program of a call goes back behind it whatever it does: it cannot end the run.
  virtual bool returns_for_certain(const Call& /*call*/) { return false; }
  /// What is wrong with the arguments of a call that finds its program; nullopt: nothing, or only a
  /// run knows.
  virtual std::optional<Fault> wrong_arguments(const Flow& /*caller*/, const Call& /*call*/) {
    return std::nullopt;
  }
};

/// @param profile, sources  outlive the programs
/// @param setup             which codes call macros
std::unique_ptr<ProgramSet> fanuc_programs(const fanuc::Profile& profile,
                                           source::SourceMap& sources,
                                           const runtime::ControlSetup& setup = {});

/// Definition files that are added define names for all of them.
/// @param sources  outlives the programs
/// @param setup    whose data programs may name
std::unique_ptr<ProgramSet> sinumerik_programs(source::SourceMap& sources,
                                               const runtime::ControlSetup& setup = {});

}  // namespace g31::analysis

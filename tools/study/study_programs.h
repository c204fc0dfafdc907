#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/disk/disk.h"
#include "tools/disk/remembering_disk.h"
#include "tools/session/control.h"
#include "tools/session/ending.h"
#include "tools/session/heard.h"
#include "tools/session/prepare.h"
#include "tools/session/programs.h"
#include "tools/session/refusal.h"
#include "tools/session/session.h"
#include "tools/study/path_recorder.h"
#include "tools/study/study.h"
#include "tools/study/study_parts.h"

namespace g31::study {

/// How a program of a study ended.
struct EndedProgram {
  std::string status = "completed";
  session::Ending ending = session::Ending::Completed;
  std::string note;                              ///< its first finding, or why it did not complete
  std::vector<std::optional<double>> variables;  ///< of the study's results; of the main program
  std::map<std::string, double> permanent;       ///< of a program before the main one
  std::optional<evaluate::Evaluation> evaluation = {};  ///< of the main program
};

/// A program that could not even begin.
EndedProgram not_begun(const session::Refusal& refusal);

/// The programs of a study, read once: those of `before`, then the main one.
class StudyPrograms {
 public:
  /// @param study  outlives this
  explicit StudyPrograms(const Study& study);

  /// Chooses the control and reads all programs.
  std::optional<session::Refusal> open(const setup::Job& job);
  /// nullopt: the control takes the set-up, and has what the study's results read.
  std::optional<session::Refusal> why_not(const setup::Job& job);

  /// Programs of `before` have the numbers below it.
  [[nodiscard]] std::size_t main() const { return paths_.size() - 1; }
  [[nodiscard]] const std::vector<std::string>& paths() const { return paths_; }
  /// What has been read for them so far, with the programs that they called.
  [[nodiscard]] std::vector<std::string> read_files() const { return disk_.paths(); }
  [[nodiscard]] const session::Control& control() const { return *control_; }
  /// The lines of a message about a part.
  [[nodiscard]] std::string rendered(const source::Diagnostic& finding) const;

  /// Runs a program; a defect fails this run alone.  Many threads may call at once.
  EndedProgram run(const setup::Job& job, const Result<StudyParts, session::Refusal>& parts,
                   std::size_t program, std::uint64_t seed);

  /// The results of the study; nullopt where a run has none.
  [[nodiscard]] std::vector<std::optional<double>> results_of(const EndedProgram& ended) const;

 private:
  EndedProgram carry_out(const setup::Job& job, const StudyParts& parts, std::size_t program,
                         std::uint64_t seed);
  [[nodiscard]] session::Request request_of(std::size_t program) const;
  void take_results(session::Session& control, const std::optional<PathRecorder>& path,
                    EndedProgram& ended) const;

  const Study& study_;
  disk::Disk real_disk_;
  disk::RememberingDisk disk_{real_disk_};
  std::vector<std::string> paths_;
  std::vector<std::string> variables_;  ///< that results read
  std::optional<session::Control> control_;
  std::optional<session::ProgramComments> comments_;          ///< of all programs, each read once
  std::vector<std::shared_ptr<session::Programs>> programs_;  ///< one for each of paths_
};

}  // namespace g31::study

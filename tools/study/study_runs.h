#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/session/ending.h"
#include "tools/session/refusal.h"
#include "tools/study/grid.h"
#include "tools/study/record.h"
#include "tools/study/study.h"
#include "tools/study/study_jobs.h"
#include "tools/study/study_parts.h"
#include "tools/study/study_programs.h"

namespace g31::study {

/// A run of a study, and what it came to.
struct StudyRun {
  Row row;  ///< without its exit code
  session::Ending ending = session::Ending::Completed;
  std::optional<evaluate::Evaluation> evaluation = {};  ///< of its path, where one is wanted
};

/// Does the runs of a study.  Sheets and programs are read once; parts and their trees are made
/// once for each set-up that needs others, and shared, read-only, by all threads.
class StudyRuns {
 public:
  /// Reads all sheets and programs and tries every listed value, so that what is wrong with them is
  /// said before anything runs.
  /// @param study  outlives what is created
  static Result<std::unique_ptr<StudyRuns>, session::Refusal> create(const Study& study);
  StudyRuns(const StudyRuns&) = delete;
  StudyRuns& operator=(const StudyRuns&) = delete;
  ~StudyRuns();

  [[nodiscard]] const Description& description() const { return description_; }

  /// Files that programs and sheets are read from, or that the sheets name.
  [[nodiscard]] std::vector<std::string> files() const;
  /// Files of programs that the runs have read so far, with those that they called.
  [[nodiscard]] std::vector<std::string> read_files() const { return programs_.read_files(); }

  /// What is wrong with the meshes of the sheets' own parts, as lines for people; it makes findings
  /// of all runs.
  [[nodiscard]] const std::string& part_findings() const { return part_findings_; }

  /// One run, by its number in the whole study.  Many threads may call at once.
  StudyRun run(std::size_t run);

 private:
  struct Geometry;
  struct Point;
  using Refusal = session::Refusal;
  using Parts = Result<StudyParts, Refusal>;

  StudyRuns(const Study& study, StudyJobs jobs);
  std::optional<Refusal> try_control(const setup::Job& first);
  void make_points(const setup::Job& first);
  void describe();
  [[nodiscard]] std::string inputs();

  void make_ready(std::size_t number);
  void let_go(std::size_t number);
  EndedProgram run_drawn(std::size_t number, const Row& row);
  EndedProgram run_all_programs(setup::Job job, const Parts& parts, const Row& row);
  /// What the programs of `before` leave goes into `job`.  @returns how one ended that did not
  /// complete
  std::optional<EndedProgram> run_before(setup::Job& job, const Parts& parts, SeedUse use,
                                         std::size_t event);

  const Study& study_;
  StudyJobs jobs_;
  StudyPrograms programs_;
  Description description_;
  std::vector<std::unique_ptr<Point>> points_;
  std::vector<std::unique_ptr<Geometry>> geometries_;  ///< one for all points, or one for each
  bool draws_geometry_ = false;
  std::string part_findings_;
};

}  // namespace g31::study

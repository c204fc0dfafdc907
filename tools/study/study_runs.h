#pragma once

#include <cstddef>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/disk/disk.h"
#include "tools/session/control.h"
#include "tools/session/ending.h"
#include "tools/session/heard.h"
#include "tools/session/prepare.h"
#include "tools/session/programs.h"
#include "tools/session/refusal.h"
#include "tools/session/session.h"
#include "tools/session/world.h"
#include "tools/setup/sheet_stack.h"
#include "tools/study/grid.h"
#include "tools/study/path_recorder.h"
#include "tools/study/record.h"
#include "tools/study/study.h"

namespace g31::study {

/// A run of a study, and what it came to.
struct StudyRun {
  Row row;  ///< without its exit code
  session::Ending ending = session::Ending::Completed;
  std::optional<evaluate::Evaluation> evaluation = {};  ///< of its path, where one is wanted
};

/// The parts of a set-up, and what is wrong with their meshes.
struct StudyParts {
  session::SensedParts sensed;
  std::vector<source::Diagnostic> findings;
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

  /// What is wrong with the meshes of the sheets' own parts, as lines for people; it makes findings
  /// of all runs.
  [[nodiscard]] const std::string& part_findings() const { return part_findings_; }

  /// One run, by its number in the whole study.  Many threads may call at once.
  StudyRun run(std::size_t run);

 private:
  struct Geometry;
  struct Point;
  struct Ended;
  using Refusal = session::Refusal;
  using Parts = Result<StudyParts, Refusal>;

  explicit StudyRuns(const Study& study);
  std::optional<Refusal> read_sheets();
  std::optional<Refusal> try_listed_values();
  std::optional<Refusal> try_control();
  void make_points();
  void describe();
  [[nodiscard]] std::string inputs();

  /// @param drawn  values of the study's drawn axes; empty: the sheets' own
  Result<setup::Job, Refusal> job_of(std::size_t point, const std::vector<double>& drawn);
  [[nodiscard]] const setup::SheetStack& stack_of(std::size_t point) const;
  [[nodiscard]] session::Request request_of(std::size_t program) const;
  void make_ready(std::size_t number);
  void let_go(std::size_t number);
  Ended run_drawn(std::size_t number, const Row& row);
  Ended run_all_programs(setup::Job job, const Parts& parts, const Row& row);
  /// What the programs of `before` leave goes into `job`.  @returns how one ended that did not
  /// complete
  std::optional<Ended> run_before(setup::Job& job, const Parts& parts, SeedUse use,
                                  std::size_t event);
  /// @param program  of `before`, or the number of those for the main program
  Ended run_program(const setup::Job& job, const Parts& parts, std::size_t program,
                    std::uint64_t seed);
  Ended carry_out(const setup::Job& job, const Parts& parts, std::size_t program,
                  std::uint64_t seed);
  static void take_evaluation(const PathRecorder& path, Ended& ended);
  [[nodiscard]] std::vector<std::optional<double>> results_of(const Ended& ended) const;

  const Study& study_;
  disk::Disk disk_;
  Description description_;
  std::optional<session::Control> control_;
  std::optional<session::ProgramComments> comments_;  ///< of all programs, each read once
  std::vector<std::string> paths_;                    ///< programs of `before`, then the main one
  std::vector<std::shared_ptr<session::Programs>> programs_;  ///< one for each of paths_
  std::vector<std::string> variables_;                        ///< that results read
  std::vector<setup::SheetStack> stacks_;  ///< one for each combination of listed sheets
  std::vector<std::unique_ptr<Point>> points_;
  std::vector<std::unique_ptr<Geometry>> geometries_;  ///< one for all points, or one for each
  bool draws_geometry_ = false;
  std::string part_findings_;
};

}  // namespace g31::study

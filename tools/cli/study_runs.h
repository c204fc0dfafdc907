#pragma once

#include <cstddef>
#include <map>
#include <memory>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "machine/base/result.h"
#include "probe/sensor/touchable_parts.h"
#include "tools/cli/chosen_profile.h"
#include "tools/cli/control_session.h"
#include "tools/cli/run_preparation.h"
#include "tools/disk/disk.h"
#include "tools/setup/sheet_stack.h"
#include "tools/study/grid.h"
#include "tools/study/record.h"
#include "tools/study/study.h"

namespace g31::cli {

/// Does the runs of a study.  Sheets are read once; parts and their trees are made once for each
/// set-up that needs others, and shared, read-only, by all threads; programs of a Fanuc are read
/// once on each thread, those of a SINUMERIK for each run: what they define belongs to one session.
class StudyRuns {
 public:
  /// Reads all sheets and programs and tries every listed value, so that what is wrong with them is
  /// said before anything runs.
  /// @param study  outlives what is created
  static Result<std::unique_ptr<StudyRuns>, Refusal> create(const study::Study& study);
  StudyRuns(const StudyRuns&) = delete;
  StudyRuns& operator=(const StudyRuns&) = delete;
  ~StudyRuns();

  [[nodiscard]] const study::Description& description() const { return description_; }

  /// One run, by its number in the whole study.  Many threads may call at once.
  study::Row run(std::size_t run);

 private:
  struct Geometry;
  struct Point;
  struct Programs;
  struct Ended;
  using Parts = Result<std::shared_ptr<const probe::TouchableParts>, Refusal>;

  explicit StudyRuns(const study::Study& study);
  std::optional<Refusal> read_sheets();
  std::optional<Refusal> try_listed_values();
  std::optional<Refusal> try_control();
  void make_points();
  void describe();
  [[nodiscard]] std::string inputs() const;

  /// @param drawn  values of the study's drawn axes; empty: the sheets' own
  Result<setup::Job, Refusal> job_of(std::size_t point, const std::vector<double>& drawn) const;
  [[nodiscard]] const setup::SheetStack& stack_of(std::size_t point) const;
  [[nodiscard]] RunOptions options_of(std::size_t program) const;
  fanuc::ProgramLibrary& library_of(std::size_t program);
  Result<SessionPointer, Refusal> session_of(std::size_t program, machine::MachinePort& machine,
                                             runtime::Observer& observer);
  void make_ready(std::size_t number);
  void let_go(std::size_t number);
  Ended run_drawn(std::size_t number, const study::Row& row);
  Ended run_all_programs(setup::Job job, const Parts& parts, const study::Row& row);
  /// What the programs of `before` leave goes into `job`.  @returns how one ended that did not
  /// complete
  std::optional<Ended> run_before(setup::Job& job, const Parts& parts, study::SeedUse use,
                                  std::size_t event);
  /// @param program  of `before`, or the number of those for the main program
  Ended run_program(const setup::Job& job, const Parts& parts, std::size_t program,
                    std::uint64_t seed);
  [[nodiscard]] std::vector<std::optional<double>> results_of(const Ended& ended) const;

  const study::Study& study_;
  study::Description description_;
  std::optional<ChosenControl> control_;
  std::vector<std::string> programs_;      ///< those of `before`, then the main one
  std::vector<std::string> variables_;     ///< that results read
  std::vector<setup::SheetStack> stacks_;  ///< one for each combination of listed sheets
  std::vector<std::unique_ptr<Point>> points_;
  std::vector<std::unique_ptr<Geometry>> geometries_;  ///< one for all points, or one for each
  bool draws_geometry_ = false;
  disk::Disk disk_;
  std::mutex libraries_mutex_;
  std::map<std::thread::id, std::unique_ptr<Programs>> libraries_;
};

}  // namespace g31::cli

#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "tools/session/control.h"
#include "tools/session/refusal.h"
#include "tools/setup/sheet_stack.h"
#include "tools/study/study.h"

namespace g31::study {

/// The set-ups of a study: its sheets, read once, with the values of its axes put in.
class StudyJobs {
 public:
  /// Reads the sheets of all combinations of listed sheets.
  /// @param study  outlives what is read
  static Result<StudyJobs, session::Refusal> read(const Study& study);

  /// The set-up of a point of the grid.  Many threads may call at once.
  /// @param drawn  values of the study's drawn axes; empty: the sheets' own
  [[nodiscard]] Result<setup::Job, session::Refusal> at(std::size_t point,
                                                        const std::vector<double>& drawn) const;

  /// nullopt: every listed value, and what is drawn, has a place in the sheets.
  [[nodiscard]] std::optional<session::Refusal> why_not_all() const;

  /// Files that the sheets are read from, or that they name with any listed value.
  [[nodiscard]] std::vector<std::string> files() const;

  /// One for each combination of listed sheets.
  [[nodiscard]] const std::vector<setup::SheetStack>& stacks() const { return stacks_; }

 private:
  /// A point of the grid that is tried for its value of a list.
  struct TriedPoint {
    std::size_t point = 0;
    const ListedAxis* axis = nullptr;  ///< nullptr: it has the first value of every list
  };

  explicit StudyJobs(const Study& study) : study_(&study) {}
  /// Each value with the first ones of all other lists, so that a long grid is tried quickly.
  [[nodiscard]] std::vector<TriedPoint> tried_points() const;
  [[nodiscard]] const setup::SheetStack& stack_of(std::size_t point) const;
  /// That the runs of a job are on.
  [[nodiscard]] Result<session::Control, session::Refusal> control_of(const setup::Job& job) const;

  const Study* study_;
  std::vector<setup::SheetStack> stacks_;
};

}  // namespace g31::study

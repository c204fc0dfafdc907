#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <vector>

#include "probe/planning/inspection_plan.h"
#include "tools/plan/inspection_program.h"

namespace g31::plan {

/// A measure that is computed once its points are touched.
struct StepResult {
  std::size_t measure = 0;
  int variable = 0;  ///< gets it, counted from 0
  int first = 0;     ///< variables of its contacts
  int second = 0;
  /// Of the diameter of a round wall: the two contacts across, between which its middle is; else
  /// null.
  const probe::PlannedRound* round = nullptr;
  int first_across = 0;
  int second_across = 0;
};

/// One touch of a program, or the four of a round wall by a cycle, and what comes of it.
struct ProgramStep {
  std::size_t point = 0;
  std::size_t feature = 0;
  bool begins_feature = false;
  int contact = 0;                    ///< the variable that gets the coordinate of the contact
  Point direction_P = Point::Zero();  ///< that it is counted along
  std::vector<StepResult> results;
  const probe::PlannedRound* round = nullptr;  ///< of the plan: a cycle touches its points
  /// Then the variables of the contacts at -X, +X, -Y and +Y.
  std::array<int, 4> contacts = {};
};

/// So many variables a program has for contacts and results, in either language.
inline constexpr int kProgramVariables = 87;

struct ProgramSteps {
  std::vector<ProgramStep> steps;
  /// The variable of each measure; -1: it does not stay there.
  std::vector<int> variables;
};

/// The touches with their variables.  As long as there are enough of them, each
/// measure keeps its own.
/// @param plan  outlives the steps
ProgramSteps program_steps(const probe::InspectionPlan& plan);

/// "#110" or "R10" for the first.  Those in which O9010 leaves the row A9 are passed over.
std::string variable_name(ProgramLanguage language, int variable);

/// Names before printed values: those of the measures, as controls can print them, no two alike.
std::vector<std::string> printed_names(const probe::InspectionPlan& plan);

/// Digits of a printed value, as many as DPRNT has room for.
inline constexpr int kPrintedDigits = 8;

/// Decimals that leave a value within them.
int decimals_of(const probe::PlannedMeasure& measure);

/// A coordinate of a program: "-12.5", "40."; to 0.001 mm.
std::string coordinate(double mm);

/// A number that values depend on: "40.0000001"; of two summands where eight digits are too few.
std::string exact(double value);

/// What takes it away from what stands before it; "" for 0.
std::string less_exact(double value);

/// A length in a comment, to 0.00001 mm.
std::string nominal_text(double mm);

/// What takes a number away from what stands before it: "-45.", "+10.", "" for 0.
std::string less(const std::string& number);

/// The axis that a direction is parallel to; -1: none.
int axis_along(const Point& direction);

/// The angle of a direction in the plane as a number of degrees, to 1e-7.
std::string angle_text(const Point& direction);

/// 'X' for 0.
char axis_letter(int axis);

/// A program, and which of its touches count.
struct WrittenProgram {
  std::string text;
  std::size_t touches = 0;             ///< that come in a run
  std::vector<std::size_t> of_points;  ///< which of them each point's contact is of, from 0
};

WrittenProgram fanuc_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                             const ProgramOptions& options);
WrittenProgram sinumerik_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                                 const ProgramOptions& options);

}  // namespace g31::plan

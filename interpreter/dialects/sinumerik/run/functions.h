#pragma once

#include <string>

#include "interpreter/dialects/sinumerik/run/called_programs.h"
#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

namespace g31::sinumerik {

/// Calls the functions of functions.def that are more than mathematics.
class FunctionCaller {
 public:
  /// All must outlive the caller.
  FunctionCaller(Operands& operands, Channel& channel, CalledPrograms& programs,
                 const Globals& globals)
      : operands_(operands), channel_(channel), programs_(programs), globals_(globals) {}

  MaybeFailure call(const Op& op);

 private:
  // A function takes its arguments, and what else it looks at.
  MaybeFailure call(MaybeFailure (*function)(Operands&, const Op&, Arguments), const Op& op);
  MaybeFailure call(MaybeFailure (*function)(Channel&, Operands&, const Op&, Arguments),
                    const Op& op);
  MaybeFailure call(MaybeFailure (*function)(CalledPrograms&, Operands&, const Op&, Arguments),
                    const Op& op);
  MaybeFailure call(MaybeFailure (*function)(const Globals&, Operands&, const Op&, Arguments),
                    const Op& op);
  MaybeFailure call(MaybeFailure (*function)(const Globals&, CalledPrograms&, Operands&, const Op&,
                                             Arguments),
                    const Op& op);

  Operands& operands_;
  Channel& channel_;
  CalledPrograms& programs_;
  const Globals& globals_;
};

/// The column `work` of functions.def: each puts its result where `op` says.
namespace function {

/// Its name in the language.
std::string name_of(const Op& op);

// run_functions.cc
MaybeFailure bounded(Operands& at, const Op& op, Arguments list);
MaybeFailure is_geometry_axis(Operands& at, const Op& op, Arguments list);
MaybeFailure name_of_axis(Operands& at, const Op& op, Arguments list);
MaybeFailure modulo_place(Operands& at, const Op& op, Arguments list);
MaybeFailure formatted_text(Operands& at, const Op& op, Arguments list);
MaybeFailure number_of_text(Operands& at, const Op& op, Arguments list);
MaybeFailure shows_number(Operands& at, const Op& op, Arguments list);
MaybeFailure length_of_text(Operands& at, const Op& op, Arguments list);
MaybeFailure upper_case(Operands& at, const Op& op, Arguments list);
MaybeFailure lower_case(Operands& at, const Op& op, Arguments list);
MaybeFailure axis_of_name(const Globals& globals, Operands& at, const Op& op, Arguments list);
MaybeFailure knows_variable(const Globals& globals, Operands& at, const Op& op, Arguments list);
MaybeFailure knows_file(CalledPrograms& programs, Operands& at, const Op& op, Arguments list);
MaybeFailure part_of_text(Operands& at, const Op& op, Arguments list);
MaybeFailure first_place(Operands& at, const Op& op, Arguments list);
MaybeFailure last_place(Operands& at, const Op& op, Arguments list);
MaybeFailure first_of_set(Operands& at, const Op& op, Arguments list);
MaybeFailure place_of_part(Operands& at, const Op& op, Arguments list);
// run_frames.cc
MaybeFailure shift_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure fine_shift_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure scale_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure mirror_frame(Operands& at, const Op& op, Arguments list);
MaybeFailure turn_frame(Operands& at, const Op& op, Arguments list);
MaybeFailure solid_turn_frame(Operands& at, const Op& op, Arguments list);
MaybeFailure plane_turn_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure inverse_frame(Operands& at, const Op& op, Arguments list);
MaybeFailure add_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
// run_names.cc
MaybeFailure kind_of_name(const Globals& globals, CalledPrograms& programs, Operands& at,
                          const Op& op, Arguments list);
// run_tools.cc
MaybeFailure number_of_edge(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure named_tool_in_use(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure named_tool(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure new_tool(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure edges_are_unique(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure spindle_of_axis(Channel& channel, Operands& at, const Op& op, Arguments list);
MaybeFailure axis_of_spindle(Channel& channel, Operands& at, const Op& op, Arguments list);
// run_geometry.cc
MaybeFailure circle_of_points(Operands& at, const Op& op, Arguments list);
MaybeFailure measured_frame(Channel& channel, Operands& at, const Op& op, Arguments list);
}  // namespace function
}  // namespace g31::sinumerik

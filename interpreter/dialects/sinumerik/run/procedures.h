#pragma once

#include "interpreter/dialects/sinumerik/run/calls.h"
#include "interpreter/dialects/sinumerik/run/operands.h"
#include "interpreter/dialects/sinumerik/run/synchronised_actions.h"

namespace g31::sinumerik {

/// Calls the procedures of procedures.def.
class ProcedureCaller {
 public:
  /// All must outlive the caller.
  ProcedureCaller(Operands& operands, Channel& channel, Calls& calls, SynchronisedActions& actions)
      : operands_(operands), channel_(channel), calls_(calls), actions_(actions) {}

  MaybeFailure call(const Op& op);

 private:
  // A procedure takes its arguments, and what it acts on.
  MaybeFailure done(MaybeFailure (*work)(Channel&, Operands&, Arguments), Arguments list);
  MaybeFailure done(MaybeFailure (*work)(Calls&, Operands&, Arguments), Arguments list);
  MaybeFailure done(MaybeFailure (*work)(Calls&, Channel&, Operands&, Arguments), Arguments list);
  MaybeFailure done(MaybeFailure (*work)(SynchronisedActions&, Operands&, Arguments),
                    Arguments list);

  Operands& operands_;
  Channel& channel_;
  Calls& calls_;
  SynchronisedActions& actions_;
};

/// The column `work` of procedures.def; those that give a number report it to the variable that the
/// first argument names.
namespace procedure {

// run_procedures.cc
MaybeFailure message(Channel& channel, Operands& at, Arguments list);
MaybeFailure set_master_spindle(Channel& channel, Operands& at, Arguments list);
MaybeFailure begin_noting(Channel& channel, Operands& at, Arguments list);
MaybeFailure take_noted(Channel& channel, Operands& at, Arguments list);
MaybeFailure offset_noted(Channel& channel, Operands& at, Arguments list);
MaybeFailure call_part(Calls& calls, Operands& at, Arguments list);
MaybeFailure stop_reading_ahead(Channel& channel, Operands& at, Arguments list);
MaybeFailure set_feed_axes(Channel& channel, Operands& at, Arguments list);
MaybeFailure end_in_braking(Channel& channel, Operands& at, Arguments list);
MaybeFailure diameters_by_channel(Channel& channel, Operands& at, Arguments list);
MaybeFailure couple_axis(Channel& channel, Operands& at, Arguments list);
MaybeFailure transformation_on(Channel& channel, Operands& at, Arguments list);
MaybeFailure transformation_on_chain(Channel& channel, Operands& at, Arguments list);
MaybeFailure activate_data(Channel& channel, Operands& at, Arguments list);
MaybeFailure transformation_off(Channel& channel, Operands& at, Arguments list);
MaybeFailure reset_orientation(Channel& channel, Operands& at, Arguments list);
MaybeFailure release_axis(Channel& channel, Operands& at, Arguments list);
MaybeFailure set_alarm(Channel& channel, Operands& at, Arguments list);
MaybeFailure execute_string(Calls& calls, Operands& at, Arguments list);
MaybeFailure set_call_path(Calls& calls, Operands& at, Arguments list);
MaybeFailure cancel_actions(SynchronisedActions& actions, Operands& at, Arguments list);
MaybeFailure lock_actions(SynchronisedActions& actions, Operands& at, Arguments list);
MaybeFailure unlock_actions(SynchronisedActions& actions, Operands& at, Arguments list);
MaybeFailure disable_reading(SynchronisedActions& actions, Operands& at, Arguments list);

// run_files.cc
double write_file(Channel& channel, Operands& at, Arguments list);
MaybeFailure delete_file(Calls& calls, Channel& channel, Operands& at, Arguments list);
MaybeFailure read_file(Calls& calls, Channel& channel, Operands& at, Arguments list);
double open_external(Channel& channel, Operands& at, Arguments list);
double write_external(Channel& channel, Operands& at, Arguments list);
MaybeFailure tell_file_size(Calls& calls, Channel& channel, Operands& at, Arguments list);
double close_external(Channel& channel, Operands& at, Arguments list);

// run_tools.cc
double selected_tool(Channel& channel, Operands& at, Arguments list);
double tool_in_spindle(Channel& channel, Operands& at, Arguments list);
MaybeFailure select_named_tool(Channel& channel, Operands& at, Arguments list);
MaybeFailure delete_tool(Channel& channel, Operands& at, Arguments list);

}  // namespace procedure
}  // namespace g31::sinumerik

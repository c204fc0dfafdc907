#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/dialects/sinumerik/vocabulary/system_variables.h"
#include "machine/base/result.h"

namespace g31::sinumerik {

/// Which system variable a program reads or writes.
struct SystemAccess {
  SystemId id = SystemId::ToolNumber;
  int parameter = 0;  ///< of $TC_DPn
  std::vector<int> indices;
  int axis = 0;
  std::optional<Component> component;  ///< of a frame, of `axis`
};

}  // namespace g31::sinumerik

/// What the column `work` of system_variables.def names; files by subject.  Numbers and axes are in
/// the units of the program.
namespace g31::sinumerik::system {

using Number = Result<double, Failure>;
using Text = Result<std::string, Failure>;
using WholeFrame = Result<Frame, Failure>;
using FramePlace = Result<Frame*, Failure>;

// numbers.cc: what the channel simply knows
Number zero(Channel& channel, const SystemAccess& access);
Number active(Channel& channel, const SystemAccess& access);
Number status_of_axis(Channel& channel, const SystemAccess& access);
Number pi(Channel& channel, const SystemAccess& access);
Number version(Channel& channel, const SystemAccess& access);
Number motion_end(Channel& channel, const SystemAccess& access);
Number nothing_of_axis(Channel& channel, const SystemAccess& access);
Number kind_of_number(Channel& channel, const SystemAccess& access);
Number spindle_mode(Channel& channel, const SystemAccess& access);
Number tool_number(Channel& channel, const SystemAccess& access);
Number edge_number(Channel& channel, const SystemAccess& access);
Number additive_number(Channel& channel, const SystemAccess& access);
Number tool_count(Channel& channel, const SystemAccess& access);
Number channel_number(Channel& channel, const SystemAccess& access);
Number feed(Channel& channel, const SystemAccess& access);
Number first_axis(Channel& channel, const SystemAccess& access);
Number second_axis(Channel& channel, const SystemAccess& access);
Number third_axis(Channel& channel, const SystemAccess& access);
Number geometry_axis(Channel& channel, const SystemAccess& access);
Number settable_number(Channel& channel, const SystemAccess& access);
Number dry_run(Channel& channel, const SystemAccess& access);
Number modal_code(Channel& channel, const SystemAccess& access);
Number master_spindle(Channel& channel, const SystemAccess& access);
Number speed_programmed(Channel& channel, const SystemAccess& access);
Number speed_now(Channel& channel, const SystemAccess& access);
Number spindle_turn(Channel& channel, const SystemAccess& access);
Number probe_signal(Channel& channel, const SystemAccess& access);
Number probe_switched(Channel& channel, const SystemAccess& access);
Number digital_input(Channel& channel, const SystemAccess& access);
Number digital_output(Channel& channel, const SystemAccess& access);
MaybeFailure set_digital_output(Channel& channel, const SystemAccess& access, double value);
Number analog_input(Channel& channel, const SystemAccess& access);
MaybeFailure set_analog_input(Channel& channel, const SystemAccess& access, double value);
MaybeFailure set_digital_input(Channel& channel, const SystemAccess& access, double value);

// positions.cc: present positions wait for what moves
Number block_end(Channel& channel, const SystemAccess& access);
Number machine_now(Channel& channel, const SystemAccess& access);
Number work_now(Channel& channel, const SystemAccess& access);
Number basic_zero_now(Channel& channel, const SystemAccess& access);
Number settable_now(Channel& channel, const SystemAccess& access);
Number machine_measured(Channel& channel, const SystemAccess& access);
Number work_measured(Channel& channel, const SystemAccess& access);
Number machine_measured_second(Channel& channel, const SystemAccess& access);
Number work_measured_second(Channel& channel, const SystemAccess& access);
Number upper_soft_limit(Channel& channel, const SystemAccess& access);
Number lower_soft_limit(Channel& channel, const SystemAccess& access);
Number reference_point(Channel& channel, const SystemAccess& access);
MaybeFailure set_reference_point(Channel& channel, const SystemAccess& access, double value);
Number fixed_point(Channel& channel, const SystemAccess& access);
MaybeFailure set_fixed_point(Channel& channel, const SystemAccess& access, double value);

// clocks.cc: all but the date wait for what moves
Number day(Channel& channel, const SystemAccess& access);
Number month(Channel& channel, const SystemAccess& access);
Number year(Channel& channel, const SystemAccess& access);
Number hour(Channel& channel, const SystemAccess& access);
Number minute(Channel& channel, const SystemAccess& access);
Number second(Channel& channel, const SystemAccess& access);
Number block_time(Channel& channel, const SystemAccess& access);
Number net_time(Channel& channel, const SystemAccess& access);
Number timer(Channel& channel, const SystemAccess& access);
MaybeFailure set_timer(Channel& channel, const SystemAccess& access, double value);
Number action_override(Channel& channel, const SystemAccess& access);
MaybeFailure set_action_override(Channel& channel, const SystemAccess& access, double value);
Number operating_time(Channel& channel, const SystemAccess& access);
MaybeFailure set_operating_time(Channel& channel, const SystemAccess& access, double value);
Number cycle_time(Channel& channel, const SystemAccess& access);
MaybeFailure set_cycle_time(Channel& channel, const SystemAccess& access, double value);
Number cutting_time(Channel& channel, const SystemAccess& access);
MaybeFailure set_cutting_time(Channel& channel, const SystemAccess& access, double value);
Number setup_time(Channel& channel, const SystemAccess& access);
MaybeFailure set_setup_time(Channel& channel, const SystemAccess& access, double value);
Number power_on_time(Channel& channel, const SystemAccess& access);
MaybeFailure set_power_on_time(Channel& channel, const SystemAccess& access, double value);

// tools.cc
Number tool_radius(Channel& channel, const SystemAccess& access);
Number tool_length(Channel& channel, const SystemAccess& access);
Number active_edge_datum(Channel& channel, const SystemAccess& access);
MaybeFailure set_active_edge_datum(Channel& channel, const SystemAccess& access, double value);
Number tool_exists(Channel& channel, const SystemAccess& access);
Number tool_at(Channel& channel, const SystemAccess& access);
Number edge_count(Channel& channel, const SystemAccess& access);
Number edge_at(Channel& channel, const SystemAccess& access);
Number edge_parameter(Channel& channel, const SystemAccess& access);
MaybeFailure set_edge_parameter(Channel& channel, const SystemAccess& access, double value);
Number edge_teeth(Channel& channel, const SystemAccess& access);
MaybeFailure set_edge_teeth(Channel& channel, const SystemAccess& access, double value);
Number datum_of_edge(Channel& channel, const SystemAccess& access);
MaybeFailure set_datum_of_edge(Channel& channel, const SystemAccess& access, double value);
Number datum_of_tool(Channel& channel, const SystemAccess& access);
MaybeFailure set_datum_of_tool(Channel& channel, const SystemAccess& access, double value);
Number tool_duplo(Channel& channel, const SystemAccess& access);
MaybeFailure set_tool_duplo(Channel& channel, const SystemAccess& access, double value);
Number tool_state(Channel& channel, const SystemAccess& access);
MaybeFailure set_tool_state(Channel& channel, const SystemAccess& access, double value);
Text tool_name(Channel& channel, const SystemAccess& access);
MaybeFailure set_tool_name(Channel& channel, const SystemAccess& access, const std::string& name);

// carriers.cc: tool carriers and TRAORI
Number carrier_datum(Channel& channel, const SystemAccess& access);
MaybeFailure set_carrier_datum(Channel& channel, const SystemAccess& access, double value);
Number carrier_axis(Channel& channel, const SystemAccess& access);
MaybeFailure set_carrier_axis(Channel& channel, const SystemAccess& access, double value);
Text carrier_kind(Channel& channel, const SystemAccess& access);
MaybeFailure set_carrier_kind(Channel& channel, const SystemAccess& access,
                              const std::string& text);
Text carrier_name(Channel& channel, const SystemAccess& access);
MaybeFailure set_carrier_name(Channel& channel, const SystemAccess& access,
                              const std::string& text);
Number active_carrier(Channel& channel, const SystemAccess& access);
Number active_transformation(Channel& channel, const SystemAccess& access);
Number carrier_angle(Channel& channel, const SystemAccess& access);
Number carrier_solutions(Channel& channel, const SystemAccess& access);
Number carrier_status(Channel& channel, const SystemAccess& access);
Number tool_direction(Channel& channel, const SystemAccess& access);
Number transformation_number(Channel& channel, const SystemAccess& access);
Number tool_rotation(Channel& channel, const SystemAccess& access);
Number basic_now(Channel& channel, const SystemAccess& access);

// kept_data.cc: what is only kept
Number kept_datum(Channel& channel, const SystemAccess& access);
Text kept_text(Channel& channel, const SystemAccess& access);
MaybeFailure set_kept_text(Channel& channel, const SystemAccess& access, const std::string& text);
MaybeFailure set_kept_datum(Channel& channel, const SystemAccess& access, double value);
/// A number of a kinematic chain, $NK_ and $NT_.
MaybeFailure set_chain_datum(Channel& channel, const SystemAccess& access, double value);
/// Of a compensation table.
MaybeFailure set_table_datum(Channel& channel, const SystemAccess& access, double value);

// frames.cc
FramePlace settable_frames(Channel& channel, const SystemAccess& access);
FramePlace stored_bases(Channel& channel, const SystemAccess& access);
FramePlace stored_base(Channel& channel, const SystemAccess& access);
FramePlace bases(Channel& channel, const SystemAccess& access);
FramePlace base(Channel& channel, const SystemAccess& access);
FramePlace settable_frame(Channel& channel, const SystemAccess& access);
FramePlace program_frame(Channel& channel, const SystemAccess& access);
FramePlace stored_global_bases(Channel& channel, const SystemAccess& access);
FramePlace global_bases(Channel& channel, const SystemAccess& access);
template <Frame FrameSet::*member>
FramePlace stored_frame(Channel& channel, const SystemAccess& /*access*/) {
  return &(channel.stored_frames.*member);
}
template <Frame FrameSet::*member>
FramePlace frame_now(Channel& channel, const SystemAccess& /*access*/) {
  return &(channel.frames_now.*member);
}
Number base_mask(Channel& channel, const SystemAccess& access);
Number global_base_mask(Channel& channel, const SystemAccess& access);
MaybeFailure set_base_mask(Channel& channel, const SystemAccess& access, double value);
MaybeFailure set_global_base_mask(Channel& channel, const SystemAccess& access, double value);
WholeFrame active_base(Channel& channel, const SystemAccess& access);
WholeFrame active_frame(Channel& channel, const SystemAccess& access);

}  // namespace g31::sinumerik::system

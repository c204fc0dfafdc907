#pragma once

#include <optional>
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

/// The value of a variable that holds a number or an axis, in the units of the program.
Result<double, Failure> number_of(Channel& channel, const SystemAccess& access);
MaybeFailure set_number(Channel& channel, SystemAccess access, double value);

// The parts, one a file.

/// $P_TOOL.., $P_AD, $TC_..
bool is_of_tools(SystemId id);
Result<double, Failure> tool_number_of(Channel& channel, const SystemAccess& access);
MaybeFailure set_tool_number(Channel& channel, SystemAccess access, double value);
/// $AC_TIMER and its like; reading one waits for what moves.
bool is_time(SystemId id);
Result<double, Failure> time_of(Channel& channel, const SystemAccess& access);
MaybeFailure set_time(Channel& channel, const SystemAccess& access, double value);
/// Date and time of day of the simulated clock.
double date(const Channel& channel, SystemId id);
/// $P_S, $P_SDIR, $AA_S, $AC_SDIR
bool is_of_spindle(SystemId id);
Result<double, Failure> spindle_number_of(Channel& channel, const SystemAccess& access);

/// A frame; the last two indices of a component become `axis` and `component` of the access.
Result<Frame, Failure> frame_of(Channel& channel, SystemAccess& access);
MaybeFailure set_frame(Channel& channel, SystemAccess access, const Frame& frame);

}  // namespace g31::sinumerik

#pragma once

#include <optional>
#include <vector>

#include "interpreter/dialects/sinumerik/channel.h"
#include "interpreter/dialects/sinumerik/system_variables.h"
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

/// A frame; the last two indices of a component become `axis` and `component` of the access.
Result<Frame, Failure> frame_of(Channel& channel, SystemAccess& access);
MaybeFailure set_frame(Channel& channel, SystemAccess access, const Frame& frame);

}  // namespace g31::sinumerik

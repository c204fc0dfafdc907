#pragma once

#include <optional>

#include "interpreter/dialects/sinumerik/state/channel.h"
#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/tool_carrier.h"
#include "machine/base/result.h"

// What a machine's builder has written of rotary axes as a chain of elements, $NK_, and what of it
// takes part: a transformation, $NT_, or a tool carrier, $TC_CARR_KIN_.

namespace g31::sinumerik {

/// Transformation n of $NT_ is seen as the tool carrier of this number and n: TRAFOON takes it, and
/// the cycles that measure kinematics do.
inline constexpr int kFirstOnChain = 1000;

/// Which elements of the part's and of the tool's side a transformation or a carrier takes.
struct ChainEnds {
  std::string from;  ///< empty: the root
  std::string to;    ///< empty: that side has none
  /// Behind which element the side is closed: moved until it ends where it began.  Empty: before
  /// its first rotary axis on the tool's side, behind its last one on the part's.
  std::string closed_at;
  bool is_closed = true;
};

/// What the machine data say of transformation n; nullopt: nothing.  Alarm 4342.
Result<std::optional<DataTransformation>, Failure> transformation_of_data(const Channel& channel,
                                                                          int n);

/// The chain of a machine as its sheet has it: elements $NK_[170] and on and the transformation
/// $NT_[20], SHEET, on them; SHEET_CORR1 and SHEET_CORR2 take corrections.
void fill_chain(ChannelState& state, const machine::KinematicVectors& vectors);

/// Number of the transformation $NT_ with a name; nullopt: there is none.
std::optional<int> transformation_named(const ChannelState& state, const std::string& name);

/// Whether $TC_CARR_KIN_ of a carrier names elements.
bool is_on_chain(const ChannelState& state, int number);

/// The data of a tool carrier, its vectors by its chain where it is on one; of transformations on
/// chains and by machine data, too.
/// @return nullopt: there is no such carrier; alarm 4342 with what is wrong with the chain
Result<std::optional<ToolCarrier>, Failure> carrier_in_force(const Channel& channel, int number);

}  // namespace g31::sinumerik

#pragma once

#include "interpreter/dialects/sinumerik/channel.h"
#include "interpreter/dialects/sinumerik/code.h"

namespace g31::sinumerik {

/// One NC block with its words evaluated.
struct Block {
  const BlockWords& words;
  std::span<const std::uint16_t> codes;  ///< packed
  source::Location where;

  /// The row of a group that stands in this block; nullptr: none.
  [[nodiscard]] const GCode* code_of(int group) const;
};

/// Does everything that a block commands.
MaybeFailure execute_block(Channel& channel, const Block& block);

// The parts, one a file.

/// T, D and M6.
MaybeFailure select_tool(Channel& channel, const Block& block);
/// TRANS, ROT, SCALE, MIRROR and their additive forms.
MaybeFailure program_frame(Channel& channel, const Block& block, const GCode& code);
/// Straight moves, rapid or at feed.
MaybeFailure move_straight(Channel& channel, const Block& block);
/// G2, G3 and CIP.
MaybeFailure move_along_circle(Channel& channel, const Block& block);
/// Whether the block measures, or a synchronised action may end its move.
bool listens_to_probe(const Channel& channel, const Block& block);
/// MEAS, MEAW, MEASA, MEAWA and WHEN ... DO DELDTG
MaybeFailure measure(Channel& channel, const Block& block);
/// G4
MaybeFailure dwell(Channel& channel, const Block& block);

/// The end that the axis words say, work coordinates; axes without a word stay where they are.
Result<AxisPositions, Failure> programmed_end(Channel& channel, const Block& block);
/// mm/min
Result<double, Failure> feed_in_force(const Channel& channel);
/// Moves the machine, straight or along an arc, and tells the observer.
/// @param q_W_end  where the move ends for the program
/// @param g        of the report: 0 to 3
template <typename Move>
MaybeFailure carry_out(Channel& channel, const Move& move, const AxisPositions& q_W_end, int g);
/// What a fault of the machine means here.
Failure from_fault(const machine::MachineFault& fault);
/// Whether G9, G60 or a rapid stops the axes at the end of the block.
machine::BlockEnd block_end(const Channel& channel);

}  // namespace g31::sinumerik

#pragma once

#include <limits>
#include <optional>

#include "interpreter/path/path_block.h"
#include "machine/base/result.h"

namespace g31::path {

/// What a block asks for at the corner behind it.
struct CornerWish {
  enum class Kind {
    Sharp,
    Rounding,
    ChamferLength,
    ChamferWidth,
    PassBy,  ///< the control's own: rounded where that can be, sharp where it cannot
  } kind = Kind::Sharp;
  double size_mm = 0.0;  ///< radius; length of the chamfer; what it takes off each way
  /// Of PassBy: the same where one of both blocks is at rapid and the other one is not.
  double mixed_size_mm = 0.0;
  /// Of PassBy: how far the axes of the plane may leave the corner, mm.
  PlanePoint tolerance_mm = PlanePoint::Constant(std::numeric_limits<double>::infinity());
  double feed_mm_min = 0.0;  ///< of the rounding or chamfer; 0: that of the block in front of it

  bool operator==(const CornerWish&) const = default;
};

/// What a control says about corners that do not fit, or are none.
struct CornerRules {
  enum class TooLarge { Shrinks, Refused } too_large = TooLarge::Shrinks;
  enum class ChamferAtArc { Refused, ByDistance } chamfer_at_arc = ChamferAtArc::Refused;
  /// A turn up to this is no corner, radians.
  double straight_on_rad = 1e-9;
  /// Rotary axes may turn along with the plane: over the corner they go on in proportion.
  bool rotary_go_along = false;

  bool operator==(const CornerRules&) const = default;
};

enum class CornerError {
  ChamferAtArc,    ///< chamfers join straight ways
  NotFlat,         ///< another axis moves along with one of the two ways
  WayTooShort,     ///< the way in front of the corner does not hold it
  BehindTooShort,  ///< the way behind the corner does not hold it
};

struct CornerFault {
  CornerError error;
  source::Location where;
  std::uint64_t calls = 0;  ///< PathBlock::calls of that block
};

/// Roundings and chamfers between the blocks of a contour, with one block read ahead.
///
/// Fed with programmed blocks in machine coordinates.  A corner too large for its ways becomes as
/// large as they allow, or is an error.  None is made where the next block does not move in the
/// plane, moves at rapid (but for PassBy), or goes on in the same direction.
///
/// PassBy is an arc between two straight ways that begins and ends `size_mm` from the corner at
/// most, no farther than half of either way, and leaves it by `tolerance_mm` at most.  It is made
/// of rapids, too.
///
/// Pure geometry: it knows neither the machine nor the program.
class ContourCorners {
 public:
  ContourCorners() = default;
  explicit ContourCorners(const CornerRules& rules) : rules_(rules) {}

  /// What is to be done: `before` was waiting, `now` is of the block just taken.
  struct Given {
    PathItems before;
    PathItems now;
  };

  [[nodiscard]] bool holds() const { return held_.has_value(); }
  /// Whether the block waits for no more than a corner that may as well be sharp.
  [[nodiscard]] bool holds_to_pass_by() const {
    return held_ && held_->wish.kind == CornerWish::Kind::PassBy;
  }
  /// The end of the block that waits, as programmed, and the plane of its corner.
  [[nodiscard]] const AxisPositions& held_end() const { return held_->block.q_M_end; }
  [[nodiscard]] OffsetPlane held_plane() const { return held_->plane; }

  /// @param q_M_from  where the block begins as the program has it
  Result<Given, CornerFault> take(const PathBlock& block, const AxisPositions& q_M_from,
                                  OffsetPlane plane, const CornerWish& wish);

  /// The block that waits, without a corner.
  PathItems flush();

  bool operator==(const ContourCorners&) const = default;

 private:
  struct Held {
    PathBlock block;
    AxisPositions q_M_from;
    OffsetPlane plane;
    CornerWish wish;
    double length_mm = 0.0;  ///< of its way in the plane, as programmed

    bool operator==(const Held&) const = default;
  };

  CornerRules rules_;
  std::optional<Held> held_;
};

}  // namespace g31::path

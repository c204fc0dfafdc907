#pragma once

#include <array>
#include <cstddef>

#include "interpreter/dialects/sinumerik/state/frame.h"

namespace g31::sinumerik {

/// Basic frames and system frames, as the control keeps them or as they are in force.
struct FrameSet {
  static constexpr std::size_t kBases = 16;
  /// $P_NCBFRMASK and $P_CHBFRMASK: bit n, basic frame n counts.
  struct BaseMasks {
    static constexpr unsigned kAll = (1U << kBases) - 1U;
    unsigned global = kAll;
    unsigned channel = kAll;
    bool operator==(const BaseMasks&) const = default;
  };
  Frame part;                         ///< $P_PARTFRAME
  Frame set;                          ///< $P_SETFRAME
  Frame external;                     ///< $P_EXTFRAME
  std::array<Frame, kBases> global;   ///< $P_NCBFRAME
  std::array<Frame, kBases> channel;  ///< $P_CHBFRAME
  Frame tool;                         ///< $P_TOOLFRAME
  Frame workpiece;                    ///< $P_WPFRAME
  Frame transformation;               ///< $P_TRAFRAME
  Frame cycle;                        ///< $P_CYCFRAME
  BaseMasks masks;

  /// $P_ACTBFRAME
  [[nodiscard]] Frame bases() const;
  /// All outside of the settable frame, and all between it and the programmable one.
  [[nodiscard]] Frame outer() const;
  [[nodiscard]] Frame inner() const;
  bool operator==(const FrameSet&) const = default;
};

/// Goes on with a frame; one that does nothing leaves the others as they are.
void chain(Frame& all, const Frame& next);

}  // namespace g31::sinumerik

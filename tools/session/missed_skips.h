#pragma once

#include <vector>

#include "interpreter/runtime/observer.h"
#include "interpreter/source/diagnostic.h"
#include "probe/sensor/bodies.h"
#include "tools/setup/job.h"

namespace g31::session {

/// The skip moves of a run that ended without a signal: of each block the first one, and of blocks
/// no more than kMostBlocks.
class MissedSkips {
 public:
  static constexpr std::size_t kMostBlocks = 100;

  void skipped(const runtime::TouchEvent& event);

  /// Adds to each message PRB301 which part was nearest to the ball on its way, and how far away:
  /// of a probe without a script whose way no rotary axis turns.
  void tell_nearest(const setup::Job& job, const std::vector<probe::ProbedPart>& parts,
                    std::vector<source::Diagnostic>& diagnostics) const;

 private:
  struct Missed {
    source::Location where;
    AxisPositions q_M_from;
    AxisPositions q_M_to;
  };

  std::vector<Missed> missed_;
};

}  // namespace g31::session

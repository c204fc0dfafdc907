#include "tools/session/missed_skips.h"

#include <algorithm>
#include <limits>
#include <string>

#include <fmt/format.h>

#include "probe/contact/way_distance.h"

namespace g31::session {
namespace {

bool is_same_block(const source::Location& a, const source::Location& b) {
  return a.file == b.file && a.begin == b.begin;
}

bool is_turned(const AxisPositions& q_M) {
  return !q_M.tail<3>().isZero(0.0);
}

struct NearestPart {
  std::string name;
  double distance = std::numeric_limits<double>::infinity();
};

NearestPart nearest_part(const std::vector<probe::ProbedPart>& parts, const Point& p_M_from,
                         const Point& p_M_to) {
  NearestPart nearest;
  for (const probe::ProbedPart& part : parts) {
    if (part.mount == probe::Mount::Link) {
      continue;  // a body of the machine is nothing to be measured
    }
    const double distance = probe::distance_of_way(part.mesh_M, p_M_from, p_M_to);
    if (distance < nearest.distance) {
      nearest = {part.name, distance};
    }
  }
  return nearest;
}

}  // namespace

void MissedSkips::skipped(const runtime::TouchEvent& event) {
  const bool is_known = std::ranges::any_of(
      missed_, [&](const Missed& missed) { return is_same_block(missed.where, event.where); });
  if (!event.triggered && !is_known && missed_.size() < kMostBlocks) {
    missed_.push_back({event.where, event.q_M_from, event.q_M_commanded});
  }
}

void MissedSkips::tell_nearest(const setup::Job& job, const std::vector<probe::ProbedPart>& parts,
                               std::vector<source::Diagnostic>& diagnostics) const {
  if (!job.probe || job.skip_signals || parts.empty()) {
    return;
  }
  const std::string_view code = source::info(source::DiagnosticId::SkipWithoutSignal).code;
  for (source::Diagnostic& diagnostic : diagnostics) {
    // What another message of the block explains is not where the part is.
    const bool is_explained =
        std::ranges::any_of(diagnostics, [&](const source::Diagnostic& other) {
          return other.code != code && is_same_block(other.where, diagnostic.where);
        });
    const auto missed = std::ranges::find_if(
        missed_, [&](const Missed& one) { return is_same_block(one.where, diagnostic.where); });
    if (diagnostic.code != code || is_explained || missed == missed_.end() ||
        is_turned(missed->q_M_from) || is_turned(missed->q_M_to)) {
      continue;
    }
    const Point& p_T_tip = job.machine.p_T_tip;
    const NearestPart nearest = nearest_part(parts, missed->q_M_from.head<3>() + p_T_tip,
                                             missed->q_M_to.head<3>() + p_T_tip);
    const double gap = nearest.distance - 0.5 * job.probe->ball_diameter_mm;
    if (gap > 0.0) {
      diagnostic.message +=
          fmt::format("; the nearest part, '{}', was {:.3f} mm from the ball", nearest.name, gap);
    }
  }
}

}  // namespace g31::session

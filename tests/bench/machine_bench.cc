// How long a simulated move takes, in an empty world and in one that is asked.

#include <array>

#include <benchmark/benchmark.h>

#include "machine/sim/machining_centre.h"
#include "tests/support/world_of_pieces.h"

namespace g31::machine {
namespace {

AxisPositions axes(double x, double y, double z) {
  return (AxisPositions() << x, y, z, 0, 0, 0).finished();
}

MachineSetup typical_machine() {
  MachineSetup setup;
  for (std::size_t i = 0; i < 3; ++i) {
    setup.axes[i].travel_min = -500.0;
    setup.axes[i].travel_max = 500.0;
  }
  return setup;
}

/// Four corners, so that every call really moves.
const std::array<AxisPositions, 4>& corners() {
  static const std::array<AxisPositions, 4> kCorners = {axes(0, 0, 0), axes(30, 5, 0),
                                                        axes(30, 40, -2), axes(-7, 40, 3)};
  return kCorners;
}

void move_in_empty_world(benchmark::State& state, Traverse traverse) {
  MachiningCentre centre(typical_machine(), nullptr);
  MachinePort& port = centre;
  LinearMove move{axes(0, 0, 0), traverse, 300.0};
  std::size_t i = 0;
  while (state.KeepRunning()) {
    move.q_M_end = corners()[++i % 4];
    benchmark::DoNotOptimize(port.move(move));
  }
}
BENCHMARK_CAPTURE(move_in_empty_world, rapid, Traverse::Rapid);
BENCHMARK_CAPTURE(move_in_empty_world, feed, Traverse::Feed);

/// A world that always answers the same and remembers nothing.
class TriggerHalfway final : public testing::WorldOfPieces {
  std::optional<SkipTrigger> trigger_on(const Sweep& /*sweep*/) override {
    return SkipTrigger{0.5, false, 0.001, std::nullopt};
  }
};

void move_until_skip(benchmark::State& state) {
  TriggerHalfway world;
  MachiningCentre centre(typical_machine(), &world);
  MachinePort& port = centre;
  LinearMove move{axes(0, 0, 0), Traverse::Feed, 300.0};
  std::size_t i = 0;
  while (state.KeepRunning()) {
    move.q_M_end = corners()[++i % 4];
    benchmark::DoNotOptimize(port.move_until_skip(move));
  }
}
BENCHMARK(move_until_skip);

void move_along_arc(benchmark::State& state) {
  MachiningCentre centre(typical_machine(), nullptr);
  MachinePort& port = centre;
  ArcMove arc;
  arc.centre_first = 25.0;
  arc.feed_mm_min = 300.0;
  while (state.KeepRunning()) {
    benchmark::DoNotOptimize(port.move(arc));
  }
}
BENCHMARK(move_along_arc);

}  // namespace
}  // namespace g31::machine

// What the touch of a tool on a tool probe costs: standing and turning, with and without teeth; and
// how far a cutter of 60 teeth reads from its longest tooth.

#include <cstdint>
#include <memory>
#include <vector>

#include <benchmark/benchmark.h>

#include "machine/port/way.h"
#include "probe/sensor/tool_probe.h"

namespace g31::probe {
namespace {

constexpr double kFeedMmMin = 60.0;
constexpr double kSpeedRevMin = 3000.0;

/// Radii of 10 mm less up to 0.02 mm, by a rule that repeats nowhere.
ToolSetup mill(int teeth) {
  ToolSetup tool;
  tool.number = 5;
  tool.length_mm = 100.0;
  tool.diameter_mm = 20.0;
  for (int i = 0; i < teeth; ++i) {
    tool.teeth.push_back({i * 360.0 / teeth, 10.0 - 0.02 * (i * 7 % 11) / 11.0, 100.0});
  }
  return tool;
}

std::unique_ptr<ToolProbe> setter_with(const ToolSetup& tool, bool turns) {
  const auto rack = std::make_shared<const ToolRack>(std::vector<ToolSetup>{tool}, std::nullopt,
                                                     UnnamedTools::Believed);
  auto probe = std::make_unique<ToolProbe>(ToolProbeSetup(), rack, 1, 0);
  probe->take(machine::ToolChange{{tool.number, 0.0, 0.0}, 1});
  if (turns) {
    probe->take(machine::SpindleTurn{machine::Rotation::Clockwise, kSpeedRevMin, {}, 1});
  }
  return probe;
}

/// Into the side of the plate.
void ToolTouch(benchmark::State& state) {
  const int teeth = static_cast<int>(state.range(0));
  const bool turns = state.range(1) != 0;
  const auto probe = setter_with(mill(teeth), turns);
  machine::Waypoint ends[2];
  ends[0].q_M = AxisPositions::Zero();
  ends[0].q_M.head<3>() = Point(-40.0, 1.0, 97.0);
  ends[1] = ends[0];
  ends[1].fraction = 1.0;
  ends[1].q_M[0] = 0.0;
  const machine::Listening to{2, machine::SignalEdge::Rising, kFeedMmMin / 60.0};
  double reads_mm = 0.0;
  for (auto _ : state) {
    const auto trigger = probe->first_signal(machine::Way(ends), to);
    reads_mm = trigger ? -12.5 - (-40.0 + 40.0 * trigger->fraction) : 0.0;
    benchmark::DoNotOptimize(reads_mm);
  }
  state.counters["radius_mm"] = reads_mm;
  state.counters["feed_per_rev_mm"] = turns ? kFeedMmMin / kSpeedRevMin : 0.0;
}
BENCHMARK(ToolTouch)
    ->ArgNames({"teeth", "turns"})
    ->Args({0, 0})
    ->Args({0, 1})
    ->Args({4, 0})
    ->Args({4, 1})
    ->Args({60, 0})
    ->Args({60, 1});

/// A move that passes the plate by.
void MoveBesideAToolProbe(benchmark::State& state) {
  const auto probe = setter_with(mill(4), false);
  machine::Waypoint ends[2];
  ends[0].q_M = AxisPositions::Zero();
  ends[0].q_M.head<3>() = Point(-40.0, 60.0, 300.0);
  ends[1] = ends[0];
  ends[1].fraction = 1.0;
  ends[1].q_M[0] = 40.0;
  for (auto _ : state) {
    benchmark::DoNotOptimize(probe->first_obstacle(machine::Way(ends), machine::Travel::Rapid));
  }
}
BENCHMARK(MoveBesideAToolProbe);

}  // namespace
}  // namespace g31::probe

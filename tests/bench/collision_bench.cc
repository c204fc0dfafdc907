// What stem and body of a probe cost beside its ball: straight moves over and beside a sphere of
// 80, 9.8 k and 1 M triangles.

#include <array>
#include <cmath>
#include <cstdint>
#include <map>
#include <random>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>

#include "probe/collision/rigid_touch.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe {
namespace {

constexpr double kSphereRadiusMm = 50.0;

/// A sphere about the origin, built once for each number of bands.
const std::vector<CollisionMesh>& sphere(std::int64_t bands) {
  static std::map<std::int64_t, std::vector<CollisionMesh>> built;
  std::vector<CollisionMesh>& parts = built[bands];
  if (parts.empty()) {
    parts.emplace_back(testing::sphere_mesh(kSphereRadiusMm, static_cast<std::uint32_t>(bands)));
  }
  return parts;
}

ProbeSection section(const char* name, std::array<double, 2> heights, double radius) {
  ProbeSection made;
  made.name = name;
  made.z_bottom = heights[0];
  made.z_top = heights[1];
  made.radius_bottom = radius;
  made.radius_top = radius;
  return made;
}

const std::vector<ProbeSection>& whole_probe() {
  static const std::vector<ProbeSection> kSections = {section("stem", {0.0, 50.0}, 1.8),
                                                      section("probe body", {50.0, 120.0}, 31.5)};
  return kSections;
}

enum class Moves {
  Above,  ///< higher than the part: only its box is asked
  Past,   ///< through the box of the part, 1 mm beside it
  Into,   ///< the stem meets the part
};

CentreWay way_of(Moves moves, std::mt19937_64& random) {
  const double angle = testing::between(random, 0.0, 6.28);
  const Point out(std::cos(angle), std::sin(angle), 0.0);
  const Point along(-out.y(), out.x(), 0.0);
  switch (moves) {
    case Moves::Above:
      return {Point(-250.0 * along + Point(0, 0, 60)), Point(250.0 * along + Point(0, 0, 60))};
    case Moves::Past:
      // The body, 31.5 mm wide, passes the equator at a distance of 1 mm.
      return {82.5 * out - 250.0 * along - Point(0, 0, 80),
              82.5 * out + 250.0 * along - Point(0, 0, 80)};
    case Moves::Into:
      return {Point(250.0 * out - Point(0, 0, 20)), Point(-250.0 * out - Point(0, 0, 20))};
  }
  return {};
}

void time_moves(benchmark::State& state, std::span<const CentreWay> ways) {
  const std::vector<CollisionMesh>& parts = sphere(state.range(0));
  std::size_t i = 0;
  std::size_t touches = 0;
  while (state.KeepRunning()) {
    if (first_touch(whole_probe(), parts, ways[++i % ways.size()])) {
      ++touches;
    }
  }
  state.counters["touching"] =
      benchmark::Counter(static_cast<double>(touches), benchmark::Counter::kAvgIterations);
}

void whole_probe_move(benchmark::State& state, Moves moves) {
  std::mt19937_64 random(1);
  std::vector<CentreWay> ways;
  for (int i = 0; i < 64; ++i) {
    ways.push_back(way_of(moves, random));
  }
  time_moves(state, ways);
}
BENCHMARK_CAPTURE(whole_probe_move, above, Moves::Above)->Arg(5)->Arg(50)->Arg(500);
BENCHMARK_CAPTURE(whole_probe_move, past, Moves::Past)->Arg(5)->Arg(50)->Arg(500);
BENCHMARK_CAPTURE(whole_probe_move, into, Moves::Into)->Arg(5)->Arg(50)->Arg(500);

/// Any way, up and down too, that passes the part at 2 mm or less with any piece of the probe.
void whole_probe_near_miss(benchmark::State& state) {
  constexpr double kNearMm = 2.0;
  const std::vector<CollisionMesh>& parts = sphere(state.range(0));
  std::mt19937_64 random(3);
  std::vector<CentreWay> ways;
  while (ways.size() < 64) {
    CentreWay way{200.0 * testing::any_direction(random), 200.0 * testing::any_direction(random)};
    CentreWay grown = way;
    grown.margin = kNearMm;
    if (!first_touch(whole_probe(), parts, way) && first_touch(whole_probe(), parts, grown)) {
      ways.push_back(way);
    }
  }
  time_moves(state, ways);
}
BENCHMARK(whole_probe_near_miss)->Arg(5)->Arg(50)->Arg(500);

}  // namespace
}  // namespace g31::probe

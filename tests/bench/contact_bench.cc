// Contacts per second of the contact kernel: 20 mm probing moves with a 3 mm ball.

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <numbers>
#include <random>
#include <vector>

#include <benchmark/benchmark.h>

#include "parts/artefacts/ring_gauge.h"
#include "probe/contact/sweep_mesh.h"
#include "tests/probe/test_meshes.h"

namespace {

using g31::Point;
using g31::probe::MeshSweeper;

struct Way {
  Point from;
  Point to;
};

void run(benchmark::State& state, const g31::parts::Mesh& mesh, const std::vector<Way>& ways) {
  const MeshSweeper sweeper(mesh, 3.0);
  std::size_t next = 0;
  for (auto _ : state) {
    const Way& way = ways[next++ % ways.size()];
    benchmark::DoNotOptimize(sweeper.sweep(way.from, way.to));
  }
  state.SetItemsProcessed(state.iterations());
  state.counters["triangles"] = static_cast<double>(mesh.triangles.size());
}

void ring_bore(benchmark::State& state) {
  std::mt19937_64 random(1);
  std::vector<Way> ways(4096);
  for (Way& way : ways) {
    const double angle = g31::testing::between(random, 0.0, 2.0 * std::numbers::pi);
    way.from = Point(0.0, 0.0, g31::testing::between(random, -15.0, -5.0));
    way.to = way.from + 20.0 * Point(std::cos(angle), std::sin(angle), 0.0);
  }
  run(state, g31::parts::ring_gauge_mesh(g31::parts::RingGauge{}).value(), ways);
}
BENCHMARK(ring_bore);

void sphere(benchmark::State& state) {
  std::mt19937_64 random(1);
  std::vector<Way> ways(4096);
  for (Way& way : ways) {
    way.from = 35.0 * g31::testing::any_direction(random);
    const Point aim = g31::testing::point_between(random, -12.0, 12.0);
    way.to = way.from + 20.0 * (aim - way.from).normalized();
  }
  const auto bands = static_cast<unsigned>(state.range(0));
  run(state, g31::testing::sphere_mesh(20.0, bands), ways);
}
BENCHMARK(sphere)->Arg(5)->Arg(50)->Arg(500);

void build(benchmark::State& state) {
  const auto mesh = g31::testing::sphere_mesh(20.0, 50);
  for (auto _ : state) {
    benchmark::DoNotOptimize(MeshSweeper(mesh, 3.0));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(build)->Unit(benchmark::kMillisecond);

}  // namespace

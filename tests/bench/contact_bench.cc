// Contacts per second of the contact kernel, on one core: 20 mm probing moves of a 3 mm ball from a
// free start, as many contacts as moves.  sphere/5, /50, /500 have 80, 9800 and 998,000 triangles.
//
// times_as_fast: the other method's time for the same moves over that of MeshSweeper, measured one
// after the other in the same run.

#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <memory>
#include <numbers>
#include <random>
#include <span>
#include <vector>

#include <benchmark/benchmark.h>
#include <fcl/geometry/shape/sphere.h>
#include <fcl/narrowphase/continuous_collision.h>
#include <fcl/narrowphase/distance.h>

#include "parts/artefacts/ring_gauge.h"
#include "probe/contact/contact_triangle.h"
#include "probe/contact/sweep_curve.h"
#include "probe/contact/sweep_mesh.h"
#include "probe/contact/sweep_triangle.h"
#include "tests/probe/fcl_witness.h"
#include "tests/probe/test_meshes.h"

namespace {

using g31::Point;
using g31::probe::ContactTriangle;
using g31::probe::MeshSweeper;

constexpr double kBallRadius = 3.0;
constexpr double kSphereRadius = 20.0;

struct Way {
  Point from;
  Point to;
};

/// With the patches made that else the first way makes, but not yet the branches of their tree.
MeshSweeper sweeper_of(const g31::parts::Mesh& mesh) {
  MeshSweeper sweeper(mesh, kBallRadius);
  benchmark::DoNotOptimize(sweeper.memory_bytes());
  return sweeper;
}

/// Each way has been gone before: what a way makes of the tree when it first comes there is
/// `build`'s.
void run(benchmark::State& state, const g31::parts::Mesh& mesh, const std::vector<Way>& ways) {
  const MeshSweeper sweeper = sweeper_of(mesh);
  for (const Way& way : ways) {
    benchmark::DoNotOptimize(sweeper.sweep(way.from, way.to));
  }
  std::size_t next = 0;
  std::int64_t contacts = 0;
  for (auto _ : state) {
    const Way& way = ways[next++ % ways.size()];
    const auto hit = sweeper.sweep(way.from, way.to);
    contacts += hit.status == g31::probe::SweepStatus::Contact ? 1 : 0;
  }
  state.SetItemsProcessed(contacts);
  const auto triangles = static_cast<double>(mesh.triangles.size());
  state.counters["triangles"] = triangles;
  state.counters["bytes_per_triangle"] = static_cast<double>(sweeper.memory_bytes()) / triangles;
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

std::vector<Way> ways_onto_sphere() {
  std::mt19937_64 random(1);
  std::vector<Way> ways(4096);
  for (Way& way : ways) {
    way.from = 35.0 * g31::testing::any_direction(random);
    const Point aim = g31::testing::point_between(random, -12.0, 12.0);
    way.to = way.from + 20.0 * (aim - way.from).normalized();
  }
  return ways;
}

g31::parts::Mesh sphere_of(const benchmark::State& state) {
  return g31::testing::sphere_mesh(kSphereRadius, static_cast<std::uint32_t>(state.range(0)));
}

void sphere(benchmark::State& state) {
  run(state, sphere_of(state), ways_onto_sphere());
}
BENCHMARK(sphere)->Arg(5)->Arg(50)->Arg(500);

/// Up, down and sideways over a rough field: short triangles, ridges and hollows.
void dented_sphere(benchmark::State& state) {
  const auto mesh =
      g31::testing::shaken(sphere_of(state), 4.0 / static_cast<double>(state.range(0)), 3);
  run(state, mesh, ways_onto_sphere());
}
BENCHMARK(dented_sphere)->Arg(50)->Arg(500);

/// A retract from 0.1 mm overtravel: all that lies within the ball has to be looked at.
void leaving_a_sphere(benchmark::State& state) {
  const MeshSweeper sweeper = sweeper_of(sphere_of(state));
  std::mt19937_64 random(1);
  std::vector<Point> outs(4096);
  for (Point& out : outs) {
    out = g31::testing::any_direction(random);
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const Point& out = outs[next++ % outs.size()];
    benchmark::DoNotOptimize(
        sweeper.first_contact_leaving((kSphereRadius + kBallRadius - 0.1) * out, 43.0 * out));
  }
}
BENCHMARK(leaving_a_sphere)->Arg(5)->Arg(50)->Arg(500);

/// Half circles of 25 mm that come down onto the sphere.
void arc_onto_sphere(benchmark::State& state) {
  const MeshSweeper sweeper = sweeper_of(sphere_of(state));
  std::mt19937_64 random(1);
  std::vector<Point> outs(512);
  for (Point& out : outs) {
    out = g31::testing::any_direction(random);
  }
  std::size_t next = 0;
  for (auto _ : state) {
    const Point& out = outs[next++ % outs.size()];
    const Point aside = out.unitOrthogonal();
    const g31::probe::Curve arc{
        [&](double t) {
          const double angle = std::numbers::pi * t;
          return Point(40.0 * out + 25.0 * std::cos(angle) * aside - 25.0 * std::sin(angle) * out);
        },
        25.0 * std::numbers::pi * std::numbers::pi};
    benchmark::DoNotOptimize(g31::probe::sweep_curve(sweeper, arc));
  }
}
BENCHMARK(arc_onto_sphere)->Arg(5)->Arg(50)->Arg(500);

/// How long MeshSweeper takes for one of the ways, s: the mean over many.
double sweeper_seconds(const g31::parts::Mesh& mesh, std::span<const Way> ways) {
  const MeshSweeper sweeper = sweeper_of(mesh);
  constexpr int kRounds = 20;
  const auto begin = std::chrono::steady_clock::now();
  for (int round = 0; round < kRounds; ++round) {
    for (const Way& way : ways) {
      benchmark::DoNotOptimize(sweeper.sweep(way.from, way.to));
    }
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  return passed.count() / kRounds / static_cast<double>(ways.size());
}

/// Times another method, way by way, and sets it against MeshSweeper.
template <typename Method>
void compare(benchmark::State& state, const g31::parts::Mesh& mesh, const Method& method) {
  const std::vector<Way> ways = ways_onto_sphere();
  std::size_t next = 0;
  const auto begin = std::chrono::steady_clock::now();
  for (auto _ : state) {
    const Way& way = ways[next++ % ways.size()];
    benchmark::DoNotOptimize(method(way));
  }
  const std::chrono::duration<double> passed = std::chrono::steady_clock::now() - begin;
  const double seconds = passed.count() / static_cast<double>(state.iterations());
  state.counters["times_as_fast"] = seconds / sweeper_seconds(mesh, ways);
}

void every_triangle(benchmark::State& state) {
  const g31::parts::Mesh mesh = sphere_of(state);
  std::vector<ContactTriangle> triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(mesh.vertices[t[0]], mesh.vertices[t[1]], mesh.vertices[t[2]]);
  }
  compare(state, mesh, [&](const Way& way) {
    g31::parts::Path rest{way.from, (way.to - way.from).normalized(), (way.to - way.from).norm()};
    for (const ContactTriangle& triangle : triangles) {
      rest.length = std::min(rest.length, sweep_triangle(rest, triangle, kBallRadius));
    }
    return rest.length;
  });
}
BENCHMARK(every_triangle)->Arg(5)->Arg(50)->Arg(500);

fcl::Transform3d moved_to(const g31::Point& p) {
  fcl::Transform3d place = fcl::Transform3d::Identity();
  place.translation() = p;
  return place;
}

/// FCL's continuous collision by 1000 steps: exact to a step, 0.02 mm.  (Its conservative
/// advancement misses these contacts.)
void fcl_continuous(benchmark::State& state) {
  const g31::parts::Mesh mesh = sphere_of(state);
  const auto model = g31::testing::fcl_mesh(mesh);
  const fcl::Sphered ball(kBallRadius);
  fcl::ContinuousCollisionRequestd request(1000, 1e-3);
  request.ccd_solver_type = fcl::CCDC_NAIVE;
  compare(state, mesh, [&](const Way& way) {
    const fcl::Transform3d rest = fcl::Transform3d::Identity();
    fcl::ContinuousCollisionResultd result;
    // The mesh first: the other order overflows the stack in FCL 0.7.
    fcl::continuousCollide(model.get(), rest, rest, &ball, moved_to(way.from), moved_to(way.to),
                           request, result);
    return result.time_of_contact;
  });
}
BENCHMARK(fcl_continuous)->Arg(5)->Arg(50)->Arg(500);

/// The ball goes on by its distance from the mesh until that is less than a nanometre.
void fcl_distance_loop(benchmark::State& state) {
  constexpr double kNearMm = 1e-6;
  const g31::parts::Mesh mesh = sphere_of(state);
  const auto model = g31::testing::fcl_mesh(mesh);
  const fcl::Sphered ball(kBallRadius);
  const fcl::DistanceRequestd request;
  compare(state, mesh, [&](const Way& way) {
    const double length = (way.to - way.from).norm();
    double gone = 0.0;
    while (gone < length) {
      const g31::Point p = way.from + gone / length * (way.to - way.from);
      fcl::DistanceResultd result;
      const double distance = fcl::distance(model.get(), fcl::Transform3d::Identity(), &ball,
                                            moved_to(p), request, result);
      if (distance < kNearMm) {
        break;
      }
      gone += distance;
    }
    return gone;
  });
}
BENCHMARK(fcl_distance_loop)->Arg(5)->Arg(50)->Arg(500);

void build(benchmark::State& state) {
  const auto mesh = sphere_of(state);
  for (auto _ : state) {
    benchmark::DoNotOptimize(sweeper_of(mesh));
  }
  state.SetItemsProcessed(state.iterations() * static_cast<std::int64_t>(mesh.triangles.size()));
}
BENCHMARK(build)->Arg(50)->Arg(500)->Unit(benchmark::kMillisecond);

}  // namespace

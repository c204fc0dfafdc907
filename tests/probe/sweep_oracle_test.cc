// A ball against meshes of every unpleasant kind, judged in quadruple precision over all triangles.
// G31_SWEEPS=100000 in the environment makes it that many ways; without it 4000.

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <random>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "probe/contact/sweep_mesh.h"
#include "tests/probe/exact_sweep.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::sweep_oracle_test {
namespace {

using testing::any_direction;
using testing::between;
using testing::ExactSweep;
using testing::point_between;

struct Way {
  Point from;
  Point to;
};

Point any_point_on(const parts::Mesh& mesh, std::mt19937_64& random) {
  const auto& t = mesh.triangles[random() % mesh.triangles.size()];
  // A third each: a vertex, a point of an edge, a point of the face.
  const auto kind = random() % 3;
  const double a = kind == 0 ? 0.0 : between(random, 0.0, 1.0);
  const double b = kind == 2 ? between(random, 0.0, 1.0 - a) : 0.0;
  return (1.0 - a - b) * mesh.vertices[t[0]] + a * mesh.vertices[t[1]] + b * mesh.vertices[t[2]];
}

/// A direction that makes things difficult: along an edge, in the plane of a face, along an axis,
/// each sometimes off by a tiny angle.
Point awkward_direction(const parts::Mesh& mesh, std::mt19937_64& random) {
  const auto& t = mesh.triangles[random() % mesh.triangles.size()];
  const Point ab = mesh.vertices[t[1]] - mesh.vertices[t[0]];
  const Point ac = mesh.vertices[t[2]] - mesh.vertices[t[0]];
  Point direction = any_direction(random);
  const double along_ab = between(random, -1.0, 1.0);
  const double along_ac = between(random, -1.0, 1.0);
  const double tilt = std::pow(10.0, between(random, -16.0, -1.0));
  switch (random() % 4) {
    case 0:
      direction = ab;
      break;
    case 1:
      direction = along_ab * ab + along_ac * ac;
      break;
    case 2:
      direction = Point::Unit(static_cast<Eigen::Index>(random() % 3));
      break;
    default:
      break;
  }
  if (direction.norm() < 1e-6) {
    direction = Point::UnitX();
  }
  direction.normalize();
  if (random() % 2 == 0) {
    direction += tilt * any_direction(random);
  }
  return direction.normalized();
}

/// Half aimed at the mesh, half passing it at about the radius: grazing within 1e-1..1e-14 mm.
Way next_way(const parts::Mesh& mesh, double radius, std::mt19937_64& random) {
  const double length =
      random() % 8 == 0 ? between(random, 100.0, 500.0) : between(random, 5.0, 40.0);
  const Point direction =
      random() % 2 == 0 ? any_direction(random) : awkward_direction(mesh, random);
  Point through = any_point_on(mesh, random);
  if (random() % 2 == 0) {
    const Point aside = direction.cross(any_direction(random)).normalized();
    const double off = random() % 4 == 0 ? 0.0 : std::pow(10.0, between(random, -14.0, -1.0));
    through += aside * (radius + (random() % 2 == 0 ? off : -off));
  }
  const Point from = through - between(random, 0.3, 1.3) * length * direction;
  return {from, from + length * direction};
}

struct Worst {
  double gap = 0.0;
  double steep_s = 0.0;
  int contacts = 0;
  int misses = 0;
  int starts_in_contact = 0;
};

/// One sweep against the judge.  @param error_mm  allowed in the radius
void judge(const parts::Mesh& mesh, const MeshSweeper& sweeper, double radius, const Way& way,
           double error_mm, Worst& worst) {
  const ExactSweep exact(mesh, way.from, way.to);
  const double start_gap = exact.gap_at(0.0, radius);
  const SweepHit hit = sweeper.sweep(way.from, way.to);
  if (start_gap < -kTouchBandMm - error_mm) {
    EXPECT_EQ(hit.status, SweepStatus::StartInContact);
    EXPECT_NEAR((hit.p_M_centre - hit.p_M_point).norm() - radius, start_gap, error_mm);
    ++worst.starts_in_contact;
    return;
  }
  if (start_gap < kTouchBandMm + error_mm) {
    return;  // in touch: the tests of the start below
  }
  const double s = hit.status == SweepStatus::Miss ? ExactSweep::kMiss : hit.s;
  // A slightly bigger ball touches earlier, a slightly smaller one later: the answer must lie
  // between the two, however the ball grazes.
  ASSERT_GE(s, exact.first_contact(radius, error_mm) - 1e-12);
  ASSERT_LE(s, exact.first_contact(radius, -error_mm) + 1e-12);
  if (hit.status == SweepStatus::Miss) {
    ++worst.misses;
    return;
  }
  ++worst.contacts;
  ASSERT_EQ(hit.status, SweepStatus::Contact);
  worst.gap = std::max(worst.gap, std::fabs(exact.gap_at(s, radius)));
  const double exact_s = exact.first_contact(radius, 0.0);
  if (hit.cos_incidence > 0.01 && exact_s < ExactSweep::kMiss) {
    worst.steep_s = std::max(worst.steep_s, std::fabs(s - exact_s));
  }
  EXPECT_NEAR(hit.n_M.norm(), 1.0, 1e-12);
  EXPECT_NEAR((hit.p_M_centre - hit.p_M_point - radius * hit.n_M).norm(), 0.0, 1e-10);
  EXPECT_GE(hit.cos_incidence, -1e-6);
}

/// How many ways for all meshes together.
int sweeps_wanted() {
  const char* const wanted = std::getenv("G31_SWEEPS");
  return wanted != nullptr ? std::max(1000, std::atoi(wanted)) : 4000;
}

struct Judged {
  const char* name;
  parts::Mesh mesh;
  double radius;
  /// The rule for slivers lets the ball stand too low by up to (5e-6)^2 / (2 r).
  double error_mm = kContactErrorMm;
};

std::vector<Judged> judged_meshes() {
  using namespace testing;  // NOLINT(google-build-using-namespace): a list of shapes
  return {
      {"closed box", box_mesh({30.0, 20.0, 10.0}), 3.0},
      {"box, every triangle turned as it likes", turned_at_random(box_mesh({30, 20, 10}), 5), 3.0},
      {"box without shared vertices", unshared(box_mesh({30.0, 20.0, 10.0})), 2.0},
      {"sphere of 180 triangles", sphere_mesh(15.0, 10), 1.0},
      {"sphere from inside, open", without_every(sphere_mesh(15.0, 8), 9), 3.0},
      {"dented sphere", shaken(sphere_mesh(12.0, 8), 1.5, 11), 2.0},
      {"dented sphere, turned at random", turned_at_random(shaken(sphere_mesh(12, 8), 1.5, 12), 6),
       0.5},
      {"nearly smooth sphere", shaken(sphere_mesh(12.0, 12), 1e-7, 13), 3.0},
      {"spiked fans", spiked_fan(14.0, 40), 1.5},
      {"many sheets at one edge", book(12.0, 7), 2.0},
      {"60 loose triangles", loose_triangles(1, 60), 2.0},
      {"60 loose triangles, tiny ball", loose_triangles(2, 60), 0.05},
      {"60 loose triangles, huge ball", loose_triangles(2, 60), 40.0},
      {"60 slivers", slivers(3, 60), 0.5, kContactErrorMm + 2.5e-11},
      {"60 slivers, bigger ball", slivers(4, 60), 3.0, kContactErrorMm + 5e-12},
      {"a block 1000 mm away", moved_by(box_mesh({30.0, 20.0, 10.0}), {700.0, -600.0, 400.0}), 3.0},
  };
}

TEST(MeshSweeper, AgreesWithQuadruplePrecisionOverAllTriangles) {
  const std::vector<Judged> cases = judged_meshes();
  const int sweeps = sweeps_wanted() / static_cast<int>(cases.size()) + 1;
  std::mt19937_64 random(20240607);
  Worst total;
  for (const Judged& c : cases) {
    SCOPED_TRACE(c.name);
    const MeshSweeper sweeper(c.mesh, c.radius);
    Worst worst;
    for (int i = 0; i < sweeps && !HasFatalFailure(); ++i) {
      SCOPED_TRACE(i);
      judge(c.mesh, sweeper, c.radius, next_way(c.mesh, c.radius, random), c.error_mm, worst);
    }
    EXPECT_LE(worst.gap, c.error_mm);
    EXPECT_LE(worst.steep_s, 1e-9);
    // The generator must keep producing contacts, or this test tests less than it says.
    EXPECT_GT(worst.contacts, sweeps / 20);
    total.misses += worst.misses;
    total.starts_in_contact += worst.starts_in_contact;
    std::printf("[ measured ] %-40s gap %.1e mm, s %.1e mm; %d contacts %d misses %d in contact\n",
                c.name, worst.gap, worst.steep_s, worst.contacts, worst.misses,
                worst.starts_in_contact);
  }
  EXPECT_GT(total.misses, sweeps / 2);
  EXPECT_GT(total.starts_in_contact, sweeps / 2);
}

}  // namespace
}  // namespace g31::probe::sweep_oracle_test

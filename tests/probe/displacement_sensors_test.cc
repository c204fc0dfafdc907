// What displacement sensors read, against closed forms and against a look at every triangle.

#include "probe/sensor/displacement_sensors.h"

#include <cmath>
#include <memory>
#include <numbers>
#include <optional>
#include <random>
#include <vector>

#include <Eigen/LU>
#include <gtest/gtest.h>

#include "machine/sim/machining_centre.h"
#include "probe/contact/first_surface.h"
#include "probe/sensor/world.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::displacement_sensors_test {
namespace {

/// By Cramer's rule in long double, one triangle after the other.
std::optional<double> first_of_all(const parts::Mesh& mesh, const parts::Path& ray) {
  using Vector = Eigen::Matrix<long double, 3, 1>;
  std::optional<double> first;
  for (const auto& t : mesh.triangles) {
    const Vector a = mesh.vertices[t[0]].cast<long double>();
    Eigen::Matrix<long double, 3, 3> sides;
    sides.col(0) = mesh.vertices[t[1]].cast<long double>() - a;
    sides.col(1) = mesh.vertices[t[2]].cast<long double>() - a;
    sides.col(2) = -ray.direction.cast<long double>();
    if (sides.determinant() == 0.0L) {
      continue;
    }
    const Vector found = sides.inverse() * (ray.from.cast<long double>() - a);
    const bool is_inside = found[0] >= 0.0L && found[1] >= 0.0L && found[0] + found[1] <= 1.0L;
    if (is_inside && found[2] >= 0.0L && found[2] <= static_cast<long double>(ray.length) &&
        (!first || found[2] < static_cast<long double>(*first))) {
      first = static_cast<double>(found[2]);
    }
  }
  return first;
}

TEST(FirstSurface, IsThatOfALookAtEveryTriangle) {
  std::mt19937_64 random(31);
  int met = 0;
  for (const parts::Mesh& mesh : {testing::sphere_mesh(20.0, 12), testing::loose_triangles(7, 300),
                                  testing::slivers(9, 200)}) {
    const ContactMesh contact(mesh);
    for (int i = 0; i < 400; ++i) {
      const parts::Path ray{testing::point_between(random, -40.0, 40.0),
                            testing::any_direction(random), 60.0};
      const auto expected = first_of_all(mesh, ray);
      const auto found = first_surface(contact, ray);
      ASSERT_EQ(found.has_value(), expected.has_value()) << i;
      if (found) {
        ++met;
        ASSERT_NEAR(*found, *expected, 1e-9) << i;  // slivers: nearly along the ray
      }
    }
  }
  EXPECT_GT(met, 100);
}

TEST(FirstSurface, NoRayGoesThroughAnEdgeOrACorner) {
  const parts::Mesh mesh = testing::sphere_mesh(20.0, 12);
  const ContactMesh contact(mesh);
  for (const auto& t : mesh.triangles) {
    const Point corner = mesh.vertices[t[0]];
    const Point middle = 0.5 * (corner + mesh.vertices[t[1]]);
    for (const Point& to : {corner, middle}) {
      const Point from = 3.0 * to;
      const auto found = first_surface(contact, {from, (to - from).normalized(), 100.0});
      ASSERT_TRUE(found.has_value());
      EXPECT_NEAR(*found, 2.0 * to.norm(), 1e-9);
    }
  }
}

DisplacementSetup looking(const Point& along, double range_mm = 50.0) {
  DisplacementSetup sensor;
  sensor.name = "A";
  sensor.p_T_at = Point(3.0, 0.0, -80.0);
  sensor.along_T = along.normalized();
  sensor.range_mm = range_mm;
  return sensor;
}

machine::Waypoint standing(double x, double y, double z) {
  machine::Waypoint at{0.0, AxisPositions::Zero()};
  at.q_M.head<3>() = Point(x, y, z);
  return at;
}

/// The top face is z = 10.
std::shared_ptr<const SeenParts> box() {
  SeenParts parts;
  parts.push_back(std::make_shared<const ContactMesh>(
      testing::moved_by(testing::box_mesh({100, 100, 10}), {-50, -50, 0})));
  return std::make_shared<const SeenParts>(std::move(parts));
}

TEST(DisplacementSensors, ReadTheWayToTheNearestSurface) {
  const DisplacementSensors down({looking(-Point::UnitZ())}, box(), 0);
  EXPECT_EQ(down.place(1), Point(3.0, 0.0, -80.0));
  EXPECT_EQ(down.place(2), std::nullopt);
  EXPECT_NEAR(down.reading(1, standing(0, 0, 110), 0.0), 20.0, 1e-12);
  EXPECT_EQ(down.reading(1, standing(0, 0, 141), 0.0), 50.0);   // out of range
  EXPECT_EQ(down.reading(1, standing(90, 0, 110), 0.0), 50.0);  // beside the box
  const DisplacementSensors aslant({looking({1, 0, -1})}, box(), 0);
  EXPECT_NEAR(aslant.reading(1, standing(0, 0, 110), 0.0), 20.0 * std::numbers::sqrt2, 1e-12);
}

TEST(DisplacementSensors, TurnWithTheTool) {
  machine::Waypoint at = standing(0, 0, 110);
  at.tilt = Eigen::AngleAxisd(std::numbers::pi / 6, Point::UnitY());
  const DisplacementSensors down({looking(-Point::UnitZ())}, box(), 0);
  EXPECT_NEAR(down.reading(1, at, 0.0), 20.0 / std::cos(std::numbers::pi / 6), 1e-12);
}

/// Angular errors of the axes turn the line of sight, too.
TEST(DisplacementSensors, LookWhereTheErrorsOfTheAxesTurnThem) {
  constexpr double kLean = 1e-3;
  machine::Waypoint at = standing(0, 0, 110);
  at.lean_rad = Point(0.0, kLean, 0.0);
  const DisplacementSensors aslant({looking({1, 0, -1})}, box(), 0);
  EXPECT_NEAR(aslant.reading(1, at, 0.0), 20.0 / std::cos(std::numbers::pi / 4 - std::atan(kLean)),
              1e-12);
  const DisplacementSensors down({looking(-Point::UnitZ())}, box(), 0);
  EXPECT_NEAR(down.reading(1, at, 0.0), 20.0 / std::cos(std::atan(kLean)), 1e-12);
}

/// Over a disc of radius s on a ball of radius R seen from above its pole the mean depth is
/// R - 2 (R^3 - (R^2 - s^2)^(3/2)) / (3 s^2).
TEST(DisplacementSensors, AverageOverTheirSpot) {
  constexpr double kBall = 100.0;
  constexpr double kSpot = 10.0;
  SeenParts parts;
  parts.push_back(std::make_shared<const ContactMesh>(testing::sphere_mesh(kBall, 400)));
  const auto ball = std::make_shared<const SeenParts>(std::move(parts));
  DisplacementSetup sensor = looking(-Point::UnitZ());
  sensor.spot_mm = 2.0 * kSpot;
  const machine::Waypoint above = standing(-3.0, 0.0, kBall + 80.0 + 20.0);
  const double mean_depth =
      kBall - 2.0 * (std::pow(kBall, 3) - std::pow(kBall * kBall - kSpot * kSpot, 1.5)) /
                  (3.0 * kSpot * kSpot);
  const double reading = DisplacementSensors({sensor}, ball, 0).reading(1, above, 0.0);
  EXPECT_NEAR(reading, 20.0 + mean_depth, 2e-3);  // facets of 0.4 mm stand 0.0015 mm inside
  sensor.spot_mm = 0.0;
  EXPECT_NEAR(DisplacementSensors({sensor}, ball, 0).reading(1, above, 0.0), 20.0, 1e-9);
}

TEST(DisplacementSensors, StepAndScatter) {
  DisplacementSetup sensor = looking(-Point::UnitZ());
  sensor.resolution_mm = 0.01;
  EXPECT_NEAR(DisplacementSensors({sensor}, box(), 0).reading(1, standing(0, 0, 110.0149), 0.0),
              20.01, 1e-12);
  sensor.resolution_mm = 0.0;
  sensor.noise_mm = 0.004;
  const DisplacementSensors noisy({sensor}, box(), 5);
  constexpr int kReadings = 4000;
  double sum = 0.0;
  double squares = 0.0;
  for (int i = 0; i < kReadings; ++i) {
    const double off = noisy.reading(1, standing(0, 0, 110), 0.25 * i) - 20.0;
    sum += off;
    squares += off * off;
    EXPECT_EQ(noisy.reading(1, standing(0, 0, 110), 0.25 * i) - 20.0, off) << "at the same time";
  }
  EXPECT_NEAR(sum / kReadings, 0.0, 5.0 * 0.004 / std::sqrt(kReadings));
  EXPECT_NEAR(std::sqrt(squares / kReadings), 0.004, 5.0 * 0.004 / std::sqrt(2.0 * kReadings));
  EXPECT_NE(DisplacementSensors({sensor}, box(), 6).reading(1, standing(0, 0, 110), 0.25),
            noisy.reading(1, standing(0, 0, 110), 0.25));
}

/// A machine that tilts about Y as X goes moves a sensor off the spindle's axis up and down: by the
/// angle times its distance along X.
TEST(DisplacementSensors, AreWhereTheTrueMachineHasThem) {
  machine::MachineSetup setup;
  constexpr std::size_t kPitch = 4;  // EBX, um/m
  setup.geometric_errors.along[0][kPitch] = errors::ErrorTable({{0.0, 0.0}, {100.0, 1000.0}});
  DisplacementSetup near = looking(-Point::UnitZ());
  near.p_T_at = Point(0.0, 0.0, -80.0);
  DisplacementSetup far = near;
  far.input = 2;
  far.p_T_at = Point(40.0, 0.0, -80.0);
  World world(
      {}, Tools::Fixed,
      std::make_unique<DisplacementSensors>(std::vector<DisplacementSetup>{near, far}, box(), 0));
  machine::MachiningCentre machine(setup, &world);
  ASSERT_TRUE(machine.move(machine::LinearMove{standing(0, 0, 110).q_M}).ok());
  EXPECT_NEAR(machine.displacement(1).value(), machine.displacement(2).value(), 1e-12);
  ASSERT_TRUE(machine.move(machine::LinearMove{standing(5, 0, 110).q_M}).ok());
  const double tilt = 5e-5;
  EXPECT_NEAR(std::fabs(machine.displacement(2).value() - machine.displacement(1).value()),
              40.0 * tilt, 1e-9);
  EXPECT_EQ(machine.displacement(3), std::nullopt);
}

}  // namespace
}  // namespace g31::probe::displacement_sensors_test

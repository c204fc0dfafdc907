// A probe along the axes reads the size that a shape was made with, exactly: no facet is in the
// way.

#include <map>
#include <memory>
#include <string>

#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "probe/contact/sweep_mesh.h"

namespace g31::probe::shape_touch_test {
namespace {

constexpr double kBallRadius = 3.0;

struct Touching {
  const char* what;
  const char* shape;
  std::map<std::string, double> sizes;
  Point from;
  Point to;
  double way;  ///< mm until the ball touches, by the size alone
};

void expect_touch(const Touching& t) {
  SCOPED_TRACE(t.what);
  parts::PartSetup setup;
  setup.name = "gauge";
  setup.shape = t.shape;
  setup.sizes = t.sizes;
  const MeshSweeper sweeper(std::make_shared<const ContactMesh>(parts::make_artefact(setup).value(),
                                                                parts::exact_sphere(setup)),
                            kBallRadius);
  const SweepHit hit = sweeper.sweep(t.from, t.to);
  ASSERT_EQ(hit.status, SweepStatus::Contact);
  EXPECT_NEAR(hit.s, t.way, kContactErrorMm);
  EXPECT_NEAR(hit.n_M.dot((t.to - t.from).normalized()), -1.0, 1e-12) << "head-on";
}

TEST(ShapeTouch, ReadsTheSizeOfEveryShapeAlongTheAxes) {
  const std::map<std::string, double> plug = {{"diameter", 30.003}};
  const std::map<std::string, double> ball = {{"diameter", 24.998}, {"sagitta", 0.05}};
  const std::map<std::string, double> round = {{"corner_radius", 8.0}};
  const Touching kTouches[] = {
      {"bore, +X", "ring", {}, {0, 0, -10}, {30, 0, -10}, 19.998 - 3},
      {"bore, -Y", "ring", {}, {0, 0, -10}, {0, -30, -10}, 19.998 - 3},
      {"pin, from +X", "plug", plug, {40, 0, -10}, {0, 0, -10}, 40 - 15.0015 - 3},
      {"pin, from -X", "plug", plug, {-40, 0, -10}, {0, 0, -10}, 40 - 15.0015 - 3},
      {"pin, from +Y", "plug", plug, {0, 40, -10}, {0, 0, -10}, 40 - 15.0015 - 3},
      {"pin, from -Y", "plug", plug, {0, -40, -10}, {0, 0, -10}, 40 - 15.0015 - 3},
      {"pin, top", "plug", plug, {1, 2, 10}, {1, 2, -10}, 10 - 3},
      {"foot, shoulder", "plug", plug, {20, 0, 10}, {20, 0, -50}, 10 + 20 - 3},
      {"sphere, from +X", "sphere", ball, {40, 0, 0}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, from -X", "sphere", ball, {-40, 0, 0}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, from +Y", "sphere", ball, {0, 40, 0}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, from -Y", "sphere", ball, {0, -40, 0}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, from above", "sphere", ball, {0, 0, 40}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, from below", "sphere", ball, {0, 0, -40}, {0, 0, 0}, 40 - 12.499 - 3},
      {"sphere, aslant", "sphere", ball, {20, -40, 40}, {0, 0, 0}, 60 - 12.499 - 3},
      {"cylinder, from -Y", "cylinder", {}, {0, -40, -5}, {0, 0, -5}, 40 - 15 - 3},
      {"cylinder, top", "cylinder", {}, {0, 0, 40}, {0, 0, -5}, 40 - 3},
      {"hexagon, from +X", "prism", {}, {40, 0, -5}, {0, 0, -5}, 40 - 15 - 3},
      {"hexagon, from -X", "prism", {}, {-40, 0, -5}, {0, 0, -5}, 40 - 15 - 3},
      {"block, from +X", "block", {}, {50, 1, -5}, {0, 1, -5}, 50 - 30 - 3},
      {"block, from -Y", "block", {}, {1, -50, -5}, {1, 0, -5}, 50 - 20 - 3},
      {"block, top", "block", {}, {1, 1, 50}, {1, 1, -5}, 50 - 3},
      {"gauge block, first face", "gauge_block", {}, {-20, 0, -4}, {0, 0, -4}, 20 - 3},
      {"gauge block, second face", "gauge_block", {}, {80, 0, -4}, {0, 0, -4}, 30 - 3},
      {"pocket, +X", "pocket", {}, {0, 0, -8}, {50, 0, -8}, 30 - 3},
      {"pocket, -Y", "pocket", {}, {0, 0, -8}, {0, -50, -8}, 20 - 3},
      {"pocket, floor", "pocket", {}, {1, 2, 20}, {1, 2, -30}, 20 + 15 - 3},
      {"rounded pocket, -X", "pocket", round, {0, 0, -8}, {-50, 0, -8}, 30 - 3},
      {"rounded pocket, +Y where the corner begins",
       "pocket",
       round,
       {22, 0, -8},
       {22, 50, -8},
       17},
      {"groove, -X", "groove", {}, {0, 5, -8}, {-50, 5, -8}, 10 - 3},
      {"groove, floor", "groove", {}, {0, 5, 8}, {0, 5, -50}, 8 + 15 - 3},
      {"rib, from -X", "rib", {}, {-40, 5, -8}, {0, 5, -8}, 40 - 10 - 3},
      {"rib, shoulder", "rib", {}, {20, 5, 8}, {20, 5, -50}, 8 + 15 - 3},
      {"step, upright face", "step", {}, {25, 1, -5}, {-25, 1, -5}, 25 - 3},
      {"step, lower face", "step", {}, {15, 1, 5}, {15, 1, -50}, 5 + 15 - 3},
      {"step, upper face", "step", {}, {-15, 1, 5}, {-15, 1, -50}, 5 - 3},
      {"bed, top", "bed", {}, {500, 1, 40}, {500, 1, -5}, 40 - 3},
      {"bed, its end", "bed", {}, {-20, 1, -50}, {10, 1, -50}, 20 - 3},
      {"shaft, from +X", "shaft", {}, {60, 0, -100}, {0, 0, -100}, 60 - 25 - 3},
  };
  for (const Touching& t : kTouches) {
    expect_touch(t);
  }
}

}  // namespace
}  // namespace g31::probe::shape_touch_test

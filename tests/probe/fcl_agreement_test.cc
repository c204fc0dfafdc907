// FCL as a second witness: at the contact that MeshSweeper finds, a slightly bigger ball collides
// and a slightly smaller one does not.  (FCL's own continuous collision misses contacts.)
// Compile without AVX or with EIGEN_MAX_ALIGN_BYTES=16, as the packaged FCL was.

#include <memory>
#include <random>
#include <vector>

#include <fcl/geometry/shape/sphere.h>
#include <gtest/gtest.h>

#include "probe/contact/sweep_mesh.h"
#include "tests/probe/fcl_witness.h"
#include "tests/probe/test_meshes.h"

namespace g31::probe::fcl_agreement_test {
namespace {

using testing::fcl_mesh;
using testing::FclMesh;

bool collides(const std::shared_ptr<FclMesh>& mesh, double radius, const Point& centre) {
  return testing::fcl_collides(mesh, std::make_shared<fcl::Sphered>(radius), centre);
}

TEST(MeshSweeper, AgreesWithFcl) {
  constexpr double kFclErrorMm = 5e-7;  // libccd decides at about 2e-7
  constexpr double kRadius = 3.0;
  const parts::Mesh kMeshes[] = {testing::box_mesh({30.0, 20.0, 10.0}),
                                 testing::sphere_mesh(15.0, 16), testing::loose_triangles(9, 40)};
  std::mt19937_64 random(77);
  for (const parts::Mesh& mesh : kMeshes) {
    const MeshSweeper sweeper(mesh, kRadius);
    const auto model = fcl_mesh(mesh);
    int contacts = 0;
    for (int i = 0; i < 300; ++i) {
      const Point from = 60.0 * testing::any_direction(random);
      const Point to = testing::point_between(random, -15.0, 15.0);
      const SweepHit hit = sweeper.sweep(from, to);
      if (hit.status == SweepStatus::Miss) {
        EXPECT_FALSE(collides(model, kRadius - kFclErrorMm, to));
        continue;
      }
      ++contacts;
      EXPECT_TRUE(collides(model, kRadius + kFclErrorMm, hit.p_M_centre));
      EXPECT_FALSE(collides(model, kRadius - kFclErrorMm, hit.p_M_centre));
      // And nothing was met on the way there.
      for (const double part : {0.25, 0.5, 0.75, 0.95}) {
        EXPECT_FALSE(collides(model, kRadius - kFclErrorMm, from + part * (hit.p_M_centre - from)));
      }
    }
    EXPECT_GT(contacts, 100);
  }
}

}  // namespace
}  // namespace g31::probe::fcl_agreement_test

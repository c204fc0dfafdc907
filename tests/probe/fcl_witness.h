#pragma once

#include <memory>
#include <vector>

#include <fcl/geometry/bvh/BVH_model.h>
#include <fcl/math/bv/OBBRSS.h>
#include <fcl/narrowphase/collision.h>

#include "machine/units/point.h"
#include "parts/geometry/mesh.h"

// FCL's answers, as a second opinion on ours.

namespace g31::testing {

using FclMesh = fcl::BVHModel<fcl::OBBRSSd>;

inline std::shared_ptr<FclMesh> fcl_mesh(const parts::Mesh& mesh) {
  std::vector<fcl::Triangle> triangles;
  for (const auto& t : mesh.triangles) {
    triangles.emplace_back(t[0], t[1], t[2]);
  }
  auto model = std::make_shared<FclMesh>();
  model->beginModel();
  model->addSubModel(mesh.vertices, triangles);
  model->endModel();
  return model;
}

/// Whether an upright shape touches the mesh.
inline bool fcl_collides(const std::shared_ptr<FclMesh>& mesh,
                         const std::shared_ptr<fcl::CollisionGeometryd>& shape,
                         const Point& p_middle) {
  fcl::CollisionObjectd part(mesh);
  fcl::CollisionObjectd body(shape, Eigen::Matrix3d::Identity(), p_middle);
  const fcl::CollisionRequestd request;
  fcl::CollisionResultd result;
  // The mesh first: the other order overflows the stack in FCL 0.7.
  return fcl::collide(&part, &body, request, result) > 0;
}

}  // namespace g31::testing

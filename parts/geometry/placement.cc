#include "parts/geometry/placement.h"

#include <cmath>
#include <numbers>
#include <span>

namespace g31::parts {
namespace {

struct CosSin {
  double cos = 1.0;
  double sin = 0.0;
};

CosSin cos_sin_deg(double angle_deg) {
  // std::remainder is exact, so a multiple of 90 degrees leaves exactly 0 here.
  const double rest = std::remainder(angle_deg, 90.0);
  const int quarters =
      static_cast<int>(std::lround((std::remainder(angle_deg, 360.0) - rest) / 90.0));
  const double c = std::cos(rest * std::numbers::pi / 180.0);
  const double s = std::sin(rest * std::numbers::pi / 180.0);
  switch ((quarters + 4) % 4) {
    case 1:
      return {-s, c};
    case 2:
      return {-c, -s};
    case 3:
      return {s, -c};
    default:
      return {c, s};
  }
}

void place(std::span<Point> points, const Placement& placement) {
  const bool turned = (placement.rotate_deg.array() != 0.0).any();
  const Eigen::Matrix3d R_MP = rotation_to_machine(placement);
  for (Point& p : points) {
    if (placement.growth != 0.0) {
      p += placement.growth * p;
    }
    const Point turned_p = turned ? Point(R_MP * p) : p;
    p = turned_p + placement.p_M_at;
  }
}

}  // namespace

Eigen::Matrix3d rotation_to_machine(const Placement& placement) {
  const auto [cx, sx] = cos_sin_deg(placement.rotate_deg.x());
  const auto [cy, sy] = cos_sin_deg(placement.rotate_deg.y());
  const auto [cz, sz] = cos_sin_deg(placement.rotate_deg.z());
  Eigen::Matrix3d about_x;
  Eigen::Matrix3d about_y;
  Eigen::Matrix3d about_z;
  about_x << 1, 0, 0, 0, cx, -sx, 0, sx, cx;
  about_y << cy, 0, sy, 0, 1, 0, -sy, 0, cy;
  about_z << cz, -sz, 0, sz, cz, 0, 0, 0, 1;
  return about_z * about_y * about_x;
}

Mesh placed_mesh(const Mesh& mesh_P, const Placement& placement) {
  Mesh mesh_M = mesh_P;
  place(mesh_M.vertices, placement);
  return mesh_M;
}

Sphere placed_sphere(const Sphere& sphere_P, const Placement& placement) {
  Sphere sphere_M = sphere_P;
  place(std::span(&sphere_M.centre, 1), placement);
  sphere_M.radius += placement.growth * sphere_M.radius;
  return sphere_M;
}

}  // namespace g31::parts

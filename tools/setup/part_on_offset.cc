#include "tools/setup/part_on_offset.h"

#include <cmath>
#include <numbers>

#include "machine/base/contract.h"
#include "parts/geometry/placement.h"

namespace g31::setup {
namespace {

/// Degrees about X, then Y, then Z of fixed axes: what rotation_to_machine undoes.
Point angles_of(const Eigen::Matrix3d& turn) {
  constexpr double kDegrees = 180.0 / std::numbers::pi;
  const double about_y = std::atan2(-turn(2, 0), std::hypot(turn(2, 1), turn(2, 2)));
  const bool is_upright = std::hypot(turn(2, 1), turn(2, 2)) < 1e-12;
  const double about_x =
      is_upright ? std::atan2(-turn(1, 2), turn(1, 1)) : std::atan2(turn(2, 1), turn(2, 2));
  const double about_z = is_upright ? 0.0 : std::atan2(turn(1, 0), turn(0, 0));
  return kDegrees * Point(about_x, about_y, about_z);
}

/// The part as it is seen from outside of an offset.
void leave_offset(parts::PartSetup& part, const runtime::ControlSetup& control,
                  const std::string& offset) {
  const auto origin = control.work_offsets.find(offset);
  G31_EXPECTS(origin != control.work_offsets.end());
  Point p_M_origin = origin->second.head<3>();
  Point turned = Point::Zero();
  if (const auto shape = control.offset_shapes.find(offset); shape != control.offset_shapes.end()) {
    const auto& fine = shape->second.fine_mm;
    const auto& rotate = shape->second.rotate_deg;
    p_M_origin += Point(fine.at(0), fine.at(1), fine.at(2));
    turned = Point(rotate.at(0), rotate.at(1), rotate.at(2));
  }
  if (turned == Point::Zero()) {
    part.p_M_at += p_M_origin;
    return;
  }
  const Eigen::Matrix3d turn = parts::rotation_to_machine({Point::Zero(), turned});
  part.p_M_at = p_M_origin + turn * part.p_M_at;
  const bool is_about_z = turned.head<2>().isZero(0.0);
  part.rotate_deg =
      is_about_z ? Point(part.rotate_deg + turned)
                 : angles_of(turn * parts::rotation_to_machine({Point::Zero(), part.rotate_deg}));
}

}  // namespace

void put_on_offset(parts::PartSetup& part, const runtime::ControlSetup& control,
                   const std::string& offset) {
  leave_offset(part, control, offset);
  constexpr const char* kOfAll = "EXT";
  if (offset != kOfAll && control.work_offsets.contains(kOfAll)) {
    leave_offset(part, control, kOfAll);
  }
}

}  // namespace g31::setup

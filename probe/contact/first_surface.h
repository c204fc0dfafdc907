#pragma once

#include <optional>

#include "parts/geometry/box.h"
#include "probe/contact/contact_mesh.h"

namespace g31::probe {

/// How far along a ray a mesh is met first, mm; nullopt: not before its end.  Both sides of a
/// triangle count, and its border does; so do both of a true sphere that a mesh stands for.
///
/// Accuracy: kRayErrorMm for coordinates up to 10 m and rays less than 80 degrees off the normal.
std::optional<double> first_surface(const ContactMesh& mesh, const parts::Path& ray);

inline constexpr double kRayErrorMm = 1e-11;

}  // namespace g31::probe

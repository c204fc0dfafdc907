#include "parts/features/islands.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <map>
#include <numeric>

#include "parts/features/recognise.h"

namespace g31::parts {
namespace {

bool is_level(const RemovedFace& face) {
  return face.surface == FaceSurface::Plane &&
         std::hypot(face.normal_P.x(), face.normal_P.y()) < kSameDirection;
}

/// Joins faces that share a place.
class Groups {
 public:
  explicit Groups(const std::vector<RemovedFace>& faces) : parent_(faces.size()) {
    std::iota(parent_.begin(), parent_.end(), 0U);
    // Two places that are the same lie in one cell of at least one of these grids.
    for (unsigned grid = 0; grid < 8; ++grid) {
      std::map<Cell, std::size_t> taken;
      for (std::size_t i = 0; i < faces.size(); ++i) {
        if (is_level(faces[i])) {
          continue;
        }
        for (const Point& p : faces[i].border_P) {
          const auto [at, is_new] = taken.try_emplace(cell_of(p, grid), i);
          if (!is_new) {
            parent_[root_of(i)] = root_of(at->second);
          }
        }
      }
    }
  }

  std::size_t root_of(std::size_t face) {
    while (parent_[face] != face) {
      face = parent_[face] = parent_[parent_[face]];
    }
    return face;
  }

 private:
  using Cell = std::array<std::int64_t, 3>;

  static Cell cell_of(const Point& p, unsigned grid) {
    constexpr double kCellMm = 4.0 * kSamePlaceMm;
    Cell cell{};
    for (unsigned axis = 0; axis < 3; ++axis) {
      const double shift = (grid >> axis & 1U) != 0U ? 0.5 : 0.0;
      cell[axis] = std::llround(p[axis] / kCellMm + shift);
    }
    return cell;
  }

  std::vector<std::size_t> parent_;
};

/// What is around faces, seen from above.
Box box_around(const FacesAround::Faces& faces) {
  Box box;
  for (const RemovedFace* face : faces) {
    box.include(face->at_P);
    for (const Point& p : face->border_P) {
      box.include(p);
    }
  }
  return box;
}

double width_of(const FacesAround::Faces& faces) {
  const Box box = box_around(faces);
  return std::hypot(box.max.x() - box.min.x(), box.max.y() - box.min.y());
}

/// Whether faces keep off the sides of the volume that they are of, and none of them is open.
bool stands_free(const FacesAround::Faces& faces, const Box& volume_P) {
  if (std::ranges::any_of(faces, &RemovedFace::is_open)) {
    return false;
  }
  const Box box = box_around(faces);
  const auto margin = std::min({box.min.x() - volume_P.min.x(), box.min.y() - volume_P.min.y(),
                                volume_P.max.x() - box.max.x(), volume_P.max.y() - box.max.y()});
  return margin > kSamePlaceMm;
}

}  // namespace

FacesAround faces_around(const RemovedVolume& volume) {
  FacesAround found;
  Groups groups(volume.faces);
  std::map<std::size_t, FacesAround::Faces> by_root;
  for (std::size_t i = 0; i < volume.faces.size(); ++i) {
    const RemovedFace& face = volume.faces[i];
    if (is_level(face)) {
      found.outer.push_back(&face);
    } else {
      by_root[groups.root_of(i)].push_back(&face);
    }
  }
  const auto widest = std::ranges::max_element(
      by_root, {}, [](const auto& group) { return width_of(group.second); });
  for (auto group = by_root.begin(); group != by_root.end(); ++group) {
    const FacesAround::Faces& faces = group->second;
    if (group != widest && stands_free(faces, volume.box_P)) {
      found.islands.push_back(faces);
    } else {
      found.outer.insert(found.outer.end(), faces.begin(), faces.end());
    }
  }
  return found;
}

}  // namespace g31::parts

#pragma once

#include <array>
#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

#include "machine/units/point.h"
#include "parts/features/drawn_dimension.h"
#include "parts/geometry/box.h"

namespace g31::parts {

/// features.def
enum class FeatureKind {
#define FEATURE(kind, name, words) kind,
#include "parts/features/features.def"
#undef FEATURE
};

/// "closed_pocket"
std::string_view name_of(FeatureKind kind);

/// "closed pocket"
std::string_view words_of(FeatureKind kind);

/// The sides of a box; a feature's are named by its own axes.
enum class Side { XPlus, XMinus, YPlus, YMinus, ZPlus, ZMinus };

inline constexpr std::size_t kSides = 6;

/// "+X"
std::string_view name_of(Side side);

/// Axes turned about Z of the product.
struct OwnAxes {
  double angle_deg = 0.0;  ///< -45 < angle <= 45, from +X towards +Y

  [[nodiscard]] Point own_of(const Point& p_P) const;
  [[nodiscard]] Point part_of(const Point& p_own) const;
};

/// One of the kinds, found on a product.
struct Feature {
  FeatureKind kind = FeatureKind::ClosedPocket;
  Box box_P;                        ///< product frame P
  OwnAxes axes;                     ///< of a round one those of the product
  Box own;                          ///< from wall to wall, in its own axes
  std::array<bool, kSides> open{};  ///< by Side, in its own axes
  /// Open sides that are not at right angles to its walls; by Side.
  std::array<bool, kSides> slanting{};
  /// Heights between which its walls are upright: below a chamfer, above a rounded floor edge.
  double walls_from_z = 0.0;
  double walls_to_z = 0.0;
  double corner_radius_mm = 0.0;  ///< the largest between two walls
  double floor_radius_mm = 0.0;   ///< between walls and floor
  bool has_flat_floor = false;    ///< not a drill's point, and there is one
  bool is_round = false;          ///< its wall is one cylinder; `own` is the box around it
  double facet_error_mm = 0.0;    ///< how far facets are from the round walls that they stand for

  [[nodiscard]] bool is_open(Side side) const { return open[static_cast<std::size_t>(side)]; }
  [[nodiscard]] bool is_slanting(Side side) const {
    return slanting[static_cast<std::size_t>(side)];
  }
  /// Whether it is of material and not of air: its walls look outwards, its floor is around it.
  [[nodiscard]] bool is_standing() const {
    return kind == FeatureKind::Boss || kind == FeatureKind::Rib;
  }
};

/// A removed volume of none of the kinds.
struct UnknownVolume {
  Box box_P;
  std::string why;  ///< "one of its walls is inclined by 3 deg"
};

/// What a product is made of, as far as it can be measured.
struct RecognisedPart {
  Box stock_P;
  std::vector<Feature> features;       ///< by the lower corner of their boxes: X, then Y, then Z
  std::vector<UnknownVolume> unknown;  ///< in the same order
  std::vector<DrawnDimension> dimensions = {};  ///< that the model states
  double face_error_mm = 0.0;  ///< how far plane faces may be off: those of a mesh, for rounding
};

}  // namespace g31::parts

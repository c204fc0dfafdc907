#pragma once

#include <optional>
#include <string>
#include <vector>

#include "machine/base/result.h"
#include "parts/features/drawn_dimension.h"
#include "parts/features/removed_volume.h"
#include "parts/geometry/goes_on.h"

namespace g31::parts {

/// What a product is cut from.  With neither: the box around the product.
struct StockChoice {
  std::string file;  ///< STEP or a mesh
  /// A block of these sizes, mm, centred on the product's box in X and Y, standing on its lower
  /// face.
  std::optional<Point> block_mm;
};

/// Stock less product.
struct Removal {
  Box product_P;
  Box stock_P;
  std::vector<RemovedVolume> volumes;
  std::vector<DrawnDimension> dimensions;  ///< that the product's file states (AP242)
};

/// More faces of product or stock are refused.
inline constexpr int kMostFaces = 20'000;
/// Longer products are refused.
inline constexpr double kLongestPartMm = 1e4;

/// Cuts a product out of its stock, by Open CASCADE, in a process of its own (work_apart.h), and
/// divides what is removed into connected pieces, each piece at its highest floor, and so on.  Of a
/// stock that is wider than the product what is beside the product's box comes first, by itself.
/// Round walls of a mesh are found (faceted_walls.h).
/// @param product  a STEP file of one or more bodies, else a mesh file of one closed surface
///
/// Accuracy: 1e-6 mm.
/// @throws BrokenOff  as goes_on says
/// Error: one line with the file: not read, no solid, too many faces, too long, the product is
/// outside of the stock (by how much, on which side), Open CASCADE cannot cut them.
Result<Removal, std::string> removal_of(const std::string& product, const StockChoice& stock,
                                        const GoesOn& goes_on = {});

}  // namespace g31::parts

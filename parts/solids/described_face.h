#pragma once

#include <memory>
#include <vector>

#include <BRepClass3d_SolidClassifier.hxx>
#include <Bnd_Box.hxx>
#include <IntTools_Context.hxx>
#include <TopoDS_Face.hxx>
#include <TopoDS_Shape.hxx>

#include "parts/features/removed_volume.h"

// A file of the module g31_step; functions throw what Open CASCADE throws.

namespace g31::parts {

/// Tells faces of removed volumes of one product as plain data.
class FaceDescriber {
 public:
  /// @param product  its solids
  explicit FaceDescriber(const TopoDS_Shape& product);

  [[nodiscard]] RemovedFace described(const TopoDS_Face& face);

 private:
  [[nodiscard]] bool is_on_product(const Point& p_P) const;

  struct ProductFace {
    TopoDS_Face face;
    Bnd_Box box;
  };

  std::vector<std::unique_ptr<BRepClass3d_SolidClassifier>> solids_;
  std::vector<ProductFace> faces_;  ///< of the product
  Handle(IntTools_Context) context_;
};

}  // namespace g31::parts

// Stock less product, in the module g31_step.

#include "parts/solids/removal_module.h"

#include <algorithm>
#include <cmath>
#include <exception>
#include <optional>
#include <utility>

#include <BRepAlgoAPI_Common.hxx>
#include <BRepAlgoAPI_Cut.hxx>
#include <BRepAlgoAPI_Splitter.hxx>
#include <BRepBuilderAPI_MakeFace.hxx>
#include <BRepGProp.hxx>
#include <BRepPrimAPI_MakeBox.hxx>
#include <GProp_GProps.hxx>
#include <Standard_Failure.hxx>
#include <TopExp_Explorer.hxx>
#include <TopTools_ListOfShape.hxx>
#include <TopoDS.hxx>
#include <fmt/format.h>
#include <gp_Pln.hxx>

#include "parts/features/recognise.h"
#include "parts/solids/described_face.h"
#include "parts/solids/solid_shape.h"

namespace g31::parts {
namespace {

constexpr double kSameHeightMm = 1e-6;
constexpr double kLeastVolumeMm3 = 1e-6;

TopTools_ListOfShape solids_in(const TopoDS_Shape& shape) {
  TopTools_ListOfShape solids;
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) {
    solids.Append(each.Current());
  }
  return solids;
}

Result<TopoDS_Shape, std::string> stock_shape(const RemovalRequest& request, const Box& product_P) {
  if (request.stock) {
    const auto stock = solids_of(*request.stock);
    return stock ? Result<TopoDS_Shape, std::string>(stock.value().shape) : stock.error();
  }
  Box stock_P = product_P;
  if (request.block_mm) {
    const Point& size = *request.block_mm;
    if (!(size.minCoeff() > 0.0)) {
      return std::string("the sizes of the stock are not all above 0");
    }
    const Point middle = (product_P.min + product_P.max) / 2;
    stock_P.min = {middle.x() - size.x() / 2, middle.y() - size.y() / 2, product_P.min.z()};
    stock_P.max = stock_P.min + size;
  }
  const Point& a = stock_P.min;
  const Point& b = stock_P.max;
  return TopoDS_Shape(
      BRepPrimAPI_MakeBox(gp_Pnt(a.x(), a.y(), a.z()), gp_Pnt(b.x(), b.y(), b.z())).Shape());
}

/// By how much the product is outside of the stock; "": it is not.
/// @param same_mm  counts for nothing
std::string outside(const Box& product_P, const Box& stock_P, double same_mm) {
  constexpr const char* kAxes[] = {"X", "Y", "Z"};
  for (int axis = 0; axis < 3; ++axis) {
    const double minus = stock_P.min[axis] - product_P.min[axis];
    const double plus = product_P.max[axis] - stock_P.max[axis];
    if (std::max(minus, plus) > same_mm) {
      return fmt::format(
          "the product is {:.6g} mm outside of the stock on its {}{} side; both files have one "
          "coordinate system, and the stock is the larger one",
          std::max(minus, plus), plus > minus ? '+' : '-', kAxes[axis]);
    }
  }
  return {};
}

class Remover {
 public:
  /// @param same_mm  planes of the two that are not farther apart are one: those of rounded meshes
  /// @param describer  of the product; outlives this
  Remover(const TopoDS_Shape& product, const TopoDS_Shape& stock, const Removal& boxes,
          double same_mm, FaceDescriber& describer)
      : product_(product),
        stock_(stock),
        product_P_(boxes.product_P),
        stock_P_(boxes.stock_P),
        same_mm_(same_mm),
        describer_(describer) {}

  /// @returns why it cannot be done
  std::string remove(std::vector<RemovedVolume>& volumes) {
    TopTools_ListOfShape stock = solids_in(stock_);
    TopTools_ListOfShape product = solids_in(product_);
    BRepAlgoAPI_Cut cut;
    cut.SetArguments(stock);
    cut.SetTools(product);
    cut.SetFuzzyValue(same_mm_);
    cut.Build();
    if (cut.HasErrors() || !cut.IsDone()) {
      return "Open CASCADE cannot cut the product out of the stock; is one of them no clean solid?";
    }
    for (const TopoDS_Shape& solid : solids_in(within_sides(cut.Shape(), volumes))) {
      add_layers(solid, volumes);
    }
    return {};
  }

 private:
  /// What of the removed solids is within the product's box, seen from above.
  /// @param volumes  gets what is beside it
  TopoDS_Shape within_sides(const TopoDS_Shape& removed, std::vector<RemovedVolume>& volumes) {
    const Point over = (stock_P_.max - product_P_.max).cwiseMax(product_P_.min - stock_P_.min);
    if (std::max(over.x(), over.y()) < kSameHeightMm) {
      return removed;
    }
    const Point& a = product_P_.min;
    const Point& b = product_P_.max;
    const TopoDS_Shape sides = BRepPrimAPI_MakeBox(gp_Pnt(a.x(), a.y(), stock_P_.min.z() - 1.0),
                                                   gp_Pnt(b.x(), b.y(), stock_P_.max.z() + 1.0))
                                   .Shape();
    const TopoDS_Shape within = BRepAlgoAPI_Common(removed, sides).Shape();
    const TopoDS_Shape beside = BRepAlgoAPI_Cut(removed, sides).Shape();
    constexpr double kShareOfVolume = 1e-6;
    const double whole = volume_of(removed);
    if (std::abs(volume_of(within) + volume_of(beside) - whole) > kShareOfVolume * whole) {
      return removed;  // they are not what they should be
    }
    for (const TopoDS_Shape& solid : solids_in(beside)) {
      RemovedVolume volume = described(solid);
      volume.is_beside = true;
      volumes.push_back(std::move(volume));
    }
    return within;
  }

  static double volume_of(const TopoDS_Shape& shape) {
    GProp_GProps properties;
    BRepGProp::VolumeProperties(shape, properties);
    return properties.Mass();
  }

  /// Divides a solid at its highest floor, and what is above and below that in the same way: one
  /// pocket's floor does not divide another one.
  void add_layers(const TopoDS_Shape& solid, std::vector<RemovedVolume>& volumes) {
    RemovedVolume whole = described(solid);
    if (whole.volume_mm3 < kLeastVolumeMm3) {
      return;
    }
    const auto height = highest_floor_within(whole);
    if (!height) {
      volumes.push_back(std::move(whole));
      return;
    }
    TopTools_ListOfShape pieces;
    pieces.Append(solid);
    TopTools_ListOfShape planes;
    planes.Append(level_face(whole.box_P, *height));
    BRepAlgoAPI_Splitter splitter;
    splitter.SetArguments(pieces);
    splitter.SetTools(planes);
    splitter.Build();
    TopTools_ListOfShape layers = solids_in(splitter.Shape());
    if (layers.Extent() < 2) {  // it does not take the plane
      volumes.push_back(std::move(whole));
      return;
    }
    for (const TopoDS_Shape& layer : layers) {
      add_layers(layer, volumes);
    }
  }

  /// A level face larger than a box.
  static TopoDS_Shape level_face(const Box& box, double z) {
    constexpr double kLargerMm = 10.0;
    const Point middle = (box.min + box.max) / 2;
    const Point half = (box.max - box.min) / 2 + Point::Constant(kLargerMm);
    const gp_Pln plane(gp_Pnt(middle.x(), middle.y(), z), gp_Dir(0.0, 0.0, 1.0));
    return BRepBuilderAPI_MakeFace(plane, -half.x(), half.x(), -half.y(), half.y()).Face();
  }

  RemovedVolume described(const TopoDS_Shape& solid) {
    RemovedVolume volume;
    volume.volume_mm3 = volume_of(solid);
    volume.box_P = box_around(solid);
    for (TopExp_Explorer each(solid, TopAbs_FACE); each.More(); each.Next()) {
      volume.faces.push_back(describer_.described(TopoDS::Face(each.Current())));
    }
    return volume;
  }

  /// The highest floor below which the volume goes on.
  static std::optional<double> highest_floor_within(const RemovedVolume& volume) {
    std::optional<double> highest;
    for (const RemovedFace& face : volume.faces) {
      const double z = face.at_P.z();
      const bool is_floor =
          !face.is_open && face.surface == FaceSurface::Plane && face.normal_P.z() < -1.0 + 1e-12;
      if (is_floor && z > volume.box_P.min.z() + kSameHeightMm && z > highest.value_or(z - 1.0)) {
        highest = z;
      }
    }
    return highest;
  }

  TopoDS_Shape product_;
  TopoDS_Shape stock_;
  Box product_P_;
  Box stock_P_;
  double same_mm_;
  FaceDescriber& describer_;
};

/// What the file says of sizes, with its faces as plain data.
std::vector<DrawnDimension> drawn(const SourceSolids& product, FaceDescriber& describer) {
  std::vector<DrawnDimension> dimensions;
  for (const StepDimension& step : product.dimensions) {
    DrawnDimension dimension{step.nominal_mm, step.lower_mm, step.upper_mm, {}};
    for (const TopoDS_Face& face : step.faces) {
      dimension.faces.push_back(describer.described(face));
    }
    dimensions.push_back(std::move(dimension));
  }
  return dimensions;
}

/// @returns why it cannot be done
std::string remove(const RemovalRequest& request, Removal& removal) {
  const auto product = solids_of(request.product);
  if (!product) {
    return product.error();
  }
  removal.product_P = box_around(product.value().shape);
  const double longest = (removal.product_P.max - removal.product_P.min).maxCoeff();
  if (!(longest <= kLongestPartMm)) {
    return fmt::format(
        "{}: the product is {:.6g} mm long; one of up to {:g} mm can be planned; is its unit "
        "right?",
        request.product.name, longest, kLongestPartMm);
  }
  const auto stock = stock_shape(request, removal.product_P);
  if (!stock) {
    return stock.error();
  }
  removal.stock_P = box_around(stock.value());
  const double rounding =
      request.product.mesh.rounding_mm + (request.stock ? request.stock->mesh.rounding_mm : 0.0);
  if (auto why = outside(removal.product_P, removal.stock_P, kSameHeightMm + rounding);
      !why.empty()) {
    return why;
  }
  FaceDescriber describer(product.value().shape);
  removal.dimensions = drawn(product.value(), describer);
  return Remover(product.value().shape, stock.value(), removal, kFaceErrorInRoundings * rounding,
                 describer)
      .remove(removal.volumes);
}

}  // namespace
}  // namespace g31::parts

bool g31_remove(const g31::parts::RemovalRequest* request, g31::parts::Removal* removal,
                std::string* error) {
  try {
    g31::parts::Removal found;
    *error = g31::parts::remove(*request, found);
    if (error->empty()) {
      *removal = std::move(found);
      return true;
    }
  } catch (const Standard_Failure& failure) {
    *error = request->product.name + ": Open CASCADE cannot work with it (" +
             failure.GetMessageString() + ")";
  } catch (const std::exception& failure) {
    *error = request->product.name + ": Open CASCADE cannot work with it (" + failure.what() + ")";
  }
  return false;
}

#include "parts/import/step_shape.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <span>
#include <string>
#include <string_view>

#include <BRep_Builder.hxx>
#include <BRep_Tool.hxx>
#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <StepData_StepModel.hxx>
#include <StepGeom_Direction.hxx>
#include <TColStd_HArray1OfReal.hxx>
#include <TopExp_Explorer.hxx>
#include <fmt/format.h>

namespace g31::parts {
namespace {

bool begins_with_one_of(std::string_view type, std::span<const std::string_view> beginnings) {
  return std::ranges::any_of(
      beginnings, [type](std::string_view beginning) { return type.starts_with(beginning); });
}

/// Whether Open CASCADE follows what entities of this type name without asking whether it is there.
bool is_followed(std::string_view type) {
  constexpr std::array<std::string_view, 3> kPackages = {"StepGeom_", "StepShape_", "StepRepr_"};
  return begins_with_one_of(type, kPackages);
}

/// Whether a body may be another one where such an entity does not fit its schema.  Properties,
/// dimensions and what a drawing shows are none of it, and many systems write them otherwise.
bool shapes_bodies(std::string_view type) {
  constexpr std::array<std::string_view, 9> kDimensions = {
      "StepShape_Dimensional", "StepShape_Directed",  "StepShape_PlusMinus",
      "StepShape_Tolerance",   "StepShape_Limits",    "StepShape_Angular",
      "StepShape_Measure",     "StepShape_Qualified", "StepShape_ValueFormat"};
  constexpr std::array<std::string_view, 5> kPlacing = {
      "StepRepr_ItemDefined", "StepRepr_MappedItem", "StepRepr_RepresentationMap",
      "StepRepr_RepresentationRelationship", "StepRepr_ShapeRepresentationRelationship"};
  return type.starts_with("StepGeom_") || begins_with_one_of(type, kPlacing) ||
         (type.starts_with("StepShape_") && !begins_with_one_of(type, kDimensions));
}

/// Whether what Open CASCADE says of an entity is no fault of a body: a name that is left out, or
/// an item of a drawing among those of a representation.
bool is_harmless(std::string_view fail) {
  return fail.find("name) not a quoted String") != fail.npos ||
         fail.find("description) ") != fail.npos ||
         (fail.find("representation_item)") != fail.npos &&
          fail.find("Entity has illegal type") != fail.npos);
}

bool is_faulty(std::string_view type, const Handle(Interface_Check) & check) {
  bool has_fault = false;
  for (int i = 1; i <= check->NbFails(); ++i) {
    const std::string_view fail = check->CFail(i);
    if (fail.find("reference to another entity is unresolved") != fail.npos) {
      return true;
    }
    has_fault = has_fault || !is_harmless(fail);
  }
  return has_fault && shapes_bodies(type);
}

/// What is wrong with the entities of a file that was read; "": nothing.
std::string faults_of(const Handle(StepData_StepModel) & model) {
  int faults = 0;
  int first = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (!model->IsErrorEntity(i)) {
      continue;
    }
    const std::string_view type = model->Value(i)->DynamicType()->Name();
    if (is_followed(type) && is_faulty(type, model->ReportEntity(i)->Check())) {
      first = faults++ == 0 ? model->IdentLabel(model->Value(i)) : first;
    }
  }
  return faults == 0 ? ""
                     : fmt::format(
                           "{} of its entities name others that are not there or do "
                           "not fit, first #{}; expected a whole STEP file",
                           faults, first);
}

/// Puts directions that miss an axis by the noise of floats onto it.  Open CASCADE leaves holes in
/// a cone whose seam line has such a direction, and some systems write it of each countersink.
/// What it moves is 1e-9 mm at 1 m.
void straighten_directions(const Handle(StepData_StepModel) & model) {
  constexpr double kNoise = 1e-12;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto direction = Handle(StepGeom_Direction)::DownCast(model->Value(i));
    if (direction.IsNull() || direction->DirectionRatios().IsNull()) {
      continue;
    }
    TColStd_Array1OfReal& ratios = direction->DirectionRatios()->ChangeArray1();
    double longest = 0.0;
    for (const double ratio : ratios) {
      longest = std::max(longest, std::abs(ratio));
    }
    for (double& ratio : ratios) {
      ratio = std::abs(ratio) <= kNoise * longest ? 0.0 : ratio;
    }
  }
}

}  // namespace

Result<TopoDS_Shape, std::string> read_step_shape(const std::string& path,
                                                  STEPControl_Reader& reader) {
  // Open CASCADE reports on standard output, where a program's own output goes.
  Message::DefaultMessenger()->ChangePrinters().Clear();
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone) {
    return std::string("not understood as STEP; expected a whole file with at least one body");
  }
  if (std::string faults = faults_of(reader.StepModel()); !faults.empty()) {
    return faults;
  }
  straighten_directions(reader.StepModel());
  if (reader.TransferRoots() == 0) {
    return std::string("not understood as STEP; expected a whole file with at least one body");
  }
  return reader.OneShape();
}

TopoDS_Compound bodies_in(const TopoDS_Shape& shape) {
  TopoDS_Compound bodies;
  const BRep_Builder builder;
  const auto add = [&](const TopoDS_Shape& body) {
    if (bodies.IsNull()) {
      builder.MakeCompound(bodies);
    }
    builder.Add(bodies, body);
  };
  for (TopExp_Explorer each(shape, TopAbs_SOLID); each.More(); each.Next()) {
    add(each.Current());
  }
  for (TopExp_Explorer each(shape, TopAbs_SHELL, TopAbs_SOLID); each.More(); each.Next()) {
    if (BRep_Tool::IsClosed(each.Current())) {
      add(each.Current());
    }
  }
  return bodies;
}

}  // namespace g31::parts

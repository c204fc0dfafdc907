#include "parts/solids/step_dimensions.h"

#include <algorithm>
#include <map>
#include <string_view>

#include <STEPConstruct.hxx>
#include <STEPConstruct_UnitContext.hxx>
#include <StepAP242_GeometricItemSpecificUsage.hxx>
#include <StepAP242_ItemIdentifiedRepresentationUsageDefinition.hxx>
#include <StepBasic_MeasureWithUnit.hxx>
#include <StepBasic_NamedUnit.hxx>
#include <StepBasic_Unit.hxx>
#include <StepData_StepModel.hxx>
#include <StepRepr_HArray1OfRepresentationItem.hxx>
#include <StepRepr_MeasureRepresentationItem.hxx>
#include <StepRepr_ReprItemAndMeasureWithUnit.hxx>
#include <StepRepr_RepresentationItem.hxx>
#include <StepRepr_ShapeAspect.hxx>
#include <StepRepr_ShapeAspectRelationship.hxx>
#include <StepShape_DimensionalCharacteristic.hxx>
#include <StepShape_DimensionalCharacteristicRepresentation.hxx>
#include <StepShape_DimensionalLocation.hxx>
#include <StepShape_DimensionalSize.hxx>
#include <StepShape_PlusMinusTolerance.hxx>
#include <StepShape_ShapeDimensionRepresentation.hxx>
#include <StepShape_ToleranceMethodDefinition.hxx>
#include <StepShape_ToleranceValue.hxx>
#include <TopoDS.hxx>
#include <TopoDS_Shape.hxx>
#include <Transfer_TransientProcess.hxx>
#include <XSControl_TransferReader.hxx>
#include <XSControl_WorkSession.hxx>

namespace g31::parts {
namespace {

using Entity = Handle(Standard_Transient);

/// In mm; nullopt: no length.
std::optional<double> length_of(const Handle(StepBasic_MeasureWithUnit) & measure) {
  if (measure.IsNull()) {
    return std::nullopt;
  }
  const Handle(StepBasic_NamedUnit) unit = measure->UnitComponent().NamedUnit();
  STEPConstruct_UnitContext context;
  if (unit.IsNull()) {
    return std::nullopt;
  }
  context.ComputeFactors(unit);
  return context.LengthDone() ? std::optional(measure->ValueComponent() * context.LengthFactor())
                              : std::nullopt;
}

Handle(StepBasic_MeasureWithUnit) measure_in(const Entity& item) {
  if (const auto whole = Handle(StepRepr_ReprItemAndMeasureWithUnit)::DownCast(item);
      !whole.IsNull()) {
    return whole->GetMeasureWithUnit();
  }
  const auto simple = Handle(StepRepr_MeasureRepresentationItem)::DownCast(item);
  return simple.IsNull() ? Handle(StepBasic_MeasureWithUnit)() : simple->Measure();
}

/// The lengths of a representation by their names: a value alone, or beside it its limits, "upper
/// limit" and "lower limit" (ISO 10303-47), of which the nominal value without one is the mean.
/// @returns false: there is no length, or another number of values
bool take_values(const Handle(StepShape_ShapeDimensionRepresentation) & values,
                 StepDimension& dimension) {
  if (values.IsNull() || values->Items().IsNull()) {
    return false;
  }
  std::optional<double> nominal;
  std::optional<double> lower;
  std::optional<double> upper;
  for (int i = 1; i <= values->NbItems(); ++i) {
    const Handle(StepRepr_RepresentationItem) item = values->ItemsValue(i);
    const bool is_named = !item.IsNull() && !item->Name().IsNull();
    const std::string_view name = is_named ? item->Name()->ToCString() : "";
    std::optional<double>& value = name == "upper limit"   ? upper
                                   : name == "lower limit" ? lower
                                                           : nominal;
    const auto length = length_of(measure_in(item));
    if (value || !length) {
      return false;
    }
    value = length;
  }
  if (upper.has_value() != lower.has_value() || (upper && *lower > *upper)) {
    return false;
  }
  if (upper) {
    nominal = nominal.value_or(0.5 * (*lower + *upper));
    dimension.lower_mm = *lower - *nominal;
    dimension.upper_mm = *upper - *nominal;
  }
  dimension.nominal_mm = nominal.value_or(0.0);
  return nominal.has_value();
}

bool is_radius(const Handle(StepShape_DimensionalSize) & size) {
  const std::string_view name = size->Name().IsNull() ? "" : size->Name()->ToCString();
  return name.find("radius") != name.npos;
}

class DimensionReader {
 public:
  explicit DimensionReader(const STEPControl_Reader& reader)
      : model_(reader.StepModel()),
        transferred_(reader.WS()->TransferReader()->TransientProcess()) {
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      note_faces(model_->Value(i));
      note_members(model_->Value(i));
      note_tolerance(model_->Value(i));
    }
  }

  std::vector<StepDimension> dimensions() {
    std::vector<StepDimension> found;
    for (int i = 1; i <= model_->NbEntities(); ++i) {
      const auto entity =
          Handle(StepShape_DimensionalCharacteristicRepresentation)::DownCast(model_->Value(i));
      if (entity.IsNull()) {
        continue;
      }
      const Entity what = entity->Dimension().Value();
      StepDimension dimension;
      dimension.faces = faces_of(what);
      if (dimension.faces.empty() || !take_values(entity->Representation(), dimension)) {
        continue;
      }
      take_tolerance(what, dimension);
      found.push_back(std::move(dimension));
    }
    return found;
  }

 private:
  void note_faces(const Entity& entity) {
    const auto usage = Handle(StepAP242_GeometricItemSpecificUsage)::DownCast(entity);
    if (usage.IsNull() || usage->IdentifiedItem().IsNull()) {
      return;
    }
    const Handle(StepRepr_ShapeAspect) aspect = usage->Definition().ShapeAspect();
    for (int i = 1; !aspect.IsNull() && i <= usage->NbIdentifiedItem(); ++i) {
      const TopoDS_Shape shape =
          STEPConstruct::FindShape(transferred_, usage->IdentifiedItemValue(i));
      if (!shape.IsNull() && shape.ShapeType() == TopAbs_FACE) {
        faces_[aspect.get()].push_back(TopoDS::Face(shape));
      }
    }
  }

  /// A hole that is drawn as two halves is a composite of theirs, to which its diameter applies.
  void note_members(const Entity& entity) {
    const bool is_plain = !entity.IsNull() &&
                          entity->DynamicType() == STANDARD_TYPE(StepRepr_ShapeAspectRelationship);
    const auto relation = Handle(StepRepr_ShapeAspectRelationship)::DownCast(entity);
    if (!is_plain || relation->RelatingShapeAspect().IsNull() ||
        relation->RelatedShapeAspect().IsNull()) {
      return;
    }
    members_[relation->RelatingShapeAspect().get()].push_back(relation->RelatedShapeAspect().get());
  }

  void note_tolerance(const Entity& entity) {
    const auto tolerance = Handle(StepShape_PlusMinusTolerance)::DownCast(entity);
    if (tolerance.IsNull()) {
      return;
    }
    const Handle(StepShape_ToleranceValue) value = tolerance->Range().ToleranceValue();
    const Entity what = tolerance->TolerancedDimension().Value();
    if (!value.IsNull() && !what.IsNull()) {
      tolerances_[what.get()] = value;
    }
  }

  void take_tolerance(const Entity& what, StepDimension& dimension) const {
    const auto found = tolerances_.find(what.get());
    if (found == tolerances_.end()) {
      return;
    }
    const auto bound = [](const Entity& value) {
      const auto measure = Handle(StepBasic_MeasureWithUnit)::DownCast(value);
      return length_of(measure.IsNull() ? measure_in(value) : measure);
    };
    const auto lower = bound(found->second->LowerBound());
    const auto upper = bound(found->second->UpperBound());
    if (lower && upper && *lower <= *upper) {
      dimension.lower_mm = lower;
      dimension.upper_mm = upper;
    }
  }

  [[nodiscard]] std::vector<TopoDS_Face> faces_of(const Entity& what) const {
    std::vector<TopoDS_Face> faces;
    const auto add_own = [&](const StepRepr_ShapeAspect* aspect) {
      const auto found = faces_.find(aspect);
      if (found != faces_.end()) {
        faces.insert(faces.end(), found->second.begin(), found->second.end());
      }
      return found != faces_.end();
    };
    const auto add = [&](const Handle(StepRepr_ShapeAspect) & aspect) {
      const auto members = members_.find(aspect.get());
      if (!add_own(aspect.get()) && members != members_.end()) {
        std::ranges::for_each(members->second, add_own);
      }
    };
    if (const auto size = Handle(StepShape_DimensionalSize)::DownCast(what);
        !size.IsNull() && !is_radius(size)) {
      add(size->AppliesTo());
    }
    if (const auto location = Handle(StepShape_DimensionalLocation)::DownCast(what);
        !location.IsNull()) {
      add(location->RelatingShapeAspect());
      add(location->RelatedShapeAspect());
    }
    return faces;
  }

  Handle(StepData_StepModel) model_;
  Handle(Transfer_TransientProcess) transferred_;
  std::map<const StepRepr_ShapeAspect*, std::vector<TopoDS_Face>> faces_;
  std::map<const StepRepr_ShapeAspect*, std::vector<const StepRepr_ShapeAspect*>> members_;
  std::map<const Standard_Transient*, Handle(StepShape_ToleranceValue)> tolerances_;
};

}  // namespace

std::vector<StepDimension> dimensions_of(const STEPControl_Reader& reader) {
  return DimensionReader(reader).dimensions();
}

}  // namespace g31::parts

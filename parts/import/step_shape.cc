#include "parts/import/step_shape.h"

#include <algorithm>
#include <array>
#include <string>
#include <string_view>

#include <Interface_Check.hxx>
#include <Interface_ReportEntity.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <StepData_StepModel.hxx>
#include <fmt/format.h>

namespace g31::parts {
namespace {

/// Whether an entity describes geometry: Open CASCADE follows what such ones name without asking
/// whether it is there.
bool is_geometry(const Handle(Standard_Transient) & entity) {
  constexpr std::array<std::string_view, 3> kPackages = {"StepGeom_", "StepShape_", "StepRepr_"};
  const std::string_view type = entity->DynamicType()->Name();
  return std::ranges::any_of(
      kPackages, [type](std::string_view package) { return type.starts_with(package); });
}

/// What is wrong with the entities of a file that was read; "": nothing.
std::string faults_of(const Handle(StepData_StepModel) & model) {
  int faults = 0;
  int first = 0;
  for (int i = 1; i <= model->NbEntities(); ++i) {
    if (model->IsErrorEntity(i) && is_geometry(model->Value(i))) {
      first = faults++ == 0 ? model->IdentLabel(model->Value(i)) : first;
    }
  }
  return faults == 0 ? ""
                     : fmt::format(
                           "{} of its entities name others that are not there or do "
                           "not fit, first #{}; expected a whole STEP file",
                           faults, first);
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
  if (reader.TransferRoots() == 0) {
    return std::string("not understood as STEP; expected a whole file with at least one body");
  }
  return reader.OneShape();
}

}  // namespace g31::parts

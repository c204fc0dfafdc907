#include "tests/solids/step_text.h"

#include <stdexcept>
#include <string>

#include <APIHeaderSection_MakeHeader.hxx>
#include <Interface_HArray1OfHAsciiString.hxx>
#include <Interface_Static.hxx>
#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Controller.hxx>
#include <STEPControl_Writer.hxx>
#include <StepBasic_Product.hxx>
#include <StepData_StepModel.hxx>
#include <TCollection_HAsciiString.hxx>

namespace g31::testing {
namespace {

Handle(TCollection_HAsciiString) step_string(const std::string& text) {
  return new TCollection_HAsciiString(text.c_str());
}

/// Its own would say when it was written, by whom and with what.
void write_head(const Handle(StepData_StepModel) & model, const std::string& name) {
  APIHeaderSection_MakeHeader head(model);
  head.SetName(step_string(name));
  head.SetTimeStamp(step_string(""));
  head.SetAuthorValue(1, step_string(""));
  head.SetOrganizationValue(1, step_string(""));
  head.SetPreprocessorVersion(step_string(""));
  head.SetOriginatingSystem(step_string(""));
  head.SetAuthorisation(step_string(""));
  head.SetDescriptionValue(1, step_string(name));
}

/// Its own counts the products that the program has written.
void name_products(const Handle(StepData_StepModel) & model, const std::string& name) {
  for (int i = 1; i <= model->NbEntities(); ++i) {
    const auto product = Handle(StepBasic_Product)::DownCast(model->Value(i));
    if (!product.IsNull()) {
      product->SetId(step_string(name));
      product->SetName(step_string(name));
    }
  }
}

}  // namespace

void write_step(const TopoDS_Shape& shape, const std::string& name, const std::string& path,
                const std::string& unit) {
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Controller::Init();
  Interface_Static::SetCVal("write.step.unit", unit.c_str());
  // Curves on surfaces say nothing that the curves in space do not.
  Interface_Static::SetIVal("write.surfacecurve.mode", 0);
  STEPControl_Writer writer;
  if (writer.Transfer(shape, STEPControl_AsIs) != IFSelect_RetDone) {
    throw std::runtime_error("the shape is not written as STEP");
  }
  name_products(writer.Model(), name);
  write_head(writer.Model(), name);
  if (writer.Write(path.c_str()) != IFSelect_RetDone) {
    throw std::runtime_error(path + " is not written");
  }
}

}  // namespace g31::testing

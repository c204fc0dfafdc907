#include "parts/import/step_shape.h"

#include <string>

#include <Message.hxx>
#include <Message_Messenger.hxx>
#include <STEPControl_Reader.hxx>

namespace g31::parts {

Result<TopoDS_Shape, std::string> read_step_shape(const std::string& path) {
  // Open CASCADE reports on standard output, where a program's own output goes.
  Message::DefaultMessenger()->ChangePrinters().Clear();
  STEPControl_Reader reader;
  if (reader.ReadFile(path.c_str()) != IFSelect_RetDone || reader.TransferRoots() == 0) {
    return std::string("not understood as STEP; expected a whole file with at least one body");
  }
  return reader.OneShape();
}

}  // namespace g31::parts

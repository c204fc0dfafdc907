#include "parts/import/step_library.h"

namespace g31::parts {

ModuleFunction find_in_step_library(const std::string& name) {
  ModuleFunction function = find_in_module("g31_step.so", name);
  if (function.address == nullptr) {
    function.why_not = "the module that reads STEP cannot be loaded (" + function.why_not +
                       "); install libocct-data-exchange-7.6, where g31 was built without it "
                       "libocct-data-exchange-dev and build again";
  }
  return function;
}

}  // namespace g31::parts

#include "parts/import/step_library.h"

namespace g31::parts {

ModuleFunction find_in_step_library(const std::string& name) {
  return find_in_module(
      {.file = "g31_step.so",
       .does = "reads STEP",
       .package = "libocct-data-exchange-7.6",
       .when_missing = "it is a part of g31: install g31 again, where it was built without "
                       "libocct-data-exchange-dev install that and build it again"},
      name);
}

}  // namespace g31::parts

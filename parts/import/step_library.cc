#include "parts/import/step_library.h"

#include <string>

#include <dlfcn.h>

namespace g31::parts {
namespace {

struct Loaded {
  void* library = nullptr;
  std::string why_not;
};

std::string last_error_or(const std::string& text) {
  const char* const why = dlerror();
  return why != nullptr ? why : text;
}

Loaded load() {
  // Looked for along the program's run path: beside it in a build, in lib/g31 once installed.
  void* const library = dlopen("g31_step.so", RTLD_NOW | RTLD_LOCAL);
  return {library, library != nullptr ? "" : last_error_or("it cannot be loaded")};
}

}  // namespace

StepFunction find_in_step_library(const char* name) {
  static const Loaded module = load();
  std::string why_not = module.why_not;
  if (module.library != nullptr) {
    if (void* const address = dlsym(module.library, name); address != nullptr) {
      return {address, ""};
    }
    why_not = last_error_or("it has no " + std::string(name));
  }
  return {nullptr, "the module that reads STEP cannot be loaded (" + why_not +
                       "); install libocct-data-exchange-7.6, where g31 was built without it "
                       "libocct-data-exchange-dev and build again"};
}

}  // namespace g31::parts

#include "machine/base/module.h"

#include <dlfcn.h>

namespace g31 {
namespace {

ModuleFunction what_was_wrong(const std::string& otherwise) {
  const char* const why = dlerror();
  return {nullptr, why != nullptr ? why : otherwise};
}

}  // namespace

ModuleFunction find_in_module(const std::string& module, const std::string& function) {
  // Looked for along the program's run path: beside it in a build, in lib/g31 once installed.  The
  // system counts how often it is opened, and keeps it.
  void* const library = dlopen(module.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return what_was_wrong("it cannot be loaded");
  }
  void* const address = dlsym(library, function.c_str());
  return address != nullptr ? ModuleFunction{address, ""} : what_was_wrong("it has no " + function);
}

}  // namespace g31

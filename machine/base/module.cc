#include "machine/base/module.h"

#include <dlfcn.h>

namespace g31 {
namespace {

ModuleFunction not_found(const Module& module, const std::string& otherwise) {
  const char* const told = dlerror();
  const std::string message = told != nullptr ? told : otherwise;
  return {nullptr, "the module that " + module.does + " cannot be loaded (" + message + "); " +
                       what_helps(module, message)};
}

}  // namespace

std::string what_helps(const Module& module, std::string_view message) {
  const bool is_its_own = message.find(module.file) != std::string_view::npos;
  return is_its_own ? module.when_missing : "install " + module.package;
}

ModuleFunction find_in_module(const Module& module, const std::string& function) {
  // Looked for along the program's run path: beside it in a build, in lib/g31 once installed.  The
  // system counts how often it is opened, and keeps it.
  void* const library = dlopen(module.file.c_str(), RTLD_NOW | RTLD_LOCAL);
  if (library == nullptr) {
    return not_found(module, module.file + " cannot be opened");
  }
  void* const address = dlsym(library, function.c_str());
  return address != nullptr ? ModuleFunction{address, ""}
                            : not_found(module, module.file + " has no " + function);
}

}  // namespace g31

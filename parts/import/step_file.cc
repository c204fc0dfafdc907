#include "parts/import/step_file.h"

#include <string>

#include <dlfcn.h>

#include "parts/import/step_module.h"

namespace g31::parts {
namespace {

/// The module, once it is asked for; it stays to the end of the program, as Open CASCADE wants it.
struct StepModule {
  decltype(&g31_read_step) read = nullptr;
  std::string why_not;
};

StepModule load_step_module() {
  StepModule module;
  // Looked for along the program's run path: beside it in a build, in lib/g31 once installed.
  void* const library = dlopen("g31_step.so", RTLD_NOW | RTLD_LOCAL);
  void* const symbol = library != nullptr ? dlsym(library, "g31_read_step") : nullptr;
  if (symbol == nullptr) {
    const char* const why = dlerror();
    module.why_not = why != nullptr ? why : "it has no g31_read_step";
    return module;
  }
  module.read = reinterpret_cast<decltype(module.read)>(symbol);
  return module;
}

const StepModule& step_module() {
  static const StepModule module = load_step_module();
  return module;
}

}  // namespace

bool can_read_step() {
  return step_module().read != nullptr;
}

Result<Mesh, std::string> read_step_file(const std::string& path, double sagitta_mm) {
  if (!can_read_step()) {
    return "the module that reads STEP cannot be loaded (" + step_module().why_not +
           "); install libocct-data-exchange-7.6, where g31 was built without it "
           "libocct-data-exchange-dev and build again, or save the part as STL, OBJ, PLY or 3MF";
  }
  Mesh mesh;
  std::string error;
  if (!step_module().read(path.c_str(), sagitta_mm, &mesh, &error)) {
    return error;
  }
  return mesh;
}

}  // namespace g31::parts

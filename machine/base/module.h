#pragma once

#include <string>
#include <string_view>

namespace g31 {

/// A part of the program that is loaded at the first question, so that a run without it does not
/// wait for its libraries; it stays to the end.
///
/// Program and module come from one build, so they agree on the types of C++.
struct Module {
  std::string file;     ///< in the folder of modules: "g31_step.so"
  std::string does;     ///< "reads STEP"
  std::string package;  ///< of Debian, with the library that it brings
  /// What helps where the module itself is missing.
  std::string when_missing = "it is a part of g31: install g31 again";
};

/// A function of a module, or why there is none.
struct ModuleFunction {
  void* address = nullptr;  ///< of the function asked for; null: there is none
  std::string why_not;      ///< with what would help
};

ModuleFunction find_in_module(const Module& module, const std::string& function);

/// What helps where a module is not loaded: a message of the loader that names it is about itself,
/// any other about a library that it needs.
std::string what_helps(const Module& module, std::string_view message);

}  // namespace g31

#pragma once

#include <string>

namespace g31 {

/// A function of a module, or why there is none.
struct ModuleFunction {
  void* address = nullptr;  ///< of the function asked for; null: there is none
  std::string why_not;
};

/// Looks for a function of a module, that is a part of the program that is loaded at the first
/// question, so that a run without it does not wait for its libraries; it stays to the end.
///
/// Program and module come from one build, so they agree on the types of C++.
/// @param module  its file in the folder of modules: "g31_step.so"
ModuleFunction find_in_module(const std::string& module, const std::string& function);

}  // namespace g31

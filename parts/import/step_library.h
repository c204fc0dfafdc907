#pragma once

#include <string>

namespace g31::parts {

/// A function of the module g31_step, or why there is none.
struct StepFunction {
  void* address = nullptr;  ///< of the function asked for; null: there is none
  std::string why_not;      ///< what is wrong and what to install
};

/// Looks for a function of the module, which is loaded at the first question; it stays to the end
/// of the program, as Open CASCADE wants it.
StepFunction find_in_step_library(const char* name);

}  // namespace g31::parts

#pragma once

#include <string>
#include <vector>

#include "interpreter/runtime/reference.h"

namespace g31::sinumerik {

/// An entry under every name that a user may give it.
struct Topic {
  std::string name;
  std::string other;  ///< a number, say; empty: none
  runtime::Entry entry;
};

using Topics = std::vector<Topic>;

}  // namespace g31::sinumerik

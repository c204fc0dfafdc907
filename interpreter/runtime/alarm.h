#pragma once

#include <cstdint>
#include <string>
#include <vector>

#include "interpreter/source/location.h"

namespace g31::runtime {

/// One level of the NC call stack: which program called, and where.
struct CallSite {
  std::string program;  ///< "O6001"
  source::Location where;
};

/// Why the control stopped the program.
struct Alarm {
  int number = 0;    ///< as in the result document: without letters
  std::string text;  ///< what the control shows
  source::Location where;
  std::string detail;  ///< what exactly is wrong here; may be empty
  std::string remedy;  ///< what would be right; may be empty
  /// Programs behind the call at `where` that do not show their blocks: where each of them stood,
  /// the innermost first, which is where the alarm arose.
  std::vector<CallSite> inside;
  std::vector<CallSite> calls;  ///< innermost first
  std::uint64_t level = 0;      ///< CallLevel::number of the level that `where` is in
};

}  // namespace g31::runtime

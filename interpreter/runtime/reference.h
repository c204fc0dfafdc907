#pragma once

#include <string>
#include <vector>

namespace g31::runtime {

/// One line of an entry: "unit", "mm or inch".
struct Fact {
  std::string name;
  std::string value;
};

/// What the tables of a dialect say about one thing.
struct Entry {
  std::string kind;  ///< "system variable", "G code", "alarm", ...
  std::string name;  ///< "#5061", "G31", "112 DIVIDED BY ZERO"
  std::string text;
  std::vector<Fact> facts;
};

using Entries = std::vector<Entry>;

}  // namespace g31::runtime

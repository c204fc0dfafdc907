#pragma once

#include <map>
#include <string>
#include <string_view>
#include <vector>

#include "machine/base/result.h"
#include "tools/evaluate/evaluate.h"

namespace g31::evaluate {

/// What is asked for, in the words of a command line.
struct RequestWords {
  std::string kind;
  std::vector<std::string> columns = {};       ///< "X=x_act"
  std::string unit = {};                       ///< "" for mm
  std::string magnify = {};                    ///< "": so that errors are seen
  std::map<OptionId, std::string> given = {};  ///< options that only some kinds know
};

/// Of --unit.
std::vector<std::string> unit_names();

/// Error: which of the words is wrong, and what would be right, one line.
Result<Request, std::string> request_of(const RequestWords& words);

/// The words of a kind and a line such as "--radius 50 --centre 0,0".  Error: as above.
Result<RequestWords, std::string> request_words(const std::string& kind, std::string_view line);

}  // namespace g31::evaluate

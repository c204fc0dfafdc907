#pragma once

#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "interpreter/analysis/finding.h"
#include "interpreter/source/source_map.h"
#include "machine/base/result.h"

namespace g31::check {

/// Findings that were known before: those of an earlier document of `g31 check`.
class Baseline {
 public:
  /// @param name  of the document, for messages
  /// @returns what is wrong with the document: "FILE: finding 3 has no text `line_text`: ..."
  static Result<Baseline, std::string> read(const std::string& name, std::string_view text);

  /// The findings that are new: no earlier one has the same rule, the same file and the same text
  /// of the line, wherever the line is now.
  [[nodiscard]] std::vector<analysis::Finding> without_known(
      std::vector<analysis::Finding> found, const source::SourceMap& sources) const;

 private:
  using Key = std::tuple<std::string, std::string, std::string>;  ///< rule, file, text of the line

  std::set<Key> known_;
};

}  // namespace g31::check

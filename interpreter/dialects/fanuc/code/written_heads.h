#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/dialects/fanuc/vocabulary/program_key.h"

namespace g31::fanuc {

/// The program number that a file name says: optional O, digits, optional ending; none where the
/// ending is that of a sheet, a table, a document or a picture.
std::optional<int> number_in_file_name(std::string_view name);

/// Which numbers and names of programs a text may have, so that it need not be read again for the
/// others.
class WrittenHeads {
 public:
  /// @param text  of a file; JSON and HTML, as g31 itself leaves them beside programs, have none
  explicit WrittenHeads(std::string_view text);

  /// @returns false: no program of the text has this key
  [[nodiscard]] bool may_have(const ProgramKey& key) const;

 private:
  std::vector<int> numbers_;  ///< behind an O or a colon anywhere, sorted
  bool has_angles_ = false;   ///< so it may have names
};

}  // namespace g31::fanuc

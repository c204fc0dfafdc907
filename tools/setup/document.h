#pragma once

#include <cstddef>
#include <cstdint>
#include <memory>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "interpreter/source/line_starts.h"
#include "machine/base/result.h"

namespace g31::setup {

struct SetupError;
struct Node;

/// One `key = value`, or one table under its name.
struct Member;

using Array = std::vector<Node>;
using Table = std::vector<Member>;

/// A date or time of TOML; no key of a set-up sheet takes one.
struct DateOrTime {};

/// A value of a TOML document and where it stands.  Keeps the rest of the reader apart from the
/// TOML library, which is expensive to include.
struct Node {
  int line = 1;    ///< from 1
  int column = 1;  ///< from 1, in characters
  std::variant<bool, std::int64_t, double, std::string, DateOrTime, Array, Table> value;
};

struct Member {
  std::string key;
  int line = 1;  ///< of the key
  int column = 1;
  Node node;
};

/// A TOML file, read and taken apart.
struct Document {
  std::string path;       ///< as it was named
  std::size_t order = 0;  ///< the how-manieth file of the job
  std::string text = {};
  Table root = {};
  source::LineStarts lines{{}};  ///< of the text

  /// The text of a line without its line break; "" when there is no such line.
  [[nodiscard]] std::string_view line(int number) const;
};

/// A place in a document.  The document outlives the location.
struct Location {
  const Document* document = nullptr;
  int line = 0;
  int column = 0;
};

/// Reads a TOML file.
/// @returns the document, or the one error that stopped the reading: SET101 when the file cannot
///          be read or is larger than kLargestSheetBytes, SET102 when it is not TOML
Result<std::shared_ptr<const Document>, SetupError> read_document(const std::string& path,
                                                                  std::size_t order);

/// The same for a text that is already here; `path` is what errors call it.
Result<std::shared_ptr<const Document>, SetupError> parse_document(std::string path,
                                                                   std::string text,
                                                                   std::size_t order);

/// A set-up sheet is a page; what is larger is a mesh or a device named by mistake.
inline constexpr std::size_t kLargestSheetBytes = 16U << 20U;

}  // namespace g31::setup

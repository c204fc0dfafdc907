#pragma once

#include <functional>
#include <string>
#include <utility>

#include "parts/import/byte_stream.h"
#include "parts/import/work_apart.h"

namespace g31::parts {

/// What a process of its own made; see done_apart.
template <typename Made>
struct MadeApart {
  std::string why_not;  ///< how that process ended before it was done; "": it was
  std::string error;    ///< what the work found wrong; then `made` counts for nothing
  Made made;
};

/// @tparam Made  a function `pass` takes it through byte streams
/// @param make   returns what is wrong, or ""
/// @throws BrokenOff
template <typename Made>
MadeApart<Made> make_apart(const std::function<std::string(Made&)>& make,
                           const GoesOn& goes_on = {}) {
  MadeApart<Made> apart;
  WorkApart done = done_apart(
      [&] {
        apart.error = make(apart.made);
        ByteWriter writer;
        pass(writer, apart.error);
        pass(writer, apart.made);
        return std::move(writer).take();
      },
      goes_on);
  apart.why_not = std::move(done.why_not);
  if (apart.why_not.empty()) {
    ByteReader reader(done.bytes);
    pass(reader, apart.error);
    pass(reader, apart.made);
  }
  return apart;
}

}  // namespace g31::parts

#pragma once

#include <functional>
#include <string>
#include <utility>

#include "parts/import/byte_stream.h"
#include "parts/import/work_apart.h"

namespace g31::parts {

/// A value that a process of its own makes; see done_apart.
/// @tparam Made  a function `pass` takes it through byte streams
/// @returns how that process ended before the value was made; "": it is made
/// @throws BrokenOff
template <typename Made>
std::string make_apart(Made& made, const std::function<void(Made&)>& make,
                       const GoesOn& goes_on = {}) {
  WorkApart done = done_apart(
      [&] {
        make(made);
        ByteWriter writer;
        pass(writer, made);
        return std::move(writer).take();
      },
      goes_on);
  if (done.why_not.empty()) {
    ByteReader reader(done.bytes);
    pass(reader, made);
  }
  return std::move(done.why_not);
}

}  // namespace g31::parts

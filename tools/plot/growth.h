#pragma once

#include <cstddef>
#include <functional>

namespace g31::plot {

/// Told of each piece of a text that is being made, by how many bytes it has grown.  It may end the
/// work by an exception; one that is empty is told nothing.
using Growth = std::function<void(std::size_t bytes)>;

}  // namespace g31::plot

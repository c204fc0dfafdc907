#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace g31::parts {

// Why a file is not whole, or its head promises what the file does not hold, as far as the form of
// the file tells; nullopt: nothing is wrong.  One line, without the path.  No memory is asked for
// that a head promises.

/// Each vertex has three numbers, each face three corners or more, and each of them is a vertex.  A
/// file without its last lines may be whole: what is missing leaves open edges.
std::optional<std::string> why_no_whole_obj(std::string_view text);

/// The vertices and faces that the head promises are there, and nothing else is.
std::optional<std::string> why_no_whole_off(std::string_view text);

/// Text or binary: the elements that the head promises are there, and nothing else is.
std::optional<std::string> why_no_whole_ply(std::string_view bytes);

}  // namespace g31::parts

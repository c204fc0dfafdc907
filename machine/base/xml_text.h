#pragma once

#include <string>
#include <string_view>

namespace g31 {

/// Words as they stand in XML; what XML has no sign for becomes a question mark, what is no UTF-8
/// as_valid_utf_8().
std::string xml_escaped(std::string_view words);

}  // namespace g31

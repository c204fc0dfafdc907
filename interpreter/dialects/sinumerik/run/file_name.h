#pragma once

#include <string>
#include <string_view>

namespace g31::sinumerik {

/// The name under which a program's file is kept: the path without its folders; "" when the path
/// names none, or leads out of the control's memory.
std::string file_name(std::string_view path);

}  // namespace g31::sinumerik

#pragma once

#include <string>
#include <string_view>

#include "interpreter/dialects/sinumerik/state/channel.h"

namespace g31::sinumerik {

/// The name under which a program's file is kept: the path without its folders; "" when the path
/// names none, or leads out of the control's memory.
std::string file_name(std::string_view path);

/// The file that a path means to WRITE, READ, DELETE and ISFILE: in whatever form its name is
/// written.  EXTOPEN and its like are of other devices: there a name is as it is written.
std::string file_meant(const Channel& channel, std::string_view path);

}  // namespace g31::sinumerik

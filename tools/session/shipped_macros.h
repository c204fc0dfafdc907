#pragma once

#include <string>
#include <vector>

namespace g31::session {

/// What a macro of macros/fanuc says of itself: the comments that it begins with.
struct MacroText {
  std::string name;                ///< "O9851"
  std::string title;               ///< the comment behind its number
  std::vector<std::string> lines;  ///< those below, without brackets; its call is the first
};

/// All that come with g31, by their numbers; none where they are not found.
std::vector<MacroText> shipped_macros();

/// @param text  of one program
MacroText text_of_macro(const std::string& text);

}  // namespace g31::session

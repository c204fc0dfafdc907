#pragma once

#include <string_view>

#include "interpreter/dialects/sinumerik/explain/topic.h"

namespace g31::sinumerik {

/// What programs and definition files say of themselves, so that it is written down once: where it
/// counts.
///
/// * PROC: the comment right above it, and the call with its parameters.
/// * DEF, DEFINE: the comment right above; a line `; [4] ...` in it is about that element.
/// * SETAL(number,"text"), and `CASE x OF number GOTOF label` with `label: TEXT="text"`: an alarm,
/// with
///   the comment behind the text.
///
/// @param text  of one file; programs follow one another behind headers
Topics topics_of_text(std::string_view text);

}  // namespace g31::sinumerik

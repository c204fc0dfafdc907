#pragma once

#include <vector>

#include "interpreter/source/diagnostic.h"
#include "tools/session/prepare.h"

namespace g31::review {

/// Tells the variables that the sheets give and that no program reads: neither one of the request,
/// nor one of the kind in their folder or in the libraries, nor one of g31 that these call.  A
/// program that computes the numbers of variables may read all of them, and then none is told.
/// @param request  with programs
void judge_variables(const session::Request& request, const session::Prepared& prepared,
                     std::vector<source::Diagnostic>& findings);

}  // namespace g31::review

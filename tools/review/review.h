#pragma once

#include <string>
#include <vector>

#include "interpreter/source/diagnostic.h"
#include "machine/base/result.h"
#include "machine/units/point.h"
#include "tools/session/control.h"
#include "tools/session/prepare.h"
#include "tools/session/refusal.h"

namespace g31::review {

/// A box along the machine's axes, mm; may be endless.
struct Box {
  Point p_M_min;
  Point p_M_max;
};

/// A part where it stands.
struct PlacedPart {
  std::string name;
  Box box;
};

/// What can be said of a set-up without a run that touches anything.
struct Review {
  session::Control control;
  std::vector<PlacedPart> parts;
  std::vector<std::string> files;  ///< of the sheets, those that they name, programs that ran
  Box reach;  ///< of the centre of the stylus ball; endless without travel limits
  std::vector<source::Diagnostic> findings;  ///< with their places in `in_sheet`
};

/// Looks at a set-up: what the sheets say against each other, what the control does not take, the
/// meshes of the parts, whether the ball reaches them.
///
/// With a program the request's first one is followed on a machine on which nothing can be touched:
/// missing tools and offsets, parts that no measuring move comes near.  Nothing is written and
/// nothing kept.
/// @param request  without programs: the sheets alone
/// @returns what a run would be refused for
Result<Review, session::Refusal> review(const session::Request& request);

}  // namespace g31::review

#pragma once

#include <optional>
#include <string>
#include <vector>

#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "machine/base/result.h"
#include "tools/expect/expectation.h"
#include "tools/session/prepare.h"
#include "tools/session/refusal.h"

namespace g31::review {

/// A measuring move as it is commanded.
struct SkipWay {
  AxisPositions q_M_from;
  AxisPositions q_M_to;
  source::Location where;
};

/// A program as it goes where nothing can be touched.
struct Listing {
  std::vector<SkipWay> skips;  ///< the first kMostSkips
  runtime::Outcome outcome;
  std::string ended_at;  ///< "file:line: message" where it did not come to its end; else ""
};

inline constexpr std::size_t kMostSkips = 10000;

/// Follows the main program of a request on the machine of the job, without parts: kMostBlocks
/// blocks at most, and kMostSeconds.  Nothing is written.
/// @param files     where the programs are
/// @param expected  names that the control is asked for
Result<Listing, session::Refusal> listing_of(const session::ProgramPaths& paths,
                                             const session::Prepared& prepared,
                                             source::FileSystem& files,
                                             const expect::Expectations& expected);

inline constexpr std::uint64_t kMostBlocks = 1'000'000;
inline constexpr double kMostSeconds = 10.0;

}  // namespace g31::review

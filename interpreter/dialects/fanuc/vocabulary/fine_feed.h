#pragma once

#include "interpreter/dialects/fanuc/vocabulary/profile.h"

namespace g31::fanuc {

/// What an F without a decimal point counts with parameter 1403.0.
inline constexpr FeedCounts kFineFeedCounts = {1000.0, 100'000.0};

}  // namespace g31::fanuc

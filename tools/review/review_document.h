#pragma once

#include <string>

#include "tools/review/review.h"

namespace g31::review {

/// The document g31.setup/1.
std::string review_document(const Review& review);

}  // namespace g31::review

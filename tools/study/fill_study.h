#pragma once

#include "tools/study/check_study.h"
#include "tools/study/study.h"

namespace g31::study {

/// The plain struct that checked tables describe.  What does not fit together, cannot be varied or
/// is no formula goes to `errors`.
Study fill_study(const CheckedStudy& checked, const setup::Document& document,
                 setup::ErrorList& errors);

}  // namespace g31::study

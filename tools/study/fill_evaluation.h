#pragma once

#include <optional>

#include "tools/study/check_study.h"
#include "tools/study/study.h"

namespace g31::study {

/// `[evaluation]` of a study file; nothing where something is wrong with it, which goes to
/// `errors`.
std::optional<StudyEvaluation> fill_evaluation(const StudyTable& table, setup::ErrorList& errors);

/// Takes what a `[results.NAME]` has in `evaluated`, and its unit.
void fill_evaluated(const StudyTable& table, const std::optional<StudyEvaluation>& evaluation,
                    StudyResult& result, setup::ErrorList& errors);

}  // namespace g31::study

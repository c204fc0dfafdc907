#pragma once

#include <vector>

#include "interpreter/source/diagnostic.h"
#include "machine/base/result.h"
#include "tools/session/refusal.h"
#include "tools/session/world.h"
#include "tools/study/study.h"

namespace g31::study {

/// The parts of a set-up with their trees, and what is wrong with their meshes.
struct StudyParts {
  session::SensedParts sensed;
  std::vector<source::Diagnostic> findings;
};

/// Within the time that a run of the study has.
Result<StudyParts, session::Refusal> parts_of(const setup::Job& job, const Study& study);

}  // namespace g31::study

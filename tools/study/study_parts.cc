#include "tools/study/study_parts.h"

#include "interpreter/runtime/time_budget.h"

namespace g31::study {

Result<StudyParts, session::Refusal> parts_of(const setup::Job& job, const Study& study) {
  const runtime::TimeBudget time(study.max_time_s, study.interruption);
  const auto built = session::build_parts(job, &time);
  if (!built) {
    return built.error();
  }
  const auto sensed = session::sensed_parts(job, built.value().parts, &time);
  if (!sensed) {
    return sensed.error();
  }
  return StudyParts{sensed.value(), built.value().findings};
}

}  // namespace g31::study

#include "tools/session/work_on_meshes.h"

namespace g31::session {

parts::GoesOn goes_on_within(const runtime::TimeBudget* time) {
  return time == nullptr ? parts::GoesOn()
                         : [time] { return !time->is_interrupted() && !time->is_up(); };
}

Refusal too_late(const runtime::TimeBudget& time, std::string_view with) {
  return time.is_interrupted() ? interrupted() : out_of_time(with);
}

}  // namespace g31::session

#include "interpreter/runtime/touch_event.h"

#include "interpreter/runtime/overloaded.h"

namespace g31::runtime {

TouchEvent touch_event(const machine::LinearMove& way, const machine::SkipOutcome& outcome,
                       const AxisPositions& q_M_from, const AxisPositions& q_M_now) {
  TouchEvent event;
  event.q_M_from = q_M_from;
  event.q_M_commanded = way.q_M_end;
  event.feed_mm_min = way.feed_mm_min;
  event.q_M_latched = q_M_now;
  event.q_M_stopped = q_M_now;
  event.triggered = !std::holds_alternative<machine::NoTouch>(outcome);
  std::visit(Overloaded{
                 [&](const machine::Touched& touched) {
                   event.q_M_latched = touched.q_M_latched;
                   event.q_M_stopped = touched.q_M_stopped;
                   event.contact = touched.contact;
                   event.signals = touched.signals;
                 },
                 [](const machine::NoTouch&) {},
                 [&](const machine::NoEdge& there) { event.contact = there.contact; },
             },
             outcome);
  return event;
}

}  // namespace g31::runtime

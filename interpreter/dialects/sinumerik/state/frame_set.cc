#include "interpreter/dialects/sinumerik/state/frame_set.h"

namespace g31::sinumerik {

void chain(Frame& all, const Frame& next) {
  if (!(next == Frame())) {
    all = all.chained(next);
  }
}

Frame FrameSet::bases() const {
  Frame all;
  for (const auto* const each : {&global, &channel}) {
    for (const Frame& frame : *each) {
      chain(all, frame);
    }
  }
  return all;
}

Frame FrameSet::outer() const {
  Frame all;
  for (const Frame* const frame : {&part, &set, &external}) {
    chain(all, *frame);
  }
  chain(all, bases());
  return all;
}

Frame FrameSet::inner() const {
  Frame all;
  for (const Frame* const frame : {&tool, &workpiece, &transformation}) {
    chain(all, *frame);
  }
  return all;
}

}  // namespace g31::sinumerik

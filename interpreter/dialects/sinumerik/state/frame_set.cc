#include "interpreter/dialects/sinumerik/state/frame_set.h"

#include <utility>

namespace g31::sinumerik {

void chain(Frame& all, const Frame& next) {
  if (!(next == Frame())) {
    all = all.chained(next);
  }
}

Frame FrameSet::bases() const {
  Frame all;
  const std::pair<const std::array<Frame, kBases>*, unsigned> kinds[] = {{&global, masks.global},
                                                                         {&channel, masks.channel}};
  for (const auto& [frames, mask] : kinds) {
    for (std::size_t i = 0; i < kBases; ++i) {
      if ((mask >> i & 1U) != 0) {
        chain(all, (*frames)[i]);
      }
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

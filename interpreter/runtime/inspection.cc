#include "interpreter/runtime/inspection.h"

namespace g31::runtime {

std::vector<CallSite> calls_behind(std::span<const CallLevel> levels) {
  std::vector<CallSite> calls;
  for (const CallLevel& level : levels) {
    if (&level != &levels.front()) {
      calls.push_back({level.program, level.where});
    }
    calls.insert(calls.end(), level.waiting.begin(), level.waiting.end());
  }
  return calls;
}

}  // namespace g31::runtime

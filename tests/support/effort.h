#pragma once

namespace g31::testing {

/// How many of so many like cases a test tries: all, and a fourth of them under the
/// sanitizers, where each takes ten times as long and only what it does to memory is asked.
constexpr int of_many(int cases) {
#if defined(G31_UNDER_SANITIZERS)
  return (cases + 3) / 4;
#else
  return cases;
#endif
}

}  // namespace g31::testing

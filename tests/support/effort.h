#pragma once

#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace g31::testing {

/// Of so many like cases a test tries one: of each, and under the sanitizers, where each takes ten
/// times as long and only what it does to memory is asked, of four.
#if defined(G31_UNDER_SANITIZERS)
inline constexpr int kOneCaseOf = 4;
#else
inline constexpr int kOneCaseOf = 1;
#endif

/// How many cases that are counted a test tries.
constexpr int of_many(int cases) {
  return (cases + kOneCaseOf - 1) / kOneCaseOf;
}

/// Which cases that are listed, from the first on.
template <typename Cases>
auto some_of(const Cases& cases) {
  std::vector<std::decay_t<decltype(*std::begin(cases))>> taken;
  std::size_t number = 0;
  for (const auto& one : cases) {
    if (number++ % kOneCaseOf == 0) {
      taken.push_back(one);
    }
  }
  return taken;
}

}  // namespace g31::testing

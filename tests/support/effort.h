#pragma once

#include <cstddef>
#include <iterator>
#include <vector>

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

/// The same of cases that are listed: from the first on every fourth under the sanitizers.
template <typename Cases>
auto some_of(const Cases& cases) {
  const std::size_t all = std::size(cases);
  const std::size_t few = static_cast<std::size_t>(of_many(static_cast<int>(all)));
  const std::size_t apart = few < all ? 4 : 1;
  std::vector<std::decay_t<decltype(*std::begin(cases))>> taken;
  for (std::size_t i = 0; i < all; i += apart) {
    taken.push_back(*std::next(std::begin(cases), static_cast<std::ptrdiff_t>(i)));
  }
  return taken;
}

}  // namespace g31::testing

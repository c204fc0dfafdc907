#pragma once

#include <concepts>
#include <cstddef>
#include <iterator>
#include <type_traits>
#include <vector>

namespace g31::testing {

/// Whether the libraries that are tested were compiled with the sanitizers.  Code of tests is the
/// same with and without them.
bool under_sanitizers();

/// Of so many like cases a test tries one: of each, and under the sanitizers, where each takes ten
/// times as long and only what it does to memory is asked, of eight.
int one_case_of();

/// How many cases that are counted a test tries.
template <std::integral Count>
Count of_many(Count cases) {
  const auto step = static_cast<Count>(one_case_of());
  return (cases + step - 1) / step;
}

/// Which cases that are listed, from the first on.
template <typename Cases>
auto some_of(const Cases& cases) {
  std::vector<std::decay_t<decltype(*std::begin(cases))>> taken;
  const auto step = static_cast<std::size_t>(one_case_of());
  std::size_t number = 0;
  for (const auto& one : cases) {
    if (number++ % step == 0) {
      taken.push_back(one);
    }
  }
  return taken;
}

}  // namespace g31::testing

#pragma once

namespace g31::runtime {

/// Lets std::visit take one lambda per alternative; a missing alternative does not compile.
template <typename... Functions>
struct Overloaded : Functions... {
  using Functions::operator()...;
};
template <typename... Functions>
Overloaded(Functions...) -> Overloaded<Functions...>;

}  // namespace g31::runtime

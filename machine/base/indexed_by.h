#pragma once

#include <array>
#include <cstddef>

namespace g31 {

/// An array whose places have names: those of an enumeration.
template <typename Name, typename Value, std::size_t Count>
class IndexedBy {
 public:
  constexpr Value& operator[](Name name) { return values_[static_cast<std::size_t>(name)]; }
  constexpr const Value& operator[](Name name) const {
    return values_[static_cast<std::size_t>(name)];
  }
  /// By number, as programs count the places.  @pre number < Count
  constexpr Value& at(std::size_t number) { return values_.at(number); }
  [[nodiscard]] constexpr const Value& at(std::size_t number) const { return values_.at(number); }
  constexpr bool operator==(const IndexedBy&) const = default;

 private:
  std::array<Value, Count> values_ = {};
};

}  // namespace g31

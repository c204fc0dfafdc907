#pragma once

#include <optional>
#include <utility>

namespace g31 {

/// What is nearly never there, such as the failure of a block: an optional of the size of a
/// pointer, for what everybody asks for and nobody finds.  The way on where there is nothing is
/// laid out in one piece; what makes and ends such a value lies apart ([[gnu::cold]]).
template <typename Value>
class Rare {
 public:
  // Implicit on purpose, as std::optional: `return std::nullopt;` and `return failure;`.
  // NOLINTNEXTLINE(google-explicit-constructor)
  Rare(std::nullopt_t = std::nullopt) {}
  // NOLINTNEXTLINE(google-explicit-constructor)
  [[gnu::cold]] Rare(Value value) : kept_(new Value(std::move(value))) {}
  [[gnu::cold]] Rare(const Rare& other)
      : kept_(other.kept_ != nullptr ? new Value(*other.kept_) : nullptr) {}
  Rare(Rare&& other) noexcept : kept_(std::exchange(other.kept_, nullptr)) {}
  Rare& operator=(Rare other) noexcept {
    std::swap(kept_, other.kept_);
    return *this;
  }
  ~Rare() {
    if (has_value()) {
      forget();
    }
  }

  [[nodiscard]] bool has_value() const { return __builtin_expect(kept_ != nullptr, 0) != 0; }
  explicit operator bool() const { return has_value(); }

  /// @pre it is there
  Value& operator*() & { return *kept_; }
  const Value& operator*() const& { return *kept_; }
  Value&& operator*() && { return std::move(*kept_); }
  Value* operator->() { return kept_; }
  const Value* operator->() const { return kept_; }

 private:
  // A unique_ptr would look once more whether there is anything to end.
  [[gnu::cold, gnu::noinline]] void forget() { delete kept_; }

  Value* kept_ = nullptr;
};

}  // namespace g31

#pragma once

#include <utility>

namespace g31::runtime {

/// What a control holds at one place of a run, kept as a value: runs of the same job stand at the
/// same place with equal ones.
class Keyframe {
 public:
  Keyframe() = default;
  Keyframe(const Keyframe&) = delete;
  Keyframe& operator=(const Keyframe&) = delete;
  virtual ~Keyframe() = default;

  /// Those of different dialects are never equal.
  friend bool operator==(const Keyframe& a, const Keyframe& b) { return a.is_as(b); }

 private:
  [[nodiscard]] virtual bool is_as(const Keyframe& other) const = 0;
};

/// The keyframe of a dialect whose state is this value.
template <typename State>
class KeptState final : public Keyframe {
 public:
  explicit KeptState(State state) : state_(std::move(state)) {}

 private:
  [[nodiscard]] bool is_as(const Keyframe& other) const override {
    const auto* const same_dialect = dynamic_cast<const KeptState*>(&other);
    return same_dialect != nullptr && state_ == same_dialect->state_;
  }

  State state_;
};

}  // namespace g31::runtime

#pragma once

#include <chrono>
#include <cstdint>

#include "interpreter/runtime/budget_spent.h"
#include "interpreter/runtime/interruption.h"
#include "machine/port/work_watch.h"

namespace g31::runtime {

/// The wall time that is left for work within a block, and before and behind the run; none after an
/// interruption.  Results never depend on the time, but for its end.
class TimeBudget final : public machine::WorkWatch {
 public:
  /// Time runs from here on.
  /// @param interruption  ends the work before its time; outlives the budget
  explicit TimeBudget(double wall_seconds, const Interruption* interruption = nullptr)
      : wall_seconds_(wall_seconds), interruption_(interruption) {}

  /// @throws BudgetSpent  once, where the time is up or the work interrupted; what reads out what
  /// there is then is not stopped
  void look() override {
    if (++looks_ % kLooksPerReading == 0 && !is_told_ && (is_interrupted() || is_up())) {
      is_told_ = true;
      throw BudgetSpent(
          is_interrupted() ? source::DiagnosticId::Interrupted : source::DiagnosticId::BudgetTime,
          {});
    }
  }

  [[nodiscard]] bool is_up() const { return left_s() < 0.0; }
  [[nodiscard]] bool is_interrupted() const { return runtime::is_interrupted(interruption_); }

  [[nodiscard]] double left_s() const {
    const std::chrono::duration<double> passed = Clock::now() - started_;
    return wall_seconds_ - passed.count();
  }

 private:
  using Clock = std::chrono::steady_clock;
  static constexpr std::uint64_t kLooksPerReading = 1024;

  double wall_seconds_;
  const Interruption* interruption_;
  Clock::time_point started_ = Clock::now();
  std::uint64_t looks_ = 0;
  bool is_told_ = false;
};

}  // namespace g31::runtime

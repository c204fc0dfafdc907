#pragma once

#include <chrono>

namespace g31::fanuc {

/// Date and time of the control (#3011, #3012): a start, and simulated time since then.  Never the
/// computer's clock: a program gives the same result on every day.
class Calendar {
 public:
  /// Sets the start's date, yyyymmdd, or time, hhmmss.  @returns whether there is such a one
  bool start_on(double yyyymmdd);
  bool start_at(double hhmmss);

  /// @param seconds  simulated time since the start
  [[nodiscard]] double date(double seconds) const;
  [[nodiscard]] double time_of_day(double seconds) const;

  bool operator==(const Calendar&) const = default;

 private:
  [[nodiscard]] std::chrono::sys_seconds now(double seconds) const;

  std::chrono::sys_days start_day_ = std::chrono::year{2000} / 1 / 1;
  std::chrono::seconds start_time_{0};
};

}  // namespace g31::fanuc

#include "interpreter/dialects/fanuc/state/calendar.h"

#include <cmath>

namespace g31::fanuc {
namespace {

/// The three two-digit fields of a number (the first may be longer), highest first.
struct Fields {
  int first;
  int second;
  int third;
};

Fields fields_of(double number) {
  const int whole = static_cast<int>(number);
  return {whole / 10000, whole / 100 % 100, whole % 100};
}

double number_of(const Fields& fields) {
  return fields.first * 10000 + fields.second * 100 + fields.third;
}

bool is_whole_number_up_to(double number, double largest) {
  return number >= 0.0 && number <= largest && number == std::floor(number);
}

}  // namespace

bool Calendar::start_on(double yyyymmdd) {
  if (!is_whole_number_up_to(yyyymmdd, 99991231.0)) {
    return false;
  }
  const Fields fields = fields_of(yyyymmdd);
  const std::chrono::year_month_day date{std::chrono::year{fields.first},
                                         std::chrono::month{static_cast<unsigned>(fields.second)},
                                         std::chrono::day{static_cast<unsigned>(fields.third)}};
  if (!date.ok()) {
    return false;
  }
  start_day_ = date;
  return true;
}

bool Calendar::start_at(double hhmmss) {
  if (!is_whole_number_up_to(hhmmss, 235959.0)) {
    return false;
  }
  const Fields fields = fields_of(hhmmss);
  if (fields.second > 59 || fields.third > 59) {
    return false;
  }
  start_time_ = std::chrono::hours(fields.first) + std::chrono::minutes(fields.second) +
                std::chrono::seconds(fields.third);
  return true;
}

std::chrono::sys_seconds Calendar::now(double seconds) const {
  return start_day_ + start_time_ + std::chrono::seconds(static_cast<std::int64_t>(seconds));
}

double Calendar::date(double seconds) const {
  const std::chrono::year_month_day date(std::chrono::floor<std::chrono::days>(now(seconds)));
  return number_of({static_cast<int>(date.year()),
                    static_cast<int>(static_cast<unsigned>(date.month())),
                    static_cast<int>(static_cast<unsigned>(date.day()))});
}

double Calendar::time_of_day(double seconds) const {
  const auto moment = now(seconds);
  const std::chrono::hh_mm_ss clock(moment - std::chrono::floor<std::chrono::days>(moment));
  return number_of({static_cast<int>(clock.hours().count()),
                    static_cast<int>(clock.minutes().count()),
                    static_cast<int>(clock.seconds().count())});
}

}  // namespace g31::fanuc

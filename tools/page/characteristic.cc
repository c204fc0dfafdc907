#include "tools/expect/expectation.h"
#include "tools/page/report.h"

namespace g31::page {

std::optional<double> deviation_of(const Characteristic& row) {
  return row.measured && row.nominal ? std::optional(*row.measured - *row.nominal) : std::nullopt;
}

double excess_of(const Characteristic& row) {
  constexpr double kSlack = 1.0 + expect::kLimitSlack;
  const auto deviation = deviation_of(row);
  const auto [lower, upper] = row.tolerance;
  if (!deviation) {
    return 0.0;
  }
  if (*deviation > upper * kSlack) {
    return *deviation - upper;
  }
  return *deviation < lower * kSlack ? *deviation - lower : 0.0;
}

}  // namespace g31::page

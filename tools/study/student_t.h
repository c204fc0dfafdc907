#pragma once

#include <cstddef>

namespace g31::study {

/// The t that a Student distribution stays below with probability p.
///
/// @param p        above 0, below 1
/// @param freedom  degrees of freedom, at least 1
/// Accuracy: relative 1e-10 for p from 1e-6 to 1 - 1e-6.  Source: Boost.Math.
double student_t_quantile(double p, std::size_t freedom);

/// The probability that a Student variable stays below t.
double student_t_probability(double t, std::size_t freedom);

}  // namespace g31::study

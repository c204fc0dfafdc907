#include "tools/study/student_t.h"

#include <boost/math/distributions/students_t.hpp>

#include "machine/base/contract.h"

namespace g31::study {
namespace {

namespace policies = boost::math::policies;

/// In double alone: what a processor has beyond it must not change a digit.
using Student =
    boost::math::students_t_distribution<double, policies::policy<policies::promote_double<false>>>;

Student student(std::size_t freedom) {
  return Student(static_cast<double>(freedom));
}

}  // namespace

double student_t_probability(double t, std::size_t freedom) {
  G31_EXPECTS(freedom >= 1);
  return cdf(student(freedom), t);
}

double student_t_quantile(double p, std::size_t freedom) {
  G31_EXPECTS(p > 0.0 && p < 1.0 && freedom >= 1);
  return quantile(student(freedom), p);
}

}  // namespace g31::study

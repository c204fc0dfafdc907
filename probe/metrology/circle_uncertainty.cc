#include "probe/metrology/circle_uncertainty.h"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace g31::metrology {
namespace {

/// Calls `act(u, ...)` for each error of the given sets.
template <typename Act, typename... Sets>
void for_each_error(Act act, CircleErrors& u, const Sets&... sets) {
  for (const Eigen::Index i : {0, 1}) {
    act(u.centre[i], sets.centre[i]...);
  }
  for (const std::size_t i : {0U, 1U}) {
    act(u.scale.at(i), sets.scale.at(i)...);
    act(u.backlash.at(i), sets.backlash.at(i)...);
    act(u.cyclic.at(i).sine, sets.cyclic.at(i).sine...);
    act(u.cyclic.at(i).cosine, sets.cyclic.at(i).cosine...);
  }
  act(u.radius, sets.radius...);
  act(u.squareness, sets.squareness...);
  act(u.mismatch, sets.mismatch...);
}

/// Adds to each uncertainty what its error changes by between two fits, as far as noise does not
/// account for it: the second one, of fewer samples or more terms, is off the first by the
/// difference of their variances.
void add_change(CircleFit& fit, const CircleFit& other) {
  const auto join = [](double& u, double was, double is, double u_was, double u_is) {
    const double by_noise = std::max(0.0, u_is * u_is - u_was * u_was);
    const double change = was - is;
    u = std::sqrt(u * u + std::max(0.0, change * change - by_noise));
  };
  for_each_error(join, fit.u, fit.errors, other.errors, CircleErrors(fit.u), other.u);
}

/// The same with more of the way behind the reversals left out, as far as enough of it remains.
void add_change_of_windows(const FittedCircle& fitted, CircleFit& fit) {
  constexpr double kFurther = 10.0 * kDegree;
  ReversalWindows wider = fitted.windows;
  for (double& window : wider) {
    window += kFurther;
  }
  const auto ranges = described_ranges(fitted.samples, fitted.turns, fitted.task.start.centre,
                                       wider, Ends::LeftOut);
  if (const auto other = fit_circle(fitted.samples, fitted.turns, ranges, fitted.task)) {
    add_change(fit, *other);
  }
}

/// What lobes of the orders 0, 1 and 2 as large as these would pass for.
void add_hidden_form(double lobe, bool has_radius, CircleFit& fit) {
  const double radius = fit.errors.radius;
  CircleErrors form;
  form.centre = {lobe, lobe};
  form.radius = lobe;
  const double scale = (has_radius ? std::numbers::sqrt2 : 1.0) * lobe / radius;
  form.scale = {scale, scale};
  form.squareness = 2.0 * lobe / radius;
  for_each_error([](double& u, double more) { u = std::hypot(u, more); }, fit.u, form);
}

/// Of third and fourth order: root of the mean square of an amplitude, less what noise adds.
double lobe_size(const CircleFit& fit) {
  double square = 0.0;
  constexpr std::size_t kOrders = 2;
  for (std::size_t i = 0; i < kOrders; ++i) {
    const CyclicError& is = fit.errors.lobes.at(i);
    const CyclicError& u = fit.u.lobes.at(i);
    square += is.sine * is.sine - u.sine * u.sine;
    square += is.cosine * is.cosine - u.cosine * u.cosine;
  }
  return std::sqrt(std::max(0.0, square) / (2.0 * kOrders));
}

void add_form(const FittedCircle& fitted, CircleFit& fit) {
  CircleTask with_lobes = fitted.task;
  with_lobes.has_lobes = true;
  with_lobes.start = fit.errors;
  const auto ranges = described_ranges(fitted.samples, fitted.turns, fitted.task.start.centre,
                                       fitted.windows, Ends::LeftOut);
  const auto other = fit_circle(fitted.samples, fitted.turns, ranges, with_lobes);
  if (!other) {
    return;
  }
  // Noise is what the lobes leave.
  fit.scatter = std::min(fit.scatter, other->scatter);
  for_each_error([&](double& u, double by_scatter,
                     double hidden) { u = std::hypot(fit.scatter * by_scatter, hidden); },
                 fit.u, fit.by_scatter, fit.hidden);
  add_change(fit, *other);
  add_hidden_form(lobe_size(*other), fitted.task.radius.has_value(), fit);
}

}  // namespace

void add_systematic(const FittedCircle& fitted, CircleFit& fit) {
  add_form(fitted, fit);
  add_change_of_windows(fitted, fit);
}

}  // namespace g31::metrology

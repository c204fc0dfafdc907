#include "probe/sensor/pressed_surfaces.h"

#include <algorithm>
#include <cmath>

#include <Eigen/QR>

#include "probe/contact/smooth_normal.h"

namespace g31::probe {
namespace {

/// Over so many facets a ball slides before its stylus breaks, but for the finest meshes of bores
/// that it hardly fits into: there each of them takes long.
constexpr int kMostTurns = 40;

/// So many surfaces wedge a ball.
constexpr std::size_t kMostContacts = 3;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

constexpr int kMost = static_cast<int>(kMostContacts);
using Matrix = Eigen::Matrix<double, Eigen::Dynamic, Eigen::Dynamic, 0, kMost, kMost>;
using PushAndRate = Eigen::Matrix<double, Eigen::Dynamic, 2, 0, kMost, 2>;

}  // namespace

PressedSurfaces::PressedSurfaces(std::span<const Part> parts, const Ball& ball,
                                 const Point& p_M_from, const Point& p_M_to)
    : parts_(parts),
      ball_(ball),
      p_M_from_(p_M_from),
      p_M_to_(p_M_to),
      length_((p_M_to - p_M_from).norm()),
      p_M_centre_(p_M_from),
      turns_left_(kMostTurns) {
  if (length_ > 0.0) {
    direction_ = (p_M_to - p_M_from) / length_;
  }
}

std::optional<Pressed> PressedSurfaces::next(double until) {
  const double end = std::min(until, length_);
  while ((!has_begun_ || s_ < end) && turns_left_-- > 0) {
    std::optional<Met> met;
    if (contacts_.empty()) {
      met = first_met(parts_, ball_, undeflected(s_), p_M_to_);
      if (!met) {
        return std::nullopt;
      }
    } else if (is_pressed_straight(end) || is_alone(end)) {
      return std::nullopt;
    } else {
      const double held_until = std::min({end, releases_at_, free_from(end)});
      met = first_met(parts_, ball_, p_M_centre_, p_M_centre_ + (held_until - s_) * slide_);
    }
    has_begun_ = true;
    if (met) {
      if (const auto pressed = take(*met)) {
        return pressed;
      }
    } else if (!let_go(end)) {
      return std::nullopt;
    }
  }
  return std::nullopt;
}

bool PressedSurfaces::is_pressed_straight(double end) const {
  return !may_overlap_ && (end - s_) * slide_.norm() <= kTouchBandMm &&
         std::ranges::all_of(contacts_, [](const Contact& one) { return one.rate >= 0.0; });
}

bool PressedSurfaces::is_alone(double end) const {
  const Contact& contact = contacts_.front();
  return !may_overlap_ && contacts_.size() == 1 && std::isfinite(end) &&
         std::ranges::all_of(parts_, [&](const Part& part) {
           const Point n_M = &part == contact.part ? contact.n_M : Point::Zero();
           return part.on_skip_moves != Encounter::Signal ||
                  part.sweepers[ball_.size].can_touch_only(n_M, p_M_centre_, end - s_);
         });
}

std::optional<PressedSurfaces::Met> PressedSurfaces::first_met(std::span<const Part> parts,
                                                               const Ball& ball,
                                                               const Point& p_M_from,
                                                               const Point& p_M_to) {
  std::optional<Met> first;
  for (const Part& part : parts) {
    if (part.on_skip_moves != Encounter::Signal) {
      continue;
    }
    const Met met{part.sweepers[ball.size].sweep(p_M_from, p_M_to), &part};
    if (met.hit.status == SweepStatus::StartInContact) {
      return met;
    }
    if (met.hit.status == SweepStatus::Contact && (!first || met.hit.s < first->hit.s)) {
      first = met;
    }
  }
  return first;
}

std::optional<Pressed> PressedSurfaces::take(const Met& met) {
  const SweepHit& hit = met.hit;
  const bool is_from_free = contacts_.empty() && hit.status == SweepStatus::Contact;
  const double by_way = contacts_.empty() ? 1.0 : slide_.norm();
  s_ += by_way > 0.0 ? hit.s / by_way : 0.0;
  p_M_centre_ = hit.p_M_point + ball_.radius * hit.n_M;
  may_overlap_ = hit.status == SweepStatus::StartInContact;
  const Contact contact{hit.n_M, p_M_centre_.dot(hit.n_M), met.part, hit.n_M};
  const double depth = ball_.radius - (undeflected(s_) - hit.p_M_point).dot(hit.n_M);
  const bool is_known = hold(contact);
  share_out();
  if (is_known) {
    return std::nullopt;
  }
  return Pressed{hit, met.part, is_from_free, s_, std::fabs(depth) > kTouchBandMm ? depth : 0.0};
}

bool PressedSurfaces::hold(const Contact& contact) {
  const auto old = std::ranges::find_if(
      contacts_, [&](const Contact& one) { return one.n_M.dot(contact.n_M) >= kCreaseCosine; });
  bool is_known = false;
  Point n_M_told = contact.n_M;
  if (old != contacts_.end()) {
    is_known = old->part == contact.part && old->n_M_told.dot(contact.n_M) >= kToldCosine;
    n_M_told = is_known ? old->n_M_told : contact.n_M;
    contacts_.erase(old);
  } else if (contacts_.size() == kMostContacts) {
    contacts_.erase(contacts_.begin());
  }
  contacts_.push_back(contact);
  contacts_.back().n_M_told = n_M_told;
  return is_known;
}

void PressedSurfaces::share_out() {
  // The deflection is the sum of pushes along the normals; along each of them it is the depth.
  const auto n = static_cast<Eigen::Index>(contacts_.size());
  Matrix between(n, n);
  PushAndRate wanted(n, 2);
  for (Eigen::Index i = 0; i < n; ++i) {
    const Contact& one = contacts_[static_cast<std::size_t>(i)];
    for (Eigen::Index j = 0; j < n; ++j) {
      between(i, j) = one.n_M.dot(contacts_[static_cast<std::size_t>(j)].n_M);
    }
    wanted.row(i) << depth_in(one), -one.n_M.dot(direction_);
  }
  const PushAndRate pushes =
      n == 1 ? wanted : between.completeOrthogonalDecomposition().solve(wanted);
  Eigen::Index least = 0;
  if (n > 1 && pushes.col(0).head(n - 1).minCoeff(&least) < -kTouchBandMm) {
    contacts_.erase(contacts_.begin() + least);
    share_out();
    return;
  }
  slide_ = direction_;
  releases_at_ = kInfinity;
  for (Eigen::Index i = 0; i < n; ++i) {
    Contact& one = contacts_[static_cast<std::size_t>(i)];
    one.push = pushes(i, 0);
    one.rate = pushes(i, 1);
    slide_ += one.rate * one.n_M;
    if (n > 1 && one.rate < 0.0) {
      releases_at_ = std::min(releases_at_, s_ + std::max(0.0, one.push) / -one.rate);
    }
  }
}

bool PressedSurfaces::let_go(double end) {
  const double free = free_from(end);
  const double at = std::min(free, releases_at_);
  if (at >= end) {
    return false;
  }
  p_M_centre_ += (at - s_) * slide_;
  const double gone = at - s_;
  s_ = at;
  may_overlap_ = false;
  if (free <= releases_at_) {
    contacts_.clear();
    return true;
  }
  const auto left = [&](const Contact& one) { return one.push + gone * one.rate; };
  contacts_.erase(std::ranges::min_element(contacts_, [&](const Contact& a, const Contact& b) {
    return (a.rate < 0.0 ? left(a) : kInfinity) < (b.rate < 0.0 ? left(b) : kInfinity);
  }));
  share_out();
  return true;
}

double PressedSurfaces::free_from(double end) {
  if (free_from_ > s_) {
    return free_from_;
  }
  const Point p_M_end = undeflected(end);
  double free = s_;
  bool touches = true;
  while (touches && free < end) {
    touches = false;
    for (const Part& part : parts_) {
      const MeshSweeper& sweeper = part.sweepers[ball_.size];
      const Point p_M = undeflected(free);
      if (part.on_skip_moves == Encounter::Signal && sweeper.distance_if_touching(p_M)) {
        const double share = sweeper.leave(p_M, p_M_end, ball_.radius, kLeaveAtAnyDepth).share;
        touches = share > 0.0;
        free = share < 1.0 ? free + share * (end - free) : end;
      }
    }
  }
  free_from_ = free;
  return free;
}

}  // namespace g31::probe

#include "tools/page/figure_pieces.h"

#include <algorithm>
#include <cmath>

#include "tools/picture/tip.h"

namespace g31::page {
namespace {

using Json = nlohmann::ordered_json;

Json section_json(const probe::ProbeSection& section) {
  return {
      {"name", section.name},
      {"z", {section.z_bottom, section.z_top}},
      {"radius", {section.radius_bottom + section.rounding, section.radius_top + section.rounding}},
      {"at", array_of(section.p_S)}};
}

/// What holds a further ball lies askew.
bool is_upright(const probe::ProbeSection& section) {
  return section.turn_S.isApprox(Eigen::Quaterniond::Identity(), 1e-9);
}

/// What is not upright, from end to end.
Json arms_json(const std::vector<probe::ProbeSection>& sections) {
  Json arms = Json::array();
  for (const probe::ProbeSection& section : sections) {
    if (!is_upright(section)) {
      const auto at = [&](double z) {
        return array_of(section.p_S + section.turn_S * Point(0.0, 0.0, z));
      };
      const double radius = std::max(section.radius_bottom, section.radius_top) + section.rounding;
      arms.push_back(
          {{"from", at(section.z_bottom)}, {"to", at(section.z_top)}, {"diameter", 2.0 * radius}});
    }
  }
  return arms;
}

/// One cylinder in place of several upright pieces above each other; null: there is none.
Json cylinder_json(const std::vector<probe::ProbeSection>& sections) {
  double length = 0.0;
  double radius = 0.0;
  for (const probe::ProbeSection& section : sections) {
    if (!is_upright(section)) {
      continue;
    }
    length = std::max(length, section.z_top);
    radius = std::max(
        {radius, section.radius_bottom + section.rounding, section.radius_top + section.rounding});
  }
  return length == 0.0 ? Json() : Json{{"diameter", 2.0 * radius}, {"length", length}};
}

}  // namespace

nlohmann::ordered_json array_of(const Point& p) {
  return Json::array({p.x(), p.y(), p.z()});
}

nlohmann::ordered_json array_of(const Eigen::Quaterniond& turn) {
  return Json::array({turn.x(), turn.y(), turn.z(), turn.w()});
}

Json track_json(const picture::Track& track) {
  constexpr double kTimeSteps = 1e7;   // in a second
  constexpr double kPlaceSteps = 1e5;  // in a millimetre
  constexpr double kSpeedSteps = 1e6;  // in a millimetre a second
  const auto rounded = [](double value, double steps) {
    return std::round(value * steps) / steps + 0.0;  // no minus zero
  };
  Json times = Json::array();
  Json points = Json::array();
  Json speeds = Json::array();
  for (const picture::TrackKnot& knot : track.knots()) {
    times.push_back(rounded(knot.time_s, kTimeSteps));
    for (Eigen::Index axis = 0; axis < 3; ++axis) {
      points.push_back(rounded(knot.p_M[axis], kPlaceSteps));
      speeds.push_back(rounded(knot.v_M[axis], kSpeedSteps));
    }
  }
  return {
      {"times", std::move(times)}, {"points", std::move(points)}, {"speeds", std::move(speeds)}};
}

nlohmann::ordered_json probe_json(const setup::Job& job) {
  if (!job.probe) {
    return {};
  }
  const probe::ProbeSetup& probe = *job.probe;
  Json sections = Json::array();
  for (const auto* const list : {&probe.stem, &probe.bodies}) {
    for (const probe::ProbeSection& section : *list) {
      sections.push_back(section_json(section));
    }
  }
  Json further = Json::array();
  for (const probe::StylusBall& ball : probe.further_balls) {
    further.push_back({{"at", array_of(ball.p_S_from_main)}, {"diameter", ball.diameter_mm}});
  }
  return {{"ball", probe.ball_diameter_mm},    {"further", std::move(further)},
          {"arms", arms_json(probe.stem)},     {"offset", array_of(picture::tip_of(job))},
          {"stem", cylinder_json(probe.stem)}, {"body", cylinder_json(probe.bodies)},
          {"sections", std::move(sections)}};
}

}  // namespace g31::page

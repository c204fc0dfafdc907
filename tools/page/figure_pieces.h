#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "machine/units/point.h"
#include "tools/picture/track.h"
#include "tools/setup/job.h"

// Pieces that figures are made of.

namespace g31::page {

nlohmann::ordered_json array_of(const Point& p);
nlohmann::ordered_json array_of(const Eigen::Quaterniond& turn);

/// The knots of a track as lists of times, places and speeds; rounded, which adds 1e-4 mm at most
/// to its error where a piece lasts less than ten minutes.
nlohmann::ordered_json track_json(const picture::Track& track);

/// The probe of a set-up: balls, what holds them, its bodies; mm from the main ball's centre.
/// null: there is none.
nlohmann::ordered_json probe_json(const setup::Job& job);

}  // namespace g31::page

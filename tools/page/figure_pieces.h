#pragma once

#include <Eigen/Geometry>
#include <nlohmann/json.hpp>

#include "machine/units/point.h"
#include "tools/setup/job.h"

// Pieces that figures are made of.

namespace g31::page {

nlohmann::ordered_json array_of(const Point& p);
nlohmann::ordered_json array_of(const Eigen::Quaterniond& turn);

/// The probe of a set-up: balls, what holds them, its bodies; mm from the main ball's centre.
/// null: there is none.
nlohmann::ordered_json probe_json(const setup::Job& job);

}  // namespace g31::page

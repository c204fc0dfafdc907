#pragma once

#include <array>
#include <optional>
#include <vector>

#include "tools/page/file_names.h"
#include "tools/page/run_report.h"
#include "tools/page/run_writers.h"

// The pieces that the report of a run is made of.

namespace g31::page {

/// A value as people read it, UTF-8; a dash for a vacant one.
std::string shown_value(const runtime::ShownValue& value);

/// The characteristics of the sheet, what is expected of numbers, then what --print asks for
/// besides.
std::vector<Characteristic> results_of(const RunPage& run, const Writers& writers);

/// Where the run ended before its time; nullopt: it did not.
std::optional<Ending> ending_of(const RunPage& run, const FileNames& names, Language language);

std::vector<Input> inputs_of(const RunPage& run, Language language);

/// What was not simulated, or is not shown.
std::vector<std::string> limits_of(const RunPage& run, const PictureMeshes& meshes,
                                   Language language);

/// What a characteristic says of the wall that a touch met; mm, into the material.
struct WallShare {
  double nominal_to_true_mm = 0.0;          ///< half of true less nominal: the part's own deviation
  std::optional<expect::Limits> limits_mm;  ///< half of the tolerance
};
/// One for each touch; nullopt: no characteristic with a true size has measured its wall.
///
/// A touch belongs to a size where the wall opposite that another touch of the same result met is
/// just as far, or where the middle of the part is half as far.
std::vector<std::optional<WallShare>> wall_shares(const RunPage& run,
                                                  const TouchGeometries& geometries,
                                                  const Writers& writers);

/// What pictures show of a run beside the report.
struct Pictured {
  const TouchGeometries& geometries;
  std::vector<std::optional<WallShare>> shares;  ///< one for each touch
  const PictureMeshes& meshes;
  const FileNames& names;
};
/// As JSON; lengths mm, machine frame.
/// @param report  what the page says of the run already
std::string figures_of(const RunPage& run, const Pictured& pictured, const Report& report);

}  // namespace g31::page

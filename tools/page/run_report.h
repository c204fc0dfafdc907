#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "interpreter/source/source_map.h"
#include "tools/expect/expectation.h"
#include "tools/page/file_names.h"
#include "tools/page/other_run.h"
#include "tools/page/report.h"
#include "tools/picture/pictured_part.h"
#include "tools/picture/track.h"
#include "tools/picture/way.h"
#include "tools/report/run_document.h"
#include "tools/report/run_recorder.h"
#include "tools/setup/job.h"

namespace g31::page {

/// A run that has ended, with all that is known of it; everything outlives the call.
struct RunPage {
  const report::RunResult& result;  ///< with a chronicle
  const report::RunRecorder& recorder;
  const source::SourceMap& sources;
  const setup::Job& job;
  const expect::Expectations& expectations;
  /// The number that a variable or an offset is, where it is one.
  std::function<std::optional<double>(const expect::What& what)> value;
  std::span<const picture::Way> ways;
  const picture::Track& track;                ///< of what goes the ways
  std::span<const picture::Mark> contacts;    ///< of skip moves
  std::span<const picture::Mark> collisions;  ///< the last one is what ended the run
  bool is_of_part;  ///< all of them are in the frame of the part, which rotary axes turn
  std::vector<picture::PicturedPart> parts;
  std::string command;              ///< that repeats the run
  const OtherRun* other = nullptr;  ///< that is shown beside it; nullptr: none
};

Report report_of(const RunPage& run, Language language);

/// Of a run that did not begin: why, at its place.
/// @param result   what is known of it; places of its messages are in sheets or in `sources`
/// @param command  that repeats it
Report refusal_report(const report::RunResult& result, const source::SourceMap& sources,
                      const std::string& command, Language language);

/// A message for the page: errors with their line, all with what would be right.
Finding finding_of(const source::Diagnostic& message, const FileNames& names,
                   const source::SourceMap& sources);

/// Behind the listings that are there already those of programs in which an error stands: one that
/// is wrong in itself has not run, and is looked at all the more.
void add_listings_of_errors(const std::vector<source::Diagnostic>& messages, const FileNames& names,
                            const source::SourceMap& sources, std::vector<Listing>& listings);

/// The answer in a sentence.
/// @param results  that are judged
Verdict verdict_of(const RunPage& run, std::span<const Characteristic> results, Language language);

/// The meshes that stand for the parts in the picture, one each; nullopt: so few triangles cannot
/// show it, and it is left out.
using PictureMeshes = std::vector<std::optional<parts::Mesh>>;
PictureMeshes meshes_for_picture(const RunPage& run);

/// Where a touch met its part; all places in the frame of the part as the sheet lays it, mm.
struct TouchGeometry {
  std::optional<Point> p_M_ball;  ///< centre of the main ball at the latched position
  std::optional<picture::TouchingBall> touching;  ///< the ball that touched, there
  std::optional<Point> p_M_contact;
  Point n_M = Point::Zero();           ///< outwards, where there is a contact
  std::optional<double> deviation_mm;  ///< how much deeper than the wall the ball was latched
  std::optional<double> angle_deg;     ///< between the move and the inward normal
};
using TouchGeometries = std::vector<TouchGeometry>;
/// One for each touch, in their order.
TouchGeometries geometries_of(const RunPage& run);

}  // namespace g31::page

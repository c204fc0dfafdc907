#include "tools/review/review.h"

#include <algorithm>
#include <array>
#include <iterator>
#include <limits>
#include <map>
#include <optional>
#include <string_view>
#include <utility>

#include <fmt/format.h>

#include "machine/sim/machining_centre.h"
#include "probe/contact/way_distance.h"
#include "tools/disk/disk.h"
#include "tools/disk/remembering_disk.h"
#include "tools/review/listing.h"
#include "tools/review/part_places.h"
#include "tools/review/setup_rules.h"
#include "tools/review/unread_variables.h"
#include "tools/session/world.h"
#include "tools/setup/job_files.h"

namespace g31::review {
namespace {

/// The disk, with a program on it that does nothing: what a control says of its set-up alone.
class DiskWithIdleProgram final : public source::FileSystem {
 public:
  static constexpr const char* kPath = "O0001";

  /// @param disk  outlives it
  explicit DiskWithIdleProgram(source::FileSystem& disk) : disk_(disk) {}

  std::optional<std::string> read(const std::string& path) override {
    return path == kPath ? std::optional<std::string>("M30\n") : disk_.read(path);
  }
  std::vector<std::string> list(const std::string& folder) override {
    return folder.empty() ? std::vector<std::string>() : disk_.list(folder);
  }
  std::optional<std::string> why_no_list(const std::string& folder) override {
    return disk_.why_no_list(folder);
  }
  std::vector<std::string> folders(const std::string& folder) override {
    return disk_.folders(folder);
  }
  bool has_folder(const std::string& folder) override { return disk_.has_folder(folder); }

 private:
  source::FileSystem& disk_;
};

/// What a run says of its set-up, beside what it says of its touches.
bool is_about_setup(const source::Diagnostic& diagnostic) {
  static constexpr auto kIds = std::to_array(
      {source::DiagnosticId::SetupMissingTool, source::DiagnosticId::SetupMissingOffset,
       source::DiagnosticId::OffsetNeverSet, source::DiagnosticId::ProgramTwice,
       source::DiagnosticId::UnknownParameter, source::DiagnosticId::UnusedAxis});
  // Alarms of a SINUMERIK for an edge, a tool's number and a tool's name that it has not.
  static constexpr auto kAlarms = std::to_array<std::string_view>({"17181", "17190", "17191"});
  return std::ranges::any_of(
             kIds,
             [&](source::DiagnosticId id) { return source::info(id).code == diagnostic.code; }) ||
         std::ranges::find(kAlarms, diagnostic.code) != kAlarms.end();
}

/// The ball's way nearest to a part.
double nearest_way(const setup::Job& job, const std::vector<SkipWay>& skips,
                   const probe::ProbedPart& part, const Box& box) {
  double nearest = std::numeric_limits<double>::infinity();
  for (const SkipWay& way : skips) {
    const Point p_M_from = way.q_M_from.head<3>() + job.machine.p_T_tip;
    const Point p_M_to = way.q_M_to.head<3>() + job.machine.p_T_tip;
    const auto beside = [&](const Point& p) {
      return (box.p_M_min - p).cwiseMax(p - box.p_M_max).cwiseMax(Point::Zero()).norm();
    };
    // No nearer than the box is from both ends, less the way.
    const double at_least = 0.5 * (beside(p_M_from) + beside(p_M_to) - (p_M_to - p_M_from).norm());
    if (at_least < nearest) {
      nearest = std::min(nearest, probe::distance_of_way(part.mesh_M, p_M_from, p_M_to));
    }
  }
  return nearest;
}

/// Parts that the ball passes farther away than this, mm, are not what the program measures.
constexpr double kNearMm = 20.0;

void judge_skips(const setup::Job& job, const Listing& listing, const session::BuiltParts& built,
                 Review& review) {
  if (!job.probe || job.skip_signals) {
    return;
  }
  if (listing.skips.empty() && listing.ended_at.empty()) {
    review.findings.push_back(finding_of(SetupRuleId::NoSkips, "no G31, no MEAS"));
    return;
  }
  if (!listing.ended_at.empty() || listing.skips.size() == kMostSkips) {
    return;  // what comes behind may touch any part
  }
  for (std::size_t i = 0; i < job.parts.size(); ++i) {
    const double distance =
        nearest_way(job, listing.skips, built.parts.at(i), review.parts.at(i).box) -
        0.5 * job.probe->ball_diameter_mm;
    if (!job.parts[i].is_fixture && distance > kNearMm) {
      review.findings.push_back(
          finding_of(SetupRuleId::FarFromSkips,
                     fmt::format("'{}', {:.3f} mm at the nearest", job.parts[i].name, distance)));
      review.findings.back().in_sheet = job.part_places.at(i);
    }
  }
}

/// What the sheet sets a variable to; 0: nothing.
double value_of(const setup::Job& job, const std::string& name) {
  const auto found = job.control.variables.find(name);
  return found != job.control.variables.end() ? found->second.value_or(0.0) : 0.0;
}

/// Whether a tool may be the probe.  Its length is along Z, that of a turning tool (types 500 to
/// 599) along X, whose second one is along Z.
bool is_as_long(const setup::Job& job, int number, const runtime::ToolEntry& tool) {
  constexpr double kSameMm = 1.0;
  const double radius = 0.5 * job.probe->ball_diameter_mm;
  const auto is_known = [&](double believed, double length) {
    // Controls count to the middle of the ball or to its end.
    return std::abs(believed - length) < kSameMm || std::abs(believed - length - radius) < kSameMm;
  };
  const Point& p_T_tip = job.machine.p_T_tip;
  const double first = tool.length_mm + tool.length_wear_mm;
  if (tool.type < 500.0 || tool.type >= 600.0) {
    return is_known(first, -p_T_tip.z());
  }
  return is_known(first, std::abs(p_T_tip.x())) &&
         is_known(value_of(job, fmt::format("$TC_DP4[{},1]", number)), -p_T_tip.z());
}

void judge_lengths(const setup::Job& job, std::vector<source::Diagnostic>& findings) {
  const auto& tools = job.control.tools;
  if (!job.probe || tools.empty()) {
    return;
  }
  const bool is_known = std::ranges::any_of(
      tools, [&](const auto& tool) { return is_as_long(job, tool.first, tool.second); });
  if (!is_known) {
    const Point& p_T_tip = job.machine.p_T_tip;
    const bool is_aside = std::abs(p_T_tip.x()) > 0.5 * job.probe->ball_diameter_mm;
    findings.push_back(finding_of(
        SetupRuleId::OtherLength,
        is_aside ? fmt::format("X {:.3f} mm, Z {:.3f} mm", std::abs(p_T_tip.x()), -p_T_tip.z())
                 : fmt::format("{:.3f} mm", -p_T_tip.z())));
  }
}

/// Whether a tool is the probe, as the sheet or its type says: of SINUMERIK 710 to 714 on mills,
/// 580 on lathes.
bool is_probe(const setup::Job& job, int number, const runtime::ToolEntry& tool) {
  const std::optional<int>& own = job.probe->switching.tool;
  const bool is_of_type = (tool.type >= 710.0 && tool.type <= 714.0) || tool.type == 580.0;
  return own ? number == *own : is_of_type;
}

/// Of several probes one is that of the sheet.
void judge_radii(const setup::Job& job, std::vector<source::Diagnostic>& findings) {
  constexpr double kCalibratedMm = 0.1;  // more is no calibration
  if (!job.probe) {
    return;
  }
  const double real = 0.5 * job.probe->ball_diameter_mm;
  std::string other;
  for (const auto& [number, tool] : job.control.tools) {
    const double radius = tool.radius_mm + tool.radius_wear_mm;
    if (radius <= 0.0 || !is_probe(job, number, tool)) {
      continue;
    }
    if (std::abs(radius - real) <= kCalibratedMm) {
      return;
    }
    other = other.empty()
                ? fmt::format("[tools.{}] {:.3f} mm, [probe] {:.3f} mm", number, radius, real)
                : other;
  }
  if (!other.empty()) {
    findings.push_back(finding_of(SetupRuleId::OtherRadius, other));
  }
}

/// Tools of one name: the duplo numbers tell them apart, 1 unless the sheet says another one.
void judge_tool_names(const setup::Job& job, std::vector<source::Diagnostic>& findings) {
  std::map<std::pair<std::string, double>, int> first_of;
  for (const auto& [number, tool] : job.control.tools) {
    const auto duplo = job.control.variables.find(fmt::format("$TC_TP1[{}]", number));
    const bool is_said = duplo != job.control.variables.end();
    const auto [known, is_new] =
        first_of.try_emplace({tool.name, is_said ? duplo->second.value_or(1.0) : 1.0}, number);
    if (!is_new && !tool.name.empty()) {
      findings.push_back(finding_of(
          SetupRuleId::ToolTwice,
          fmt::format("'{}', [tools.{}] and [tools.{}]", tool.name, known->second, number)));
    }
  }
}

/// An axis that starts beyond a soft limit: by [start], or because it is not named there.
void judge_start(const setup::Job& job, std::vector<source::Diagnostic>& findings) {
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const machine::AxisSetup& axis = job.machine.axes.at(i);
    const double start = job.machine.q_M_start[static_cast<Eigen::Index>(i)];
    if (!axis.present || (start >= axis.travel_min && start <= axis.travel_max)) {
      continue;
    }
    const char letter = "XYZABC"[i];
    findings.push_back(finding_of(SetupRuleId::StartOutside,
                                  fmt::format("{} at {}, it goes from {} to {}", letter, start,
                                              axis.travel_min, axis.travel_max)));
    for (const std::string& key :
         {fmt::format("start.{}", letter), fmt::format("machine.axes.{}.travel", letter)}) {
      if (const auto place = job.places.find(key); place != job.places.end()) {
        findings.back().in_sheet = place->second;
        break;
      }
    }
  }
}

/// What the control says of the set-up, with a program or without.
Result<Listing, session::Refusal> followed(const session::Request& request,
                                           const session::Prepared& prepared,
                                           source::FileSystem& disk) {
  if (!request.programs.empty()) {
    return listing_of(request, prepared, disk, prepared.job.expectations);
  }
  DiskWithIdleProgram files(disk);
  return listing_of({{DiskWithIdleProgram::kPath}, request.libraries}, prepared, files, {});
}

}  // namespace

Result<Review, session::Refusal> review(const session::Request& request) {
  disk::Disk real_disk;
  disk::RememberingDisk disk(real_disk);
  const auto prepared = session::prepare(request, disk, session::VariablesFile::WouldBeSaved);
  if (!prepared) {
    return prepared.error();
  }
  const setup::Job& job = prepared.value().job;
  const auto built = session::build_parts(job);
  if (!built) {
    return built.error();
  }
  const auto listing = followed(request, prepared.value(), disk);
  if (!listing) {
    return listing.error();
  }
  Review review{prepared.value().control, placed_parts(built.value().parts), setup::files_of(job),
                reach_of(job), built.value().findings};
  std::ranges::move(disk.paths(), std::back_inserter(review.files));
  std::ranges::move(session::lost_variables(job), std::back_inserter(review.findings));
  judge_places(job, review.parts, review.reach, review.findings);
  judge_start(job, review.findings);
  judge_lengths(job, review.findings);
  judge_radii(job, review.findings);
  judge_tool_names(job, review.findings);
  std::ranges::copy_if(listing.value().outcome.diagnostics, std::back_inserter(review.findings),
                       is_about_setup);
  if (!request.programs.empty()) {
    judge_skips(job, listing.value(), built.value(), review);
    judge_variables(request, prepared.value(), review.findings);
    if (!listing.value().ended_at.empty()) {
      review.findings.push_back(finding_of(SetupRuleId::ListingEnded, listing.value().ended_at));
    }
  }
  return review;
}

}  // namespace g31::review

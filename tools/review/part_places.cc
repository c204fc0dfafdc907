#include "tools/review/part_places.h"

#include <algorithm>
#include <limits>

#include <fmt/format.h>

#include "tools/review/setup_rules.h"

namespace g31::review {
namespace {

constexpr double kEndless = std::numeric_limits<double>::infinity();
/// Smaller than a stylus ball, larger than a machining centre.
constexpr double kSmallestMm = 2.0;
constexpr double kLargestMm = 10000.0;

Box box_of(const parts::Mesh& mesh) {
  Box box{Point::Constant(kEndless), Point::Constant(-kEndless)};
  for (const Point& p : mesh.vertices) {
    box.p_M_min = box.p_M_min.cwiseMin(p);
    box.p_M_max = box.p_M_max.cwiseMax(p);
  }
  return box;
}

std::string shown(const Box& box) {
  return fmt::format("X {:.3f} to {:.3f}, Y {:.3f} to {:.3f}, Z {:.3f} to {:.3f}", box.p_M_min.x(),
                     box.p_M_max.x(), box.p_M_min.y(), box.p_M_max.y(), box.p_M_min.z(),
                     box.p_M_max.z());
}

/// The axes on which two boxes are apart by more than `gap`, with how far.
std::string apart(const Box& reach, const Box& part, double gap) {
  std::string text;
  for (int i = 0; i < kLinearAxisCount; ++i) {
    const double beside =
        std::max(part.p_M_min[i] - reach.p_M_max[i], reach.p_M_min[i] - part.p_M_max[i]) - gap;
    if (beside > 0.0) {
      text += fmt::format("{}{:.3f} mm in {}", text.empty() ? "" : ", ", beside, "XYZ"[i]);
    }
  }
  return text;
}

void add_at_part(const setup::Job& job, std::size_t part, SetupRuleId rule,
                 const std::string& detail, std::vector<source::Diagnostic>& findings) {
  findings.push_back(finding_of(rule, detail));
  findings.back().in_sheet = job.part_places.at(part);
}

bool is_same_body(const parts::PartSetup& a, const parts::PartSetup& b) {
  return a.file == b.file && a.shape == b.shape && a.sizes == b.sizes && a.profile == b.profile &&
         a.scale == b.scale && a.p_M_at == b.p_M_at && a.rotate_deg == b.rotate_deg;
}

void judge_twins(const setup::Job& job, std::size_t part,
                 std::vector<source::Diagnostic>& findings) {
  const parts::PartSetup& own = job.parts.at(part);
  for (std::size_t i = 0; i < part; ++i) {
    const parts::PartSetup& other = job.parts.at(i);
    if (is_same_body(own, other)) {
      add_at_part(job, part, SetupRuleId::SamePart,
                  fmt::format("'{}' and '{}'", other.name, own.name), findings);
      return;  // the first one is enough
    }
    if (own.name == other.name) {
      add_at_part(job, part, SetupRuleId::PartTwice, fmt::format("'{}'", own.name), findings);
      return;
    }
  }
}

void judge_size(const setup::Job& job, std::size_t part, const Box& box,
                std::vector<source::Diagnostic>& findings) {
  const double largest = (box.p_M_max - box.p_M_min).maxCoeff();
  const bool is_file = !job.parts.at(part).file.empty();
  if (is_file && (largest < kSmallestMm || largest > kLargestMm)) {
    add_at_part(job, part, SetupRuleId::OddSize,
                fmt::format("'{}' is {:.4g} mm long", job.parts.at(part).name, largest), findings);
  }
}

}  // namespace

std::vector<PlacedPart> placed_parts(const std::vector<probe::ProbedPart>& parts) {
  std::vector<PlacedPart> placed;
  for (const probe::ProbedPart& part : parts) {
    placed.push_back({part.name, box_of(part.mesh_M)});
  }
  return placed;
}

Box reach_of(const setup::Job& job) {
  Box reach{Point::Constant(-kEndless), Point::Constant(kEndless)};
  const auto& axes = job.machine.axes;
  if (std::any_of(axes.begin() + kLinearAxisCount, axes.end(),
                  [](const machine::AxisSetup& axis) { return axis.present; })) {
    return reach;
  }
  for (int i = 0; i < kLinearAxisCount; ++i) {
    const machine::AxisSetup& axis = job.machine.axes.at(static_cast<std::size_t>(i));
    if (axis.present) {
      reach.p_M_min[i] = axis.travel_min + job.machine.p_T_tip[i];
      reach.p_M_max[i] = axis.travel_max + job.machine.p_T_tip[i];
    }
  }
  return reach;
}

void judge_places(const setup::Job& job, const std::vector<PlacedPart>& placed, const Box& reach,
                  std::vector<source::Diagnostic>& findings) {
  const std::size_t count = std::min(job.parts.size(), placed.size());
  for (std::size_t part = 0; part < count; ++part) {
    const Box& box = placed.at(part).box;
    judge_twins(job, part, findings);
    judge_size(job, part, box, findings);
    if (!job.probe || job.parts.at(part).is_fixture) {
      continue;
    }
    const std::string beside = apart(reach, box, 0.5 * job.probe->ball_diameter_mm);
    if (!beside.empty()) {
      add_at_part(
          job, part, SetupRuleId::OutOfReach,
          fmt::format("'{}' at {} is {} beyond it", placed.at(part).name, shown(box), beside),
          findings);
    }
  }
}

}  // namespace g31::review

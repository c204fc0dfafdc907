#include "tools/setup/fill_tools.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "probe/tooling/tool_shape.h"
#include "tools/setup/fill_probe.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

using probe::ToolKind;

constexpr std::size_t kMostTeeth = 100;  // what a single-tooth check of a SINUMERIK has room for

/// Which kinds have a key; the others refuse it.
struct KindKey {
  KeyId key;
  std::vector<ToolKind> needed_by;
  std::vector<ToolKind> taken_by;  ///< beside those
};

const std::array<KindKey, 12>& kind_keys() {
  using enum ToolKind;
  static const std::vector<ToolKind> turning_round = {Mill, BallMill, BullMill, Drill, Calibration};
  static const std::array<KindKey, 12> rows = {{
      {KeyId::ToolTrueLength, turning_round, {}},
      {KeyId::ToolDiameter, turning_round, {}},
      {KeyId::ToolCornerRadius, {BullMill}, turning_round},
      {KeyId::ToolCuttingLength, {}, {Mill, BullMill, Calibration}},
      {KeyId::ToolCoreDiameter, {}, {Mill, BallMill, BullMill, Drill}},
      {KeyId::ToolTipAngle, {}, turning_round},
      {KeyId::ToolLengths, {Turning}, {}},
      {KeyId::ToolTipRadius, {}, {Turning}},
      {KeyId::ToolEdgePosition, {}, {Turning}},
      {KeyId::ToolInsertAngle, {}, {Turning}},
      {KeyId::ToolOrientation, {}, {Turning}},
      {KeyId::ToolEdgeLength, {}, {Turning}},
  }};
  return rows;
}

std::string_view name_of_key(KeyId id) {
  return key_rows()[static_cast<std::size_t>(id)].name;
}

const probe::ToolKindName& kind_row_from(const TableKeys& keys) {
  const std::string given = keys.get(KeyId::ToolKind, std::string("mill"));
  const auto* const row =
      std::ranges::find(probe::kToolKindNames, std::string_view(given), &probe::ToolKindName::name);
  G31_EXPECTS(row != probe::kToolKindNames.end());
  return *row;
}

bool holds(const std::vector<ToolKind>& kinds, ToolKind kind) {
  return std::ranges::find(kinds, kind) != kinds.end();
}

void check_keys_of_kind(const SheetTable& table, const probe::ToolKindName& kind,
                        ErrorList& errors) {
  const TableKeys keys(table);
  for (const KindKey& row : kind_keys()) {
    const Entry* const given = keys.find(row.key);
    const bool is_needed = holds(row.needed_by, kind.kind);
    if (given == nullptr && is_needed) {
      errors.add(
          SetupErrorId::KeyMissing, table.where,
          {fmt::format("a tool of kind {}", kind.name), name_of_key(row.key)},
          fmt::format("for example: {}", key_rows()[static_cast<std::size_t>(row.key)].example));
    } else if (given != nullptr && !is_needed && !holds(row.taken_by, kind.kind)) {
      errors.add(SetupErrorId::KeyOfOtherKind, given->where, {name_of_key(row.key), kind.name},
                 kind.kind == ToolKind::Probe ? "its sizes are those of [probe]" : "leave it out");
    }
  }
}

/// The elements of a list within [[tool]] that belong to one tool.
std::vector<const SheetTable*> within(const Sheet& sheet, SectionId section, std::size_t tool) {
  std::vector<const SheetTable*> own;
  for (const SheetTable& table : list_of(sheet, section)) {
    if (table.of == tool) {
      own.push_back(&table);
    }
  }
  return own;
}

bool may_have(SectionId section, ToolKind kind) {
  const bool turns = kind != ToolKind::Turning && kind != ToolKind::Probe;
  return turns && (section == SectionId::ToolBody || kind != ToolKind::Calibration);
}

void fill_teeth(probe::ToolSetup& tool, const std::vector<const SheetTable*>& teeth,
                ErrorList& errors) {
  if (teeth.size() > kMostTeeth) {
    errors.add(
        SetupErrorId::TooManyTeeth, teeth.at(kMostTeeth)->where,
        {std::to_string(tool.number), std::to_string(teeth.size()), std::to_string(kMostTeeth)});
    return;
  }
  for (const SheetTable* const table : teeth) {
    const TableKeys keys(*table);
    tool.teeth.push_back({keys.get(KeyId::ToothAngle, 0.0),
                          keys.get(KeyId::ToothRadius, 0.5 * tool.diameter_mm),
                          keys.get(KeyId::ToothLength, tool.length_mm)});
  }
}

/// The bodies end at the gauge line; the heights of sections begin at the lowest point.
void fill_bodies(probe::ToolSetup& tool, const std::vector<const SheetTable*>& bodies,
                 ErrorList& errors) {
  double height = 0.0;
  for (const SheetTable* const body : bodies) {
    height += length_of_body(*body);
  }
  if (!bodies.empty() && height >= tool.length_mm) {
    errors.add(
        SetupErrorId::OutOfRange, bodies.back()->where,
        {fmt::format("the height of the bodies of tool {}", tool.number), fmt::format("{}", height),
         fmt::format("less than the length of the tool, {} mm", tool.length_mm)},
        "they end at the gauge line");
    return;
  }
  double z = tool.length_mm - height;
  for (const SheetTable* const body : bodies) {
    tool.bodies.push_back(body_from(z, *body, "holder"));
    z += length_of_body(*body);
  }
}

void fill_lists(probe::ToolSetup& tool, const Sheet& sheet, std::size_t order, ErrorList& errors) {
  for (const SectionId section : {SectionId::ToolTooth, SectionId::ToolBody}) {
    const std::vector<const SheetTable*> own = within(sheet, section, order);
    if (!own.empty() && !may_have(section, tool.kind)) {
      const auto* const row =
          std::ranges::find(probe::kToolKindNames, tool.kind, &probe::ToolKindName::kind);
      const std::string_view path = row_of(section).path;
      errors.add(SetupErrorId::KeyOfOtherKind, own.front()->where,
                 {path.substr(path.find('.') + 1), row->name}, "leave it out");
    } else if (section == SectionId::ToolTooth) {
      fill_teeth(tool, own, errors);
    } else {
      fill_bodies(tool, own, errors);
    }
  }
}

/// Length and diameter of a tool are those of its longest and of its widest tooth.
struct ReachOfTeeth {
  KeyId of_tooth;
  KeyId of_tool;
  double probe::Tooth::*reach;
  double wanted;  ///< as the tool's own key says
  double shown;   ///< the value of that key
  const char* words;
};

/// At the tooth that reaches too far, else, where none reaches so far, at the tool's own key.
void check_reach(const probe::ToolSetup& tool, const ReachOfTeeth& row, const TableKeys& keys,
                 const std::vector<const SheetTable*>& teeth, ErrorList& errors) {
  const auto most = std::ranges::max_element(tool.teeth, {}, row.reach);
  constexpr double kSameMm = 1e-6;
  const double reach = (*most).*row.reach;
  const Entry* const own = keys.find(row.of_tool);
  if (own == nullptr || std::abs(reach - row.wanted) <= kSameMm) {
    return;  // what is missing is told already
  }
  const auto which = static_cast<std::size_t>(most - tool.teeth.begin());
  const Entry* const given = TableKeys(*teeth[which]).find(row.of_tooth);
  errors.add(SetupErrorId::TeethOfAnotherTool,
             reach > row.wanted && given != nullptr ? given->where : own->where,
             {std::to_string(tool.number), name_of_key(row.of_tool), fmt::format("{}", row.shown),
              row.words, fmt::format("{}", reach)},
             "give the tool what its teeth reach, or correct the tooth");
}

void check_teeth(const probe::ToolSetup& tool, const SheetTable& table,
                 const std::vector<const SheetTable*>& teeth, ErrorList& errors) {
  if (tool.teeth.empty()) {
    return;
  }
  const TableKeys keys(table);
  const ReachOfTeeth rows[] = {
      {KeyId::ToothLength, KeyId::ToolTrueLength, &probe::Tooth::length_mm, tool.length_mm,
       tool.length_mm, "longest tooth is"},
      {KeyId::ToothRadius, KeyId::ToolDiameter, &probe::Tooth::radius_mm, 0.5 * tool.diameter_mm,
       tool.diameter_mm, "widest tooth has a radius of"},
  };
  for (const ReachOfTeeth& row : rows) {
    check_reach(tool, row, keys, teeth, errors);
  }
}

void check_edges(const probe::ToolSetup& tool, const TableKeys& keys, ErrorList& errors) {
  if (const Entry* const corner = keys.find(KeyId::ToolCornerRadius);
      corner != nullptr && tool.corner_radius_mm > 0.5 * tool.diameter_mm) {
    errors.add(SetupErrorId::OutOfRange, corner->where,
               {"tool.corner_radius", fmt::format("{}", tool.corner_radius_mm),
                fmt::format("half the diameter at most, {} mm", 0.5 * tool.diameter_mm)});
  }
  if (const Entry* const edges = keys.find(KeyId::ToolCuttingLength);
      edges != nullptr && !(tool.cutting_length_mm < tool.length_mm)) {
    errors.add(SetupErrorId::OutOfRange, edges->where,
               {"tool.cutting_length", fmt::format("{}", tool.cutting_length_mm),
                fmt::format("less than the length of the tool, {} mm", tool.length_mm)});
  }
}

/// The core is thinner than the tool: its teeth stand out.
void check_core(const probe::ToolSetup& tool, const TableKeys& keys, ErrorList& errors) {
  double least = 0.5 * tool.diameter_mm;
  for (const probe::Tooth& tooth : tool.teeth) {
    least = std::min(least, tooth.radius_mm);
  }
  if (const Entry* const core = keys.find(KeyId::ToolCoreDiameter);
      core != nullptr && !(0.5 * tool.core_diameter_mm < least)) {
    errors.add(SetupErrorId::OutOfRange, core->where,
               {"tool.core_diameter", fmt::format("{}", tool.core_diameter_mm),
                fmt::format("less than that of all teeth, {} mm", 2.0 * least)});
  }
}

/// A cone must end below the gauge line.
void check_tip(const probe::ToolSetup& tool, const Location& where, ErrorList& errors) {
  if (tool.kind != ToolKind::Drill || tool.diameter_mm == 0.0 || tool.length_mm == 0.0) {
    return;  // no drill, or what is missing is told already
  }
  const auto is_too_long = [&](double radius, double length) {
    return !(probe::cone_height(tool, radius) < length);
  };
  const bool is_tooth = std::ranges::any_of(tool.teeth, [&](const probe::Tooth& tooth) {
    return is_too_long(tooth.radius_mm, tooth.length_mm);
  });
  if (is_tooth || is_too_long(0.5 * tool.diameter_mm, tool.length_mm)) {
    errors.add(SetupErrorId::OutOfRange, where,
               {"tool.tip_angle_deg", fmt::format("{}", tool.tip_angle_deg),
                "so wide that the cone is shorter than the tool"});
  }
}

probe::ToolSetup tool_with_shape_from(const TableKeys& keys) {
  probe::ToolSetup tool;
  tool.kind = kind_row_from(keys).kind;
  tool.length_mm = keys.get(KeyId::ToolTrueLength, tool.length_mm);
  tool.diameter_mm = keys.get(KeyId::ToolDiameter, tool.diameter_mm);
  tool.corner_radius_mm = keys.get(KeyId::ToolCornerRadius, tool.corner_radius_mm);
  if (tool.kind == ToolKind::Mill && tool.corner_radius_mm > 0.0) {
    tool.kind = ToolKind::BullMill;
  }
  tool.cutting_length_mm = keys.get(KeyId::ToolCuttingLength, tool.cutting_length_mm);
  tool.core_diameter_mm = keys.get(KeyId::ToolCoreDiameter, tool.core_diameter_mm);
  tool.tip_angle_deg = keys.get(KeyId::ToolTipAngle, tool.tip_angle_deg);
  const Point lengths = point_from(keys, KeyId::ToolLengths);
  tool.insert.lengths_mm = {lengths.x(), lengths.y(), lengths.z()};
  tool.insert.tip_radius_mm = keys.get(KeyId::ToolTipRadius, tool.insert.tip_radius_mm);
  tool.insert.edge_position = static_cast<int>(
      keys.get(KeyId::ToolEdgePosition, static_cast<double>(tool.insert.edge_position)));
  tool.insert.angle_deg = keys.get(KeyId::ToolInsertAngle, tool.insert.angle_deg);
  if (keys.find(KeyId::ToolOrientation) != nullptr) {
    tool.insert.orientation_deg = keys.get(KeyId::ToolOrientation, 0.0);
  }
  tool.insert.edge_length_mm = keys.get(KeyId::ToolEdgeLength, tool.insert.edge_length_mm);
  return tool;
}

/// The touch probe as a tool: one number for both.
void join_probe(Job& job, int number, const Location& where, ErrorList& errors) {
  if (!job.probe) {
    errors.add(SetupErrorId::KeyMissing, where, {"a tool of kind probe", "[probe]"},
               "write a [probe], or leave this [[tool]] out");
    return;
  }
  std::optional<int>& tool = job.probe->switching.tool;
  if (tool && *tool != number) {
    errors.add(SetupErrorId::OutOfRange, where,
               {"tool.number", std::to_string(number),
                fmt::format("{}, the tool that is the probe", *tool)},
               "one tool is the probe: probe.tool and the [[tool]] of kind probe have one number");
  }
  tool = number;
}

/// @param known  numbers of the tools before it
void fill_tool(Job& job, const Sheet& sheet, std::size_t order, std::set<int>& known,
               ErrorList& errors) {
  const SheetTable& table = list_of(sheet, SectionId::Tool)[order];
  const TableKeys keys(table);
  const Entry* const number = keys.find(KeyId::ToolWhich);
  if (!table.is_whole) {
    return;  // what is refused already would be missed again
  }
  if (number == nullptr) {
    errors.add(SetupErrorId::KeyMissing, table.where, {"a tool", "number"},
               "for example: number = 5");
    return;
  }
  check_keys_of_kind(table, kind_row_from(keys), errors);
  probe::ToolSetup tool = tool_with_shape_from(keys);
  tool.number = static_cast<int>(number_of(*number));
  check_edges(tool, keys, errors);
  fill_lists(tool, sheet, order, errors);
  check_teeth(tool, table, within(sheet, SectionId::ToolTooth, order), errors);
  check_core(tool, keys, errors);
  const Entry* const tip = keys.find(KeyId::ToolTipAngle);
  check_tip(tool, tip != nullptr ? tip->where : table.where, errors);
  if (!known.insert(tool.number).second) {
    errors.add(SetupErrorId::GivenTwice, number->where,
               {fmt::format("[[tool]] with number {}", tool.number)});
    return;
  }
  if (tool.kind == ToolKind::Probe) {
    join_probe(job, tool.number, number->where, errors);
  } else if (job.probe && job.probe->switching.tool == tool.number) {
    errors.add(SetupErrorId::OutOfRange, number->where,
               {"tool.number", std::to_string(tool.number), "another than probe.tool"},
               "the tool that is the probe has kind = \"probe\", or no [[tool]]");
  } else if (job.probe) {
    job.probe->switching.other_tools.push_back(tool.number);
  }
  job.tools.push_back(std::move(tool));
}

}  // namespace

void fill_tools(Job& job, const Sheet& sheet, ErrorList& errors) {
  const std::size_t count = list_of(sheet, SectionId::Tool).size();
  std::set<int> known;
  for (std::size_t order = 0; order < count; ++order) {
    fill_tool(job, sheet, order, known, errors);
  }
}

}  // namespace g31::setup

#include <algorithm>
#include <set>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/contract.h"
#include "tools/setup/fill_tools.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

constexpr double kUsualInputOfToolProbe = 2.0;
constexpr double kWidestDiscMm = 1000.0;

probe::ToolProbeShape shape_from(const TableKeys& keys) {
  const std::string given = keys.get(KeyId::ToolProbeShape, std::string("cube"));
  const auto* const row = std::ranges::find(probe::kToolProbeShapeNames, std::string_view(given),
                                            &probe::ToolProbeShapeName::name);
  G31_EXPECTS(row != probe::kToolProbeShapeNames.end());
  return row->shape;
}

/// How many sizes a shape has, and in words.
struct ShapeSizes {
  std::size_t count;
  const char* words;
};

ShapeSizes sizes_of(probe::ToolProbeShape shape) {
  switch (shape) {
    case probe::ToolProbeShape::Cube:
      return {3, "the edge of the cube or [x, y, z]"};
    case probe::ToolProbeShape::Disc:
      return {2, "[diameter, thickness] of the disc"};
    case probe::ToolProbeShape::Laser:
      return {2, "[length, diameter] of the beam"};
  }
  contract_violated("every shape of a tool probe has sizes", __FILE__, __LINE__);
}

void fill_size(probe::ToolProbeSetup& probe, const SheetTable& table, ErrorList& errors) {
  const Entry* const given = TableKeys(table).find(KeyId::ToolProbeSize);
  const bool is_cube = probe.shape == probe::ToolProbeShape::Cube;
  const ShapeSizes sizes = sizes_of(probe.shape);
  if (given == nullptr) {
    if (!is_cube) {
      errors.add(SetupErrorId::KeyMissing, table.where, {"a tool probe of this shape", "size"},
                 fmt::format("size is {}", sizes.words));
    }
    return;
  }
  const auto& list = std::get<std::vector<double>>(given->value);
  if (is_cube && list.size() == 1) {
    probe.size_mm.fill(list.front());
    return;
  }
  if (list.size() != sizes.count) {
    errors.add(SetupErrorId::OutOfRange, given->where,
               {"tool_probe.size", fmt::format("[{}]", fmt::join(list, ", ")), sizes.words});
    return;
  }
  probe.size_mm.fill(0.0);
  std::ranges::copy(list, probe.size_mm.begin());
  if (probe.shape == probe::ToolProbeShape::Disc && list.front() > kWidestDiscMm) {
    errors.add(SetupErrorId::OutOfRange, given->where,
               {"tool_probe.size", fmt::format("[{}]", fmt::join(list, ", ")),
                fmt::format("{} mm of a disc across at most", kWidestDiscMm)});
  }
}

/// A plate gives way, a beam of light sorts drips out.
void check_keys_of_shape(const probe::ToolProbeSetup& probe, const TableKeys& keys,
                         ErrorList& errors) {
  const bool is_beam = probe.shape == probe::ToolProbeShape::Laser;
  const std::vector<KeyId> others =
      is_beam ? std::vector{KeyId::ToolProbePreTravel, KeyId::ToolProbeDeflection}
              : std::vector{KeyId::ToolProbeFilter};
  for (const KeyId id : others) {
    if (const Entry* const given = keys.find(id)) {
      const auto* const shape = std::ranges::find(probe::kToolProbeShapeNames, probe.shape,
                                                  &probe::ToolProbeShapeName::shape);
      errors.add(SetupErrorId::KeyOfOtherShape, given->where,
                 {key_rows()[static_cast<std::size_t>(id)].name, shape->name}, "leave it out");
    }
  }
}

/// The signal comes before the plate breaks.
void check_pre_travel(const probe::ToolProbeSetup& probe, const TableKeys& keys,
                      ErrorList& errors) {
  const Entry* const given = keys.find(KeyId::ToolProbePreTravel);
  if (given != nullptr && !(probe.pre_travel_mm < probe.deflection_limit_mm)) {
    errors.add(SetupErrorId::OutOfRange, given->where,
               {"tool_probe.pre_travel_mm", fmt::format("{}", probe.pre_travel_mm),
                fmt::format("less than deflection_limit, {} mm", probe.deflection_limit_mm)});
  }
}

probe::ToolProbeSetup tool_probe_from(const SheetTable& table, ErrorList& errors) {
  const TableKeys keys(table);
  probe::ToolProbeSetup probe;
  probe.name = keys.get(KeyId::ToolProbeName, probe.name);
  probe.shape = shape_from(keys);
  fill_size(probe, table, errors);
  probe.p_M_at = point_from(keys, KeyId::ToolProbeAt);
  probe.rotate_deg = point_from(keys, KeyId::ToolProbeRotate);
  probe.side = keys.get(KeyId::ToolProbeSide, std::string("bed")) == "table"
                   ? probe::ToolProbeSide::Table
                   : probe::ToolProbeSide::Bed;
  probe.input = static_cast<int>(keys.get(KeyId::ToolProbeInput, kUsualInputOfToolProbe));
  probe.delay_s = keys.get(KeyId::ToolProbeDelay, probe.delay_s);
  probe.repeatability_mm = keys.get(KeyId::ToolProbeRepeatability, probe.repeatability_mm);
  probe.pre_travel_mm = keys.get(KeyId::ToolProbePreTravel, probe.pre_travel_mm);
  probe.deflection_limit_mm = keys.get(KeyId::ToolProbeDeflection, probe.deflection_limit_mm);
  probe.filter_s = keys.get(KeyId::ToolProbeFilter, probe.filter_s);
  check_keys_of_shape(probe, keys, errors);
  if (probe.shape != probe::ToolProbeShape::Laser) {
    check_pre_travel(probe, keys, errors);
  }
  return probe;
}

}  // namespace

void fill_tool_probes(Job& job, const Sheet& sheet, ErrorList& errors) {
  std::set<std::string> names;
  for (const SheetTable& table : list_of(sheet, SectionId::ToolProbe)) {
    if (!table.is_whole) {
      continue;  // what is refused already would be missed again
    }
    const probe::ToolProbeSetup probe = tool_probe_from(table, errors);
    if (!names.insert(probe.name).second) {
      const Entry* const name = TableKeys(table).find(KeyId::ToolProbeName);
      errors.add(SetupErrorId::GivenTwice, name != nullptr ? name->where : table.where,
                 {fmt::format("the tool probe \"{}\"", probe.name)}, "give each a name of its own");
    }
    job.tool_probes.push_back(probe);
  }
}

}  // namespace g31::setup

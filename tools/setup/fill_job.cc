#include "tools/setup/fill_job.h"

#include <algorithm>
#include <array>
#include <filesystem>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include <fmt/format.h>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"
#include "tools/setup/fill_characteristics.h"
#include "tools/setup/fill_expectations.h"
#include "tools/setup/fill_inputs.h"
#include "tools/setup/fill_machine.h"
#include "tools/setup/fill_probe.h"
#include "tools/setup/fill_sensors.h"
#include "tools/setup/fill_tools.h"
#include "tools/setup/part_mounts.h"
#include "tools/setup/part_on_offset.h"
#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

/// @pre "A", "B" or "C"
runtime::OffsetMemory offset_memory_from(const std::string& name) {
  if (name == "A") {
    return runtime::OffsetMemory::A;
  }
  return name == "B" ? runtime::OffsetMemory::B : runtime::OffsetMemory::C;
}

void fill_control(runtime::ControlSetup& control, const TableKeys& keys) {
  control.profile = keys.get(KeyId::ControlProfile, control.profile);
  control.increment = keys.get(KeyId::ControlIncrement, control.increment);
  control.axes = keys.get(KeyId::ControlAxes, control.axes);
  if (const Entry* const memory = keys.find(KeyId::ControlOffsetMemory)) {
    control.offset_memory = offset_memory_from(std::get<std::string>(memory->value));
  }
  if (const Entry* const rapids = keys.find(KeyId::ControlRapids)) {
    control.rapids = std::get<std::string>(rapids->value) == "straight"
                         ? machine::RapidPath::Straight
                         : machine::RapidPath::Independent;
  }
  control.lookahead_blocks = static_cast<int>(
      keys.get(KeyId::ControlLookahead, static_cast<double>(control.lookahead_blocks)));
  control.feed_switches.override_percent =
      keys.get(KeyId::ControlFeedOverride, control.feed_switches.override_percent);
  control.feed_switches.dry_run_mm_min =
      keys.get(KeyId::ControlDryRun, control.feed_switches.dry_run_mm_min);
  control.keys = keys.get(KeyId::ControlKeys, control.keys);
  control.files_folder = keys.get(KeyId::ControlFiles, control.files_folder);
  control.variables_file = keys.get(KeyId::ControlVariablesFile, control.variables_file);
  for (const double number : keys.get(KeyId::ControlBlockSkip, std::vector<double>{})) {
    control.block_skip.insert(static_cast<int>(number));
  }
}

void fill_parameters(runtime::ControlSetup& control, const SheetTable& table) {
  for (const auto& [number, entry] : table.entries) {
    control.parameters[number] = number_of(entry);
  }
}

void fill_macro_calls(runtime::ControlSetup& control, const SheetTable& table) {
  for (const auto& [code, entry] : table.entries) {
    control.macro_calls[code] = static_cast<int>(number_of(entry));
  }
}

void fill_variables(runtime::ControlSetup& control, const SheetTable& table) {
  for (const auto& [name, entry] : table.entries) {
    const auto* number = std::get_if<double>(&entry.value);
    control.variables[name] = number != nullptr ? std::optional(*number) : std::nullopt;
  }
}

void fill_data(runtime::ControlSetup& control, const SheetTable& table) {
  for (const auto& [name, entry] : table.entries) {
    if (const auto* const text = std::get_if<std::string>(&entry.value)) {
      control.data[name] = *text;
    } else if (const auto* const list = std::get_if<std::vector<double>>(&entry.value)) {
      control.data[name] = *list;
    } else {
      control.data[name] = number_of(entry);
    }
  }
}

/// What programs call an axis beside its letter: words with blanks between them.
void fill_axis_names(runtime::ControlSetup& control, const std::string& letter,
                     const TableKeys& keys) {
  std::istringstream names(keys.get(KeyId::AxisNames, std::string()));
  for (std::string name; names >> name;) {
    control.axis_names[name] = letter.front();
  }
}

runtime::FurtherAxisSetup further_axis_from(const TableKeys& keys) {
  runtime::FurtherAxisSetup axis;
  axis.home = keys.get(KeyId::AxisHome, axis.home);
  axis.rapid_per_min = keys.get(KeyId::AxisRapid, axis.rapid_per_min);
  const std::vector<double> travel =
      keys.get(KeyId::AxisTravel, std::vector<double>{axis.travel_min, axis.travel_max});
  axis.travel_min = travel.at(0);
  axis.travel_max = travel.at(1);
  return axis;
}

/// What an offset does beside shifting.
void fill_offset_shape(runtime::ControlSetup& control, const std::string& name,
                       const TableKeys& keys) {
  constexpr KeyId kShapes[] = {KeyId::WorkOffsetRotate, KeyId::WorkOffsetFine,
                               KeyId::WorkOffsetScale, KeyId::WorkOffsetMirror};
  if (std::ranges::none_of(kShapes, [&](KeyId id) { return keys.find(id) != nullptr; })) {
    return;
  }
  runtime::OffsetShape& shape = control.offset_shapes[name];
  shape.rotate_deg = keys.get(KeyId::WorkOffsetRotate, shape.rotate_deg);
  shape.fine_mm = keys.get(KeyId::WorkOffsetFine, shape.fine_mm);
  shape.scale = keys.get(KeyId::WorkOffsetScale, shape.scale);
  shape.mirrored = keys.get(KeyId::WorkOffsetMirror, shape.mirrored);
}

runtime::ToolEntry tool_from(const TableKeys& keys) {
  runtime::ToolEntry tool;
  tool.length_mm = keys.get(KeyId::ToolLength, tool.length_mm);
  tool.radius_mm = keys.get(KeyId::ToolRadius, tool.radius_mm);
  tool.length_wear_mm = keys.get(KeyId::ToolLengthWear, tool.length_wear_mm);
  tool.radius_wear_mm = keys.get(KeyId::ToolRadiusWear, tool.radius_wear_mm);
  tool.name = keys.get(KeyId::ToolName, tool.name);
  tool.type = keys.get(KeyId::ToolType, tool.type);
  return tool;
}

/// What the control knows of an axis of the machine.
void fill_axis_limits(runtime::ControlSetup& control, std::size_t axis, const TableKeys& keys) {
  control.q_M_reference[static_cast<Eigen::Index>(axis)] =
      keys.get(KeyId::AxisHome, machine::AxisSetup().home);
  if (keys.find(KeyId::AxisTravel) != nullptr) {
    const std::vector<double> limits = keys.get(KeyId::AxisTravel, std::vector<double>{});
    control.q_M_travel[static_cast<int>(axis)] = {limits.at(0), limits.at(1)};
  }
}

void fill_table(Job& job, SectionId section, const std::string& name, const SheetTable& table) {
  const TableKeys keys(table);
  switch (section) {
    case SectionId::Control:
      fill_control(job.control, keys);
      return;
    case SectionId::Parameters:
      fill_parameters(job.control, table);
      return;
    case SectionId::MacroCalls:
      fill_macro_calls(job.control, table);
      return;
    case SectionId::MachineData:
    case SectionId::UserData:
      fill_data(job.control, table);
      return;
    case SectionId::Variables:
      fill_variables(job.control, table);
      return;
    case SectionId::WorkOffsets:
      job.control.work_offsets[name] = positions_from(table);
      fill_offset_shape(job.control, name, keys);
      return;
    case SectionId::Tools:
      job.control.tools[std::stoi(name)] = tool_from(keys);
      return;
    case SectionId::Expect:
    case SectionId::ExpectVariables:
    case SectionId::ExpectOffsets:
    case SectionId::Start:
    case SectionId::Machine:
    case SectionId::MachineErrors:
    case SectionId::MachineCompensation:
    case SectionId::Believed:
    case SectionId::BelievedAxes:
    case SectionId::Probe:
    case SectionId::ProbeSecond:
      return;  // fill_expectations, fill_machine, fill_probe
    case SectionId::MachineAxes:
      fill_axis_names(job.control, name, keys);
      if (is_further_axis(name)) {
        job.control.further_axes[name.front()] = further_axis_from(keys);
        return;
      }
      fill_axis_limits(job.control, index_of_axis(name), keys);
      return;
    case SectionId::ProbeBall:
    case SectionId::ProbeBody:
    case SectionId::Part:
    case SectionId::Sensor:
    case SectionId::Tool:
    case SectionId::ToolTooth:
    case SectionId::ToolBody:
    case SectionId::ToolProbe:
    case SectionId::Input:
    case SectionId::SkipSignal:
    case SectionId::Characteristic:
      contract_violated("a list is not a table", __FILE__, __LINE__);
  }
}

/// One number is the same everywhere.
parts::ShapeProfile profile_from(const TableKeys& keys) {
  const std::vector<double> list = keys.get(KeyId::PartProfile, std::vector<double>{});
  if (list.size() == 1) {
    return {{0.0, list.front()}};
  }
  parts::ShapeProfile profile;
  for (std::size_t i = 0; i + 1 < list.size(); i += 2) {
    profile.push_back({list[i], list[i + 1]});
  }
  return profile;
}

/// Where the sheet says that a part lies on a work offset.
void take_offset(parts::PartSetup& part, const TableKeys& keys,
                 const runtime::ControlSetup& control, ErrorList& errors) {
  const Entry* const on = keys.find(KeyId::PartOn);
  if (on == nullptr) {
    return;
  }
  const auto offset = normal_name(NameForm::WorkOffset, std::get<std::string>(on->value));
  G31_EXPECTS(offset.has_value());
  if (!control.work_offsets.contains(*offset)) {
    errors.add(
        SetupErrorId::OffsetNotGiven, on->where, {*offset},
        fmt::format("for example: [work_offsets.{}] X = 250.0",
                    offset->find(' ') == std::string::npos ? *offset : "\"" + *offset + "\""));
    return;
  }
  put_on_offset(part, control, *offset);
}

parts::PartSetup part_from(const SheetTable& table, const runtime::ControlSetup& control,
                           ErrorList& errors) {
  const TableKeys keys(table);
  parts::PartSetup part;
  part.file = keys.get(KeyId::PartFile, part.file);
  part.shape = keys.get(KeyId::PartShape, part.shape);
  const std::string stem = std::filesystem::path(part.file).stem().string();
  part.name = keys.get(KeyId::PartName, part.shape.empty() ? stem : part.shape);
  part.step_sagitta_mm = keys.get(KeyId::PartStepSagitta, part.step_sagitta_mm);
  part.unit = keys.get(KeyId::PartUnit, part.unit);
  part.scale = keys.get(KeyId::PartScale, part.scale);
  part.is_closed = keys.get(KeyId::PartClosed, 1.0) != 0.0;
  part.is_fixture = keys.get(KeyId::PartFixture, 0.0) != 0.0;
  part.p_M_at = point_from(keys, KeyId::PartAt);
  part.rotate_deg = point_from(keys, KeyId::PartRotate);
  take_offset(part, keys, control, errors);
  part.growth.expansion = keys.get(KeyId::PartExpansion, part.growth.expansion);
  part.growth.temperature = keys.get(KeyId::PartTemperature, part.growth.temperature);
  for (const auto& [key, entry] : table.entries) {
    const std::optional<FoundKey> found = find_key(SectionId::Part, key);
    if (found && found->row->id == KeyId::PartShapeSize) {
      part.sizes[key] = number_of(entry);
    }
  }
  part.profile = profile_from(keys);

  std::error_code unreadable;
  const Entry* file = keys.find(KeyId::PartFile);
  if (file != nullptr && !std::filesystem::is_regular_file(part.file, unreadable)) {
    errors.add(SetupErrorId::FileNotFound, file->where, {part.file},
               std::filesystem::is_directory(part.file, unreadable)
                   ? "this is a folder: name a mesh or STEP file in it"
                   : "paths start at the folder of the sheet");
  }
  return part;
}

/// Where the settings stand that only the control can judge, or that more than one table decides.
void keep_places(Job& job, SectionId section, const std::string& name, const SheetTable& table) {
  if (section == SectionId::WorkOffsets || section == SectionId::Tools) {
    job.places.emplace(fmt::format("{}.{}", row_of(section).path, name), place_of(table.where));
    return;
  }
  if (section == SectionId::MachineAxes) {
    if (const Entry* const travel = TableKeys(table).find(KeyId::AxisTravel)) {
      job.places.emplace(fmt::format("{}.{}.travel", row_of(section).path, name),
                         place_of(travel->where));
    }
    return;
  }
  const bool is_data = section == SectionId::MachineData || section == SectionId::UserData;
  if (is_data || section == SectionId::Variables || section == SectionId::Parameters ||
      section == SectionId::MacroCalls || section == SectionId::Start ||
      section == SectionId::Control) {
    const std::string_view above = is_data ? "data" : row_of(section).path;
    for (const auto& [key, entry] : table.entries) {
      job.places.emplace(fmt::format("{}.{}", above, key), place_of(entry.where));
    }
  }
}

/// Where the sheet names what the part is made of.
source::ShownPlace place_of_body(const SheetTable& table) {
  const TableKeys keys(table);
  const Entry* const file = keys.find(KeyId::PartFile);
  const Entry* const body = file != nullptr ? file : keys.find(KeyId::PartShape);
  return place_of(body != nullptr ? body->where : table.where);
}

probe::SkipSignal skip_signal_from(const SheetTable& table) {
  const TableKeys keys(table);
  probe::SkipSignal signal;
  signal.axis = static_cast<int>(index_of_axis(keys.get(KeyId::SkipSignalAxis, std::string("X"))));
  if (const Entry* at = keys.find(KeyId::SkipSignalAt)) {
    signal.at = number_of(*at);
  }
  return signal;
}

}  // namespace

Job fill_job(const Sheet& sheet, ErrorList& errors) {
  Job job;
  for (const auto& [place, table] : sheet.tables) {
    fill_table(job, place.first, place.second, table);
    keep_places(job, place.first, place.second, table);
  }
  for (const SheetTable& table : list_of(sheet, SectionId::Part)) {
    job.parts.push_back(part_from(table, job.control, errors));
    job.has_parts_on_offsets |= TableKeys(table).find(KeyId::PartOn) != nullptr;
    job.part_places.push_back(place_of_body(table));
  }
  for (const Location& where : sheet.lost_variables) {
    job.lost_variables.push_back(place_of(where));
  }
  if (const auto probe = sheet.tables.find({SectionId::Probe, ""}); probe != sheet.tables.end()) {
    job.probe = probe_from(sheet, probe->second);
  }
  if (const auto list = sheet.lists.find(SectionId::SkipSignal); list != sheet.lists.end()) {
    job.skip_signals.emplace();
    for (const SheetTable& table : list->second) {
      job.skip_signals->push_back(skip_signal_from(table));
    }
  }
  job.expectations = expectations_from(sheet);
  job.expectations.characteristics = characteristics_from(sheet, job.parts, errors);
  job.control.inputs = inputs_from(sheet, errors);
  fill_sensors(job, sheet, errors);
  fill_tools(job, sheet, errors);
  fill_tool_probes(job, sheet, errors);
  job.machine = machine_from(sheet, errors);
  fill_mounts(job, sheet, errors);
  if (const Entry* const spindle = sheet.find(KeyId::MachineToolSpindle)) {
    job.control.tool_spindle = static_cast<int>(number_of(*spindle));
  }
  job.control.kinematics = believed_kinematics(sheet, job.machine, errors);
  if (job.probe) {
    const SheetTable& probe = sheet.tables.at({SectionId::Probe, ""});
    job.machine.wires = wires_of(probe, job.probe->input);
    job.machine.p_T_tip = {job.probe->eccentricity_mm[0], job.probe->eccentricity_mm[1],
                           -job.probe->length_mm};
  }
  job.second_probe = second_probe_from(sheet, job.probe, errors);
  return job;
}

}  // namespace g31::setup

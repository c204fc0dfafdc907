#include "tools/setup/fill_job.h"

#include <array>
#include <filesystem>
#include <set>
#include <string>
#include <vector>

#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::setup {
namespace {

/// The keys of one table, each with the value to take when it is not given.
class Keys {
 public:
  explicit Keys(const SheetTable& table) : table_(table) {}

  [[nodiscard]] const Entry* find(KeyId id) const {
    const KeyRow& row = key_rows()[static_cast<std::size_t>(id)];
    const auto entry = table_.entries.find(std::string(row.name));
    return entry != table_.entries.end() ? &entry->second : nullptr;
  }

  /// `Value` is the alternative of SheetValue that the key's type becomes.
  template <typename Value>
  [[nodiscard]] Value get(KeyId id, const Value& otherwise) const {
    const Entry* entry = find(id);
    return entry != nullptr ? std::get<Value>(entry->value) : otherwise;
  }

 private:
  const SheetTable& table_;
};

double number_of(const Entry& entry) {
  return std::get<double>(entry.value);
}

std::size_t index_of_axis(const std::string& letter) {
  const int index = axis_index(letter.front());
  G31_EXPECTS(index >= 0);
  return static_cast<std::size_t>(index);
}

AxisPositions positions_from(const SheetTable& table) {
  AxisPositions q = AxisPositions::Zero();
  for (const auto& [letter, entry] : table.entries) {
    q[static_cast<Eigen::Index>(index_of_axis(letter))] = number_of(entry);
  }
  return q;
}

Point point_from(const Keys& keys, KeyId id) {
  const std::vector<double> list = keys.get(id, std::vector<double>{0.0, 0.0, 0.0});
  return {list.at(0), list.at(1), list.at(2)};
}

/// @pre "A", "B" or "C"
runtime::OffsetMemory offset_memory_from(const std::string& name) {
  if (name == "A") {
    return runtime::OffsetMemory::A;
  }
  return name == "B" ? runtime::OffsetMemory::B : runtime::OffsetMemory::C;
}

void fill_control(runtime::ControlSetup& control, const Keys& keys) {
  control.profile = keys.get(KeyId::ControlProfile, control.profile);
  control.increment = keys.get(KeyId::ControlIncrement, control.increment);
  if (const Entry* const memory = keys.find(KeyId::ControlOffsetMemory)) {
    control.offset_memory = offset_memory_from(std::get<std::string>(memory->value));
  }
  control.lookahead_blocks = static_cast<int>(
      keys.get(KeyId::ControlLookahead, static_cast<double>(control.lookahead_blocks)));
  control.feed_switches.override_percent =
      keys.get(KeyId::ControlFeedOverride, control.feed_switches.override_percent);
  control.feed_switches.dry_run_mm_min =
      keys.get(KeyId::ControlDryRun, control.feed_switches.dry_run_mm_min);
  control.variables_file = keys.get(KeyId::ControlVariablesFile, control.variables_file);
  for (const double number : keys.get(KeyId::ControlBlockSkip, std::vector<double>{})) {
    control.block_skip.insert(static_cast<int>(number));
  }
}

void fill_variables(runtime::ControlSetup& control, const SheetTable& table) {
  for (const auto& [name, entry] : table.entries) {
    const auto* number = std::get_if<double>(&entry.value);
    control.variables[name] = number != nullptr ? std::optional(*number) : std::nullopt;
  }
}

runtime::ToolEntry tool_from(const Keys& keys) {
  runtime::ToolEntry tool;
  tool.length_mm = keys.get(KeyId::ToolLength, tool.length_mm);
  tool.radius_mm = keys.get(KeyId::ToolRadius, tool.radius_mm);
  tool.length_wear_mm = keys.get(KeyId::ToolLengthWear, tool.length_wear_mm);
  tool.radius_wear_mm = keys.get(KeyId::ToolRadiusWear, tool.radius_wear_mm);
  return tool;
}

void fill_axis(machine::AxisSetup& axis, const Keys& keys) {
  axis.present = true;
  const std::vector<double> travel =
      keys.get(KeyId::AxisTravel, std::vector<double>{axis.travel_min, axis.travel_max});
  axis.travel_min = travel.at(0);
  axis.travel_max = travel.at(1);
  axis.rapid_per_min = keys.get(KeyId::AxisRapid, axis.rapid_per_min);
  axis.acceleration_per_s2 = keys.get(KeyId::AxisAcceleration, axis.acceleration_per_s2);
  axis.home = keys.get(KeyId::AxisHome, axis.home);
}

probe::ProbeSetup probe_from(const Keys& keys) {
  probe::ProbeSetup probe;
  probe.ball_diameter_mm = keys.get(KeyId::ProbeBallDiameter, probe.ball_diameter_mm);
  probe.length_mm = keys.get(KeyId::ProbeLength, probe.length_mm);
  const std::vector<double> eccentricity =
      keys.get(KeyId::ProbeEccentricity, std::vector<double>{0.0, 0.0});
  probe.eccentricity_mm = {eccentricity.at(0), eccentricity.at(1)};
  probe.trigger_delay_s = keys.get(KeyId::ProbeTriggerDelay, probe.trigger_delay_s);
  probe.repeatability_mm = keys.get(KeyId::ProbeRepeatability, probe.repeatability_mm);
  return probe;
}

void fill_table(Job& job, SectionId section, const std::string& name, const SheetTable& table) {
  const Keys keys(table);
  switch (section) {
    case SectionId::Control:
      fill_control(job.control, keys);
      return;
    case SectionId::Parameters:
      for (const auto& [number, entry] : table.entries) {
        job.control.parameters[number] = number_of(entry);
      }
      return;
    case SectionId::MacroCalls:
      for (const auto& [code, entry] : table.entries) {
        job.control.macro_calls[code] = static_cast<int>(number_of(entry));
      }
      return;
    case SectionId::Variables:
      fill_variables(job.control, table);
      return;
    case SectionId::Start:
      job.machine.q_M_start = positions_from(table);
      return;
    case SectionId::WorkOffsets:
      job.control.work_offsets[name] = positions_from(table);
      return;
    case SectionId::Tools:
      job.control.tools[std::stoi(name)] = tool_from(keys);
      return;
    case SectionId::Machine:
      job.machine.name = keys.get(KeyId::MachineName, job.machine.name);
      return;
    case SectionId::MachineAxes:
      fill_axis(job.machine.axes.at(index_of_axis(name)), keys);
      job.control.q_M_reference[static_cast<Eigen::Index>(index_of_axis(name))] =
          job.machine.axes.at(index_of_axis(name)).home;
      return;
    case SectionId::Probe:
      job.probe = probe_from(keys);
      return;
    case SectionId::Part:
    case SectionId::SkipSignal:
      contract_violated("a list is no table", __FILE__, __LINE__);
  }
}

parts::PartSetup part_from(const SheetTable& table, ErrorList& errors) {
  const Keys keys(table);
  parts::PartSetup part;
  part.file = keys.get(KeyId::PartFile, part.file);
  part.shape = keys.get(KeyId::PartShape, part.shape);
  const std::string stem = std::filesystem::path(part.file).stem().string();
  part.name = keys.get(KeyId::PartName, part.shape.empty() ? stem : part.shape);
  part.p_M_at = point_from(keys, KeyId::PartAt);
  part.rotate_deg = point_from(keys, KeyId::PartRotate);
  for (const auto& [key, entry] : table.entries) {
    const std::optional<FoundKey> found = find_key(SectionId::Part, key);
    if (found && found->row->id == KeyId::PartShapeSize) {
      part.sizes[key] = number_of(entry);
    }
  }

  std::error_code unreadable;
  const Entry* file = keys.find(KeyId::PartFile);
  if (file != nullptr && !std::filesystem::is_regular_file(part.file, unreadable)) {
    errors.add(SetupErrorId::FileNotFound, file->where, {part.file},
               "paths start at the folder of the sheet");
  }
  return part;
}

/// Where the sheet names what the part is made of.
SheetPlace place_of_body(const SheetTable& table) {
  const Keys keys(table);
  const Entry* const file = keys.find(KeyId::PartFile);
  const Entry* const body = file != nullptr ? file : keys.find(KeyId::PartShape);
  const Location& where = body != nullptr ? body->where : table.where;
  return {where.document->path, where.line, where.column,
          std::string(where.document->line(where.line))};
}

probe::SkipSignal skip_signal_from(const SheetTable& table) {
  const Keys keys(table);
  probe::SkipSignal signal;
  signal.axis = static_cast<int>(index_of_axis(keys.get(KeyId::SkipSignalAxis, std::string("X"))));
  if (const Entry* at = keys.find(KeyId::SkipSignalAt)) {
    signal.at = number_of(*at);
  }
  return signal;
}

/// An ideal signal wants an ideal stop, unless the sheet says otherwise.
machine::Stopping stopping_from(const Sheet& sheet) {
  if (const Entry* given = sheet.find(KeyId::MachineStopping)) {
    return std::get<std::string>(given->value) == "ideal" ? machine::Stopping::Ideal
                                                          : machine::Stopping::Braking;
  }
  return sheet.lists.contains(SectionId::SkipSignal) ? machine::Stopping::Ideal
                                                     : machine::MachineSetup().stopping;
}

}  // namespace

Job fill_job(const Sheet& sheet, ErrorList& errors) {
  Job job;
  for (const auto& [place, table] : sheet.tables) {
    fill_table(job, place.first, place.second, table);
  }
  if (const auto parts = sheet.lists.find(SectionId::Part); parts != sheet.lists.end()) {
    for (const SheetTable& table : parts->second) {
      job.parts.push_back(part_from(table, errors));
      job.part_places.push_back(place_of_body(table));
    }
  }
  if (const auto list = sheet.lists.find(SectionId::SkipSignal); list != sheet.lists.end()) {
    job.skip_signals.emplace();
    for (const SheetTable& table : list->second) {
      job.skip_signals->push_back(skip_signal_from(table));
    }
  }
  job.machine.stopping = stopping_from(sheet);
  return job;
}

}  // namespace g31::setup

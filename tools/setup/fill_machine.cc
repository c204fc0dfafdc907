#include "tools/setup/fill_machine.h"

#include <algorithm>
#include <numbers>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/setup/table_keys.h"

namespace g31::setup {
namespace {

void fill_axis(machine::AxisSetup& axis, const TableKeys& keys) {
  axis.present = true;
  const std::vector<double> travel =
      keys.get(KeyId::AxisTravel, std::vector<double>{axis.travel_min, axis.travel_max});
  axis.travel_min = travel.at(0);
  axis.travel_max = travel.at(1);
  axis.rapid_per_min = keys.get(KeyId::AxisRapid, axis.rapid_per_min);
  axis.acceleration_per_s2 = keys.get(KeyId::AxisAcceleration, axis.acceleration_per_s2);
  axis.home = keys.get(KeyId::AxisHome, axis.home);
  axis.jerk_per_s3 = keys.get(KeyId::AxisJerk, axis.jerk_per_s3);
  axis.servo_gain = keys.get(KeyId::AxisServoGain, axis.servo_gain);
  axis.feed_forward = keys.get(KeyId::AxisFeedForward, axis.feed_forward);
  axis.contour_acceleration_per_s2 =
      keys.get(KeyId::AxisContourAcceleration, axis.contour_acceleration_per_s2);
  if (keys.find(KeyId::AxisCornerJump) != nullptr) {
    axis.corner_jump_per_min = keys.get(KeyId::AxisCornerJump, 0.0);
  }
  machine::VelocityLoopSetup& loop = axis.velocity_loop;
  loop.gain_per_s = keys.get(KeyId::AxisVelocityGain, loop.gain_per_s);
  loop.reset_s = keys.get(KeyId::AxisVelocityReset, loop.reset_s);
  loop.friction_per_s2 = keys.get(KeyId::AxisFriction, loop.friction_per_s2);
  loop.friction_way = keys.get(KeyId::AxisFrictionWay, loop.friction_way);
  axis.scale_resolution = keys.get(KeyId::AxisResolution, axis.scale_resolution);
  axis.play.backlash = keys.get(KeyId::AxisBacklash, axis.play.backlash);
  axis.play.spike = keys.get(KeyId::AxisSpike, axis.play.spike);
  axis.play.spike_way = keys.get(KeyId::AxisSpikeWay, axis.play.spike_way);
  errors::CyclicErrorSetup& cyclic = axis.cyclic_error;
  cyclic.amplitude = keys.get(KeyId::AxisCyclicError, cyclic.amplitude);
  cyclic.pitch = keys.get(KeyId::AxisCyclicPitch, cyclic.pitch);
  cyclic.phase_deg = keys.get(KeyId::AxisCyclicPhase, cyclic.phase_deg);
  axis.scale_growth.expansion = keys.get(KeyId::AxisExpansion, axis.scale_growth.expansion);
  axis.scale_growth.temperature = keys.get(KeyId::AxisTemperature, axis.scale_growth.temperature);
  axis.scale_fixed_at = keys.get(KeyId::AxisFixedAt, axis.scale_fixed_at);
}

/// With more than that the axis would go back while its encoder goes on: no screw does.
void check_cyclic_error(const machine::AxisSetup& axis, const SheetTable& table,
                        const std::string& letter, ErrorList& errors) {
  const double most = axis.cyclic_error.pitch / (2.0 * std::numbers::pi);
  if (axis.cyclic_error.amplitude >= most) {
    errors.add(SetupErrorId::CyclicErrorTurnsBack, table.where, {letter},
               fmt::format("with this cyclic_pitch, cyclic_error has to be below {:.6g}", most));
  }
}

/// A position loop that is too fast for its velocity loop swings ever farther.
void check_loops(const machine::AxisSetup& axis, const SheetTable& table, const std::string& letter,
                 ErrorList& errors) {
  if (!axis.velocity_loop.is_there() || axis.servo_gain <= 0.0) {
    return;
  }
  const double position_gain_per_s = axis.servo_gain / machine::kSecondsAtGainOne;
  if (!machine::settles({axis.velocity_loop, position_gain_per_s, 0.0})) {
    errors.add(SetupErrorId::LoopsSwing, table.where, {letter},
               fmt::format("servo_gain makes {:.6g} 1/s of the position loop: a velocity_gain of "
                           "several times that, and at most 10000",
                           position_gain_per_s));
  }
}

void fill_machine(machine::MachineSetup& machine, const TableKeys& keys) {
  machine.name = keys.get(KeyId::MachineName, machine.name);
  machine.stop_delay_s = keys.get(KeyId::MachineStopDelay, machine.stop_delay_s);
  machine.in_position = keys.get(KeyId::MachineInPosition, machine.in_position);
}

errors::ErrorTable error_table(const std::vector<double>& list) {
  std::vector<errors::ErrorTable::Row> rows;
  if (list.size() == 1) {
    rows.push_back({0.0, list.front()});
  }
  for (std::size_t i = 1; i < list.size(); i += 2) {
    rows.push_back({list[i - 1], list[i]});
  }
  return errors::ErrorTable(std::move(rows));
}

/// Of a table whose keys are the names of ISO 230-1, and some others.
errors::GeometricErrorSetup along_axes(const SheetTable& table) {
  errors::GeometricErrorSetup setup;
  for (const auto& [name, entry] : table.entries) {
    if (const auto* list = std::get_if<std::vector<double>>(&entry.value)) {
      const std::size_t along = index_of_axis(name.substr(2, 1));
      setup.along.at(along).at(index_of_axis(name.substr(1, 1))) = error_table(*list);
    }
  }
  return setup;
}

errors::GeometricErrorSetup errors_from(const SheetTable& table) {
  const TableKeys keys(table);
  errors::GeometricErrorSetup setup = along_axes(table);
  setup.a0z = keys.get(KeyId::ErrorA0Z, setup.a0z);
  setup.b0z = keys.get(KeyId::ErrorB0Z, setup.b0z);
  setup.c0y = keys.get(KeyId::ErrorC0Y, setup.c0y);
  return setup;
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

std::string text_of(const Sheet& sheet, KeyId id, const std::string& otherwise) {
  const Entry* entry = sheet.find(id);
  return entry != nullptr ? std::get<std::string>(entry->value) : otherwise;
}

bool is_linear(char letter) {
  return is_linear_axis(axis_index(letter));
}

/// The sides as the sheet gives them: together they name every axis of the machine once.
void fill_chain(machine::MachineSetup& machine, const Sheet& sheet, ErrorList& errors) {
  const Entry* table_side = sheet.find(KeyId::MachineTableSide);
  const Entry* tool_side = sheet.find(KeyId::MachineToolSide);
  const Entry* named = table_side != nullptr ? table_side : tool_side;
  if (named == nullptr) {
    return;
  }
  machine::AxisChainSetup& chain = machine.chain;
  chain.table_side = text_of(sheet, KeyId::MachineTableSide, "");
  chain.tool_side = text_of(sheet, KeyId::MachineToolSide, "XYZ");
  const std::string part_to_tool = chain.table_side + chain.tool_side;
  for (std::size_t i = 0; i < kAxisCount; ++i) {
    const std::string letter(1, kAxisLetters[i]);
    const auto times = std::ranges::count(part_to_tool, letter.front());
    const auto section = sheet.tables.find({SectionId::MachineAxes, letter});
    if (times > 1) {
      errors.add(SetupErrorId::AxisTwiceInChain, named->where, {letter});
    } else if (times == 0 && section != sheet.tables.end()) {
      errors.add(SetupErrorId::AxisNotInChain, section->second.where, {letter});
    }
    machine.axes.at(i).present = times > 0;
  }
  std::string linear;
  std::ranges::copy_if(part_to_tool + "XYZ", std::back_inserter(linear), [&](char letter) {
    return is_linear(letter) && linear.find(letter) == std::string::npos;
  });
  std::ranges::transform(linear, machine.geometric_errors.part_to_tool.begin(), axis_index);
}

/// The keys that say where a rotary axis is.
struct RotaryKeys {
  KeyId centre;
  KeyId direction;
};
constexpr RotaryKeys kTrueAxis{KeyId::AxisCentre, KeyId::AxisDirection};
constexpr RotaryKeys kBelievedAxis{KeyId::BelievedCentre, KeyId::BelievedDirection};

/// What is given changes the line.
void fill_rotary(machine::AxisChainSetup& chain, const std::string& letter, const TableKeys& keys,
                 const RotaryKeys& names) {
  if (is_linear(letter.front())) {
    return;
  }
  machine::RotaryLine& line =
      chain.rotary.at(index_of_axis(letter) - std::size_t{kLinearAxisCount});
  if (keys.find(names.centre) != nullptr) {
    line.p_M_centre = point_from(keys, names.centre);
  }
  if (keys.find(names.direction) != nullptr) {
    line.axis_M = point_from(keys, names.direction);
  }
}

}  // namespace

machine::MachineSetup machine_from(const Sheet& sheet, ErrorList& errors) {
  machine::MachineSetup machine;
  for (const auto& [place, table] : sheet.tables) {
    const TableKeys keys(table);
    if (place.first == SectionId::Start) {
      machine.q_M_start = positions_from(table);
    } else if (place.first == SectionId::Machine) {
      fill_machine(machine, keys);
    } else if (place.first == SectionId::MachineAxes && !is_further_axis(place.second)) {
      machine::AxisSetup& axis = machine.axes.at(index_of_axis(place.second));
      fill_axis(axis, keys);
      check_cyclic_error(axis, table, place.second, errors);
      check_loops(axis, table, place.second, errors);
      fill_rotary(machine.chain, place.second, keys, kTrueAxis);
    } else if (place.first == SectionId::MachineErrors) {
      machine.geometric_errors = errors_from(table);
    } else if (place.first == SectionId::MachineCompensation) {
      machine.compensation = along_axes(table);
    }
  }
  machine.stopping = stopping_from(sheet);
  fill_chain(machine, sheet, errors);
  return machine;
}

machine::AxisChainSetup believed_kinematics(const Sheet& sheet,
                                            const machine::MachineSetup& machine,
                                            ErrorList& errors) {
  machine::AxisChainSetup believed = machine.chain;
  for (const auto& [place, table] : sheet.tables) {
    if (place.first != SectionId::BelievedAxes) {
      continue;
    }
    if ((believed.table_side + believed.tool_side).find(place.second) == std::string::npos) {
      errors.add(SetupErrorId::NoSuchRotaryAxis, table.where, {place.second},
                 "table_side and tool_side of [machine] name its rotary axes");
    }
    fill_rotary(believed, place.second, TableKeys(table), kBelievedAxis);
  }
  return believed;
}

}  // namespace g31::setup

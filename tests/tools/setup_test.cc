#include <limits>
#include <string>
#include <tuple>
#include <vector>

#include <gtest/gtest.h>

#include "tests/tools/setup_sheets.h"
#include "tools/setup/keys.h"
#include "tools/setup/toml_reader.h"

namespace g31::setup::setup_test {
namespace {

class SetupReader : public SetupSheets {
 protected:
  SetupReader() {
    static_cast<void>(write("ring.stl", "solid ring\nendsolid ring\n"));
    static_cast<void>(write("base.toml", ""));
  }
  /// The job, or the default one with a failure that shows the errors.
  [[nodiscard]] Job job(const std::vector<std::string>& sheets) const {
    const auto result = read(sheets);
    EXPECT_EQ(errors_of(result), "");
    return result ? result.value() : Job{};
  }
};

TEST_F(SetupReader, EmptySheetsGiveTheDefaultJob) {
  const std::vector<std::vector<std::string>> kCases = {{}, {""}, {"# nothing\n", "\n"}};
  for (const auto& sheets : kCases) {
    SCOPED_TRACE(sheets.size());
    const Job read = job(sheets);
    EXPECT_EQ(read.control.profile, "");
    EXPECT_TRUE(read.control.parameters.empty() && read.control.variables.empty());
    EXPECT_TRUE(read.control.tools.empty() && read.control.work_offsets.empty());
    EXPECT_EQ(read.machine.name, "ideal three-axis machine");
    EXPECT_EQ(read.machine.stopping, machine::Stopping::Braking);
    EXPECT_TRUE(read.machine.axes[2].present && !read.machine.axes[3].present);
    EXPECT_FALSE(read.probe.has_value());
    EXPECT_TRUE(read.parts.empty());
    EXPECT_FALSE(read.skip_signals.has_value());
  }
}

TEST_F(SetupReader, TheSheetOfTheTestHasEveryKeyOfTheTable) {
  const std::string sheet = kEveryKey;
  for (const KeyRow& row : key_rows()) {
    if (row.name_form == NameForm::Exact) {
      EXPECT_NE(sheet.find("\n" + std::string(row.name) + " = "), std::string::npos) << row.name;
    }
  }
}

TEST_F(SetupReader, ControlKeysArrive) {
  const runtime::ControlSetup control = job({kEveryKey}).control;
  EXPECT_EQ(control.profile, "fanuc-16i");
  EXPECT_EQ(control.increment, "IS-C");
  EXPECT_EQ(control.offset_memory, runtime::OffsetMemory::B);
  EXPECT_EQ(control.axes, "XYZB");
  EXPECT_EQ(control.block_skip, (std::set<int>{1, 9}));
  EXPECT_EQ(control.lookahead_blocks, 3);
  EXPECT_EQ(control.feed_switches.override_percent, 80.0);
  EXPECT_EQ(control.feed_switches.dry_run_mm_min, 1500.0);
  EXPECT_EQ(control.rapids, machine::RapidPath::Straight);
  EXPECT_EQ(control.variables_file, path_of("v55.vars"));
  EXPECT_EQ(control.files_folder, path_of("logs"));
  EXPECT_EQ(control.keys, "NY");
  EXPECT_EQ(std::get<double>(control.data.at("$MN_OEM_LIMIT")), 5.0);
  EXPECT_EQ(std::get<std::vector<double>>(control.data.at("LIMITS")),
            (std::vector<double>{0.1, 0.2}));
  EXPECT_EQ(std::get<std::string>(control.data.at("PALLET_NAME")), "A");
  EXPECT_EQ(control.offset_shapes.at("G505").fine_mm, (std::vector<double>{0.05, 0.0, 0.0}));
  EXPECT_EQ(control.offset_shapes.at("G505").mirrored, "X");
  EXPECT_EQ(control.parameters, (std::map<std::string, double>{{"6001.0", 0.0},
                                                               {"6001.1", 1.0},
                                                               {"6001.7", 1.0},
                                                               {"3410", 0.01},
                                                               {"5114", -7},
                                                               {"1241.Z", -150.5}}));
  EXPECT_EQ(control.macro_calls, (std::map<std::string, int>{{"G100", 9010}, {"M6", 99999999}}));
  EXPECT_EQ(control.variables,
            (std::map<std::string, std::optional<double>>{{"#515", 6.0},
                                                          {"#516", std::nullopt},
                                                          {"R1", -2.0},
                                                          {"_OVR[0]", 0.25},
                                                          {"$P_UIFR[1,X,TR]", 17.0}}));
}

TEST_F(SetupReader, AxesThatCarryNothingAndNamesOfAxesArrive) {
  const runtime::ControlSetup control =
      job({"[machine.axes.W]\nhome = -3.0\nrapid = 12000.0\ntravel = [-5.0, 300.0]\n"
           "[machine.axes.V]\n[machine.axes.C]\nnames = \"SP1 C4\"\n"})
          .control;
  ASSERT_EQ(control.further_axes.size(), 2U);
  const runtime::FurtherAxisSetup& axis = control.further_axes.at('W');
  EXPECT_EQ(axis.home, -3.0);
  EXPECT_EQ(axis.rapid_per_min, 12000.0);
  EXPECT_EQ(axis.travel_min, -5.0);
  EXPECT_EQ(axis.travel_max, 300.0);
  EXPECT_EQ(control.further_axes.at('V').rapid_per_min, 20000.0);
  EXPECT_EQ(control.axis_names, (std::map<std::string, char>{{"C4", 'C'}, {"SP1", 'C'}}));
}

TEST_F(SetupReader, OffsetsAndToolsArrive) {
  const runtime::ControlSetup control = job({kEveryKey}).control;
  ASSERT_EQ(control.work_offsets.size(), 4U);
  EXPECT_EQ(control.work_offsets.at("G59"),
            (AxisPositions() << 250.0, 0.0, 0.0, 0.0, 30.0, 0.0).finished());
  EXPECT_EQ(control.work_offsets.at("EXT"), AxisPositions::Zero());
  EXPECT_EQ(control.work_offsets.at("G54.1 P12")[2], -1.0);
  EXPECT_EQ(control.work_offsets.at("G505")[1], 8.0);
  ASSERT_EQ(control.tools.size(), 2U);
  EXPECT_EQ(control.tools.at(0).length_mm, 0.0);
  EXPECT_EQ(control.tools.at(99).length_mm, 120.0);
  EXPECT_EQ(control.tools.at(99).radius_mm, 3.0);
  EXPECT_EQ(control.tools.at(99).length_wear_mm, 0.02);
  EXPECT_EQ(control.tools.at(99).radius_wear_mm, -0.01);
}

TEST_F(SetupReader, MachineKeysArrive) {
  const machine::MachineSetup machine = job({kEveryKey}).machine;
  EXPECT_EQ(machine.name, "V55");
  EXPECT_EQ(machine.stopping, machine::Stopping::Ideal);
  EXPECT_EQ(machine.q_M_start, (AxisPositions() << 1.0, 2.0, 3.5, 0.0, 0.0, 45.0).finished());
  EXPECT_EQ(machine.axes[0].travel_min, -10.0);
  EXPECT_EQ(machine.axes[0].travel_max, 900.0);
  EXPECT_EQ(machine.axes[0].rapid_per_min, 48000.0);
  EXPECT_EQ(machine.axes[0].acceleration_per_s2, 5000.0);
  EXPECT_EQ(machine.axes[0].home, 0.5);
  EXPECT_EQ(job({kEveryKey}).control.q_M_reference[0], 0.5) << "the control knows the mark, too";
  EXPECT_TRUE(machine.axes[1].present) << "an axis of a side needs no table of its own";
  EXPECT_EQ(machine.axes[1].travel_max, std::numeric_limits<double>::infinity());
  EXPECT_FALSE(machine.axes[3].present);
  EXPECT_TRUE(machine.axes[4].present) << "[machine.axes.B] adds the axis";
}

TEST_F(SetupReader, WhatARealMachineDoesArrives) {
  const machine::MachineSetup machine = job({kEveryKey}).machine;
  EXPECT_EQ(machine.stop_delay_s, 0.016);
  EXPECT_EQ(machine.in_position, 0.02);
  EXPECT_EQ(machine.axes[0].jerk_per_s3, 50000.0);
  EXPECT_EQ(machine.axes[0].servo_gain, 1.8);
  EXPECT_EQ(machine.axes[0].feed_forward, 0.9);
  EXPECT_EQ(machine.axes[0].contour_acceleration_per_s2, 1000.0);
  EXPECT_EQ(machine.axes[0].corner_jump_per_min, 0.0);
  EXPECT_EQ(machine.axes[0].velocity_loop.gain_per_s, 250.0);
  EXPECT_EQ(machine.axes[0].velocity_loop.reset_s, 0.02);
  EXPECT_EQ(machine.axes[0].velocity_loop.friction_per_s2, 300.0);
  EXPECT_EQ(machine.axes[0].velocity_loop.friction_way, 0.03);
  EXPECT_EQ(machine.axes[0].scale_resolution, 0.0001);
  EXPECT_EQ(machine.axes[0].play.backlash, 0.002);
  EXPECT_EQ(machine.axes[0].play.spike, 0.003);
  EXPECT_EQ(machine.axes[0].play.spike_way, 0.04);
  EXPECT_EQ(machine.axes[0].scale_growth.expansion, 11.5);
  EXPECT_EQ(machine.axes[0].scale_growth.temperature, 25.5);
  EXPECT_EQ(machine.axes[0].scale_fixed_at, 450.0);
  EXPECT_EQ(machine.chain.table_side, "BX");
  EXPECT_EQ(machine.chain.tool_side, "YZ");
  EXPECT_EQ(machine.chain.rotary[1].p_M_centre, Point(1.0, 2.0, -400.0));
  EXPECT_EQ(machine.chain.rotary[1].axis_M, Point(0.0, -1.0, 0.001));
  EXPECT_EQ(machine.chain.rotary[2].axis_M, Point::UnitZ());
  EXPECT_EQ(machine.p_T_tip, Point(0.02, -0.03, -119.5)) << "the ball of the probe";
  const errors::GeometricErrorSetup& errors = machine.geometric_errors;
  EXPECT_EQ(errors.along[0][0].at(225.25), 0.001);
  EXPECT_EQ(errors.along[0][0].at(1000.0), -0.001);
  EXPECT_EQ(errors.along[0][5].at(77.0), -3.5) << "one number holds everywhere";
  EXPECT_EQ(errors.along[2][3].at(0.0), 4.0);
  EXPECT_TRUE(errors.along[1][0].is_zero());
  EXPECT_EQ(errors.a0z, 5.0);
  EXPECT_EQ(errors.b0z, -4.0);
  EXPECT_EQ(errors.c0y, 8.0);
  EXPECT_EQ(errors.part_to_tool, (std::array<int, 3>{0, 1, 2}));
  EXPECT_EQ(job({"[machine]\ntool_side = \"ZYX\"\n"}).machine.geometric_errors.part_to_tool,
            (std::array<int, 3>{2, 1, 0}));
}

TEST_F(SetupReader, WhatTheControlBelievesIsTheMachineUnlessSaidOtherwise) {
  const Job read = job({kEveryKey});
  EXPECT_NE(read.control.kinematics, read.machine.chain);
  EXPECT_EQ(read.control.kinematics.tool_side, "YZ");
  EXPECT_EQ(read.control.kinematics.rotary[1].p_M_centre, Point(1.0, 2.03, -400.0));
  EXPECT_EQ(read.control.kinematics.rotary[1].axis_M, Point(0.0, -1.0, 0.0));
  EXPECT_EQ(read.control.kinematics.rotary[0], read.machine.chain.rotary[0]);

  const std::string table =
      "[machine]\ntable_side = \"CA\"\n[machine.axes.A]\n"
      "centre = [0.0, 20.0, -450.0]\ndirection = [1.0, 0.0, 0.1]\n";
  const Job equal = job({table});
  EXPECT_EQ(equal.control.kinematics, equal.machine.chain);
  const Job half = job({table, "[believed.axes.A]\ncentre = [0.0, 20.01, -450.0]\n"});
  EXPECT_EQ(half.control.kinematics.rotary[0].p_M_centre, Point(0.0, 20.01, -450.0));
  EXPECT_EQ(half.control.kinematics.rotary[0].axis_M, Point(1.0, 0.0, 0.1));
  EXPECT_EQ(half.machine.chain, equal.machine.chain) << "the machine stays what it is";
  EXPECT_EQ(job({"[start]\nX = 0.0\n"}).control.kinematics, machine::AxisChainSetup());
}

TEST_F(SetupReader, TheProbeIsATool) {
  const Job read = job({kEveryKey});
  EXPECT_EQ(read.probe->input, 2);
  EXPECT_EQ(read.probe->switching.tool, 7);
  EXPECT_EQ(read.probe->switching.on, (probe::ProgramSwitch{probe::ProgramSwitch::Kind::Code, 80}));
  EXPECT_EQ(read.probe->switching.off,
            (probe::ProgramSwitch{probe::ProgramSwitch::Kind::Code, 81}));
  ASSERT_EQ(read.machine.wires.size(), 2U);
  EXPECT_EQ(read.machine.wires[0].number, 1004);
  EXPECT_EQ(read.machine.wires[0].source, machine::InputWire::Source::Ready);
  EXPECT_EQ(read.machine.wires[1].number, 5);
  EXPECT_EQ(read.machine.wires[1].source, machine::InputWire::Source::Signal);
  EXPECT_EQ(read.machine.wires[1].measuring_input, 2);
  const Job plain = job({"[probe]\n"});
  EXPECT_EQ(plain.probe->input, 1);
  EXPECT_FALSE(plain.probe->switching.is_up_to_program());
  EXPECT_TRUE(plain.machine.wires.empty());
}

TEST_F(SetupReader, InputsArriveInTheirOrderBehindThatOfTheBattery) {
  using From = runtime::InputStep::From;
  const std::vector<runtime::InputStep> inputs = job({kEveryKey}).control.inputs;
  ASSERT_EQ(inputs.size(), 5U);
  const std::vector<std::tuple<int, bool, From, double>> expected = {{1005, true, From::Start, 0.0},
                                                                     {1003, false, From::Time, 2.5},
                                                                     {7, true, From::Block, 120.0},
                                                                     {7, true, From::Reads, 3.0},
                                                                     {7, true, From::Code, 21.0}};
  for (std::size_t i = 0; i < inputs.size(); ++i) {
    EXPECT_EQ(std::tuple(inputs[i].number, inputs[i].value, inputs[i].from, inputs[i].at),
              expected[i])
        << i;
  }
}

TEST_F(SetupReader, TheSidesOfTheMachineSayWhichAxesItHas) {
  const machine::MachineSetup lathe = job({"[machine]\ntool_side = \"ZX\"\n"}).machine;
  EXPECT_TRUE(lathe.axes[0].present && lathe.axes[2].present);
  EXPECT_FALSE(lathe.axes[1].present);
  const machine::MachineSetup table = job({"[machine]\ntable_side = \"CA\"\n"}).machine;
  EXPECT_TRUE(table.axes[1].present && table.axes[3].present && table.axes[5].present);
  EXPECT_FALSE(table.axes[4].present);
}

TEST_F(SetupReader, AMachineFileIsFoundAmongTheShippedOnes) {
  static_cast<void>(write("shipped/small.toml", "name = \"small\"\n"));
  const std::string folder = path_of("shipped");
  const std::string sheet = write("sheet.toml", "[machine]\nfile = \"small.toml\"\n");
  const auto found = read_job(std::vector<std::string>{sheet}, folder);
  ASSERT_TRUE(found.ok()) << errors_of(found);
  EXPECT_EQ(found.value().machine.name, "small");
  static_cast<void>(write("small.toml", "name = \"beside the sheet\"\n"));
  const auto nearer = read_job(std::vector<std::string>{sheet}, folder);
  ASSERT_TRUE(nearer.ok()) << errors_of(nearer);
  EXPECT_EQ(nearer.value().machine.name, "beside the sheet");
}

TEST_F(SetupReader, ProfilesAndSensorsArrive) {
  const Job read = job({kEveryKey});
  EXPECT_EQ(read.parts.at(3).profile, (parts::ShapeProfile{{0.0, 0.001}, {500.0, -0.002}}));
  EXPECT_TRUE(read.parts.at(1).profile.empty());
  ASSERT_EQ(read.sensors.size(), 2U);
  const probe::DisplacementSetup& sensor = read.sensors[0];
  EXPECT_EQ(sensor.name, "A");
  EXPECT_EQ(sensor.p_T_at, Point(100, 0, -80));
  EXPECT_EQ(sensor.along_T, Point(0, -1, 0));
  EXPECT_EQ(sensor.range_mm, 5.0);
  EXPECT_EQ(sensor.resolution_mm, 0.0002);
  EXPECT_EQ(sensor.spot_mm, 2.0);
  EXPECT_EQ(sensor.noise_mm, 0.0001);
  EXPECT_EQ(sensor.input, 3);
  EXPECT_EQ(read.sensors[1].name, "sensor2");
  EXPECT_EQ(read.sensors[1].input, 2);
  EXPECT_EQ(read.sensors[1].along_T, Point(0, 0, -1));
  ASSERT_EQ(read.control.sensor_words.size(), 2U);
  EXPECT_EQ(read.control.sensor_words[0].number, 1033);
  EXPECT_EQ(read.control.sensor_words[0].count_mm, 0.0002);
  EXPECT_EQ(read.control.sensor_words[1].number, 1133);
  EXPECT_EQ(read.control.sensor_words[1].count_mm, 0.0001);
}

TEST_F(SetupReader, ProbePartsAndSignalsArrive) {
  const Job read = job({kEveryKey});
  ASSERT_TRUE(read.probe.has_value());
  EXPECT_EQ(read.probe->ball_diameter_mm, 5.9);
  EXPECT_EQ(read.probe->length_mm, 119.5);
  EXPECT_EQ(read.probe->eccentricity_mm, (std::array<double, 2>{0.02, -0.03}));
  EXPECT_EQ(read.probe->trigger_delay_s, 0.001);
  EXPECT_EQ(read.probe->repeatability_mm, 0.0005);
  const probe::SwitchSetup& at_switch = read.probe->at_switch;
  EXPECT_EQ(at_switch.type, probe::ProbeType::Mono);
  EXPECT_EQ(at_switch.mono_direction_deg, 90.0);
  EXPECT_EQ(at_switch.pre_travel_mm, 0.01);
  EXPECT_EQ(at_switch.seats, probe::Seats::Tripod);
  EXPECT_EQ(at_switch.weak_direction_deg, 30.0);
  EXPECT_EQ(at_switch.trigger_force_n, 0.5);
  EXPECT_EQ(at_switch.axial_force_n, 5.5);
  EXPECT_EQ(at_switch.stem_stiffness_n_mm, 40.0);
  EXPECT_EQ(read.probe->state, probe::ProbeState::LowBattery);
  ASSERT_EQ(read.probe->further_balls.size(), 2U);
  EXPECT_EQ(read.probe->further_balls[0].p_S_from_main, Point(30, 0, 10));
  EXPECT_EQ(read.probe->further_balls[0].diameter_mm, 4.0);
  EXPECT_EQ(read.probe->further_balls[1].p_S_from_main, Point(0, 0, 0));
  EXPECT_EQ(read.probe->further_balls[1].diameter_mm, 5.9) << "as thick as the main ball";

  ASSERT_EQ(read.parts.size(), 4U);
  EXPECT_EQ(read.parts[0].name, "mesh");
  EXPECT_EQ(read.parts[0].file, path_of("ring.stl"));
  EXPECT_EQ(read.parts[0].step_sagitta_mm, 0.002);
  EXPECT_EQ(read.parts[0].unit, "cm");
  EXPECT_EQ(read.parts[0].scale, 2.0);
  EXPECT_FALSE(read.parts[0].is_closed);
  EXPECT_TRUE(read.parts[2].is_closed);
  EXPECT_TRUE(read.parts[0].is_fixture);
  EXPECT_FALSE(read.parts[2].is_fixture);
  EXPECT_EQ(read.parts[0].mount, "bed");
  EXPECT_EQ(read.parts[2].mount, "table");
  EXPECT_EQ(read.parts[0].p_M_at, Point(250.0, -180.0, -300.0));
  EXPECT_EQ(read.parts[0].rotate_deg, Point(0.0, 10.0, 90.0));
  EXPECT_EQ(read.parts[0].growth.expansion, 23.0);
  EXPECT_EQ(read.parts[0].growth.temperature, 22.0);
  EXPECT_EQ(read.parts[1].growth.per_unit(), 0.0);
  EXPECT_EQ(read.parts[1].name, "ring") << "a part without a name is called after its shape";
  EXPECT_EQ(read.parts[1].shape, "ring");
  EXPECT_EQ(read.parts[1].file, "");
  EXPECT_EQ(read.parts[1].sizes, (std::map<std::string, double>{{"bore", 50.0}}));
  EXPECT_EQ(read.parts[2].name, "ring") << "or after its file";

  ASSERT_TRUE(read.skip_signals && read.skip_signals->size() == 3U);
  EXPECT_EQ(read.skip_signals->at(0).axis, 1);
  EXPECT_EQ(read.skip_signals->at(0).at, 10.0);
  EXPECT_EQ(read.skip_signals->at(1).axis, 5);
  EXPECT_EQ(read.skip_signals->at(1).at, std::nullopt);
  EXPECT_EQ(read.skip_signals->at(2).at, std::nullopt);
}

/// What an example of [[tool]] needs beside it.
std::string sheet_of_tool(const KeyRow& row, const std::string& sheet) {
  if (row.section == SectionId::ToolTooth || row.section == SectionId::ToolBody) {
    return "[[tool]]\nnumber = 5\nlength = 100.0\ndiameter = 16.0\n" + sheet;
  }
  if (row.id == KeyId::ToolProbeFilter) {
    return sheet + "shape = \"laser\"\nsize = [300.0, 0.5]\n";
  }
  if (row.section != SectionId::Tool) {
    return sheet;
  }
  const bool is_of_insert = row.id == KeyId::ToolLengths || row.id == KeyId::ToolTipRadius ||
                            row.id == KeyId::ToolEdgePosition || row.id == KeyId::ToolInsertAngle ||
                            row.id == KeyId::ToolOrientation || row.id == KeyId::ToolEdgeLength;
  const std::string kind = is_of_insert                    ? "kind = \"turning\"\n"
                           : row.id == KeyId::ToolTipAngle ? "kind = \"drill\"\n"
                                                           : "";
  const std::string lengths = row.id == KeyId::ToolLengths ? "" : "lengths = [1.0, 2.0, 3.0]\n";
  const std::string length = row.id == KeyId::ToolTrueLength ? "" : "length = 100.0\n";
  const std::string diameter = row.id == KeyId::ToolDiameter ? "" : "diameter = 16.0\n";
  return sheet + (row.id == KeyId::ToolWhich ? "" : "number = 5\n") + kind +
         (is_of_insert ? lengths : length + diameter);
}

TEST_F(SetupReader, EveryExampleOfTheTableIsASheet) {
  static_cast<void>(write("v55.toml", "name = \"V55\"\n"));
  for (const KeyRow& row : key_rows()) {
    SCOPED_TRACE(row.example);
    std::string sheet = std::string(row_of(row.section).example) + "\n";
    if (row.section == SectionId::Part && row.id != KeyId::PartFile && row.id != KeyId::PartShape) {
      const bool is_of_file =
          row.id == KeyId::PartUnit || row.id == KeyId::PartScale || row.id == KeyId::PartClosed;
      sheet += is_of_file ? "file = \"ring.stl\"\n" : "shape = \"ring\"\n";
    }
    if (row.section == SectionId::ProbeSecond) {
      sheet = "[probe]\n" + sheet + (row.id == KeyId::SecondAt ? "" : "at = [200.0, 0.0, 0.0]\n");
    }
    if (row.section == SectionId::BelievedAxes) {
      sheet = "[machine]\ntable_side = \"C\"\n" + sheet;
    }
    if (row.id == KeyId::PartOn) {
      sheet = "[work_offsets.G54]\n" + sheet;
    }
    sheet = sheet_of_tool(row, sheet);
    if (row.section == SectionId::Characteristic) {
      sheet = "[[part]]\nname = \"ring\"\nshape = \"ring\"\nbore = 40.0\n" + sheet;
      sheet += row.id == KeyId::CharacteristicName ? "" : "name = \"Bore, X\"\n";
      sheet += row.id == KeyId::CharacteristicVariable ? "" : "variable = \"#164\"\n";
      sheet += row.id == KeyId::CharacteristicTolerance ? "nominal = 40.0\n" : "";
    }
    if (row.section == SectionId::Input && row.id != KeyId::InputWhich) {
      sheet += "number = 1003\n";
    }
    if (row.id == KeyId::SkipSignalAt) {
      sheet += "axis = \"X\"\n";
    }
    EXPECT_EQ(errors_of(read({sheet + std::string(row.example) + "\n"})), "");
    EXPECT_FALSE(row.text.empty());
  }
}

TEST_F(SetupReader, LaterSheetsWinKeyByKey) {
  const Job read = job({R"([control]
profile = "fanuc-16i"
increment = "IS-B"
[variables]
"#100" = 1
"#101" = 2
[tools.1]
length = 100.0
radius = 5.0
[machine.axes.X]
travel = [0, 10]
rapid = 100
[[part]]
shape = "ring"
[[part]]
file = "is_not_there.stl"
[[skip_signal]]
)",
                        R"([control]
profile = "haas"
[variables]
"#0101" = ""
[tools.01]
radius = 6.0
[tools.2]
[machine.axes.X]
rapid = 200
[probe]
[[part]]
name = "the only one"
file = "ring.stl"
)",
                        "part = []\n[variables]\n\"#102\" = 7\n"});
  EXPECT_EQ(read.control.profile, "haas");
  EXPECT_EQ(read.control.increment, "IS-B");
  EXPECT_EQ(read.control.variables, (std::map<std::string, std::optional<double>>{
                                        {"#100", 1.0}, {"#101", std::nullopt}, {"#102", 7.0}}));
  EXPECT_EQ(read.control.tools.at(1).length_mm, 100.0);
  EXPECT_EQ(read.control.tools.at(1).radius_mm, 6.0);
  EXPECT_EQ(read.control.tools.count(2), 1U);
  EXPECT_EQ(read.machine.axes[0].travel_max, 10.0);
  EXPECT_EQ(read.machine.axes[0].rapid_per_min, 200.0);
  EXPECT_TRUE(read.probe.has_value());
  EXPECT_TRUE(read.parts.empty()) << "a list is replaced as a whole, also by an empty one";
  EXPECT_EQ(read.skip_signals->size(), 1U) << "a list that is not given stays";
}

TEST_F(SetupReader, AVariableIsTheSameInSmallLettersAndInCapitals) {
  const Job both =
      job({"[variables]\nr1 = 7\n\"_ovr[3]\" = 1\n", "[variables]\nR1 = 6\n\"_OVR[3]\" = 2\n"});
  EXPECT_EQ(both.control.variables,
            (std::map<std::string, std::optional<double>>{{"r1", 6.0}, {"_ovr[3]", 2.0}}));
  const std::string twice = errors_of(read({"[variables]\nR1 = 1\nr01 = 2\n"}));
  EXPECT_NE(twice.find(":3:1: error: variables.r01 is given twice in this sheet [SET108]"),
            std::string::npos)
      << twice;
}

TEST_F(SetupReader, MachineFileIsReadFirstWhereverItsKeysStand) {
  for (const std::string header : {"", "[machine]\n"}) {
    SCOPED_TRACE(header);
    const std::string axes = header.empty() ? "[axes.X]\n" : "[machine.axes.X]\n";
    static_cast<void>(write("machines/v55.toml", header + "name = \"V55\"\nstopping = \"ideal\"\n" +
                                                     axes + "travel = [0, 900]\nrapid = 100\n"));
    const Job read =
        job({"[machine]\nfile = \"machines/v55.toml\"\nname = \"ours\"\n[machine.axes.X]\nrapid = "
             "7\n"});
    EXPECT_EQ(read.machine.name, "ours");
    EXPECT_EQ(read.machine.stopping, machine::Stopping::Ideal);
    EXPECT_EQ(read.machine.axes[0].travel_max, 900.0);
    EXPECT_EQ(read.machine.axes[0].rapid_per_min, 7.0);
  }
}

TEST_F(SetupReader, SkipSignalsStopIdeallyUnlessTheSheetSaysOtherwise) {
  using machine::Stopping;
  struct Case {
    const char* sheet;
    Stopping stopping;
  };
  const Case kCases[] = {
      {"", Stopping::Braking},
      {"[probe]\n", Stopping::Braking},
      {"[[skip_signal]]\n", Stopping::Ideal},
      {"skip_signal = []\n", Stopping::Ideal},
      {"[machine]\nstopping = \"braking\"\n[[skip_signal]]\n", Stopping::Braking},
      {"[machine]\nstopping = \"ideal\"\n", Stopping::Ideal},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.sheet);
    EXPECT_EQ(job({c.sheet}).machine.stopping, c.stopping);
  }
}

TEST_F(SetupReader, RelativePathsStartAtTheFolderOfTheirSheet) {
  static_cast<void>(write("a/meshes/ring.stl", ""));
  static_cast<void>(write("b/v.toml", "name = \"B\"\n"));
  const std::string first =
      write("a/one.toml",
            "[control]\nvariables_file = \"../x.vars\"\n[[part]]\nfile = \"meshes/ring.stl\"\n");
  const std::string second = write("b/two.toml", "[machine]\nfile = \"v.toml\"\n");
  const std::vector<std::string> paths = {first, second};
  const auto result = read_job(paths);
  ASSERT_EQ(errors_of(result), "");
  EXPECT_EQ(result.value().control.variables_file, path_of("a/../x.vars"));
  EXPECT_EQ(result.value().parts.at(0).file, path_of("a/meshes/ring.stl"));
  EXPECT_EQ(result.value().machine.name, "B");

  const std::string absolute = path_of("a/meshes/ring.stl");
  EXPECT_EQ(job({"[[part]]\nfile = \"" + absolute + "\"\n"}).parts.at(0).file, absolute);
}

TEST_F(SetupReader, TheSheetOfTheManualIsRead) {
  static_cast<void>(write("v55.toml", "[axes.Z]\ntravel = [-560.0, 0.0]\n"));
  const Job read = job({R"([control]
profile = "fanuc-16i"
increment = "IS-B"            # IS-A, IS-B, IS-C
block_skip = [1]              # switches that are ON, 1..9
variables_file = "v55.vars"   # non-volatile variables, read at the start and saved at the end

[parameters]                  # control parameters, bit as NUMBER.BIT
"6001.1" = 1
"3410" = 0.01
[macro_calls]                 # G code to program, what parameters 6050.. do
G100 = 9010
[variables]
"#515" = 6.0
[start]                       # machine position at the start
X = 0.0
Y = 0.0
Z = 0.0
[work_offsets.G59]
X = 250.0
Y = -180.0
Z = -300.0
[tools.99]                    # H99 / T99
length = 120.0
radius = 3.0

[machine]
file = "v55.toml"             # or the keys in place; without it an ideal three-axis machine
[probe]
ball_diameter = 6.0
length = 120.0
trigger_delay_s = 0.0
repeatability_mm = 0.0
[[part]]
name = "ring"
file = "ring.stl"             # any mesh that assimp reads; or shape = "ring" with its sizes
at = [250.0, -180.0, -300.0]  # machine coordinates of the part's origin
rotate_deg = [0.0, 0.0, 0.0]
)"});
  EXPECT_EQ(read.machine.axes[2].travel_min, -560.0);
  EXPECT_EQ(read.parts.at(0).p_M_at, Point(250.0, -180.0, -300.0));
  EXPECT_EQ(read.control.work_offsets.at("G59")[1], -180.0);
}

}  // namespace
}  // namespace g31::setup::setup_test

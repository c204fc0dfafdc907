#pragma once

#include <filesystem>
#include <fstream>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "tools/setup/setup_error.h"
#include "tools/setup/toml_reader.h"

namespace g31::setup {

/// Every key of keys.def once, [machine] in place; the part files are written by the tests.
inline constexpr const char* kEveryKey = R"([control]
profile = "fanuc-16i"
increment = "IS-C"
offset_memory = "B"
axes = "XYZB"
lookahead = 3
feed_override = 80.0
dry_run = 1500.0
rapids = "straight"
block_skip = [1, 9]
variables_file = "v55.vars"
files = "logs"
keys = "NY"
[parameters]
"6001.1" = 1
"6001.0" = false
"6001.7" = true
"3410" = 0.01
"05114" = -7
"01241.Z" = -150.5
[macro_calls]
G100 = 9010
M06 = 99999999
[variables]
"#515" = 6.0
"#0516" = ""
R1 = -2
"_OVR[0]" = 0.25
"$P_UIFR[1, X, TR]" = 17
[start]
X = 1.0
Y = 2
Z = 3.5
C = 45.0
[machine_data]
"$MN_OEM_LIMIT" = 5.0
[gud]
LIMITS = [0.1, 0.2]
PALLET_NAME = "A"
[work_offsets.G59]
X = 250.0
B = 30.0
[work_offsets.EXT]
[work_offsets."G54.1 P12"]
Z = -1.0
[work_offsets.G505]
Y = 8.0
rotate_deg = [0.0, 0.0, 30.0]
fine = [0.05, 0.0, 0.0]
scale = [1.0, 2.0, 1.0]
mirror = "X"
[tools.99]
length = 120.0
radius = 3.0
length_wear = 0.02
radius_wear = -0.01
[tools.0]
[machine]
file = "base.toml"
name = "V55"
stopping = "ideal"
stop_delay_s = 0.016
in_position = 0.02
table_side = "BX"
tool_spindle = 3
tool_side = "YZ"
[machine.axes.X]
travel = [-10, 900.0]
rapid = 48000
acceleration = 5000.0
home = 0.5
jerk = 50000
servo_gain = 1.8
feed_forward = 0.9
contour_acceleration = 1000.0
corner_jump = 0
velocity_gain = 250.0
velocity_reset_s = 0.02
friction = 300.0
friction_way = 0.03
resolution = 0.0001
names = "XA X7"
backlash = 0.002
reversal_spike = 0.003
reversal_way = 0.04
cyclic_error = 0.0015
cyclic_pitch = 12.0
cyclic_phase_deg = 30
expansion = 11.5
temperature = 25.5
fixed_at = 450.0
[machine.axes.B]
centre = [1.0, 2, -400.0]
direction = [0.0, -1.0, 0.001]
[machine.errors]
EXX = [[0, 0.0], [450.5, 0.002], [900.0, -0.001]]
ECX = -3.5
EAZ = [[-10, 4]]
A0Z = 5.0
B0Z = -4
C0Y = 8.0
[believed.axes.B]
centre = [1.0, 2.03, -400.0]
direction = [0.0, -1.0, 0.0]
[probe]
ball_diameter = 5.9
length = 119.5
eccentricity = [0.02, -0.03]
trigger_delay_s = 0.001
repeatability_mm = 0.0005
type = "mono"
direction_deg = 90.0
pre_travel_mm = 0.01
seats = "tripod"
weak_direction_deg = 30.0
trigger_force = 0.5
axial_force = 5.5
stem_stiffness = 40.0
state = "low_battery"
low_battery_input = 1005
input = 2
tool = 7
on = "M80"
off = "M81"
ready_input = 1004
signal_input = 5
start_up_s = 0.5
may_turn = true
calibrated_feed = 50.0
stem_diameter = 3.0
stem_length = 50.0
deflection_limit = 2.0
[probe.second]
at = [200.0, 0.0, 1.0]
input = 3
ball_diameter = 5.0
length = 121.0
eccentricity = [0.01, 0.02]
trigger_delay_s = 0.002
[[probe.body]]
name = "transmitter"
length = 45.0
diameter = 40.0
top_diameter = 63.0
rounding = 2.0
[[probe.ball]]
at = [30.0, 0.0, 10.0]
diameter = 4.0
arm_diameter = 2.0
[[probe.ball]]
[[input]]
number = 1003
value = 0
from_s = 2.5
[[input]]
number = 7
from_block = 120
[[input]]
number = 7
from_reads = 3
[[input]]
number = 7
from_code = "M21"
[[part]]
name = "mesh"
file = "ring.stl"
step_sagitta = 0.002
unit = "cm"
scale = 2.0
closed = false
fixture = true
mount = "bed"
at = [250.0, -180, -300.0]
rotate_deg = [0.0, 10.0, 90.0]
expansion = 23.0
temperature = 22.0
[[part]]
shape = "ring"
on = "G505"
at = [1.0, 2.0, 3.0]
bore = 50.0
[[part]]
file = "ring.stl"
[[part]]
shape = "bed"
width = 50.0
profile = [[0.0, 0.001], [500.0, -0.002]]
[[sensor]]
name = "A"
at = [100.0, 0.0, -80.0]
direction = [0.0, -2.0, 0.0]
range = 5.0
resolution = 0.0002
spot = 2.0
noise = 0.0001
input = 3
word = 33
[[sensor]]
[[tool]]
number = 7
kind = "probe"
[[tool]]
number = 5
kind = "bull_mill"
length = 100.0
diameter = 16.0
corner_radius = 1.5
cutting_length = 30.0
core_diameter = 10.0
[[tool.teeth]]
angle_deg = 90.0
[[tool.teeth]]
angle_deg = 270.0
radius = 7.99
length = 99.98
[[tool.body]]
name = "chuck"
length = 40.0
diameter = 32.0
top_diameter = 50.0
rounding = 1.0
[[tool.body]]
length = 20.0
[[tool]]
number = 6
kind = "drill"
length = 80.0
diameter = 6.0
tip_angle_deg = 140.0
[[tool]]
number = 9
kind = "turning"
lengths = [50.0, 80.0, -0.5]
tip_radius = 0.4
edge_position = 2
insert_angle_deg = 80.0
orientation_deg = 135.0
edge_length = 12.0
[[tool_probe]]
name = "setter"
shape = "disc"
size = [20.0, 6.0]
at = [200.0, -30.0, -400.0]
rotate_deg = [0.0, 0.0, 45.0]
side = "table"
input = 3
delay_s = 0.002
repeatability_mm = 0.0005
pre_travel_mm = 0.01
deflection_limit = 2.0
[[tool_probe]]
[[tool_probe]]
name = "beam"
shape = "laser"
size = [300.0, 0.5]
filter_s = 0.01
[[skip_signal]]
axis = "Y"
at = 10.0
[[skip_signal]]
axis = "C"
[[skip_signal]]
[expect]
status = "completed"
alarm = 3160
output = "X 1.000\n"
output_contains = "X 1.000"
output_file = "expected.txt"
touches = 4
findings = 0
machine_time_s = [0.0, 90.0]
[expect.variables]
"#160" = [19.998, 1e-4]
[expect.work_offsets.G54]
X = [0.0, 0.001]
[[characteristic]]
name = "bore"
variable = "#164"
nominal = 50.0
tolerance = [-0.01, 0.01]
unit = "mm"
true = "bed.width"
)";

/// A folder of set-up sheets that goes away with the test.
class SetupSheets : public ::testing::Test {
 protected:
  SetupSheets() {
    const auto* test = ::testing::UnitTest::GetInstance()->current_test_info();
    folder_ = std::filesystem::temp_directory_path() /
              ("g31_setup_" + std::string(test->name()) + "_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  ~SetupSheets() override {
    std::error_code ignored;
    std::filesystem::remove_all(folder_, ignored);
  }
  SetupSheets(const SetupSheets&) = delete;
  SetupSheets& operator=(const SetupSheets&) = delete;

  /// Writes a file of the folder and returns its whole path.
  [[nodiscard]] std::string write(const std::string& name, const std::string& text) const {
    const std::filesystem::path path = folder_ / name;
    std::filesystem::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary) << text;
    return path.string();
  }

  [[nodiscard]] std::string path_of(const std::string& name) const {
    return (folder_ / name).string();
  }

  [[nodiscard]] Result<Job, SetupErrors> read(const std::vector<std::string>& sheets) const {
    std::vector<std::string> paths;
    for (std::size_t i = 0; i < sheets.size(); ++i) {
      paths.push_back(write("sheet" + std::to_string(i + 1) + ".toml", sheets[i]));
    }
    return read_job(paths);
  }

  /// All errors as text, files named from the folder on; "" when there are none.
  [[nodiscard]] std::string errors_of(const Result<Job, SetupErrors>& result) const {
    std::string text;
    if (!result) {
      for (const SetupError& error : result.error()) {
        text += render(error);
      }
    }
    const std::string prefix = folder_.string() + "/";
    for (std::size_t at = text.find(prefix); at != std::string::npos; at = text.find(prefix)) {
      text.erase(at, prefix.size());
    }
    return text;
  }

 private:
  std::filesystem::path folder_;
};

}  // namespace g31::setup

#include "tools/cli/starter_files.h"

#include <string_view>

#include <fmt/format.h>

namespace g31::cli {
namespace {

constexpr std::string_view kFanucProgram = R"(%
O0001 (WIDTH AND MIDDLE OF A BLOCK)
(THE PROBE IS TOOL 1, G54 IS THE MIDDLE OF THE BLOCK'S TOP)
G90 G54 G40
G00 X45. Y0.
G43 H1 Z50.
(RIGHT SIDE)
G00 Z-10.
G31 X25. F100.
#501=#5061
G00 X45.
G00 Z50.
(LEFT SIDE)
G00 X-45.
G00 Z-10.
G31 X-25. F100.
#502=#5061
G00 X-45.
G00 Z50.
#503=#501-#502-6.
#504=[#501+#502]/2
IF [ABS[#503-60.] GT 0.05] GOTO 90
M30
N90 #3000=1 (WIDTH OUT OF TOLERANCE)
%
)";

constexpr std::string_view kSinumerikProgram = R"(; Width and middle of a block
; The probe is tool 1, G54 is the middle of the block's top
T1 M6
D1
G17 G90 G54 G40
G0 X45 Y0
G0 Z50
; right side
G0 Z-10
MEAS=1 G1 X25 F100
STOPRE
IF $AC_MEA[1] == 0 GOTOF MISSED
R1 = $AA_MW[X]
G0 X45
G0 Z50
; left side
G0 X-45
G0 Z-10
MEAS=1 G1 X-25 F100
STOPRE
IF $AC_MEA[1] == 0 GOTOF MISSED
R2 = $AA_MW[X]
G0 X-45
G0 Z50
R3 = R1 - R2 - 6
R4 = (R1 + R2) / 2
IF ABS(R3 - 60) > 0.05 GOTOF WRONG
M30
MISSED: SETAL(65000) ; nothing was touched
M30
WRONG: SETAL(65001) ; the width is out of tolerance
M30
)";

constexpr std::string_view kSheet =
    R"(# What the program finds on the machine.  What a key means: g31 explain KEY.

[control]
profile = "{profile}"

# Where the axes stand at the start, machine coordinates.
[start]
X = 250.0
Y = -200.0
Z = 0.0

# What the control believes: where the work is, and how long the probe is.
[work_offsets.G54]
X = 250.0
Y = -200.0
Z = -400.0

[tools.1]
length = 120.0
radius = 3.0

# The machine; without travel it reaches everywhere.
[machine.axes.X]
travel = [0.0, 560.0]
[machine.axes.Y]
travel = [-410.0, 0.0]
[machine.axes.Z]
travel = [-510.0, 0.0]

# The probe as it truly is.
[probe]
ball_diameter = 6.0
length = 120.0

# The part as it truly is: a block of 60 mm, its top in the zero of G54.
[[part]]
name = "block"
shape = "block"
length = 60.0
width = 40.0
height = 20.0
on = "G54"

# What is right: exit code 0 where all of it comes, 1 otherwise.
[expect]
touches = 2
findings = 0
[expect.variables]
{width} = [60.0, 0.01]
)";

constexpr std::string_view kWorkflow =
    R"(# Runs the program at each push.  The runner needs g31: install it there, or name a container that has it.
name: measuring programs
on: [push, pull_request]
jobs:
  g31:
    runs-on: self-hosted
    steps:
      - uses: actions/checkout@v4
      - name: What is wrong without running
        run: g31 check {program} --setup setup.toml --format github
      - name: Does the set-up fit
        run: g31 setup setup.toml --program {program}
      - name: Run
        run: g31 run {program} --setup setup.toml --json result.json
)";

constexpr std::string_view kGitlab =
    R"(# Runs the program at each push.  The runner needs g31: install it there, or name an image that has it.
measuring programs:
  script:
    - g31 check {program} --setup setup.toml
    - g31 setup setup.toml --program {program}
    - g31 run {program} --setup setup.toml --json result.json
  artifacts:
    when: always
    paths:
      - result.json
)";

constexpr std::string_view kReadme = R"(# Measuring programs

`{program}` measures the width of a block in X with the control {profile}; `setup.toml` says what it finds on
the machine.

    g31 run {program} --setup setup.toml --print '{results}'
    g31 setup setup.toml --program {program}
    g31 check {program}

Exit code 0: all is well; `g31 run --help` has the others.  `.github/workflows/g31.yml` (GitHub) and
`.gitlab-ci.yml` (GitLab) do the same at each push: keep the one that you need.  Next: put your own program beside it, give its parts and offsets in `setup.toml`.
)";

std::string filled(std::string_view text, std::string_view name, std::string_view value) {
  std::string whole(text);
  const std::string mark = fmt::format("{{{}}}", name);
  for (std::size_t at = whole.find(mark); at != std::string::npos; at = whole.find(mark)) {
    whole.replace(at, mark.size(), value);
  }
  return whole;
}

}  // namespace

std::vector<StarterFile> starter_files(const session::Control& control) {
  const bool is_fanuc = std::holds_alternative<session::FanucControl>(control);
  const std::string program = is_fanuc ? "measure.nc" : "MEASURE.MPF";
  const std::string readme =
      filled(filled(kReadme, "program", program), "profile", session::name_of(control));
  return {{program, std::string(is_fanuc ? kFanucProgram : kSinumerikProgram)},
          {"setup.toml", filled(filled(kSheet, "profile", session::name_of(control)), "width",
                                is_fanuc ? "\"#503\"" : "R3")},
          {".github/workflows/g31.yml", filled(kWorkflow, "program", program)},
          {".gitlab-ci.yml", filled(kGitlab, "program", program)},
          {"README.md", filled(readme, "results", is_fanuc ? "#503,#504" : "R3,R4")}};
}

}  // namespace g31::cli

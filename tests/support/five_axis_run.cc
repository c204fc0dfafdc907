#include "tests/support/five_axis_run.h"

#include <fmt/format.h>

namespace g31::testing {
namespace {

std::string numbers(const Point& p) {
  return fmt::format("[{:.17g}, {:.17g}, {:.17g}]", p.x(), p.y(), p.z());
}

bool has_axis(const machine::AxisChainSetup& chain, char letter) {
  return (chain.table_side + chain.tool_side).find(letter) != std::string::npos;
}

std::string lines_of(const machine::AxisChainSetup& chain, const char* section,
                     const std::map<char, std::pair<double, double>>& travel = {}) {
  std::string text;
  for (int i = 0; i < kRotaryAxisCount; ++i) {
    const char letter = kAxisLetters[kLinearAxisCount + i];
    const machine::RotaryLine& line = chain.rotary.at(static_cast<std::size_t>(i));
    if (has_axis(chain, letter)) {
      text += fmt::format("[{}.{}]\ncentre = {}\ndirection = {}\n", section, letter,
                          numbers(line.p_M_centre), numbers(line.axis_M));
      if (std::string(section).starts_with("machine")) {
        const auto found = travel.find(letter);
        const auto [low, high] =
            found != travel.end() ? found->second : std::pair(-36000.0, 36000.0);
        text += fmt::format("travel = [{:.17g}, {:.17g}]\n", low, high);
      }
    }
  }
  return text;
}

}  // namespace

std::string five_axis_sheet(const machine::AxisChainSetup& chain, const Point& work_offset,
                            const std::map<char, std::pair<double, double>>& travel) {
  std::string text = fmt::format(
      "[control]\nprofile = \"sinumerik-828d\"\n[tools.1]\nlength = 120.0\nradius = 3.0\n"
      "type = 710.0\nname = \"PROBE\"\n[probe]\nball_diameter = 6.0\nlength = 117.0\n"
      "[machine]\ntable_side = \"{}\"\ntool_side = \"{}\"\n",
      chain.table_side, chain.tool_side);
  for (const char letter : {'X', 'Y', 'Z'}) {
    text += fmt::format("[machine.axes.{}]\ntravel = [-3000.0, 3000.0]\n", letter);
  }
  text += lines_of(chain, "machine.axes", travel);
  text += fmt::format("[work_offsets.G54]\nX = {:.17g}\nY = {:.17g}\nZ = {:.17g}\n",
                      work_offset.x(), work_offset.y(), work_offset.z());
  return text + kCalibrated;
}

std::string believed_sheet(const machine::AxisChainSetup& chain) {
  return lines_of(chain, "believed.axes");
}

}  // namespace g31::testing

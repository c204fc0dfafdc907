#include <array>

#include "interpreter/dialects/fanuc/system/access.h"

// What the set-up sheet says of the machine: settings, parameters, data of tools.

namespace g31::fanuc::system {
namespace {

constexpr std::int32_t kNameOfParameter = 100000;
constexpr std::int32_t kAxisOfParameter = 100002;

// Of a Haas.
constexpr std::int32_t kLastBeforeSettings = 6000;
constexpr std::int32_t kLastBeforeParameters = 6500;
constexpr std::int32_t kChosenParameter = 6996;
constexpr std::int32_t kChosenBit = 6997;
constexpr std::int32_t kChosenTool = 8550;
constexpr std::int32_t kTableOfSettings = 20000;
constexpr std::int32_t kTableOfParameters = 30000;

/// Where #8551 and on find the data of a tool: the number of tool 0 of each.
constexpr std::array<std::int32_t, 14> kDataOfTools = {1600, 1800, 2000, 2200, 2400, 2600, 3200,
                                                       3400, 5400, 5500, 5600, 5700, 5800, 5900};

double datum(const Control& control, std::int32_t number) {
  const auto found = control.data.find(number);
  return found != control.data.end() ? found->second : 0.0;
}

/// #6001 is setting 1, #20001; #6501 is parameter 1, #30001.
std::int32_t aliased(const Place& place) {
  return place.number > kLastBeforeParameters
             ? kTableOfParameters + place.number - kLastBeforeParameters
             : kTableOfSettings + place.number - kLastBeforeSettings;
}

}  // namespace

ReadResult read_datum(Control& control, const Place& place) {
  const auto found = control.data.find(place.number);
  return Cell(found != control.data.end() ? found->second : 0.0);
}

WriteResult write_datum(Control& control, const Place& place, Cell value) {
  control.data[place.number] = value.or_zero();
  return std::nullopt;
}

/// #100010 of MELDAS: the parameter that #100000 and, of one axis, #100002 name.
ReadResult read_named_parameter(Control& control, const Place&) {
  const int number = nearest_integer(control.data[kNameOfParameter]);
  const int axis = nearest_integer(control.data[kAxisOfParameter]);
  const auto of = control.controlled_axis(axis - 1);
  return Cell(of ? control.parameters.shown_for_axis(number, *of)
                 : control.parameters.shown(number));
}

ReadResult read_datum_alias(Control& control, const Place& place) {
  return Cell(datum(control, aliased(place)));
}

WriteResult write_datum_alias(Control& control, const Place& place, Cell value) {
  control.data[aliased(place)] = value.or_zero();
  return std::nullopt;
}

/// #6998 of a Haas: the parameter that #6996 names, or its bit #6997.
ReadResult read_chosen_parameter(Control& control, const Place&) {
  constexpr int kBits = 32;
  const double value =
      datum(control, kTableOfParameters + nearest_integer(datum(control, kChosenParameter)));
  const int bit = nearest_integer(datum(control, kChosenBit));
  const bool is_bit = control.data.contains(kChosenBit) && bit >= 0 && bit < kBits;
  return Cell(is_bit ? static_cast<double>(static_cast<std::int64_t>(value) >> bit & 1) : value);
}

/// #8551 and on of a Haas: data of the tool that #8550 names.
ReadResult read_tool_datum(Control& control, const Place& place) {
  const int tool = nearest_integer(datum(control, kChosenTool));
  if (tool < 1) {
    return Cell(0.0);
  }
  return control.all_variables.read(kDataOfTools.at(static_cast<std::size_t>(place.index())) +
                                    tool);
}

}  // namespace g31::fanuc::system

#include "tools/evaluate/sinumerik_compensation.h"

#include <fmt/format.h>

#include "tools/evaluate/even_table.h"

namespace g31::evaluate {
namespace {

/// Of a table across an axis of an 828D.  Source: function manual K3, 6FC5397-1BP40-3BA1, page 264.
constexpr std::size_t kMostAcross = 200;
/// Of a table along an axis, the upper limit of MD38000.
constexpr std::size_t kMostAlong = 5000;

/// What a table leaves of the error, as a line of its head; nothing where that is 0.0.
std::string what_is_left(const EvenTable& table, const Curve& curve) {
  const std::string left = fmt::format("{:.1f}", kUmPerMm * left_at_places(curve, table));
  return left == "0.0" ? "" : fmt::format("; It leaves {} um at the places measured.\n", left);
}

/// Encoder compensation of the first encoder.
std::string along_axis(const EvenTable& table, const MachineError& error) {
  const char axis = error.name[2];
  std::string text = fmt::format(
      "%_N_AX_EEC_INI\n"
      "; Compensation along {0}1, mm: positive values move the axis in the negative direction.\n"
      "; Load it with MD32700[0,{0}1]=0; MD38000[0,{0}1]={1} points or more.\n"
      "; It acts with MD32700[0,{0}1]=1 afterwards.\n{2}CHANDATA(1)\n",
      axis, table.values.size(), what_is_left(table, error.deviations));
  for (std::size_t n = 0; n < table.values.size(); ++n) {
    text += fmt::format("$AA_ENC_COMP[0,{},{}1]={:.6f}\n", n, axis, table.values[n] + 0.0);
  }
  text += fmt::format("$AA_ENC_COMP_STEP[0,{}1]={:.6f}\n", axis, table.step);
  text += fmt::format("$AA_ENC_COMP_MIN[0,{}1]={:.6f}\n", axis, table.first + 0.0);
  text += fmt::format("$AA_ENC_COMP_MAX[0,{}1]={:.6f}\n", axis,
                      table.place(table.values.size() - 1) + 0.0);
  return text + fmt::format("$AA_ENC_COMP_IS_MODULO[0,{}1]=0\nM17\n", axis);
}

/// The first sag and angularity table.
std::string across_axis(const EvenTable& table, const MachineError& error) {
  const char compensated = error.name[1];
  const char moving = error.name[2];
  std::string text = fmt::format(
      "%_N_NC_CEC_INI\n"
      "; Compensation of {1}1 by the place of {0}1, mm: positive values move {1}1 in the negative "
      "direction.\n"
      "; Load it with MD32710[{1}1]=0; MD18342[0]={2} points or more.\n"
      "; It acts with SD41300 $SN_CEC_TABLE_ENABLE[0]=1 and MD32710[{1}1]=1 afterwards.\n"
      "{3}CHANDATA(1)\n",
      moving, compensated, table.values.size(), what_is_left(table, error.deviations));
  for (std::size_t n = 0; n < table.values.size(); ++n) {
    text += fmt::format("$AN_CEC[0,{}]={:.6f}\n", n, table.values[n] + 0.0);
  }
  text += fmt::format("$AN_CEC_INPUT_AXIS[0]=({}1)\n", moving);
  text += fmt::format("$AN_CEC_OUTPUT_AXIS[0]=({}1)\n", compensated);
  text += fmt::format("$AN_CEC_STEP[0]={:.6f}\n", table.step);
  text += fmt::format("$AN_CEC_MIN[0]={:.6f}\n", table.first + 0.0);
  text += fmt::format("$AN_CEC_MAX[0]={:.6f}\n", table.place(table.values.size() - 1) + 0.0);
  return text + "$AN_CEC_DIRECTION[0]=0\n$AN_CEC_MULT_BY_TABLE[0]=0\n$AN_CEC_IS_MODULO[0]=0\nM17\n";
}

}  // namespace

std::string sinumerik_compensation(const MachineError& error) {
  const bool is_along = error.name[1] == error.name[2];
  const EvenTable table = even_table(error.deviations, is_along ? kMostAlong : kMostAcross);
  return is_along ? along_axis(table, error) : across_axis(table, error);
}

}  // namespace g31::evaluate

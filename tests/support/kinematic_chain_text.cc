#include "tests/support/kinematic_chain_text.h"

#include <vector>

#include <fmt/format.h>

#include "machine/kinematics/kinematic_vectors.h"

namespace g31::testing {
namespace {

struct Element {
  std::string name;
  std::string type;
  Point vector = Point::Zero();
  std::string axis = {};
};

Element rotary(const machine::KinematicVectors& vectors, std::size_t i) {
  return {fmt::format("ROT{}", i + 1), "AXIS_ROT", i == 0 ? vectors.v1 : vectors.v2,
          fmt::format("{}1", kAxisLetters[static_cast<std::size_t>(vectors.axes.at(i))])};
}

/// The side of a table: from the bed to the part.
std::vector<Element> table_side(const machine::KinematicVectors& v) {
  if (v.type == machine::KinematicType::Mixed) {
    return {{"P0", "OFFSET", v.i3},
            {"CORR2", "OFFSET", Point::Zero()},
            rotary(v, 1),
            {"P9", "OFFSET", -v.i3}};
  }
  return {{"P0", "OFFSET", v.i2},        {"CORR1", "OFFSET", Point::Zero()}, rotary(v, 0),
          {"P1", "OFFSET", v.i3},        {"CORR2", "OFFSET", Point::Zero()}, rotary(v, 1),
          {"P9", "OFFSET", -v.i2 - v.i3}};
}

/// The side of a head: from the bed to the spindle, behind the linear axes.
std::vector<Element> head_side(const machine::KinematicVectors& v) {
  if (v.type == machine::KinematicType::Mixed) {
    return {{"T1", "OFFSET", v.i2},
            rotary(v, 0),
            {"CORR1", "OFFSET", Point::Zero()},
            {"T9", "OFFSET", -v.i2}};
  }
  return {{"T1", "OFFSET", v.i2 + v.i3}, rotary(v, 0), {"CORR1", "OFFSET", Point::Zero()},
          {"T2", "OFFSET", -v.i2},       rotary(v, 1), {"CORR2", "OFFSET", Point::Zero()},
          {"T9", "OFFSET", -v.i3}};
}

/// One element after the other; `n` is the number of the first, and of the next afterwards.
std::string written(const std::vector<Element>& elements, int& n) {
  std::string text;
  for (std::size_t i = 0; i < elements.size(); ++i, ++n) {
    const Element& e = elements[i];
    text += fmt::format(
        "$NK_NAME[{0}]=\"{1}\" $NK_TYPE[{0}]=\"{2}\" $NK_AXIS[{0}]=\"{3}\" $NK_NEXT[{0}]=\"{4}\"\n"
        "$NK_OFF_DIR[{0},0]={5:.15f} $NK_OFF_DIR[{0},1]={6:.15f} $NK_OFF_DIR[{0},2]={7:.15f}\n",
        n, e.name, e.type, e.axis, i + 1 < elements.size() ? elements[i + 1].name : "",
        e.vector.x(), e.vector.y(), e.vector.z());
  }
  return text;
}

}  // namespace

std::string chain_text(const machine::AxisChainSetup& chain) {
  const machine::KinematicVectors vectors = machine::vectors_of(chain).value();
  const bool has_head = vectors.type != machine::KinematicType::Part;
  const bool has_table = vectors.type != machine::KinematicType::Tool;
  int n = 0;
  std::string text = written({{"ROOT", "OFFSET", Point::Zero()}}, n) + "$NK_NEXT[0]=\"X\"\n";
  std::vector<Element> tool = {{"X", "AXIS_LIN", Point::UnitX(), "X1"},
                               {"Y", "AXIS_LIN", Point::UnitY(), "Y1"},
                               {"Z", "AXIS_LIN", Point::UnitZ(), "Z1"}};
  if (has_head) {
    const std::vector<Element> head = head_side(vectors);
    tool.insert(tool.end(), head.begin(), head.end());
  }
  text += written(tool, n);
  if (has_table) {
    text += written(table_side(vectors), n) + "$NK_PARALLEL[1]=\"P0\"\n";
  }
  text +=
      "$NT_NAME[1]=\"CHAIN\" $NT_TRAFO_TYPE[1]=\"TRAORI_DYN\" $NT_CNTRL[1]=384\n"
      "$TC_CARR34[2]=\"CARRIED\" $TC_CARR_CORR_ELEM[2,0]=\"CORR1\" "
      "$TC_CARR_CORR_ELEM[2,1]=\"CORR2\"\n";
  if (has_head) {
    text +=
        "$NT_T_CHAIN_LAST_ELEM[1]=\"T9\" $TC_CARR_KIN_TOOL_END[2]=\"T9\" "
        "$NT_CORR_ELEM_T[1,0]=\"CORR1\"\n";
  }
  if (has_table) {
    text += "$NT_P_CHAIN_LAST_ELEM[1]=\"P9\" $TC_CARR_KIN_PART_END[2]=\"P9\"\n";
  }
  if (!has_table) {
    text += "$NT_CORR_ELEM_T[1,1]=\"CORR2\"\n";
  } else if (has_head) {
    text += "$NT_CORR_ELEM_P[1,0]=\"CORR2\"\n";
  } else {
    text += "$NT_CORR_ELEM_P[1,0]=\"CORR1\" $NT_CORR_ELEM_P[1,1]=\"CORR2\"\n";
  }
  return text;
}

}  // namespace g31::testing

#include "interpreter/dialects/sinumerik/code/globals.h"

#include <algorithm>
#include <numeric>

#include "interpreter/dialects/sinumerik/vocabulary/machine_data.h"
#include "interpreter/dialects/sinumerik/vocabulary/words.h"
#include "machine/base/contract.h"
#include "machine/units/axis_positions.h"

namespace g31::sinumerik {
namespace {

bool is_by_axis(std::string_view name) {
  return name.starts_with("$MA_") || name.starts_with("$SA_");
}

Variable row_variable(std::string_view name, Type type, int count) {
  Variable variable;
  variable.name = name;
  variable.type = type;
  constexpr int kLongestAxisName = 15;  // texts among machine data are names of axes
  variable.longest = type == Type::String ? kLongestAxisName : 0;
  constexpr int kAxes = static_cast<int>(kAxisCount);
  variable.is_by_axis = is_by_axis(name);
  const bool twice = variable.is_by_axis && count > kAxes;
  variable.shape = twice       ? Shape{2, {count / kAxes, kAxes, 1}}
                   : count > 0 ? Shape{1, {count, 1, 1}}
                               : Shape{};
  return variable;
}

}  // namespace

/// What differs from axis to axis: their numbers, and that A, B and C turn.
void Globals::number_axes(std::string_view name, std::int32_t place) {
  const auto first = layout_.numbers.begin() + place;
  if (name == "$MC_AXCONF_GEOAX_ASSIGN_TAB") {
    std::iota(first, first + kLinearAxisCount, 1.0);
  } else if (name == "$MC_AXCONF_MACHAX_USED") {
    std::iota(first, first + kAxisCount, 1.0);
  } else if (name.starts_with("$MC_TRAFO_AXES_IN_")) {
    std::iota(first, first + kLinearAxisCount, 1.0);
  } else if (name.starts_with("$MC_TRAFO5_BASE_ORIENT_")) {
    *(first + kLinearAxisCount - 1) = 1.0;
  } else if (name == "$MA_IS_ROT_AX") {
    std::fill(first + kLinearAxisCount, first + kAxisCount, 1.0);
  }
}

Globals::Globals() {
  Variable r;
  r.name = "R";
  r.shape = {1, {kRParameters, 1, 1}};
  define(r);
  by_name_.emplace("$R", 0);  // as synchronised actions write it
  for (const MachineDatum& row : machine_data()) {
    Variable variable = row_variable(row.name, row.type, row.count);
    variable.unit = row.unit;
    variable.fixed =
        row.effect == MachineDatum::Effect::Fixed ? std::optional(row.preset) : std::nullopt;
    variable.is_watched = row.effect == MachineDatum::Effect::Watched;
    const std::int32_t place = define(variable)->place;
    if (is_number(row.type)) {
      std::fill(layout_.numbers.begin() + place, layout_.numbers.end(), row.preset);
      number_axes(row.name, place);
    }
  }
  for (const MemoryRow& row : memory_rows()) {
    define(row_variable(row.name, row.type, row.count));
  }
}

void Globals::shorten(std::string_view name, int count) {
  const auto found = by_name_.find(name);
  G31_EXPECTS(found != by_name_.end());
  int& size = variables_[found->second].shape.size.front();
  size = std::clamp(count, 0, size);
}

int Globals::axis(std::string_view name) const {
  const auto found = axis_names.find(name);
  return found != axis_names.end() ? found->second : axis_named(name);
}

const Variable* Globals::find(std::string_view name) const {
  const auto found = by_name_.find(name);
  return found != by_name_.end() ? &variables_[found->second] : nullptr;
}

void Globals::offer_of_main(Variable variable) {
  variable.storage = Storage::OfMain;
  of_main_.emplace(variable.name, variable);
}

const Variable* Globals::find_of_main(std::string_view name) const {
  const auto found = of_main_.find(name);
  return found != of_main_.end() ? &found->second : nullptr;
}

const Variable* Globals::define(const Variable& variable) {
  if (!by_name_.emplace(variable.name, variables_.size()).second) {
    return nullptr;
  }
  Variable& defined = variables_.emplace_back(variable);
  defined.storage = Storage::Global;
  defined.place = layout_.add(variable.type, variable.shape.count());
  return &defined;
}

}  // namespace g31::sinumerik

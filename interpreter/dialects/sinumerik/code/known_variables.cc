#include "interpreter/dialects/sinumerik/code/known_variables.h"

#include <algorithm>
#include <string>
#include <utility>

namespace g31::sinumerik {

std::int32_t KnownVariables::find(std::string_view name) {
  if (const auto local = program_.locals.find(name); local != program_.locals.end()) {
    return local->second;
  }
  const Variable* outside = globals_.find(name);
  if (outside == nullptr && program_.sees_main) {
    outside = globals_.find_of_main(name);
  }
  return outside != nullptr ? import(*outside) : -1;
}

std::int32_t KnownVariables::import(const Variable& variable) {
  const auto [found, is_new] =
      imported_.emplace(variable.name, static_cast<std::int32_t>(program_.variables.size()));
  if (is_new) {
    program_.variables.push_back(variable);
  }
  return found->second;
}

std::int32_t KnownVariables::define_local(Variable variable) {
  const auto index = static_cast<std::int32_t>(program_.variables.size());
  if (!program_.locals.emplace(variable.name, index).second) {
    fail(AlarmId::DefinedTwice, block(), variable.name);
    return -1;
  }
  variable.place = program_.layout.add(variable.type, variable.shape.count());
  program_.variables.push_back(variable);
  return index;
}

void KnownVariables::note_unknown(const Token& name) {
  auto& known = program_.unknown_data;
  const auto same = [&](const UnknownDatum& row) { return row.name == name.text; };
  if (std::ranges::none_of(known, same)) {
    known.push_back({std::string(name.text), name.where});
  }
}

}  // namespace g31::sinumerik

#include "tools/session/control.h"

#include <algorithm>
#include <filesystem>
#include <vector>

#include <fmt/format.h>

#include "interpreter/dialects/sinumerik/run/session.h"
#include "interpreter/runtime/overloaded.h"
#include "machine/base/contract.h"
#include "machine/base/nearest_name.h"

namespace g31::session {

std::string_view name_of(const Control& control) {
  return std::visit(
      runtime::Overloaded{
          [](const FanucControl& chosen) -> std::string_view { return chosen.profile.get().name; },
          [](const SinumerikControl&) { return sinumerik::kControlName; },
      },
      control);
}

Result<Control, std::string> control_named(std::string_view name) {
  if (const fanuc::Profile* const profile = fanuc::find_profile(name)) {
    return Control(FanucControl{*profile});
  }
  if (name == sinumerik::kControlName) {
    return Control(SinumerikControl{});
  }
  std::vector<std::string_view> known;
  for (const fanuc::Profile& profile : fanuc::profiles()) {
    known.push_back(profile.name);
  }
  known.push_back(sinumerik::kControlName);
  const auto nearest = nearest_name(name, known);
  return fmt::format("unknown control '{}'{}; known: {}", name,
                     nearest ? fmt::format(", did you mean '{}'?", *nearest) : "",
                     fmt::join(known, ", "));
}

Control default_control() {
  const fanuc::Profile* const profile = fanuc::find_profile("fanuc-16i");
  G31_EXPECTS(profile != nullptr);
  return FanucControl{*profile};
}

Control control_of_program(const std::string& path, std::string_view text) {
  std::string ending = std::filesystem::path(path).extension().string();
  std::ranges::transform(ending, ending.begin(), [](char c) {
    return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c;
  });
  const bool by_ending = ending == ".mpf" || ending == ".spf" || ending == ".arc";
  return by_ending || text.starts_with("%_N_") ? Control(SinumerikControl{}) : default_control();
}

}  // namespace g31::session

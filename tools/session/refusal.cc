#include "tools/session/refusal.h"

#include <algorithm>
#include <utility>

#include <fmt/format.h>

namespace g31::session {

Refusal bad_input(std::string message) {
  return {Ending::BadInput, std::move(message)};
}

Refusal bad_setup(std::string message) {
  return {Ending::Setup, std::move(message)};
}

Refusal refusal_of(setup::SetupErrors errors) {
  const auto missing = setup::code_of(setup::SetupErrorId::FileNotFound);
  const bool is_missing = std::ranges::any_of(
      errors, [&](const setup::SetupError& error) { return error.code == missing; });
  return {is_missing ? Ending::Setup : Ending::BadInput, {}, std::move(errors)};
}

std::string render(const Refusal& refusal) {
  if (refusal.sheet_errors.empty()) {
    return fmt::format("g31: error: {}\n", refusal.message);
  }
  std::string text;
  for (const setup::SetupError& error : refusal.sheet_errors) {
    text += setup::render(error);
  }
  return text;
}

}  // namespace g31::session

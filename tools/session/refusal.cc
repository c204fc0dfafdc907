#include "tools/session/refusal.h"

#include <algorithm>
#include <tuple>
#include <utility>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "machine/base/contract.h"
#include "tools/disk/disk.h"

namespace g31::session {

Refusal bad_input(std::string message) {
  return {Ending::BadInput, std::move(message)};
}

Refusal closed_folder(const std::string& folder, const std::string& why) {
  return bad_input(fmt::format("cannot read the folder {}: {}", folder, why));
}

Refusal unreadable(std::string_view what, const std::string& path) {
  return bad_input(fmt::format("cannot read {}{}: {}",
                               what.empty() ? std::string() : fmt::format("the {} ", what), path,
                               disk::why_unreadable(path)));
}

Refusal bad_setup(std::string message) {
  return {Ending::Setup, std::move(message)};
}

Refusal interrupted() {
  return {Ending::Interrupted, "interrupted"};
}

Refusal out_of_time(std::string_view with) {
  return {
      Ending::Budget,
      fmt::format("the limit of computing time is reached with {}: --max-time raises it", with)};
}

Refusal refusal_of(setup::SetupErrors errors) {
  const auto missing = setup::code_of(setup::SetupErrorId::FileNotFound);
  const bool is_missing = std::ranges::any_of(
      errors, [&](const setup::SetupError& error) { return error.code == missing; });
  return {is_missing ? Ending::Setup : Ending::BadInput, {}, std::move(errors)};
}

Refusal refused_settings(const setup::Job& job,
                         const std::vector<runtime::RefusedSetting>& refused) {
  G31_EXPECTS(!refused.empty());
  Refusal refusal{Ending::Setup, {}, {}};
  for (const runtime::RefusedSetting& setting : refused) {
    const auto place = job.places.find(setting.key);
    const source::ShownPlace where =
        place != job.places.end() ? place->second : source::ShownPlace{"g31", 0, 0, {}};
    refusal.sheet_errors.push_back(
        error_at(where, setup::SetupErrorId::SettingRefused, {setting.message}));
  }
  std::ranges::stable_sort(refusal.sheet_errors, {}, [](const setup::SetupError& error) {
    return std::tuple(error.file, error.line, error.column);
  });
  return refusal;
}

std::string render(const Refusal& refusal) {
  if (refusal.sheet_errors.empty()) {
    return fmt::format("g31: {}: {}\n", refusal.ending == Ending::Defect ? "defect" : "error",
                       source::printable_lines(refusal.message));
  }
  std::string text;
  for (const setup::SetupError& error : refusal.sheet_errors) {
    text += setup::render(error);
  }
  return text;
}

}  // namespace g31::session

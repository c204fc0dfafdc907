#include "tools/setup/true_sizes.h"

#include <algorithm>
#include <variant>
#include <vector>

#include <fmt/format.h>
#include <fmt/ranges.h>

#include "machine/base/nearest_name.h"
#include "parts/artefacts/artefact.h"
#include "parts/artefacts/worked_out.h"

namespace g31::setup {
namespace {

constexpr TruePlace kTruePlaces[] = {
#define TRUE_PLACE(key, axis, text) {key, axis, expect::Quantity::Length, text},
#define TRUE_ANGLE(key, axis, text) {key, axis, expect::Quantity::Angle, text},
#include "tools/setup/true_places.def"
#undef TRUE_PLACE
#undef TRUE_ANGLE
};

expect::Quantity quantity_of(parts::Quantity quantity) {
  switch (quantity) {
    case parts::Quantity::Length:
      return expect::Quantity::Length;
    case parts::Quantity::Angle:
      return expect::Quantity::Angle;
    case parts::Quantity::Count:
      break;
  }
  return expect::Quantity::Number;
}

/// What the keys of a part may be.
std::vector<std::string_view> known_keys(const parts::PartSetup& part) {
  std::vector<std::string_view> known;
  for (const parts::ShapeSize& size : parts::shape_sizes()) {
    if (part.shape == size.shape) {
      known.push_back(size.name);
    }
  }
  for (const parts::WorkedOut& result : parts::worked_out()) {
    if (part.shape == result.shape) {
      known.push_back(result.name);
    }
  }
  for (const TruePlace& place : kTruePlaces) {
    known.push_back(place.key);
  }
  return known;
}

std::string quoted(const parts::PartSetup& part, std::string_view key) {
  return fmt::format("\"{}.{}\"", part.name, key);
}

/// What may stand for `key`: the one that was probably meant, or all that there are.
std::string known_sizes(const parts::PartSetup& part, std::string_view key) {
  const std::vector<std::string_view> known = known_keys(part);
  if (const auto nearest = nearest_name(key, known)) {
    return quoted(part, *nearest);
  }
  std::vector<std::string> all;
  for (const std::string_view name : known) {
    all.push_back(quoted(part, name));
  }
  const std::string last = all.back();
  all.pop_back();
  return fmt::format("{} or {}", fmt::join(all, ", "), last);
}

/// What may stand for a name of no part.
std::string known_parts(std::span<const parts::PartSetup> parts, std::string_view key) {
  if (parts.empty()) {
    return "PART.KEY with a part of the sheet";
  }
  if (parts.size() == 1) {
    return known_sizes(parts.front(), key);
  }
  std::vector<std::string> names;
  for (const parts::PartSetup& part : parts) {
    names.push_back(quoted(part, "KEY"));
  }
  return fmt::format("{}", fmt::join(names, " or "));
}

/// The part whose name stands before a dot; of names within each other the longest.
const parts::PartSetup* part_in(std::string_view given, std::span<const parts::PartSetup> parts) {
  const parts::PartSetup* found = nullptr;
  for (const parts::PartSetup& part : parts) {
    if (given.starts_with(part.name + ".") &&
        (found == nullptr || part.name.size() > found->name.size())) {
      found = &part;
    }
  }
  return found;
}

}  // namespace

std::span<const TruePlace> true_places() {
  return kTruePlaces;
}

std::optional<expect::TrueSize> TrueSizes::find(const Entry& entry) const {
  const std::string& given = std::get<std::string>(entry.value);
  const parts::PartSetup* const part = part_in(given, parts_);
  if (part == nullptr) {
    const std::size_t dot = given.rfind('.');
    return refuse(entry, known_parts(parts_, dot == std::string::npos
                                                 ? std::string_view()
                                                 : std::string_view(given).substr(dot + 1)));
  }
  if (std::ranges::count(parts_, part->name, &parts::PartSetup::name) > 1) {
    return refuse(entry, "PART.KEY with a name that no other part has");
  }
  const std::string key = given.substr(part->name.size() + 1);
  if (const auto size = parts::size_of(*part, key)) {
    return expect::TrueSize{part->name, key, size->value, quantity_of(size->quantity)};
  }
  for (const TruePlace& place : kTruePlaces) {
    if (place.key == key) {
      const Point& of = place.quantity == expect::Quantity::Angle ? part->rotate_deg : part->p_M_at;
      return expect::TrueSize{part->name, key, of[place.axis], place.quantity};
    }
  }
  return refuse(entry, known_sizes(*part, key));
}

std::optional<expect::TrueSize> TrueSizes::refuse(const Entry& entry,
                                                  const std::string& should_be) const {
  errors_.add(SetupErrorId::OutOfRange, entry.where,
              {"characteristic.true", fmt::format("\"{}\"", std::get<std::string>(entry.value)),
               should_be});
  return std::nullopt;
}

}  // namespace g31::setup

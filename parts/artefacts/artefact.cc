#include "parts/artefacts/artefact.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <map>
#include <variant>
#include <vector>

#include "machine/base/nearest_name.h"
#include "parts/artefacts/makers.h"
#include "parts/artefacts/worked_out.h"

namespace g31::parts {
namespace {

constexpr std::optional<double> kComputed = std::nullopt;

constexpr auto kShapes = std::to_array<Shape>({
#define SHAPE(name, make, text) {#name, text},
#define SHAPE_SIZE(shape, name, default_mm, text)
#define SHAPE_COUNT(shape, name, default_value, text)
#include "parts/artefacts/shapes.def"
#undef SHAPE
#undef SHAPE_SIZE
#undef SHAPE_COUNT
});

constexpr auto kSizes = std::to_array<ShapeSize>({
#define SHAPE(name, make, text)
#define SHAPE_SIZE(shape, name, default_mm, text) \
  {#shape, #name, default_mm, Quantity::Length, text},
#define SHAPE_COUNT(shape, name, default_value, text) \
  {#shape, #name, default_value, Quantity::Count, text},
#include "parts/artefacts/shapes.def"
#undef SHAPE
#undef SHAPE_SIZE
#undef SHAPE_COUNT
});

using AnyMaker = std::variant<Maker, ProfiledMaker>;

constexpr auto kMakers = std::to_array<AnyMaker>({
#define SHAPE(name, make, text) (make),
#define SHAPE_SIZE(shape, name, default_mm, text)
#define SHAPE_COUNT(shape, name, default_value, text)
#include "parts/artefacts/shapes.def"
#undef SHAPE
#undef SHAPE_SIZE
#undef SHAPE_COUNT
});

/// "; did you mean 'ring'?" or the list of what there is.
std::string advice(std::string_view unknown, const std::vector<std::string_view>& known) {
  if (const auto nearest = nearest_name(unknown, known)) {
    return "; did you mean '" + std::string(*nearest) + "'?";
  }
  std::string list = "; known are";
  for (const std::string_view name : known) {
    list += (name == known.front() ? " '" : ", '") + std::string(name) + "'";
  }
  return list;
}

std::vector<std::string_view> shape_names() {
  std::vector<std::string_view> names(kShapes.size());
  std::ranges::transform(kShapes, names.begin(), &Shape::name);
  return names;
}

std::vector<std::string_view> size_names(std::string_view shape) {
  std::vector<std::string_view> names;
  for (const ShapeSize& size : kSizes) {
    if (size.shape == shape) {
      names.push_back(size.name);
    }
  }
  return names;
}

/// nullopt, or what is wrong with the given sizes.
std::optional<std::string> why_wrong(const PartSetup& part) {
  const std::vector<std::string_view> known = size_names(part.shape);
  for (const auto& [name, value] : part.sizes) {
    if (std::ranges::find(known, name) == known.end()) {
      return "shape '" + part.shape + "' has no size '" + name + "'" + advice(name, known);
    }
    if (!std::isfinite(value) || value <= 0.0) {
      return "size '" + name + "' must be a number of mm greater than 0";
    }
    if (value > kLargestSizeMm) {
      return "size '" + name + "' must be at most 1000000 mm";
    }
  }
  return std::nullopt;
}

Sizes with_defaults(const PartSetup& part) {
  Sizes sizes = part.sizes;
  for (const ShapeSize& size : kSizes) {
    if (size.shape == part.shape && size.default_value) {
      sizes.try_emplace(std::string(size.name), *size.default_value);
    }
  }
  for (const WorkedOut& stand_in : stand_ins()) {
    if (stand_in.shape == part.shape && !sizes.contains(std::string(stand_in.name))) {
      sizes.emplace(stand_in.name, stand_in.from(sizes));
    }
  }
  return sizes;
}

Result<Mesh, std::string> make_with(const AnyMaker& maker, const PartSetup& part) {
  if (const auto* const profiled = std::get_if<ProfiledMaker>(&maker)) {
    return (*profiled)(with_defaults(part), part.profile);
  }
  if (!part.profile.empty()) {
    return "shape '" + part.shape + "' takes no profile; bed and shaft do";
  }
  return std::get<Maker>(maker)(with_defaults(part));
}

}  // namespace

std::span<const Shape> shapes() {
  return kShapes;
}

std::span<const ShapeSize> shape_sizes() {
  return kSizes;
}

std::string_view unit_of(Quantity quantity) {
  switch (quantity) {
    case Quantity::Length:
      return "mm";
    case Quantity::Angle:
      return "deg";
    case Quantity::Count:
      break;
  }
  return "none";
}

std::optional<Measure> size_of(const PartSetup& part, const std::string& name) {
  const Sizes sizes = with_defaults(part);
  for (const ShapeSize& size : shape_sizes()) {
    if (size.shape == part.shape && size.name == name) {
      return Measure{sizes.at(name), size.quantity};
    }
  }
  const auto row = std::ranges::find_if(worked_out(), [&](const WorkedOut& result) {
    return result.shape == part.shape && result.name == name;
  });
  return row != worked_out().end() ? std::optional(Measure{row->from(sizes), row->quantity})
                                   : std::nullopt;
}

std::optional<Sphere> exact_sphere(const PartSetup& part) {
  if (part.shape != "sphere") {
    return std::nullopt;
  }
  return Sphere{Point::Zero(), 0.5 * with_defaults(part).at("diameter")};
}

Result<Mesh, std::string> make_artefact(const PartSetup& part) {
  const std::string who = "part '" + part.name + "': ";
  const auto row = std::ranges::find(kShapes, std::string_view(part.shape), &Shape::name);
  if (row == kShapes.end()) {
    return who + "there is no shape '" + part.shape + "'" + advice(part.shape, shape_names());
  }
  if (const auto wrong = why_wrong(part)) {
    return who + *wrong;
  }
  Result<Mesh, std::string> made =
      make_with(kMakers[static_cast<std::size_t>(row - kShapes.begin())], part);
  if (!made) {
    return who + made.error();
  }
  return made;
}

}  // namespace g31::parts

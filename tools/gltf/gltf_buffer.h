#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>

#include <nlohmann/json.hpp>

#include "machine/units/point.h"

namespace g31::gltf {

using Json = nlohmann::ordered_json;

/// The binary part of a glTF file and the objects that speak of it.  Every piece begins at a
/// multiple of 4 bytes, little-endian.
class GltfBuffer {
 public:
  /// Positions as float32; returns the index of their accessor.  @param points  at least one
  std::size_t add_points(std::span<const Point> points);

  /// Corners of triangles; returns the index of their accessor.  @param triangles  at least one
  std::size_t add_triangles(std::span<const std::array<std::uint32_t, 3>> triangles);

  [[nodiscard]] const std::string& bytes() const { return bytes_; }
  [[nodiscard]] const Json& views() const { return views_; }
  [[nodiscard]] const Json& accessors() const { return accessors_; }

 private:
  /// What a view is for, as glTF numbers it.
  enum class Target { Vertices = 34962, Indices = 34963 };

  std::size_t add_view(std::size_t begin, Target target);
  void append(std::uint32_t word);

  std::string bytes_;
  Json views_ = Json::array();
  Json accessors_ = Json::array();
};

}  // namespace g31::gltf

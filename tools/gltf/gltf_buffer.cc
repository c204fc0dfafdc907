#include "tools/gltf/gltf_buffer.h"

#include <algorithm>
#include <bit>
#include <limits>

#include "machine/base/contract.h"

namespace g31::gltf {
namespace {

constexpr int kFloat32 = 5126;
constexpr int kUnsigned32 = 5125;

}  // namespace

std::size_t GltfBuffer::add_points(std::span<const Point> points) {
  G31_EXPECTS(!points.empty());
  const std::size_t begin = bytes_.size();
  std::array<float, 3> low;
  std::array<float, 3> high;
  low.fill(std::numeric_limits<float>::infinity());
  high.fill(-std::numeric_limits<float>::infinity());
  for (const Point& p : points) {
    for (std::size_t i = 0; i < 3; ++i) {
      const auto coordinate = static_cast<float>(p[static_cast<Eigen::Index>(i)]);
      append(std::bit_cast<std::uint32_t>(coordinate));
      low[i] = std::min(low[i], coordinate);
      high[i] = std::max(high[i], coordinate);
    }
  }
  accessors_.push_back({{"bufferView", add_view(begin, Target::Vertices)},
                        {"componentType", kFloat32},
                        {"count", points.size()},
                        {"type", "VEC3"},
                        {"min", low},
                        {"max", high}});
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_triangles(std::span<const std::array<std::uint32_t, 3>> triangles) {
  G31_EXPECTS(!triangles.empty());
  const std::size_t begin = bytes_.size();
  for (const auto& triangle : triangles) {
    for (const std::uint32_t vertex : triangle) {
      append(vertex);
    }
  }
  accessors_.push_back({{"bufferView", add_view(begin, Target::Indices)},
                        {"componentType", kUnsigned32},
                        {"count", 3 * triangles.size()},
                        {"type", "SCALAR"}});
  return accessors_.size() - 1;
}

std::size_t GltfBuffer::add_view(std::size_t begin, Target target) {
  views_.push_back({{"buffer", 0},
                    {"byteOffset", begin},
                    {"byteLength", bytes_.size() - begin},
                    {"target", static_cast<int>(target)}});
  return views_.size() - 1;
}

void GltfBuffer::append(std::uint32_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes_.push_back(static_cast<char>(word >> shift & 0xFFU));
  }
}

}  // namespace g31::gltf

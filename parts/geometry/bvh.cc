#include "parts/geometry/bvh.h"

#include <algorithm>

#include "machine/base/contract.h"

namespace g31::parts {
namespace {

/// A ball against a triangle costs about as much as ten boxes: small leaves pay.
constexpr std::size_t kLeafSize = 2;
constexpr std::size_t kBins = 16;

double half_surface(const Box& box) {
  const Point size = (box.max - box.min).cwiseMax(0.0);
  return size.x() * size.y() + size.y() * size.z() + size.z() * size.x();
}

struct Bin {
  Box box;
  std::size_t count = 0;
};

/// The number of bins on the left side of the cheapest split; 0 when no split separates anything.
std::size_t cheapest_split(const std::array<Bin, kBins>& bins) {
  std::array<double, kBins> right_cost{};
  Bin right;
  for (std::size_t i = kBins - 1; i > 0; --i) {
    right.box.include(bins[i].box);
    right.count += bins[i].count;
    right_cost[i] =
        right.count == 0 ? 0.0 : half_surface(right.box) * static_cast<double>(right.count);
  }
  std::size_t best = 0;
  double best_cost = std::numeric_limits<double>::infinity();
  Bin left;
  std::size_t right_count = right.count + bins[0].count;
  for (std::size_t i = 1; i < kBins; ++i) {
    left.box.include(bins[i - 1].box);
    left.count += bins[i - 1].count;
    right_count -= bins[i - 1].count;
    if (left.count == 0 || right_count == 0) {
      continue;
    }
    const double cost = half_surface(left.box) * static_cast<double>(left.count) + right_cost[i];
    if (cost < best_cost) {
      best_cost = cost;
      best = i;
    }
  }
  return best;
}

}  // namespace

std::vector<Box> triangle_boxes(const Mesh& mesh) {
  std::vector<Box> boxes;
  boxes.reserve(mesh.triangles.size());
  for (const auto& triangle : mesh.triangles) {
    Box box;
    for (const std::uint32_t vertex : triangle) {
      box.include(mesh.vertices[vertex]);
    }
    boxes.push_back(box);
  }
  return boxes;
}

Bvh::Bvh(std::span<const Box> boxes) {
  G31_EXPECTS(boxes.size() < std::numeric_limits<std::uint32_t>::max());
  if (boxes.empty()) {
    return;
  }
  std::vector<Item> items(boxes.size());
  for (std::size_t i = 0; i < boxes.size(); ++i) {
    items[i] = {boxes[i], 0.5 * (boxes[i].min + boxes[i].max), static_cast<std::uint32_t>(i)};
  }
  nodes_.reserve(boxes.size());
  order_.reserve(boxes.size());
  build_node(items, 0);
}

void Bvh::build_node(std::span<Item> items, int depth) {
  const std::size_t here = nodes_.size();
  Node node;
  for (const Item& item : items) {
    node.box.include(item.box);
  }
  if (items.size() <= kLeafSize) {
    node.first = static_cast<std::uint32_t>(order_.size());
    node.count = static_cast<std::uint32_t>(items.size());
    for (const Item& item : items) {
      order_.push_back(item.index);
    }
    nodes_.push_back(node);
    return;
  }
  nodes_.push_back(node);
  const std::size_t left = split(items, depth);
  build_node(items.first(left), depth + 1);
  nodes_[here].first = static_cast<std::uint32_t>(nodes_.size());
  build_node(items.subspan(left), depth + 1);
}

std::size_t Bvh::split(std::span<Item> items, int depth) {
  Box centres;
  for (const Item& item : items) {
    centres.include(item.centre);
  }
  Eigen::Index axis = 0;
  const double extent = (centres.max - centres.min).maxCoeff(&axis);
  const double low = centres.min[axis];
  const auto bin_of = [&](const Item& item) {
    const double place = (item.centre[axis] - low) / extent * static_cast<double>(kBins);
    return std::min(kBins - 1, static_cast<std::size_t>(place));
  };
  if (depth < kHeuristicDepth && extent > 0.0) {
    std::array<Bin, kBins> bins;
    for (const Item& item : items) {
      Bin& bin = bins[bin_of(item)];
      bin.box.include(item.box);
      ++bin.count;
    }
    if (const std::size_t border = cheapest_split(bins); border > 0) {
      const auto middle = std::partition(items.begin(), items.end(),
                                         [&](const Item& item) { return bin_of(item) < border; });
      return static_cast<std::size_t>(middle - items.begin());
    }
  }
  const std::size_t half = items.size() / 2;
  std::nth_element(items.begin(), items.begin() + static_cast<std::ptrdiff_t>(half), items.end(),
                   [&](const Item& a, const Item& b) { return a.centre[axis] < b.centre[axis]; });
  return half;
}

}  // namespace g31::parts

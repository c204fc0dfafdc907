#include "parts/import/stl_file.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "parts/import/coordinate_rounding.h"
#include "parts/import/mesh_limits.h"
#include "parts/import/text_lines.h"
#include "parts/import/vertex_weld.h"
#include "parts/import/written_digits.h"

namespace g31::parts {
namespace {

constexpr std::size_t kStlHead = 84;   // bytes: a comment of 80, then the number of facets
constexpr std::size_t kStlFacet = 50;  // bytes: normal, three corners, attributes

std::uint32_t little_endian_32(const char* bytes) {
  std::uint32_t value = 0;
  for (unsigned int i = 0; i < 4; ++i) {
    value |= std::uint32_t{static_cast<unsigned char>(bytes[i])} << (8U * i);
  }
  return value;
}

bool equals_in_any_case(std::string_view a, std::string_view b) {
  return std::ranges::equal(
      a, b, [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}

std::string_view first_word(std::string_view text) {
  return take_word(text);
}

using StlCorners = std::array<Point, 3>;

/// What is left of a difference of floats stands for 0 in one facet, and the next one has the 0: a
/// corner is one place.
double without_noise(double coordinate) {
  constexpr double kNoise = 1e-12;
  return std::abs(coordinate) < kNoise ? 0.0 : coordinate;
}

StlCorners corners_of_facet(const char* facet) {
  constexpr std::size_t kNormal = 12;  // bytes
  StlCorners corners;
  for (std::size_t corner = 0; corner < 3; ++corner) {
    for (std::size_t axis = 0; axis < 3; ++axis) {
      const std::size_t at = kNormal + 4 * (3 * corner + axis);
      corners.at(corner)[static_cast<Eigen::Index>(axis)] =
          without_noise(static_cast<double>(std::bit_cast<float>(little_endian_32(facet + at))));
    }
  }
  return corners;
}

/// @param bytes  of whole facets
void add_facets(std::string_view bytes, VertexWeld& weld, Mesh& mesh) {
  // Looking up a vertex is mostly waiting for memory: for some facets it is fetched ahead.
  constexpr std::size_t kAhead = 32;
  std::array<StlCorners, kAhead> facets;
  while (!bytes.empty()) {
    const std::size_t count = std::min(kAhead, bytes.size() / kStlFacet);
    for (std::size_t i = 0; i < count; ++i) {
      facets.at(i) = corners_of_facet(&bytes[i * kStlFacet]);
      for (const Point& corner : facets.at(i)) {
        weld.prefetch(corner);
      }
    }
    for (std::size_t i = 0; i < count; ++i) {
      const StlCorners& corners = facets.at(i);
      const std::uint32_t a = weld.vertex_at(corners[0]);
      const std::uint32_t b = weld.vertex_at(corners[1]);
      mesh.triangles.push_back({a, b, weld.vertex_at(corners[2])});
    }
    bytes.remove_prefix(count * kStlFacet);
  }
}

/// The grammar of the text form, word by word.
class TextStl {
 public:
  TextStl(std::string_view text, double mm_per_unit, const GoesOn& goes_on)
      : text_(text), rest_(text), mm_per_unit_(mm_per_unit), steps_(goes_on) {}

  Result<Mesh, std::string> read() {
    while (wrong_.empty() && !next_word().empty()) {
      read_solid();
    }
    if (!wrong_.empty()) {
      return wrong_;
    }
    // Nobody knows whether digits were cut off: not so much that a run would warn of it.
    constexpr double kMostMm = 0.00025;
    const double furthest = furthest_of(mesh_);
    mesh_.rounding_mm =
        furthest > 0.0 ? std::min(kMostMm / mm_per_unit_, digits_.rounding_at(furthest)) : 0.0;
    return std::move(mesh_);
  }

 private:
  [[nodiscard]] std::string_view next_word() const { return first_word(rest_); }

  void read_solid() {
    expect({"solid"});
    skip_line();
    while (wrong_.empty() && !equals_in_any_case(next_word(), "endsolid")) {
      read_facet();
    }
    expect({"endsolid"});
    skip_line();
  }

  void read_facet() {
    steps_.step();
    expect({"facet", "normal"});
    for (int i = 0; i < 3; ++i) {
      take_word(rest_);  // what a normal says does not count, and of a facet without area it is nan
    }
    expect({"outer", "loop"});
    std::array<std::uint32_t, 3> corners{};
    for (std::uint32_t& corner : corners) {
      corner = vertex();
    }
    expect({"endloop", "endfacet"});
    mesh_.triangles.push_back(corners);
  }

  std::uint32_t vertex() {
    expect({"vertex"});
    Point p = Point::Zero();
    for (double& coordinate : p) {
      const std::string_view rest = rest_;
      const std::string_view word = take_word(rest_);
      const auto number = number_in<double>(word);
      if (!number) {
        rest_ = rest;
        expected("a number");
        return 0;
      }
      coordinate = without_noise(*number);
      digits_.take(word);
    }
    return wrong_.empty() ? weld_.vertex_at(p) : 0;
  }

  void expect(std::initializer_list<std::string_view> words) {
    for (const std::string_view wanted : words) {
      const std::string_view rest = rest_;
      if (!equals_in_any_case(take_word(rest_), wanted)) {
        rest_ = rest;
        expected(fmt::format("'{}'", wanted));
        return;
      }
    }
  }

  void skip_line() { rest_.remove_prefix(std::min(rest_.size(), rest_.find_first_of("\r\n"))); }

  /// Notes the first thing that is wrong.
  void expected(const std::string& what) {
    constexpr std::size_t kShown = 40;
    if (!wrong_.empty()) {
      return;
    }
    const std::string_view word = next_word();
    const std::size_t at =
        word.empty() ? text_.size() : static_cast<std::size_t>(word.data() - text_.data());
    const auto line = 1 + std::ranges::count(text_.substr(0, at), '\n');
    const bool is_last = at + word.size() == text_.size();
    wrong_ = is_last ? fmt::format(
                           "it ends in line {}, where {} is expected: it was cut off; "
                           "a text STL ends with endsolid",
                           line, what)
                     : fmt::format("line {}: '{}', where {} is expected", line,
                                   word.substr(0, kShown), what);
    rest_ = {};
  }

  std::string_view text_;
  std::string_view rest_;
  double mm_per_unit_;
  Steps steps_;
  Mesh mesh_;
  VertexWeld weld_{mesh_};
  WrittenDigits digits_;
  std::string wrong_;
};

}  // namespace

bool is_binary_stl(std::string_view beginning, std::uint64_t size) {
  if (beginning.size() >= kStlHead &&
      size == kStlHead + std::uint64_t{kStlFacet} * little_endian_32(&beginning[80])) {
    return true;
  }
  return !equals_in_any_case(first_word(beginning), "solid");
}

Result<Mesh, std::string> read_binary_stl(std::istream& file, std::uint64_t size,
                                          const GoesOn& goes_on) {
  std::array<char, kStlHead> head{};
  if (size < kStlHead || !file.read(head.data(), head.size())) {
    return fmt::format(
        "not understood as an STL: {} bytes are neither a text that begins with "
        "solid nor the {} that a binary one begins with",
        size, kStlHead);
  }
  const std::uint64_t count = little_endian_32(&head[80]);
  if (const std::uint64_t needed = kStlHead + kStlFacet * count; size != needed) {
    return fmt::format(
        "it says that it has {} facets, which are {} bytes, but it has {}: it was "
        "cut off, or is no binary STL",
        count, needed, size);
  }
  if (count > kMostTriangles) {
    return fmt::format("it has {} facets; {} are the most", count, kMostTriangles);
  }
  constexpr std::size_t kAtATime = 4096;
  std::vector<char> facets(kAtATime * kStlFacet);
  Mesh mesh;
  mesh.triangles.reserve(static_cast<std::size_t>(count));
  VertexWeld weld(mesh, static_cast<std::size_t>(count) / 2 + 2);  // as many as a sphere has
  const Steps steps(goes_on);
  for (std::uint64_t done = 0; done < count;) {
    steps.ask();
    const auto now = static_cast<std::size_t>(std::min<std::uint64_t>(count - done, kAtATime));
    if (!file.read(facets.data(), static_cast<std::streamsize>(now * kStlFacet))) {
      return std::string("it cannot be read to its end");
    }
    add_facets({facets.data(), now * kStlFacet}, weld, mesh);
    done += now;
  }
  mesh.rounding_mm = rounding_of(mesh);
  return mesh;
}

Result<Mesh, std::string> read_text_stl(std::string_view text, double mm_per_unit,
                                        const GoesOn& goes_on) {
  return TextStl(text, mm_per_unit, goes_on).read();
}

}  // namespace g31::parts

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <cstring>
#include <optional>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "machine/units/point.h"
#include "parts/geometry/box.h"
#include "parts/geometry/mesh.h"
#include "parts/import/round_walls.h"

// Values as bytes, from one process of this program to another one.  One function `pass` of a type
// writes it to a ByteWriter and reads it from a ByteReader.

namespace g31::parts {

class ByteWriter {
 public:
  static constexpr bool kReads = false;

  void raw(void* data, std::size_t size) { bytes_.append(static_cast<const char*>(data), size); }
  [[nodiscard]] std::string take() && { return std::move(bytes_); }

 private:
  std::string bytes_;
};

/// Bytes that end too early leave values as they are, and `is_whole` is false.
class ByteReader {
 public:
  static constexpr bool kReads = true;

  /// @param bytes  outlive it
  explicit ByteReader(std::string_view bytes) : bytes_(bytes) {}

  void raw(void* data, std::size_t size) {
    is_whole_ = is_whole_ && size <= bytes_.size();
    if (is_whole_) {
      std::memcpy(data, bytes_.data(), size);
      bytes_.remove_prefix(size);
    }
  }
  [[nodiscard]] std::size_t left() const { return is_whole_ ? bytes_.size() : 0; }
  [[nodiscard]] bool is_whole() const { return is_whole_; }

 private:
  std::string_view bytes_;
  bool is_whole_ = true;
};

template <typename Stream, typename Number>
requires std::is_arithmetic_v<Number> || std::is_enum_v<Number>
void pass(Stream& stream, Number& number) {
  stream.raw(&number, sizeof number);
}

template <typename Stream>
void pass(Stream& stream, Point& point) {
  stream.raw(point.data(), sizeof(double) * 3);
}

template <typename Stream>
void pass(Stream& stream, std::array<std::uint32_t, 3>& corners) {
  stream.raw(corners.data(), sizeof corners);
}

template <typename Stream>
void pass(Stream& stream, Box& box) {
  pass(stream, box.min);
  pass(stream, box.max);
}

template <typename Stream, typename Value>
void pass(Stream& stream, std::optional<Value>& value) {
  bool is_there = value.has_value();
  pass(stream, is_there);
  if (is_there) {
    Value inner = value.value_or(Value());
    pass(stream, inner);
    value = inner;
  }
}

/// A text or a list.
template <typename Stream, typename List>
requires std::is_same_v<List, std::string> ||
    std::is_same_v<List, std::vector<typename List::value_type>>
void pass(Stream& stream, List& list) {
  std::uint64_t count = list.size();
  pass(stream, count);
  if constexpr (Stream::kReads) {
    // Each element takes a byte at least, so no length asks for more memory than has come.
    list.resize(count <= stream.left() ? static_cast<std::size_t>(count) : 0);
  }
  for (auto& element : list) {
    pass(stream, element);
  }
}

template <typename Stream>
void pass(Stream& stream, Mesh& mesh) {
  pass(stream, mesh.vertices);
  pass(stream, mesh.triangles);
  pass(stream, mesh.faces_left_out);
}

template <typename Stream>
void pass(Stream& stream, RoundWall& wall) {
  pass(stream, wall.axis_at);
  pass(stream, wall.radius_mm);
  pass(stream, wall.first);
  pass(stream, wall.last);
}

}  // namespace g31::parts

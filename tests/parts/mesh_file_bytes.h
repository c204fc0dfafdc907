#pragma once

#include <bit>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "parts/geometry/mesh.h"

namespace g31::testing {

inline void append_bytes(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((value >> shift) & 0xffU);
  }
}

inline void append_bytes(std::string& bytes, float value) {
  append_bytes(bytes, std::bit_cast<std::uint32_t>(value));
}

inline std::string binary_stl(const parts::Mesh& mesh) {
  std::string bytes(80, ' ');
  append_bytes(bytes, static_cast<std::uint32_t>(mesh.triangles.size()));
  for (const auto& t : mesh.triangles) {
    for (int i = 0; i < 3; ++i) {
      append_bytes(bytes, 0.0F);
    }
    for (const std::uint32_t vertex : t) {
      for (Eigen::Index i = 0; i < 3; ++i) {
        append_bytes(bytes, static_cast<float>(mesh.vertices[vertex][i]));
      }
    }
    bytes += std::string(2, '\0');
  }
  return bytes;
}

inline void append_bytes(std::string& bytes, std::uint16_t value) {
  bytes += static_cast<char>(value & 0xffU);
  bytes += static_cast<char>(value >> 8U);
}

inline std::uint32_t crc32(std::string_view bytes) {
  std::uint32_t crc = 0xffffffffU;
  for (const char c : bytes) {
    crc ^= static_cast<std::uint8_t>(c);
    for (int bit = 0; bit < 8; ++bit) {
      crc = (crc >> 1U) ^ ((crc & 1U) != 0 ? 0xedb88320U : 0U);
    }
  }
  return ~crc;
}

/// A zip archive of stored, not packed files.
inline std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
  std::string archive;
  std::string directory;
  const auto word = [](unsigned value) { return static_cast<std::uint16_t>(value); };
  for (const auto& [name, text] : files) {
    std::string common;
    for (const unsigned value : {20U, 0U, 0U, 0U, 0x21U}) {
      append_bytes(common, word(value));
    }
    append_bytes(common, crc32(text));
    append_bytes(common, static_cast<std::uint32_t>(text.size()));
    append_bytes(common, static_cast<std::uint32_t>(text.size()));
    append_bytes(common, static_cast<std::uint16_t>(name.size()));
    append_bytes(common, word(0));
    const auto offset = static_cast<std::uint32_t>(archive.size());
    archive += "PK\x03\x04" + common + name + text;
    directory += "PK\x01\x02";
    append_bytes(directory, word(20));
    directory += common + std::string(10, '\0');
    append_bytes(directory, offset);
    directory += name;
  }
  const auto start = static_cast<std::uint32_t>(archive.size());
  archive += directory + "PK\x05\x06" + std::string(4, '\0');
  append_bytes(archive, static_cast<std::uint16_t>(files.size()));
  append_bytes(archive, static_cast<std::uint16_t>(files.size()));
  append_bytes(archive, static_cast<std::uint32_t>(directory.size()));
  append_bytes(archive, start);
  append_bytes(archive, word(0));
  return archive;
}

/// A corner of 10 x 10 x 12.5 units, moved by 100 along X by its build item.
inline std::string corner_3mf(const std::string& unit = "millimeter") {
  return zip(
      {{"[Content_Types].xml",
        R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
       {"_rels/.rels",
        R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
       {"3D/3dmodel.model",
        std::string(R"(<?xml version="1.0"?><model unit=")") + unit +
            R"(" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="10" y="0" z="0"/><vertex x="0" y="10" z="0"/><vertex x="0" y="0" z="12.5"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object></resources><build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 100 0 0"/></build></model>)"}});
}

inline constexpr std::string_view kObj =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 5 5 7.25\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

inline constexpr std::string_view kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n10 0 0\n0 10 0\n0 0 12.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

inline constexpr std::string_view kAsciiStl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid t\n";

inline constexpr std::string_view kOff =
    "OFF\n4 4 6\n0 0 0\n10 0 0\n0 10 0\n0 0 12.5\n"
    "3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

}  // namespace g31::testing

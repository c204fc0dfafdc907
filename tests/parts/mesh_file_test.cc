#include "parts/import/mesh_file.h"

#include <bit>
#include <cstddef>
#include <cstdint>
#include <filesystem>
#include <fstream>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>
#include <unistd.h>

#include "parts/artefacts/ring_gauge.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::mesh_file_test {
namespace {

class MeshFile : public ::testing::Test {
 protected:
  void SetUp() override {
    folder_ =
        std::filesystem::temp_directory_path() / ("g31_mesh_file_" + std::to_string(::getpid()));
    std::filesystem::create_directories(folder_);
  }
  void TearDown() override { std::filesystem::remove_all(folder_); }

  [[nodiscard]] std::string write(const std::string& name, std::string_view text) const {
    const std::string path = (folder_ / name).string();
    std::ofstream(path, std::ios::binary) << text;
    return path;
  }

  std::filesystem::path folder_;
};

void append_bytes(std::string& bytes, std::uint32_t value) {
  for (int shift = 0; shift < 32; shift += 8) {
    bytes += static_cast<char>((value >> shift) & 0xffU);
  }
}

void append_bytes(std::string& bytes, float value) {
  append_bytes(bytes, std::bit_cast<std::uint32_t>(value));
}

std::string binary_stl(const Mesh& mesh) {
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

void append_bytes(std::string& bytes, std::uint16_t value) {
  bytes += static_cast<char>(value & 0xffU);
  bytes += static_cast<char>(value >> 8U);
}

std::uint32_t crc32(std::string_view bytes) {
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
std::string zip(const std::vector<std::pair<std::string, std::string>>& files) {
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

/// A corner of 10 x 10 x 12.5 mm, moved by 100 mm along X by its build item.
std::string corner_3mf() {
  return zip(
      {{"[Content_Types].xml",
        R"(<?xml version="1.0"?><Types xmlns="http://schemas.openxmlformats.org/package/2006/content-types"><Default Extension="rels" ContentType="application/vnd.openxmlformats-package.relationships+xml"/><Default Extension="model" ContentType="application/vnd.ms-package.3dmanufacturing-3dmodel+xml"/></Types>)"},
       {"_rels/.rels",
        R"(<?xml version="1.0"?><Relationships xmlns="http://schemas.openxmlformats.org/package/2006/relationships"><Relationship Target="/3D/3dmodel.model" Id="rel0" Type="http://schemas.microsoft.com/3dmanufacturing/2013/01/3dmodel"/></Relationships>)"},
       {"3D/3dmodel.model",
        R"(<?xml version="1.0"?><model unit="millimeter" xmlns="http://schemas.microsoft.com/3dmanufacturing/core/2015/02"><resources><object id="1" type="model"><mesh><vertices><vertex x="0" y="0" z="0"/><vertex x="10" y="0" z="0"/><vertex x="0" y="10" z="0"/><vertex x="0" y="0" z="12.5"/></vertices><triangles><triangle v1="0" v2="2" v3="1"/><triangle v1="0" v2="1" v3="3"/><triangle v1="1" v2="2" v3="3"/><triangle v1="2" v2="0" v3="3"/></triangles></mesh></object></resources><build><item objectid="1" transform="1 0 0 0 1 0 0 0 1 100 0 0"/></build></model>)"}});
}

constexpr std::string_view kObj =
    "v 0 0 0\nv 10 0 0\nv 10 10 0\nv 0 10 0\nv 5 5 7.25\n"
    "f 4 3 2 1\nf 1 2 5\nf 2 3 5\nf 3 4 5\nf 4 1 5\n";

constexpr std::string_view kPly =
    "ply\nformat ascii 1.0\nelement vertex 4\nproperty float x\nproperty float y\n"
    "property float z\nelement face 4\nproperty list uchar int vertex_indices\nend_header\n"
    "0 0 0\n10 0 0\n0 10 0\n0 0 12.5\n3 0 2 1\n3 0 1 3\n3 1 2 3\n3 2 0 3\n";

constexpr std::string_view kAsciiStl =
    "solid t\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
    "endloop\nendfacet\nfacet normal 0 0 1\nouter loop\nvertex 1 0 0\nvertex 1 1 0\n"
    "vertex 0 1 0\nendloop\nendfacet\nendsolid t\n";

TEST_F(MeshFile, ReadsWhatWasWritten) {
  struct Case {
    const char* name;
    std::string path;
    std::size_t vertices;
    std::size_t triangles;
    double volume;  ///< of a closed mesh, exact; 0: open
  };
  const Case kCases[] = {
      {"binary STL, corners joined again",
       write("box.stl", binary_stl(testing::box_mesh({3, 2, 1}))), 8, 12, 6.0},
      {"ASCII STL, open", write("open.stl", kAsciiStl), 4, 2, 0.0},
      {"OBJ with a quadrangle", write("pyramid.obj", kObj), 5, 6, 725.0 / 3.0},
      {"PLY", write("corner.ply", kPly), 4, 4, 1250.0 / 6.0},
      {"3MF", write("corner.3mf", corner_3mf()), 4, 4, 1250.0 / 6.0},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto read = read_mesh_file(c.path);
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_EQ(read.value().vertices.size(), c.vertices);
    EXPECT_EQ(read.value().triangles.size(), c.triangles);
    EXPECT_EQ(testing::is_closed_and_oriented(read.value()), c.volume > 0.0);
    if (c.volume > 0.0) {
      EXPECT_NEAR(testing::enclosed_volume(read.value()), c.volume, 1e-9);
    }
  }
}

TEST_F(MeshFile, AppliesTheTransformOfA3mfItem) {
  const auto read = read_mesh_file(write("moved.3mf", corner_3mf()));
  ASSERT_TRUE(read.ok()) << read.error();
  Point low = read.value().vertices[0];
  Point high = low;
  for (const Point& p : read.value().vertices) {
    low = low.cwiseMin(p);
    high = high.cwiseMax(p);
  }
  EXPECT_EQ(low, Point(100, 0, 0));
  EXPECT_EQ(high, Point(110, 10, 12.5));
}

TEST_F(MeshFile, KeepsARingGaugeWithinFloat32) {
  const Mesh ring = ring_gauge_mesh(RingGauge{}).value();
  const auto read = read_mesh_file(write("ring.stl", binary_stl(ring)));
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read.value().triangles.size(), ring.triangles.size());
  EXPECT_EQ(read.value().vertices.size(), ring.vertices.size());
  EXPECT_TRUE(testing::is_closed_and_oriented(read.value()));
  for (std::size_t i = 0; i < ring.triangles.size(); ++i) {
    for (std::size_t corner = 0; corner < 3; ++corner) {
      const Point& was = ring.vertices[ring.triangles[i][corner]];
      const Point& is = read.value().vertices[read.value().triangles[i][corner]];
      ASSERT_LE((was - is).cwiseAbs().maxCoeff(), 4e-6 / 2) << "float32 at 40 mm";
    }
  }
}

TEST_F(MeshFile, KeepsDegenerateTriangles) {
  const auto read =
      read_mesh_file(write("flat.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 0 1 0\nf 1 2 3\nf 1 2 4\n"));
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read.value().triangles.size(), 2U);
}

TEST_F(MeshFile, SaysWhatIsWrongInOneLine) {
  const std::string stl = binary_stl(testing::box_mesh({3, 2, 1}));
  std::string not_finite = stl;
  not_finite.replace(84 + 12, 4, std::string("\x00\x00\xc0\x7f", 4));
  struct Case {
    const char* name;
    std::string path;
    const char* reason;  ///< a part of the message
  };
  const Case kCases[] = {
      {"missing", (folder_ / "none.stl").string(), "there is no such file"},
      {"a folder", folder_.string(), "this is a folder"},
      {"empty", write("empty.stl", ""), "it is empty"},
      {"STL cut off", write("cut.stl", std::string_view(stl).substr(0, 300)), "not understood"},
      {"STL cut in its head", write("head.stl", std::string_view(stl).substr(0, 40)),
       "not understood"},
      {"STL with NaN", write("nan.stl", not_finite), "finite"},
      {"ASCII STL with inf",
       write("inf.stl",
             "solid a\nfacet normal 0 0 1\nouter loop\n"
             "vertex inf 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
             "endloop\nendfacet\nendsolid a\n"),
       "finite"},
      {"text", write("text.stl", "this is not a mesh at all, only some words in a file\n"),
       "not understood"},
      {"text as OBJ", write("text.obj", "this is not a mesh at all\n"), ""},
      {"OBJ names a vertex that is not there", write("far.obj", "v 0 0 0\nv 1 0 0\nf 1 2 9\n"), ""},
      {"OBJ without faces", write("points.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\n"), ""},
      {"PLY names a vertex that is not there",
       write("far.ply", std::string(kPly).replace(kPly.rfind("2 0 3"), 5, "2 0 9")), ""},
      {"PLY cut off in its header: assimp alone would try for ever",
       write("header.ply", kPly.substr(0, 95)), "not understood"},
      {"PLY cut off", write("cut.ply", kPly.substr(0, kPly.size() - 30)), ""},
      {"unknown ending", write("mesh.xyzzy", "1 2 3\n"), "expected a whole STL, OBJ, PLY or 3MF"},
      {"broken 3MF", write("broken.3mf", "PK\x03\x04 no archive"), ""},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto read = read_mesh_file(c.path);
    ASSERT_FALSE(read.ok());
    EXPECT_EQ(read.error().find("mesh file '" + c.path + "': "), 0U) << read.error();
    EXPECT_NE(read.error().find(c.reason), std::string::npos) << read.error();
    EXPECT_EQ(read.error().find('\n'), std::string::npos) << read.error();
  }
}

// Any truncation and any flipped byte ends in a mesh or in an error, never in a crash, and what is
// read always keeps its promise.
TEST_F(MeshFile, SurvivesDamage) {
  const std::pair<std::string, std::string> kWhole[] = {
      {"a.stl", binary_stl(testing::box_mesh({3, 2, 1}))},
      {"b.stl", std::string(kAsciiStl)},
      {"c.obj", std::string(kObj)},
      {"d.ply", std::string(kPly)},
  };
  std::mt19937_64 random(31);
  for (const auto& [name, whole] : kWhole) {
    for (int i = 0; i < 150; ++i) {
      std::string damaged = whole;
      damaged[random() % damaged.size()] = static_cast<char>(random() & 0xffU);
      if (i % 3 == 0) {
        damaged.resize(random() % damaged.size());
      }
      const auto read = read_mesh_file(write(name, damaged));
      if (!read) {
        EXPECT_FALSE(read.error().empty());
        continue;
      }
      EXPECT_FALSE(read.value().triangles.empty());
      for (const Point& p : read.value().vertices) {
        ASSERT_TRUE(p.allFinite());
      }
      for (const auto& t : read.value().triangles) {
        for (const std::uint32_t vertex : t) {
          ASSERT_LT(vertex, read.value().vertices.size());
        }
      }
    }
  }
}

}  // namespace
}  // namespace g31::parts::mesh_file_test

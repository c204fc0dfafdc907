// Files that are cut off, or whose heads promise what they do not hold.

#include "parts/import/whole_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <string_view>
#include <utility>

#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>

#include "parts/import/mesh_file.h"
#include "parts/import/mesh_limits.h"
#include "parts/import/three_mf_file.h"
#include "tests/parts/mesh_file_bytes.h"
#include "tests/parts/mesh_folder.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::whole_file_test {
namespace {

using testing::binary_stl;
using testing::corner_3mf;
using testing::kAsciiStl;
using testing::kObj;
using testing::kOff;
using testing::kPly;

std::string changed(std::string_view whole, std::string_view from, std::string_view to) {
  std::string bytes(whole);
  return bytes.replace(bytes.find(from), from.size(), to);
}

struct Broken {
  const char* name;
  std::string file;
  std::string bytes;
  const char* says;
};

class WholeFile : public testing::MeshFolder {
 protected:
  void expect_refused(std::span<const Broken> cases) const {
    for (const Broken& c : cases) {
      SCOPED_TRACE(c.name);
      const auto read = read_mesh_file(write(c.file, c.bytes));
      ASSERT_FALSE(read.ok());
      EXPECT_NE(read.error().find(c.says), std::string::npos) << read.error();
      EXPECT_EQ(read.error().find('\n'), std::string::npos);
    }
  }
};

/// The corner of kPly in the binary form.
std::string binary_ply(bool is_big_endian) {
  const std::string form = is_big_endian ? "binary_big_endian" : "binary_little_endian";
  std::string bytes = fmt::format(
      "ply\nformat {} 1.0\ncomment made by hand\nelement vertex 4\nproperty float x\n"
      "property float y\nproperty float z\nelement face 4\n"
      "property list uchar int vertex_indices\nend_header\n",
      form);
  const auto append = [&](auto value) {
    std::string number;
    testing::append_bytes(number, value);
    bytes += is_big_endian ? std::string(number.rbegin(), number.rend()) : number;
  };
  for (const float number : {0.F, 0.F, 0.F, 10.F, 0.F, 0.F, 0.F, 10.F, 0.F, 0.F, 0.F, 12.5F}) {
    append(number);
  }
  for (const std::uint32_t face : {21U, 13U, 123U, 203U}) {
    bytes += '\3';
    for (const std::uint32_t corner : {face / 100, face / 10 % 10, face % 10}) {
      append(corner);
    }
  }
  return bytes;
}

// Every beginning of a file is refused, or reads as the whole; of an OBJ, which promises nothing,
// it may read as less: then edges are left open.
TEST_F(WholeFile, IsReadWholeOrRefused) {
  struct Case {
    const char* name;
    std::string whole;
    bool may_be_open;
  };
  const Case kCases[] = {
      {"a.stl", binary_stl(testing::box_mesh({3, 2, 1})), false},
      {"b.stl", std::string(kAsciiStl), false},
      {"c.obj", std::string(kObj), true},
      {"d.ply", std::string(kPly), false},
      {"e.ply", binary_ply(false), false},
      {"f.ply", binary_ply(true), false},
      {"g.off", std::string(kOff), false},
      {"h.3mf", corner_3mf(), false},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    const auto whole = read_mesh_file(write(c.name, c.whole));
    ASSERT_TRUE(whole.ok()) << whole.error();
    std::size_t refused = 0;
    for (std::size_t size = 0; size < c.whole.size(); ++size) {
      const auto part = read_mesh_file(write(c.name, std::string_view(c.whole).substr(0, size)));
      if (!part) {
        ++refused;
      } else if (c.may_be_open) {
        EXPECT_TRUE(part.value().triangles == whole.value().triangles ||
                    !testing::is_closed_and_oriented(part.value()))
            << size;
      } else {
        EXPECT_EQ(part.value().triangles, whole.value().triangles) << size;
        EXPECT_EQ(part.value().vertices, whole.value().vertices) << size;
      }
    }
    EXPECT_GT(refused, c.whole.size() / 2);
  }
}

TEST_F(WholeFile, BothOrdersOfBytesAreTheSameMesh) {
  const auto text = read_mesh_file(write("a.ply", kPly));
  for (const bool is_big_endian : {false, true}) {
    const auto binary = read_mesh_file(write("b.ply", binary_ply(is_big_endian)));
    ASSERT_TRUE(binary.ok()) << binary.error();
    EXPECT_EQ(binary.value().vertices, text.value().vertices);
    EXPECT_EQ(binary.value().triangles, text.value().triangles);
  }
}

// The numbers of a text STL are read as they stand, not as float32.
TEST_F(WholeFile, TextStlIsReadInDouble) {
  const auto read = read_mesh_file(
      write("fine.stl",
            "solid a facet\nFACET NORMAL nan nan nan\n outer loop\n vertex 100.00000001 +1e-3 0\n"
            "vertex 1 0 0\r\nvertex 0 1 0\nendloop endfacet\nendsolid a facet\n\n"
            "solid\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\n"
            "endloop\nendfacet\nendsolid"));
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_EQ(read.value().vertices[0], Point(100.00000001, 1e-3, 0));
  EXPECT_EQ(read.value().triangles.size(), 2U);
  EXPECT_EQ(read.value().vertices.size(), 4U);
}

TEST_F(WholeFile, ThatAnStlIsNotIsSaidWithItsPlace) {
  const std::string stl = binary_stl(testing::box_mesh({3, 2, 1}));
  const std::string text(kAsciiStl);
  const Broken kCases[] = {
      {"half a text STL", "a.stl", text.substr(0, text.find("endloop")),
       "it ends in line 7, where 'endloop' is expected: it was cut off"},
      {"a text STL without its end", "a.stl", text.substr(0, text.rfind("endsolid")),
       "it ends in line 16, where 'facet' is expected: it was cut off"},
      {"a quadrangle", "a.stl", changed(text, "endloop", "vertex 1 1 1\nendloop"),
       "line 7: 'vertex', where 'endloop' is expected"},
      {"a comma", "a.stl", changed(text, "vertex 1 0 0", "vertex 1,5 0 0"),
       "line 5: '1,5', where a number is expected"},
      {"a binary STL with a facet more", "a.stl", fmt::format("{}{:50}", stl, ""),
       "it says that it has 12 facets, which are 684 bytes, but it has 734"},
      {"a binary STL that says solid, cut off", "a.stl",
       changed(stl.substr(0, 600), "     ", "solid"), "is expected"},
      {"an STL by another name", "a.mesh", text.substr(0, 50), "it was cut off"},
  };
  expect_refused(kCases);
}

TEST_F(WholeFile, ThatAMeshOfNumberedVerticesIsNotIsSaidWithItsPlace) {
  const Broken kCases[] = {
      {"a face with two corners", "a.obj", changed(kObj, "f 1 2 5", "f 1 2"),
       "line 7: a face has three corners or more, this one 2"},
      {"a face in the air", "a.obj", changed(kObj, "f 1 2 5", "f 1 2 6"),
       "line 7: a face names vertex 6, but there are only 5"},
      {"vertex 0", "a.obj", changed(kObj, "f 1 2 5", "f 1 2 0"),
       "line 7: '0' names no vertex of a face"},
      {"a vertex before the first", "a.obj", changed(kObj, "f 1 2 5", "f 1 2 -6"), "line 7: '-6'"},
      {"a word as a coordinate", "a.obj", changed(kObj, "v 10 0 0", "v 1o 0 0"),
       "line 2: a vertex has three numbers; '1o' is none"},
      {"OFF with a vertex more", "a.off", changed(kOff, "4 4 6", "5 4 6"),
       "line 10: expected a face"},
      {"OFF that goes on", "a.off", changed(kOff, "3 2 0 3", "3 2 0 3\n3 0 1 2"),
       "line 11: the 4 vertices"},
      {"OFF that names nothing", "a.off", changed(kOff, "3 2 0 3", "3 2 0 4"), "vertices below 4"},
      {"OFF of a billion", "a.off", changed(kOff, "4 4 6", "1000000000 4 6"), "its head lies"},
      {"PLY that goes on", "a.ply", changed(kPly, "3 2 0 3", "3 2 0 3\n3 0 1 2"),
       "it goes on behind"},
      {"PLY with a short list", "a.ply", changed(kPly, "3 2 0 3", "4 2 0 3"),
       "line 17: expected element face number 4 of 4"},
      {"PLY of a billion", "a.ply", changed(kPly, "vertex 4", "vertex 1000000000"),
       "its head promises 1000000000 of element vertex, and 61 bytes follow"},
      {"PLY of more than there can be", "a.ply",
       changed(binary_ply(false), "face 4", "face 18446744073709551615"), "its head lies"},
      {"PLY of elements without properties", "a.ply",
       changed(kPly, "element face", "element nothing 1000000000\nelement face"), "its head lies"},
      {"a kilometre and more", "a.obj", changed(kObj, "v 10 0 0", "v 1e7 0 0"), "is the farthest"},
  };
  expect_refused(kCases);
}

TEST_F(WholeFile, ThatAPackedFileIsNotIsSaid) {
  const Broken kCases[] = {
      {"packed", "a.stl.gz", "\x1f\x8b\x08 and so on", "it is packed; unpack it first"},
      {"packed, and named as if it were not", "a.stl", "PK\x03\x04 and so on", "it is packed"},
      {"3MF without its end", "a.3mf", corner_3mf().substr(0, 900), "it was cut off"},
      {"3MF in cubits", "a.3mf", corner_3mf("cubit"), "its unit is 'cubit', which is none of 3MF"},
      {"3MF with another byte", "a.3mf", changed(corner_3mf(), "12.5", "22.5"),
       "its checksum is wrong"},
      {"3MF with another byte beside its model", "a.3mf", changed(corner_3mf(), "rel0", "rel1"),
       "'_rels/.rels' in it is damaged: its checksum is wrong"},
  };
  expect_refused(kCases);
}

double width_of(const Mesh& mesh) {
  double least = mesh.vertices[0].x();
  double most = least;
  for (const Point& p : mesh.vertices) {
    least = std::min(least, p.x());
    most = std::max(most, p.x());
  }
  return most - least;
}

// 10 units wide, whatever the unit.
TEST_F(WholeFile, LengthsBecomeMm) {
  for (const auto& [unit, mm] :
       {std::pair{"micron", 0.01}, std::pair{"millimeter", 10.0}, std::pair{"centimeter", 100.0},
        std::pair{"inch", 254.0}, std::pair{"foot", 3048.0}, std::pair{"meter", 10000.0}}) {
    const auto read = read_mesh_file(write("a.3mf", corner_3mf(unit)));
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_NEAR(width_of(read.value()), mm, 1e-12 * mm) << unit;
  }
  for (const auto& [unit, mm] :
       {std::pair{"um", 0.01}, std::pair{"mm", 10.0}, std::pair{"cm", 100.0},
        std::pair{"m", 10000.0}, std::pair{"inch", 254.0}, std::pair{"foot", 3048.0}}) {
    const auto read = read_mesh_file(write("a.ply", kPly), {kStepSagittaMm, unit, 2.0});
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_NEAR(width_of(read.value()), 2.0 * mm, 1e-12 * mm) << unit;
  }
  const auto twice =
      read_mesh_file(write("a.3mf", corner_3mf("inch")), {kStepSagittaMm, "mm", 1.0});
  ASSERT_FALSE(twice.ok());
  EXPECT_NE(twice.error().find("it says its unit itself; leave out unit"), std::string::npos)
      << twice.error();
}

/// MiB that this process has used at most.
std::int64_t peak_mib() {
  rusage usage{};
  ::getrusage(RUSAGE_SELF, &usage);
  return usage.ru_maxrss / 1024;
}

TEST_F(WholeFile, MemoryIsNotAskedForThatAHeadPromises) {
  const std::int64_t before = peak_mib();
  for (const auto& [name, head] :
       {std::pair{"a.ply",
                  "ply\nformat ascii 1.0\nelement vertex 1000000000\nproperty float x\n"
                  "property float y\nproperty float z\nend_header\n0 0 0\n"},
        std::pair{"b.ply",
                  "ply\nformat binary_little_endian 1.0\nelement face 1000000000\n"
                  "property list uchar int vertex_indices\nend_header\n0 0 0\n"},
        std::pair{"c.off", "OFF\n1000000000 1000000000 0\n0 0 0\n"}}) {
    EXPECT_FALSE(read_mesh_file(write(name, head)).ok()) << name;
  }
  std::string stl = binary_stl(testing::box_mesh({3, 2, 1}));
  stl.replace(80, 4, "\xff\xff\xff\x7f");
  EXPECT_FALSE(read_mesh_file(write("d.stl", stl)).ok());
  EXPECT_LT(peak_mib() - before, 100);
}

/// An archive that says that its first file has that many bytes unpacked: its directory and the
/// head in front of the file.
std::string bomb(std::uint32_t unpacked) {
  std::string archive = corner_3mf();
  std::string size;
  testing::append_bytes(size, unpacked);
  archive.replace(archive.find("PK\x03\x04") + 22, 4, size);
  return archive.replace(archive.find("PK\x01\x02") + 24, 4, size);
}

TEST_F(WholeFile, WhatIsPackedIsJudgedBeforeItIsUnpacked) {
  const std::int64_t before = peak_mib();
  const auto large = read_mesh_file(write("bomb.3mf", bomb(4'000'000'000U)));
  ASSERT_FALSE(large.ok());
  EXPECT_NE(large.error().find("bytes; 536870912 are the most"), std::string::npos)
      << large.error();
  EXPECT_LT(peak_mib() - before, 100);
}

}  // namespace
}  // namespace g31::parts::whole_file_test

#include "parts/import/mesh_file.h"

#include <cstddef>
#include <cstdint>
#include <random>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "parts/artefacts/ring_gauge.h"
#include "parts/import/assimp_file.h"
#include "tests/parts/mesh_file_bytes.h"
#include "tests/parts/mesh_folder.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::mesh_file_test {
namespace {

using MeshFile = testing::MeshFolder;

using testing::binary_stl;
using testing::corner_3mf;
using testing::kAsciiStl;
using testing::kObj;
using testing::kPly;

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

/// %g writes six digits, so 0.00005 mm are lost of 19.8451; numbers of a drawing lose nothing.
TEST_F(MeshFile, ATextIsAsRoundedAsItsDigitsSay) {
  struct Case {
    const char* first;
    const char* second;
    double rounding_mm;
  };
  for (const Case& c :
       {Case{"19.8451", "5.13515", 5e-5}, Case{"19.845124", "5.135150", 5e-7},
        Case{"1.984512e+01", "5.135150e+00", 5e-6}, Case{"50", "12.5", 0.0},
        Case{"50.0000", "12.3450", 0.0}, Case{"0.0625", "150.5", 0.0},
        Case{"150.123", "5.13515", 2.5e-4}, Case{"19.845123456789013", "1", 5e-16}}) {
    SCOPED_TRACE(c.first);
    const std::string facet = std::string("facet normal 0 0 0\nouter loop\nvertex 0 0 0\nvertex ") +
                              c.first + " 0 0\nvertex 0 -" + c.second + " 0\nendloop\nendfacet\n";
    const auto read = read_mesh_file(write("digits.stl", "solid a\n" + facet + "endsolid a\n"));
    ASSERT_TRUE(read.ok()) << read.error();
    EXPECT_NEAR(read.value().rounding_mm, c.rounding_mm, 1e-9 * c.rounding_mm);
  }
}

/// Six digits of 150.123 inches end at 0.0005 inches, which is beyond the 0.00025 mm that a text is
/// held to be rounded at most.
TEST_F(MeshFile, ATextInInchesIsNoMoreRoundedThanOneInMillimetres) {
  const std::string path = write("inches.stl",
                                 "solid a\nfacet normal 0 0 0\nouter loop\nvertex 0 0 0\n"
                                 "vertex 150.123 0 0\nvertex 0 -5.13515 0\nendloop\nendfacet\n"
                                 "endsolid a\n");
  MeshFileReading how;
  how.unit = "inch";
  const auto read = read_mesh_file(path, how);
  ASSERT_TRUE(read.ok()) << read.error();
  EXPECT_NEAR(read.value().rounding_mm, 0.00025, 1e-12);
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

TEST_F(MeshFile, WithoutAnyAreaOrOfNoSizeIsNoSurface) {
  const auto flat =
      read_mesh_file(write("line.obj", "v 0 0 0\nv 1 0 0\nv 2 0 0\nv 3 0 0\nf 1 2 3\nf 1 2 4\n"));
  ASSERT_FALSE(flat.ok());
  EXPECT_NE(flat.error().find("none of its triangles has an area"), std::string::npos);
  const auto small =
      read_mesh_file(write("small.obj", "v 0 0 0\nv 1e-4 0 0\nv 0 1e-4 0\nf 1 2 3\n"));
  ASSERT_FALSE(small.ok());
  EXPECT_NE(small.error().find(" mm large; 0.001 mm is the least"), std::string::npos)
      << small.error();
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
      {"STL cut off", write("cut.stl", std::string_view(stl).substr(0, 300)), "it was cut off"},
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
       write("header.ply", kPly.substr(0, 95)), "no line of the head of a PLY"},
      {"PLY cut off", write("cut.ply", kPly.substr(0, kPly.size() - 30)), ""},
      {"unknown ending", write("mesh.xyzzy", "1 2 3\n"),
       "expected a whole STL, OBJ, PLY, OFF or 3MF"},
      {"a file of a CAD system", write("part.IGS", "S      1\n"),
       "this is a file of IGES, which g31 does not read: export STEP or STL"},
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

// Found by fuzzing: the directory of the archive calls the model otherwise than the relationships
// do.
TEST_F(MeshFile, A3mfWithoutItsModelIsRefused) {
  std::string bytes = corner_3mf();
  const std::size_t name = bytes.rfind("3D/3dmodel.model");  // in the directory, at the end
  ASSERT_NE(name, std::string::npos);
  bytes[name] = 'Z';
  const auto read = read_mesh_file(write("moved.3mf", bytes));
  ASSERT_FALSE(read.ok());
  EXPECT_NE(read.error().find("'3D/3dmodel.model', its model, is not in it"), std::string::npos)
      << read.error();
}

// What would end the process in assimp, were it not in one of its own, is an error like others.
TEST_F(MeshFile, AFileThatAssimpStopsAtIsRefused) {
  std::string bytes = corner_3mf();
  bytes[bytes.rfind("3D/3dmodel.model")] = 'Z';
  const auto read = read_through_assimp("moved.3mf", bytes);
  ASSERT_FALSE(read.ok());
  EXPECT_NE(
      read.error().find("assimp does not get through it (it breaks off at this file with signal 6"),
      std::string::npos)
      << read.error();
}

// Found by fuzzing: the head in front of a file has another checksum than the directory.
TEST_F(MeshFile, A3mfWhoseHeadsContradictEachOtherIsRefused) {
  const std::string whole = corner_3mf();
  for (const std::size_t place : {8U, 14U, 18U, 22U, 26U}) {
    std::string bytes = whole;
    const std::size_t head = bytes.rfind("PK\x03\x04");
    ASSERT_NE(head, std::string::npos);
    bytes[head + place] = static_cast<char>(bytes[head + place] ^ 1);
    EXPECT_FALSE(read_mesh_file(write("heads.3mf", bytes)).ok()) << place;
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

// Reading, judging and preparing a mesh can be broken off at every place where they ask, and do
// what they do otherwise when they are only asked.

#include <cerrno>
#include <functional>
#include <string>
#include <vector>

#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include "parts/geometry/bvh.h"
#include "parts/geometry/goes_on.h"
#include "parts/geometry/mesh_defects.h"
#include "parts/import/mesh_file.h"
#include "parts/import/work_apart.h"
#include "tests/parts/mesh_file_bytes.h"
#include "tests/parts/mesh_folder.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::broken_off_test {
namespace {

using BrokenOffWork = testing::MeshFolder;

/// How often work asks.
int askings(const std::function<void(const GoesOn&)>& work) {
  int asked = 0;
  work([&] {
    ++asked;
    return true;
  });
  return asked;
}

/// Breaks work off at its first askings.
void expect_breakable_at_first(const std::function<void(const GoesOn&)>& work, int askings) {
  for (int last = 1; last <= askings; ++last) {
    int asked = 0;
    EXPECT_THROW(work([&] { return ++asked < last; }), BrokenOff) << last;
    EXPECT_EQ(asked, last);
  }
}

/// Breaks work off at each of its askings, or at some of many.
void expect_breakable(const std::function<void(const GoesOn&)>& work, int at_least) {
  const int all = askings(work);
  EXPECT_GE(all, at_least);
  for (int last = 1; last <= all; last += 1 + all / 20) {
    int asked = 0;
    EXPECT_THROW(work([&] { return ++asked < last; }), BrokenOff) << last << " of " << all;
    EXPECT_EQ(asked, last);
  }
}

std::string text_stl(const Mesh& mesh) {
  std::string text = "solid s\n";
  for (const auto& t : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : t) {
      const Point& p = mesh.vertices[corner];
      text += "vertex " + std::to_string(p.x()) + ' ' + std::to_string(p.y()) + ' ' +
              std::to_string(p.z()) + '\n';
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid s\n";
}

TEST_F(BrokenOffWork, IsTheReadingOfAnStlFile) {
  const Mesh sphere = testing::sphere_mesh(10.0, 60);  // 14,160 facets
  ASSERT_GT(sphere.triangles.size(), 3U * 4096U);
  struct Case {
    std::string path;
    int at_least;
  };
  const Case kCases[] = {
      {write("binary.stl", testing::binary_stl(sphere)), 4},
      {write("text.stl", text_stl(sphere)), 3},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.path);
    std::size_t triangles = 0;
    expect_breakable(
        [&](const GoesOn& goes_on) {
          MeshFileReading how;
          how.goes_on = goes_on;
          const auto read = read_mesh_file(c.path, how);
          ASSERT_TRUE(read.ok()) << read.error();
          triangles = read.value().triangles.size();
        },
        c.at_least);
    EXPECT_EQ(triangles, read_mesh_file(c.path).value().triangles.size());
  }
}

// Before it is read, and while the process that reads it works: at its bytes and at their end.
TEST_F(BrokenOffWork, IsTheReadingOfAFileThroughAssimp) {
  for (const std::string& path :
       {write("pyramid.obj", testing::kObj), write("corner.ply", testing::kPly),
        write("corner.3mf", testing::corner_3mf())}) {
    SCOPED_TRACE(path);
    expect_breakable_at_first(
        [&](const GoesOn& goes_on) {
          MeshFileReading how;
          how.goes_on = goes_on;
          (void)read_mesh_file(path, how);
        },
        3);
    EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1) << "a process is left";
    EXPECT_EQ(errno, ECHILD);
  }
}

TEST(BrokenOff, IsTheJudgingOfAMesh) {
  const Mesh sphere = testing::sphere_mesh(10.0, 60);
  expect_breakable([&](const GoesOn& goes_on) { (void)defects_of(sphere, goes_on); }, 10);
}

TEST(BrokenOff, IsTheMakingOfATree) {
  const std::vector<Box> boxes = triangle_boxes(testing::sphere_mesh(10.0, 60));
  expect_breakable([&](const GoesOn& goes_on) { const Bvh tree(boxes, goes_on); }, 3);
}

// The process of its own is gone then.
TEST(BrokenOff, IsWorkApart) {
  int asked = 0;
  EXPECT_THROW((void)done_apart(
                   []() -> std::string {
                     for (;;) {
                       ::pause();
                     }
                   },
                   [&] { return ++asked < 3; }),
               BrokenOff);
  EXPECT_EQ(asked, 3);
  EXPECT_EQ(::waitpid(-1, nullptr, WNOHANG), -1);
  EXPECT_EQ(errno, ECHILD);
}

}  // namespace
}  // namespace g31::parts::broken_off_test

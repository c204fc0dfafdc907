#include "parts/geometry/mesh_defects.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <numbers>
#include <random>
#include <string>
#include <utility>
#include <vector>

#include <Eigen/LU>
#include <fmt/format.h>
#include <gtest/gtest.h>

#include "parts/artefacts/artefact.h"
#include "parts/geometry/crossing_facets.h"
#include "parts/geometry/winding_number.h"
#include "parts/import/mesh_file.h"
#include "parts/import/vertex_weld.h"
#include "tests/probe/test_meshes.h"

namespace g31::parts::mesh_defects_test {
namespace {

using testing::box_mesh;
using testing::moved_by;

/// Both meshes in one.
Mesh together(const Mesh& a, const Mesh& b) {
  Mesh both;
  VertexWeld weld(both);
  for (const Mesh* const mesh : {&a, &b}) {
    for (const auto& t : mesh->triangles) {
      both.triangles.push_back({weld.vertex_at(mesh->vertices[t[0]]),
                                weld.vertex_at(mesh->vertices[t[1]]),
                                weld.vertex_at(mesh->vertices[t[2]])});
    }
  }
  return both;
}

Mesh turned_over(Mesh mesh) {
  for (auto& t : mesh.triangles) {
    std::swap(t[0], t[1]);
  }
  return mesh;
}

Mesh box_with(const std::array<std::uint32_t, 3>& further) {
  Mesh mesh = box_mesh({10, 10, 10});
  mesh.triangles.push_back(further);
  return mesh;
}

/// How many of each: open, flipped, inward, stray, flat, self-contact.
using Counts = std::array<std::uint64_t, 6>;

Counts counts_of(const Mesh& mesh) {
  const MeshDefects found = defects_of(mesh);
  return {found.open_edges.count,   found.flipped_facets.count, found.inward_shells.count,
          found.stray_shells.count, found.flat_facets.count,    found.self_contacts.count};
}

constexpr Counts kClean{};

TEST(MeshDefects, CarefulMeshesHaveNone) {
  const Mesh box = box_mesh({10, 10, 10});
  const Mesh cavity = turned_over(moved_by(box_mesh({6, 6, 6}), {2, 2, 2}));
  const Mesh core = moved_by(box_mesh({2, 2, 2}), {4, 4, 4});
  EXPECT_EQ(counts_of(Mesh{}), kClean);
  EXPECT_EQ(counts_of(box), kClean);
  EXPECT_EQ(counts_of(testing::sphere_mesh(20.0, 30)), kClean);
  EXPECT_EQ(counts_of(together(testing::unshared(testing::sphere_mesh(20.0, 9)), Mesh{})), kClean);
  EXPECT_EQ(counts_of(together(box, cavity)), kClean) << "a hollow";
  EXPECT_EQ(counts_of(together(together(box, cavity), core)), kClean) << "a solid in a hollow";
  EXPECT_EQ(counts_of(together(box, moved_by(box, {300, 0, 0}))), kClean) << "two clamps";
  EXPECT_EQ(
      counts_of(together(box, turned_over(moved_by(box_mesh({0.05, 0.05, 0.05}), {5, 5, 5})))),
      kClean)
      << "a pore";
  EXPECT_EQ(counts_of(together(box, moved_by(box_mesh({0.1, 0.1, 0.1}), {5, 5, 10.1}))), kClean)
      << "a small piece close by";
}

TEST(MeshDefects, ShapesAndShippedMeshesHaveNone) {
  for (const Shape& shape : shapes()) {
    PartSetup setup;
    setup.shape = shape.name;
    const auto mesh = make_artefact(setup);
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(counts_of(mesh.value()), kClean) << shape.name;
  }
  for (const char* const name : {"06", "09", "15"}) {
    const auto mesh =
        read_mesh_file(fmt::format("parts/library/hirose_figures/figure_{}.obj", name));
    ASSERT_TRUE(mesh.ok()) << mesh.error();
    EXPECT_EQ(counts_of(mesh.value()), kClean) << name;
  }
}

TEST(MeshDefects, EachIsCounted) {
  const Mesh box = box_mesh({10, 10, 10});
  Mesh removed = box;
  removed.triangles.erase(removed.triangles.begin() + 4);
  Mesh flipped = box;
  std::swap(flipped.triangles[5][0], flipped.triangles[5][1]);
  Mesh first_flipped = box;
  std::swap(first_flipped.triangles[0][0], first_flipped.triangles[0][1]);
  Mesh both = removed;
  std::swap(both.triangles[8][0], both.triangles[8][1]);
  Mesh junction = box;  // the edge from 0 to 1 has a vertex more on one side
  junction.vertices.emplace_back(5, 0, 0);
  junction.triangles[0] = {0, 2, 8};
  junction.triangles.push_back({8, 2, 1});
  struct Case {
    const char* name;
    Mesh mesh;
    Counts counts;
  };
  const Case kCases[] = {
      {"one facet removed", removed, {3, 0, 0, 0, 0, 0}},
      {"one flipped", flipped, {0, 1, 0, 0, 0, 0}},
      {"the first one flipped", first_flipped, {0, 1, 0, 0, 0, 0}},
      {"one removed, one flipped", both, {3, 1, 0, 0, 0, 0}},
      {"all normals inwards", turned_over(box), {0, 0, 1, 0, 0, 0}},
      {"all inwards, one outwards", turned_over(flipped), {0, 1, 1, 0, 0, 0}},
      {"one doubled: three edges of three, and itself", box_with({0, 2, 1}), {0, 0, 0, 0, 0, 4}},
      {"one doubled, the other way round", box_with({0, 1, 2}), {0, 0, 0, 0, 0, 4}},
      {"a wall inside: edges of three", box_with({0, 1, 7}), {2, 0, 0, 0, 0, 1}},
      {"a corner twice", box_with({0, 0, 1}), {0, 0, 0, 0, 1, 0}},
      {"a T-junction", junction, {3, 0, 0, 0, 0, 0}},
      {"a speck far away",
       together(box, moved_by(box_mesh({.01, .01, .01}), {40, 0, 0})),
       {0, 0, 0, 1, 0, 0}},
      {"a speck turned inside out",
       together(box, turned_over(moved_by(box_mesh({.01, .01, .01}), {40, 0, 0}))),
       {0, 0, 1, 1, 0, 0}},
      {"two boxes in one file that run into each other: one facet each of three faces",
       together(box, moved_by(box, {5, 5, 5})),
       {0, 0, 0, 0, 0, 3}},
      {"a hollow with its normals outwards",
       together(box, moved_by(box_mesh({6, 6, 6}), {2, 2, 2})),
       {0, 0, 1, 0, 0, 0}},
      {"a hollow, all turned over",
       turned_over(together(box, turned_over(moved_by(box_mesh({6, 6, 6}), {2, 2, 2})))),
       {0, 0, 2, 0, 0, 0}},
  };
  for (const Case& c : kCases) {
    EXPECT_EQ(counts_of(c.mesh), c.counts) << c.name;
  }
}

/// The strip of a closed ribbon along a curve, 2 mm high, of `count` squares.
template <typename Curve>
Mesh ribbon(int count, const Curve& curve) {
  Mesh mesh;
  for (int i = 0; i < count; ++i) {
    const auto [x, y] = curve(2.0 * std::numbers::pi * i / count);
    mesh.vertices.emplace_back(x, y, 0.0);
    mesh.vertices.emplace_back(x, y, 2.0);
  }
  for (int i = 0; i < count; ++i) {
    const auto a = static_cast<std::uint32_t>(2 * i);
    const auto b = static_cast<std::uint32_t>(2 * ((i + 1) % count));
    mesh.triangles.push_back({a, b, b + 1});
    mesh.triangles.push_back({a, b + 1, a + 1});
  }
  return mesh;
}

TEST(CrossingFacets, AreThoseOfARibbonThatGoesThroughItself) {
  const auto eight = [](double t) {
    return std::pair(10.0 * std::sin(t), 5.0 * std::sin(2.0 * t));
  };
  const auto circle = [](double t) { return std::pair(10.0 * std::sin(t), 10.0 * std::cos(t)); };
  // 50 squares: squares 0 to 24 go one way through the middle, 25 to 49 the other one; both legs
  // have a vertex there with 50, the middle of a square with 46.
  EXPECT_TRUE(crossing_facets(ribbon(50, circle)).facets.empty());
  const CrossingFacets crossing =
      crossing_facets(ribbon(46, [&](double t) { return eight(t + std::numbers::pi / 46); }));
  EXPECT_EQ(crossing.looked_at, 92U);
  EXPECT_EQ(crossing.facets, (std::vector<std::uint32_t>{44, 45}));
}

TEST(CrossingFacets, AreNoneWhereFacetsTouch) {
  const Mesh box = box_mesh({10, 10, 10});
  for (const Point& by : {Point(10, 0, 0), Point(10, 5, 5), Point(10, 10, 10), Point(3, 4, 10),
                          Point(10 - 1e-6, 3, 3), Point(0, 0, 10)}) {
    EXPECT_TRUE(crossing_facets(together(box, moved_by(box, by))).facets.empty()) << by;
  }
  EXPECT_FALSE(crossing_facets(together(box, moved_by(box, {10 - 1e-4, 3, 3}))).facets.empty());
}

/// No facet goes through another one: pieces of four faces lie over each other.
TEST(CrossingFacets, AreThoseThatLieOverEachOtherInOnePlane) {
  const Mesh box = box_mesh({10, 10, 10});
  for (const Point& by : {Point(4, 0, 0), Point(0, -3, 0), Point(0, 0, 9.9), Point(1e-3, 0, 0)}) {
    EXPECT_FALSE(crossing_facets(together(box, moved_by(box, by))).facets.empty()) << by;
  }
  const Mesh leaf{{Point(0, 0, 0), Point(9, 0, 0), Point(0, 9, 0)}, {{0, 1, 2}}};
  const auto with = [&](const Mesh& other) {
    return crossing_facets(together(leaf, other)).facets;
  };
  EXPECT_EQ(with(moved_by(leaf, {1, 1, 0})), (std::vector<std::uint32_t>{0}));
  EXPECT_TRUE(with(turned_over(moved_by(leaf, {1, 1, 0}))).empty()) << "back to back";
  EXPECT_TRUE(with(moved_by(leaf, {4.5, 4.5, 0})).empty()) << "beside the long side";
  // Over it by 0.03 um, within 16 times 2^-22 of 13.5 mm (0.05 um), and by 1.4 um.
  EXPECT_TRUE(with(moved_by(leaf, {4.5 - 2e-5, 4.5 - 2e-5, 0})).empty());
  EXPECT_EQ(with(moved_by(leaf, {4.5 - 1e-3, 4.5 - 1e-3, 0})), (std::vector<std::uint32_t>{0}));
  EXPECT_TRUE(with(moved_by(leaf, {1, 1, 0.1})).empty()) << "above it";
}

/// Whether a side of a facet goes through another one.
bool goes_through(const Mesh& mesh, std::uint32_t t, std::uint32_t other) {
  const auto& w = mesh.triangles[other];
  const Point& o = mesh.vertices[w[0]];
  for (std::size_t i = 0; i < 3; ++i) {
    const Point& from = mesh.vertices[mesh.triangles[t].at(i)];
    const Point& to = mesh.vertices[mesh.triangles[t].at((i + 1) % 3)];
    Eigen::Matrix3d system;
    system << from - to, mesh.vertices[w[1]] - o, mesh.vertices[w[2]] - o;
    const Point s = system.fullPivLu().solve(from - o);  // share of the way, place in the facet
    if (s.minCoeff() > 1e-9 && s.x() < 1.0 - 1e-9 && s.y() + s.z() < 1.0 - 1e-9) {
      return true;
    }
  }
  return false;
}

// Brute force: every side of a facet against every other facet.
TEST(CrossingFacets, AreThoseThatASideGoesThrough) {
  std::mt19937_64 random(17);
  for (int round = 0; round < 20; ++round) {
    const Mesh mesh =
        together(testing::sphere_mesh(10.0, 5),
                 moved_by(testing::sphere_mesh(7.0, 4), testing::point_between(random, -9.0, 9.0)));
    std::vector<std::uint32_t> expected;
    for (std::uint32_t a = 0; a < mesh.triangles.size(); ++a) {
      for (std::uint32_t b = a + 1; b < mesh.triangles.size(); ++b) {
        if (goes_through(mesh, a, b) || goes_through(mesh, b, a)) {
          expected.push_back(a);
          break;
        }
      }
    }
    EXPECT_EQ(crossing_facets(mesh).facets, expected);
  }
}

// A box of twelve facets through a wall of more than half a million.
TEST(CrossingFacets, AreFoundInALargeMesh) {
  const Mesh sphere = testing::sphere_mesh(10.0, 400);
  ASSERT_GT(sphere.triangles.size(), 600'000U);
  const Mesh mesh = together(sphere, moved_by(box_mesh({3, 2, 1}), {8.5, -0.7, 0.3}));
  std::vector<std::uint32_t> expected;
  const auto all = static_cast<std::uint32_t>(mesh.triangles.size());
  for (std::uint32_t t = 0; t < all - 12; ++t) {
    if (mesh.vertices[mesh.triangles[t][0]].x() < 9.5) {
      continue;  // far from the box, whose piece of the sphere begins at 9.8
    }
    for (std::uint32_t of_box = all - 12; of_box < all; ++of_box) {
      if (goes_through(mesh, t, of_box) || goes_through(mesh, of_box, t)) {
        expected.push_back(t);
        break;
      }
    }
  }
  ASSERT_FALSE(expected.empty());
  EXPECT_EQ(crossing_facets(mesh).facets, expected);
}

TEST(CrossingFacets, AreNotLookedForBeyondTheirBudget) {
  const Mesh sphere = testing::sphere_mesh(10.0, 10);
  const CrossingFacets some = crossing_facets(sphere, 5000);
  EXPECT_GT(some.looked_at, 5U);
  EXPECT_LT(some.looked_at, sphere.triangles.size());
}

// What is asked of a mesh of any size: a third of the budget is plenty for a careful one, also
// where all of it lies in one plane.
TEST(CrossingFacets, OfACarefulMeshAreAllLookedForWithinAThirdOfTheBudget) {
  Mesh plane;
  constexpr std::uint32_t kSquares = 100;
  for (std::uint32_t i = 0; i <= kSquares; ++i) {
    for (std::uint32_t j = 0; j <= kSquares; ++j) {
      plane.vertices.emplace_back(0.3 * i, 0.2 * j, 7.0);
    }
  }
  for (std::uint32_t i = 0; i < kSquares; ++i) {
    for (std::uint32_t j = 0; j < kSquares; ++j) {
      const std::uint32_t a = i * (kSquares + 1) + j;
      plane.triangles.push_back({a, a + kSquares + 1, a + kSquares + 2});
      plane.triangles.push_back({a, a + kSquares + 2, a + 1});
    }
  }
  for (const Mesh& mesh : {testing::sphere_mesh(10.0, 60), plane, turned_over(plane)}) {
    const CrossingFacets found =
        crossing_facets(mesh, kMostComparedForEach / 3 * mesh.triangles.size());
    EXPECT_EQ(found.looked_at, mesh.triangles.size());
    EXPECT_TRUE(found.facets.empty());
  }
}

TEST(MeshDefects, TheFirstHasAPlace) {
  Mesh mesh = box_mesh({10, 20, 30});
  mesh.triangles.erase(mesh.triangles.begin());  // 0, 2, 1 of the lower face
  const MeshDefects found = defects_of(mesh);
  EXPECT_EQ(found.open_edges.p_P_first, Point(5, 0, 0));
  Mesh flipped = box_mesh({10, 20, 30});
  std::swap(flipped.triangles[2][0], flipped.triangles[2][1]);
  EXPECT_TRUE(defects_of(flipped).flipped_facets.p_P_first.isApprox(Point(10.0 / 3, 20.0 / 3, 30)));
}

// Any number of facets turned over at random: never more than half of them count.
TEST(MeshDefects, FlippedFacetsAreTheFewer) {
  const Mesh sphere = testing::sphere_mesh(10.0, 8);
  for (std::uint64_t seed = 0; seed < 20; ++seed) {
    const Mesh turned = testing::turned_at_random(sphere, seed);
    std::uint64_t differing = 0;
    for (std::size_t i = 0; i < sphere.triangles.size(); ++i) {
      differing += sphere.triangles[i] != turned.triangles[i] ? 1U : 0U;
    }
    EXPECT_EQ(defects_of(turned).flipped_facets.count,
              std::min(differing, sphere.triangles.size() - differing));
    EXPECT_EQ(defects_of(turned).open_edges.count, 0U);
  }
}

TEST(WindingNumber, SaysWhatIsInside) {
  const Mesh box = box_mesh({10, 10, 10});
  const Mesh hollow = together(box, turned_over(moved_by(box_mesh({6, 6, 6}), {2, 2, 2})));
  EXPECT_NEAR(winding_number(box, {5, 5, 5}), 1.0, 1e-12);
  EXPECT_NEAR(winding_number(box, {5, 5, 9.999}), 1.0, 1e-9);
  EXPECT_NEAR(winding_number(box, {5, 5, 10.001}), 0.0, 1e-9);
  EXPECT_NEAR(winding_number(box, {5, 5, 10}), 0.5, 1e-9);
  EXPECT_NEAR(winding_number(turned_over(box), {1, 2, 3}), -1.0, 1e-12);
  EXPECT_NEAR(winding_number(hollow, {5, 5, 5}), 0.0, 1e-12);
  EXPECT_NEAR(winding_number(hollow, {5, 5, 1}), 1.0, 1e-12);
}

// Few and many are looked through in different ways.
TEST(MeshDefects, PagesOnOneEdgeAreOneContactAndEachDoubledPageAnother) {
  for (const std::uint32_t pages : {3U, 16U, 17U, 300U}) {
    Mesh book;
    book.vertices = {{0.0, 0.0, 0.0}, {0.0, 0.0, 10.0}};
    for (std::uint32_t page = 0; page < pages; ++page) {
      const double angle = 2.0 * std::numbers::pi * page / pages;
      book.vertices.emplace_back(10.0 * std::cos(angle), 10.0 * std::sin(angle), 5.0);
      book.triangles.push_back({0, 1, page + 2});
    }
    EXPECT_EQ(defects_of(book).self_contacts.count, 1U) << pages;
    book.triangles.push_back({1, 0, 2});
    book.triangles.push_back({0, 1, pages + 1});
    EXPECT_EQ(defects_of(book).self_contacts.count, 3U) << pages;
  }
}

// They all lie in one place, where the search would hold each against all.
TEST(MeshDefects, AMillionFacetsInOnePointAreFlatAndNothingElse) {
  Mesh mesh = box_mesh({10, 10, 10});
  mesh.triangles.resize(1'000'000, {0, 0, 0});
  const CrossingFacets crossing = crossing_facets(mesh);
  EXPECT_EQ(crossing.facets.size(), 0U);
  EXPECT_EQ(crossing.looked_at, mesh.triangles.size());
}

// Bytes that are no numbers are told by who reads the file: here they are a place like others.
TEST(VertexWeld, FindsWhatIsNoNumberAgain) {
  Mesh mesh;
  VertexWeld weld(mesh);
  const Point none = Point::Constant(std::numeric_limits<double>::quiet_NaN());
  EXPECT_EQ(weld.vertex_at(none), 0U);
  EXPECT_EQ(weld.vertex_at({0.0, 1.0, 2.0}), 1U);
  EXPECT_EQ(weld.vertex_at({-0.0, 1.0, 2.0}), 1U);
  EXPECT_EQ(weld.vertex_at(none), 0U);
}

}  // namespace
}  // namespace g31::parts::mesh_defects_test

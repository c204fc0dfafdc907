// STEP files that are cut off, changed at random or lack an entity, and meshes: a message or a
// result, never a crash.

#include <cstddef>
#include <fstream>
#include <iterator>
#include <string>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "machine/base/random.h"
#include "parts/features/recognise.h"
#include "parts/import/step_file.h"
#include "parts/solids/removal.h"
#include "tests/solids/made_parts.h"
#include "tests/solids/step_text.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"

namespace g31::hostile_step_test {
namespace {

const char* const kProduct = "parts/library/inspection/product.step";

std::string product_text() {
  std::ifstream file(kProduct, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

class Mutation {
 public:
  explicit Mutation(std::uint64_t number) : stream_{number, 0} {}

  std::string of(std::string text) {
    switch (draw(4)) {
      case 0:
        return text.substr(0, draw(text.size()));
      case 1:
        for (std::size_t i = 1 + draw(8); i > 0; --i) {
          text[draw(text.size())] = static_cast<char>(draw(256));
        }
        return text;
      case 2:  // another entity is named
        return with(text, "#", fmt::format("#{}", 1 + draw(900)), 3);
      default:  // another number
        return with(text, ".,", draw(2) == 0 ? "e308," : "e-9,", 2);
    }
  }

 private:
  std::size_t draw(std::size_t count) {
    return static_cast<std::size_t>(uniform(stream_, next_++) * static_cast<double>(count));
  }

  std::string with(std::string text, std::string_view at, const std::string& other,
                   std::size_t length) {
    const std::size_t place = text.find(at, draw(text.size()));
    return place == text.npos ? text : text.replace(place, length, other);
  }

  Stream stream_;
  std::uint64_t next_ = 0;
};

TEST(HostileStep, ChangedAtRandomItIsReadOrRefused) {
  const std::uint64_t kFiles = testing::of_many(100U);
  const testing::TemporaryFolder folder;
  const std::string text = product_text();
  ASSERT_FALSE(text.empty());
  std::size_t refused = 0;
  for (std::uint64_t number = 0; number < kFiles; ++number) {
    const std::string path = folder.write("changed.step", Mutation(number).of(text));
    const auto removal = parts::removal_of(path, {});
    if (removal) {
      const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
      EXPECT_LE(part.features.size(), 20U) << number;
    } else {
      ++refused;
      EXPECT_FALSE(removal.error().empty()) << number;
    }
    const auto mesh = parts::read_step_file(path, 0.01);
    EXPECT_TRUE(mesh.ok() || !mesh.error().empty()) << number;
  }
  EXPECT_GT(refused, kFiles / 2);
  if (!testing::under_sanitizers()) {
    EXPECT_LT(refused, kFiles);
  }
}

TEST(HostileStep, CutOffAnywhereItIsRefused) {
  const std::uint64_t kFiles = testing::of_many(200U);
  const testing::TemporaryFolder folder;
  const std::string text = product_text();
  ASSERT_FALSE(text.empty());
  std::size_t refused = 0;
  for (std::uint64_t number = 0; number < kFiles; ++number) {
    const std::string path = folder.write(
        "changed.step", text.substr(0, static_cast<std::size_t>(uniform({number, 0}, 0) *
                                                                static_cast<double>(text.size()))));
    const auto removal = parts::removal_of(path, {});
    if (removal) {
      const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
      EXPECT_LE(part.features.size(), 20U) << number;
    } else {
      ++refused;
      EXPECT_FALSE(removal.error().empty()) << number;
    }
    const auto mesh = parts::read_step_file(path, 0.01);
    EXPECT_TRUE(mesh.ok() || !mesh.error().empty()) << number;
  }
  EXPECT_GT(refused, kFiles / 2);
}

TEST(HostileStep, AnEntityThatIsNotThereIsNamed) {
  const testing::TemporaryFolder folder;
  std::string text = product_text();
  const std::size_t at = text.find("CARTESIAN_POINT");
  ASSERT_NE(at, text.npos);
  const std::size_t begin = text.rfind('\n', at) + 1;
  text.erase(begin, text.find('\n', at) - begin + 1);
  const auto mesh = parts::read_step_file(folder.write("hole.step", text), 0.01);
  ASSERT_FALSE(mesh.ok());
  EXPECT_NE(mesh.error().find("name others that are not there"), std::string::npos) << mesh.error();
}

// What is none of the body does not make a file broken: properties, names left out, callouts.
TEST(HostileStep, WhatSystemsWriteBesideTheBodyIsNoFault) {
  const testing::TemporaryFolder folder;
  const std::string text = product_text();
  const auto product = parts::read_step_file(kProduct, 0.01);
  ASSERT_TRUE(product.ok());
  for (const std::string beside :
       {"#9001=DESCRIPTIVE_REPRESENTATION_ITEM('AMS 4928');\n"
        "#9002=REPRESENTATION('material name',(#9001),#892);\n",
        "#9001=INTEGER_REPRESENTATION_ITEM('count',3.);\n",
        "#9001=ITEM_DEFINED_TRANSFORMATION($,$,#11,#11);\n",
        "#9001=LEADER_DIRECTED_CALLOUT('',(#9003));\n#9003=ANNOTATION_CURVE_OCCURRENCE('',(),#9004)"
        ";\n"
        "#9004=POLYLINE('',(#12,#12));\n#9002=SHAPE_REPRESENTATION('',(#9001),#892);\n"}) {
    std::string whole = text;
    whole.insert(whole.rfind("ENDSEC;"), beside);
    const auto mesh = parts::read_step_file(folder.write("beside.step", whole), 0.01);
    ASSERT_TRUE(mesh.ok()) << beside << mesh.error();
    EXPECT_EQ(mesh.value().triangles.size(), product.value().triangles.size()) << beside;
  }
  std::string cut = text;
  cut.insert(cut.rfind("ENDSEC;"), "#9002=SHAPE_REPRESENTATION('',(#9001),#892);\n");
  EXPECT_FALSE(parts::read_step_file(folder.write("cut.step", cut), 0.01).ok());
}

/// A mesh as a text STL.
std::string stl_of(const parts::Mesh& mesh) {
  std::string text = "solid part\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const auto vertex : triangle) {
      const Point& p = mesh.vertices[vertex];
      text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid part\n";
}

TEST(Meshes, GoThroughTheSameSteps) {
  const testing::TemporaryFolder folder;
  const std::string step = folder.path("part.step");
  testing::write_step(testing::cut(testing::block({{0, 0, -40}, {160, 110, 0}}),
                                   {testing::block({{0, 45, -10}, {160, 57, 0}}),
                                    testing::block({{90, 10, -15}, {130, 35, 0}}),
                                    testing::block({{100, 15, -25}, {120, 30, -15}})}),
                      "part", step);
  const auto mesh = parts::read_step_file(step, 0.01);
  ASSERT_TRUE(mesh.ok()) << mesh.error();
  const std::string stl = folder.write("part.stl", stl_of(mesh.value()));
  const auto removal = parts::removal_of(stl, {});
  ASSERT_TRUE(removal.ok()) << removal.error();
  const auto part = parts::recognise(removal.value().stock_P, removal.value().volumes);
  ASSERT_EQ(part.features.size(), 3U);
  EXPECT_TRUE(part.unknown.empty());
  EXPECT_EQ(name_of(part.features[0].kind), "open_slot");
  EXPECT_EQ(name_of(part.features[1].kind), "closed_pocket");
  EXPECT_EQ(part.features[1].box_P.min, Point(90, 10, -15));
  EXPECT_EQ(part.features[2].box_P.min, Point(100, 15, -25));
}

/// What is found on a product that comes as a mesh of a STEP file's facets.
parts::RecognisedPart recognised_mesh(const TopoDS_Shape& product, double sagitta_mm) {
  const testing::TemporaryFolder folder;
  const std::string step = folder.path("part.step");
  testing::write_step(product, "part", step);
  const auto mesh = parts::read_step_file(step, sagitta_mm);
  EXPECT_TRUE(mesh.ok()) << mesh.error();
  const auto removal = parts::removal_of(folder.write("part.stl", stl_of(mesh.value())), {});
  EXPECT_TRUE(removal.ok()) << removal.error();
  return parts::recognise(removal.value().stock_P, removal.value().volumes);
}

TEST(Meshes, HaveRoundWallsWhereTheirFacetsLieOnACylinder) {
  for (const double sagitta : {0.1, 0.01}) {
    SCOPED_TRACE(sagitta);
    const auto part = recognised_mesh(testing::inspection_product(), sagitta);
    EXPECT_TRUE(part.unknown.empty()) << part.unknown.front().why;
    ASSERT_EQ(part.features.size(), 7U);
    const parts::Feature& hole = part.features[2];
    EXPECT_EQ(name_of(hole.kind), "blind_hole");
    EXPECT_TRUE(hole.is_round);
    EXPECT_LT((hole.own.min - Point(20, 75, -18)).norm(), 1e-4);
    EXPECT_LT((hole.own.max - Point(40, 95, 0)).norm(), 1e-4);
    EXPECT_GT(hole.facet_error_mm, 0.0);
    EXPECT_LT(hole.facet_error_mm, 1.01 * sagitta);
    EXPECT_EQ(name_of(part.features[4].kind), "blind_hole");
    EXPECT_EQ(part.features[0].facet_error_mm, 0.0);
  }
}

TEST(Meshes, OfASlotWithRoundEndsAndABoss) {
  // 60 x 20 with half round ends, and a pocket with a pin of 10 in it.
  const TopoDS_Shape slot =
      testing::cut(testing::block({{0, 0, -30}, {160, 110, 0}}),
                   {testing::block({{30, 20, -12}, {70, 40, 0}}),
                    testing::pin({30, 30, -12}, 20, 12), testing::pin({70, 30, -12}, 20, 12),
                    testing::cut(testing::block({{80, 50, -15}, {140, 100, 0}}),
                                 {testing::pin({105, 75, -15}, 10, 15)})});
  const auto part = recognised_mesh(slot, 0.02);
  ASSERT_TRUE(part.unknown.empty()) << part.unknown.front().why;
  ASSERT_EQ(part.features.size(), 3U);
  EXPECT_EQ(name_of(part.features[0].kind), "closed_pocket");
  EXPECT_LT((part.features[0].own.min - Point(20, 20, -12)).norm(), 1e-4);
  EXPECT_LT((part.features[0].own.max - Point(80, 40, 0)).norm(), 1e-4);
  EXPECT_NEAR(part.features[0].corner_radius_mm, 10.0, 1e-4);
  EXPECT_EQ(name_of(part.features[1].kind), "closed_pocket");
  EXPECT_EQ(name_of(part.features[2].kind), "boss");
  EXPECT_LT((part.features[2].own.min - Point(100, 70, -15)).norm(), 1e-4);
}

TEST(Meshes, ThatAreOpenAreRefused) {
  const testing::TemporaryFolder folder;
  const std::string stl = folder.write(
      "open.stl",
      "solid a\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
      "endfacet\nendsolid a\n");
  const auto removal = parts::removal_of(stl, {"", Point(10, 10, 10)});
  ASSERT_FALSE(removal.ok());
  EXPECT_NE(removal.error().find("not closed"), std::string::npos) << removal.error();
}

}  // namespace
}  // namespace g31::hostile_step_test

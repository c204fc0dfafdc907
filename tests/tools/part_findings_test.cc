// What a run says about the meshes of its parts.

#include <cstdint>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>
#include <gtest/gtest.h>

#include "parts/geometry/mesh.h"
#include "tests/probe/test_meshes.h"
#include "tests/support/run_program.h"
#include "tests/support/run_study.h"
#include "tools/cli/run_options.h"

namespace g31::part_findings_test {
namespace {

using testing::box_mesh;
using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;

std::string text_stl(const parts::Mesh& mesh) {
  std::string text = "solid box\n";
  for (const auto& triangle : mesh.triangles) {
    text += "facet normal 0 0 0\nouter loop\n";
    for (const std::uint32_t corner : triangle) {
      const Point& p = mesh.vertices[corner];
      text += fmt::format("vertex {} {} {}\n", p.x(), p.y(), p.z());
    }
    text += "endloop\nendfacet\n";
  }
  return text + "endsolid box\n";
}

/// A touch of the box of 10 mm from above: the top at Z10.
RunOutput run_on(const std::string& stl, const std::string& keys,
                 const std::vector<std::string>& allowed = {}) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("box.stl", stl));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nG91 G31 Z-100. F100.\n#1=#5063\nM30\n")};
  options.setups = {folder.write("sheet.toml",
                                 "[probe]\nlength = 100.0\n[machine]\nstopping = \"ideal\"\n"
                                 "[[part]]\nfile = \"box.stl\"\nat = [-4.0, -3.0, 0.0]\n" +
                                     keys + "[start]\nZ = 160.0\n")};
  options.allowed = allowed;
  options.prints = {"#5063"};
  return run_program(options);
}

parts::Mesh open_box() {
  parts::Mesh mesh = box_mesh({10, 10, 10});
  mesh.triangles.pop_back();
  return mesh;
}

TEST(PartFindings, ACarefulMeshHasNone) {
  const RunOutput output = run_on(text_stl(box_mesh({10, 10, 10})), "");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.errors, "");
  EXPECT_EQ(output.document["variables"]["#5063"], 113.0);
}

TEST(PartFindings, OfACarelessOneAreToldWithNumberAndPlace) {
  const std::string stl = text_stl(open_box());
  const RunOutput told = run_on(stl, "");
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_NE(
      told.errors.find(
          "sheet.toml:6:8: warning: open edges in the mesh of a part: 3 of 'box', first at X10 "
          "Y5 Z5 in its file [PRB511]"),
      std::string::npos)
      << told.errors;
  EXPECT_EQ(told.document["variables"]["#5063"], 113.0);
  EXPECT_EQ(told.document["diagnostics"].size(), 1U);
  const RunOutput allowed = run_on(stl, "", {"PRB511"});
  EXPECT_EQ(allowed.exit_code, 0);
  EXPECT_EQ(allowed.errors, "");
  const RunOutput by_intent = run_on(stl, "closed = false\n");
  EXPECT_EQ(by_intent.exit_code, 0);
  EXPECT_EQ(by_intent.errors, "");
}

TEST(PartFindings, FacetsWithoutAreaAreANote) {
  parts::Mesh mesh = box_mesh({10, 10, 10});
  mesh.triangles.push_back({0, 0, 1});
  const RunOutput output = run_on(text_stl(mesh), "");
  EXPECT_EQ(output.exit_code, 0);
  EXPECT_NE(output.errors.find("note: facets without area in the mesh of a part: 1 of 'box'"),
            std::string::npos)
      << output.errors;
}

std::string binary_stl(const parts::Mesh& mesh) {
  std::string stl(80, ' ');
  const auto count = static_cast<std::uint32_t>(mesh.triangles.size());
  stl.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (const auto& triangle : mesh.triangles) {
    stl.append(12, '\0');
    for (const std::uint32_t corner : triangle) {
      for (const double mm : mesh.vertices[corner]) {
        const auto rounded = static_cast<float>(mm);
        stl.append(reinterpret_cast<const char*>(&rounded), sizeof rounded);
      }
    }
    stl.append(2, '\0');
  }
  return stl;
}

/// float32 steps by 2^-9 mm from 16,384 mm on, so a coordinate is off by half of it: 0.98 um.
TEST(PartFindings, CoordinatesFarFromTheOriginOfTheirFileAreTold) {
  parts::Mesh mesh = box_mesh({10, 10, 10});
  EXPECT_EQ(run_on(binary_stl(mesh), "").errors, "");
  for (Point& vertex : mesh.vertices) {
    vertex.x() += 20'000.0;
  }
  const RunOutput told = run_on(binary_stl(mesh), "");
  EXPECT_EQ(told.exit_code, 1);
  EXPECT_NE(told.errors.find("the mesh of a part is far from the origin of its file: coordinates "
                             "of 'box' are off by up to 0.00098 mm [PRB520]"),
            std::string::npos)
      << told.errors;
  EXPECT_EQ(run_on(text_stl(mesh), "").errors.find("PRB520"), std::string::npos);
}

TEST(PartFindings, WhatIsNotJudgedIsANote) {
  // 4,600 tetrahedra side by side: each is asked about all, 20 million times in all; that is spent
  // with the 4,347th.
  std::string stl(80, ' ');
  constexpr std::uint32_t count = 4 * 4'600;
  stl.append(reinterpret_cast<const char*>(&count), sizeof count);
  for (std::uint32_t i = 0; i < count; ++i) {
    const float x = static_cast<float>(i / 4 % 300);
    const float y = static_cast<float>(i / 1200);
    const float corners[4][3] = {{x, y, 0}, {x + 0.5F, y, 0}, {x, y + 0.5F, 0}, {x, y, 0.5F}};
    constexpr int kFaces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    stl.append(12, '\0');
    for (const int corner : kFaces[i % 4]) {
      stl.append(reinterpret_cast<const char*>(corners[corner]), sizeof corners[corner]);
    }
    stl.append(2, '\0');
  }
  const RunOutput output = run_on(stl, "");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NE(output.errors.find("note: not all of the mesh of a part is judged: of 'box' 253 "
                               "pieces were not asked which of them are inside others"),
            std::string::npos)
      << output.errors;
}

TEST(PartFindings, LengthsAreThoseOfUnitAndScale) {
  const RunOutput output =
      run_on(text_stl(box_mesh({10, 10, 10})), "unit = \"inch\"\nscale = 0.1\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_NEAR(output.document["variables"]["#5063"].get<double>(), 100.0 + 3.0 + 25.4, 1e-9);
}

TEST(PartFindings, HalfAFileIsRefused) {
  const std::string stl = text_stl(box_mesh({10, 10, 10}));
  const RunOutput output = run_on(stl.substr(0, stl.size() / 2), "");
  EXPECT_EQ(output.exit_code, 5);
  EXPECT_EQ(output.document["status"], "setup");
  EXPECT_EQ(output.document["diagnostics"][0]["code"], "SET111");
  EXPECT_EQ(output.document["diagnostics"][0]["file"], "sheet.toml");
  EXPECT_EQ(output.document["diagnostics"][0]["line"], 6);
  EXPECT_NE(output.errors.find("it was cut off; a text STL ends with endsolid [SET111]"),
            std::string::npos)
      << output.errors;
}

/// The ball of 6 mm begins this far above the machine's zero, in the middle of a block of 40 mm.
RunOutput begin_at(double z, const std::string& keys, const std::string& block) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("box.stl", text_stl(box_mesh({40, 40, 40}))));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nG91 G00 X0.5\nM30\n")};
  options.setups = {folder.write(
      "sheet.toml",
      fmt::format("[probe]\nlength = 100.0\n{}[[part]]\n{}[start]\nX = 3.0\nZ = {:.4f}\n", keys,
                  block, 100.0 + z))};
  return run_program(options);
}

constexpr const char* kStandsInside = "the stylus ball stands inside a part at the start: in";

TEST(StartInside, IsToldWhateverTheStemDoes) {
  const std::string file = "file = \"box.stl\"\nat = [-20.0, -20.0, -40.0]\n";
  const std::string shape = "shape = \"block\"\nlength = 40.0\nwidth = 40.0\nheight = 40.0\n";
  for (const std::string& stem : {std::string("stem_diameter = 0.0\n"), std::string()}) {
    for (const std::string& block : {file, shape}) {
      const RunOutput inside = begin_at(-20.0, stem, block);
      EXPECT_NE(inside.exit_code, 0);
      EXPECT_NE(inside.errors.find(kStandsInside), std::string::npos) << inside.errors;
      EXPECT_NE(inside.errors.find("[PRB517]"), std::string::npos) << inside.errors;
      const RunOutput above = begin_at(3.01, stem, block);
      EXPECT_EQ(above.exit_code, 0) << above.errors;
      EXPECT_EQ(above.errors, "");
    }
  }
}

/// A mill cuts its way into a block, and the probe takes its place there.
RunOutput changed_in_a_block(const std::string& name, const std::string& program,
                             const std::string& start) {
  const TemporaryFolder folder;
  cli::RunOptions options;
  options.programs = {folder.write(name, program)};
  options.setups = {folder.write(
      "sheet.toml",
      start + "[probe]\nlength = 100.0\ntool = 1\nstem_diameter = 0.0\n[tools.1]\nlength = 100.0\n"
              "[tools.2]\nlength = 100.0\nradius = 5.0\n[[tool]]\nnumber = 2\nkind = \"mill\"\n"
              "length = 100.0\ndiameter = 10.0\n[[part]]\nname = \"block\"\nshape = \"block\"\n"
              "length = 40.0\nwidth = 40.0\nheight = 40.0\n[start]\nX = 3.0\nZ = 110.0\n")};
  return run_program(options);
}

TEST(StartInside, IsToldWhereTheProbeComesIntoTheSpindle) {
  constexpr const char* kTold =
      "the stylus ball stands inside a part as it comes into the spindle: in 'block' [PRB517]";
  const auto fanuc = [](int depth) {
    return changed_in_a_block("case.nc",
                              fmt::format("O1\nT2 M6\nG91 G1 Z-{}. F100\nT1 M6\nM30\n", depth), "");
  };
  const RunOutput inside = fanuc(30);
  EXPECT_EQ(inside.exit_code, 1);
  EXPECT_NE(inside.errors.find(kTold), std::string::npos) << inside.errors;
  EXPECT_NE(inside.errors.find("case.nc:4:1"), std::string::npos) << inside.errors;
  EXPECT_EQ(fanuc(5).errors.find("PRB517"), std::string::npos);
  const RunOutput sinumerik =
      changed_in_a_block("case.mpf", "T2 M6 D0\nG91 G1 Z-30 F100\nT1 M6 D0\nM30\n",
                         "[control]\nprofile = \"sinumerik-828d\"\n");
  EXPECT_EQ(sinumerik.exit_code, 1);
  EXPECT_NE(sinumerik.errors.find(kTold), std::string::npos) << sinumerik.errors;
}

TEST(StartInside, IsTheNoteOfEachRunOfAStudy) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("case.nc", "O1\n#101=1\nM30\n"));
  static_cast<void>(folder.write("sheet.toml",
                                 "[probe]\nlength = 100.0\n[[part]]\nshape = \"block\"\n"
                                 "length = 40.0\nwidth = 40.0\nheight = 40.0\n"));
  cli::StudyOptions options;
  options.study = folder.write("study.toml",
                               "[study]\nprogram = \"case.nc\"\nsetup = \"sheet.toml\"\n"
                               "[[vary]]\nkey = \"start.Z\"\nvalues = [80.0, 150.0]\n"
                               "[results.one]\nvalue = \"#101\"\n");
  const testing::StudyOutput output = testing::study_document(options);
  EXPECT_EQ(output.exit_code, 1) << output.errors;
  const auto rows = nlohmann::json::parse(output.out).at("rows");
  EXPECT_NE(rows.at(0).at("note").get<std::string>().find(
                "sheet.toml:4:9: warning: the stylus ball stands inside a part at the start"),
            std::string::npos)
      << rows.at(0);
  EXPECT_EQ(rows.at(0).at("exit"), 1);
  EXPECT_EQ(rows.at(1).at("exit"), 0);
  EXPECT_FALSE(rows.at(1).contains("note"));
}

TEST(StartInside, OfASurfaceThatIsNoSolidIsNothing) {
  const RunOutput output =
      begin_at(-20.0, "stem_diameter = 0.0\n",
               "file = \"box.stl\"\nat = [-20.0, -20.0, -40.0]\nclosed = false\n");
  EXPECT_EQ(output.exit_code, 0) << output.errors;
  EXPECT_EQ(output.errors, "");
}

TEST(StartInside, HangsOnNoSingleFacet) {
  const TemporaryFolder folder;
  static_cast<void>(folder.write("box.stl", text_stl(open_box())));
  cli::RunOptions options;
  options.programs = {folder.write("case.nc", "O1\nM30\n")};
  // 1 mm from the hole in the face at X10, in and out.
  for (const auto& [x, is_in] : {std::pair{"-1.0", true}, std::pair{"1.0", false}}) {
    options.setups = {folder.write(
        "sheet.toml", fmt::format("[probe]\nlength = 100.0\n[[part]]\nfile = \"box.stl\"\nat = "
                                  "[-10.0, -2.0, -2.0]\n[start]\nX = {}\nZ = 100.0\n",
                                  x))};
    EXPECT_EQ(run_program(options).errors.find(kStandsInside) != std::string::npos, is_in) << x;
  }
}

}  // namespace
}  // namespace g31::part_findings_test

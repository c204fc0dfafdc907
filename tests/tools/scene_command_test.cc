// The glTF scene of a run, read back the way a viewer reads it.

#include "tools/cli/scene_command.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cmath>
#include <cstdint>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include "machine/units/point.h"
#include "tests/support/run_program.h"
#include "tools/gltf/gltf_document.h"
#include "tools/picture/base64.h"

namespace g31::scene_command_test {
namespace {

using testing::run_program;
using testing::RunOutput;
using testing::TemporaryFolder;
using Json = nlohmann::json;

const char* const kRing = "parts/library/ring_gauge/ring.toml";
const char* const kMeasureRing = "parts/library/ring_gauge/measure_ring.nc";

std::string bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  bytes << file.rdbuf();
  return std::move(bytes).str();
}

std::uint32_t word_at(const std::string& bytes, std::size_t at) {
  std::uint32_t word = 0;
  for (std::size_t i = 0; i < 4; ++i) {
    word |= static_cast<std::uint32_t>(static_cast<unsigned char>(bytes.at(at + i))) << (8 * i);
  }
  return word;
}

/// A scene as a viewer has it: the JSON and the bytes it speaks of.
struct Glb {
  Json json;
  std::string buffer;
};

/// Reads the chunks of a .glb; every length must fit.
Glb parse_glb(const std::string& file) {
  Glb glb;
  EXPECT_EQ(file.substr(0, 4), "glTF");
  EXPECT_EQ(word_at(file, 4), 2U);
  EXPECT_EQ(word_at(file, 8), file.size());
  const std::size_t json_size = word_at(file, 12);
  EXPECT_EQ(file.substr(16, 4), "JSON");
  EXPECT_EQ(json_size % 4, 0U);
  glb.json = Json::parse(file.substr(20, json_size));
  const std::size_t binary = 20 + json_size;
  const std::size_t binary_size = word_at(file, binary);
  EXPECT_EQ(file.substr(binary + 4, 4), std::string("BIN\0", 4));
  EXPECT_EQ(binary_size % 4, 0U);
  EXPECT_EQ(binary + 8 + binary_size, file.size());
  const std::size_t stated = glb.json.at("buffers").at(0).at("byteLength");
  EXPECT_LE(stated, binary_size);
  EXPECT_GE(stated + 3, binary_size);
  glb.buffer = file.substr(binary + 8, stated);
  return glb;
}

/// The numbers of an accessor, each component one of them.
std::vector<double> numbers_of(const Glb& glb, std::size_t accessor_index) {
  const Json& accessor = glb.json.at("accessors").at(accessor_index);
  const Json& view = glb.json.at("bufferViews").at(accessor.at("bufferView").get<std::size_t>());
  const std::size_t offset = view.at("byteOffset");
  const bool is_vector = accessor.at("type") == "VEC3";
  const std::size_t count = accessor.at("count").get<std::size_t>() * (is_vector ? 3 : 1);
  EXPECT_EQ(view.at("byteLength"), 4 * count);
  EXPECT_EQ(offset % 4, 0U);
  EXPECT_LE(offset + 4 * count, glb.buffer.size());
  EXPECT_EQ(accessor.at("componentType"), is_vector ? 5126 : 5125);
  EXPECT_EQ(view.at("target"), is_vector ? 34962 : 34963);
  std::vector<double> numbers;
  for (std::size_t i = 0; i < count; ++i) {
    const std::uint32_t word = word_at(glb.buffer, offset + 4 * i);
    numbers.push_back(is_vector ? static_cast<double>(std::bit_cast<float>(word)) : word);
  }
  return numbers;
}

/// Every accessor fits its view, its bounds are those of its numbers, every index has a vertex.
void expect_valid(const Glb& glb) {
  EXPECT_EQ(glb.json.at("asset").at("version"), "2.0");
  for (std::size_t i = 0; i < glb.json.at("accessors").size(); ++i) {
    SCOPED_TRACE(i);
    const Json& accessor = glb.json.at("accessors").at(i);
    const std::vector<double> numbers = numbers_of(glb, i);
    if (accessor.at("type") != "VEC3") {
      continue;
    }
    for (std::size_t axis = 0; axis < 3; ++axis) {
      double low = numbers[axis];
      double high = low;
      for (std::size_t k = axis; k < numbers.size(); k += 3) {
        low = std::min(low, numbers[k]);
        high = std::max(high, numbers[k]);
      }
      EXPECT_EQ(accessor.at("min").at(axis).get<double>(), low);
      EXPECT_EQ(accessor.at("max").at(axis).get<double>(), high);
    }
  }
  for (const Json& mesh : glb.json.at("meshes")) {
    for (const Json& primitive : mesh.at("primitives")) {
      const std::size_t position = primitive.at("attributes").at("POSITION");
      const std::size_t vertices = glb.json.at("accessors").at(position).at("count");
      EXPECT_LT(primitive.at("material").get<std::size_t>(), glb.json.at("materials").size());
      if (primitive.at("mode") == 1) {
        EXPECT_EQ(vertices % 2, 0U) << "lines are pairs of points";
        continue;
      }
      for (const double index : numbers_of(glb, primitive.at("indices").get<std::size_t>())) {
        ASSERT_LT(index, static_cast<double>(vertices));
      }
    }
  }
}

const Json* node_named(const Glb& glb, const std::string& name) {
  for (const Json& node : glb.json.at("nodes")) {
    if (node.at("name") == name) {
      return &node;
    }
  }
  return nullptr;
}

Point point_of(const Json& list) {
  return {list.at(0).get<double>(), list.at(1).get<double>(), list.at(2).get<double>()};
}

Eigen::Quaterniond turn_of(const Json& node) {
  const Json& q = node.at("rotation");
  return {q.at(3).get<double>(), q.at(0).get<double>(), q.at(1).get<double>(),
          q.at(2).get<double>()};
}

struct SceneRun {
  int exit_code = -1;
  std::string file;
  std::string errors;
};

SceneRun scene_of(const std::string& program, const std::string& name,
                  const std::string& sheet = kRing) {
  TemporaryFolder folder;
  cli::SceneOptions options;
  options.run.programs = {program};
  options.run.setups = {sheet};
  options.output = folder.path(name);
  SceneRun run;
  ::testing::internal::CaptureStderr();
  run.exit_code = static_cast<int>(cli::scene_command(options));
  run.errors = ::testing::internal::GetCapturedStderr();
  run.file = bytes_of(options.output);
  return run;
}

TEST(SceneCommand, WritesAValidSceneWithTheSameBytesEachTime) {
  const SceneRun run = scene_of(kMeasureRing, "ring.glb");
  ASSERT_EQ(run.exit_code, 0) << run.errors;
  expect_valid(parse_glb(run.file));
  EXPECT_EQ(run.file, scene_of(kMeasureRing, "again.glb").file);
}

TEST(SceneCommand, TakesThePicturesOptionsForPicturesOnly) {
  const TemporaryFolder folder;
  for (const char* const name : {"ring.glb", "ring.gltf", "ring.svg"}) {
    SCOPED_TRACE(name);
    cli::SceneOptions options;
    options.run.programs = {kMeasureRing};
    options.run.setups = {kRing};
    options.output = folder.path(name);
    options.theme = "dark";
    ::testing::internal::CaptureStderr();
    const bool is_picture = options.output.ends_with(".svg");
    EXPECT_EQ(static_cast<int>(cli::scene_command(options)), is_picture ? 0 : 2);
    EXPECT_EQ(::testing::internal::GetCapturedStderr().find("--theme") == std::string::npos,
              is_picture);
    EXPECT_EQ(std::filesystem::exists(options.output), is_picture);
  }
}

TEST(SceneCommand, ContactsStandWhereTheTouchesWere) {
  const Glb glb = parse_glb(scene_of(kMeasureRing, "ring.glb").file);
  cli::RunOptions options;
  options.programs = {kMeasureRing};
  options.setups = {kRing};
  options.touches = true;
  const RunOutput output = run_program(options);
  std::size_t count = 0;
  std::size_t number = 0;
  for (const auto& touch : output.document.at("touches")) {
    ++number;
    if (touch.at("contact").is_null()) {
      continue;
    }
    ++count;
    const Json* const node = node_named(glb, "touch " + std::to_string(number) + ", ring");
    ASSERT_NE(node, nullptr);
    EXPECT_EQ(node->at("extras").at("touch"), number);
    EXPECT_EQ(point_of(node->at("translation")), point_of(touch.at("contact")));
    EXPECT_EQ(point_of(node->at("extras").at("normal")), point_of(touch.at("normal")));
    EXPECT_EQ(node->at("extras").at("part"), touch.at("part"));
    const Point whisker = turn_of(*node) * Point::UnitZ();
    EXPECT_NEAR((whisker - point_of(touch.at("normal"))).norm(), 0.0, 1e-12);
  }
  EXPECT_GE(count, 4U);
  EXPECT_EQ(node_named(glb, "contacts")->at("children").size(), count);
  EXPECT_EQ(node_named(glb, "collisions"), nullptr);
}

TEST(SceneCommand, ATableThatTurnsIsToldInTheFrameOfThePart) {
  const char* const sheet = "parts/library/kinematics_ball/kinematics_ball.toml";
  const char* const program = "parts/library/kinematics_ball/measure_kinematics.mpf";
  const Glb glb = parse_glb(scene_of(program, "five.glb", sheet).file);
  EXPECT_NE(node_named(glb, "coordinates of the part, mm"), nullptr);
  EXPECT_EQ(node_named(glb, "machine coordinates, mm"), nullptr);
  const std::string unit = glb.json.at("asset").at("extras").at("unit");
  EXPECT_NE(unit.find("'coordinates of the part, mm'"), std::string::npos) << unit;
  cli::RunOptions options;
  options.programs = {program};
  options.setups = {sheet};
  options.touches = true;
  const RunOutput output = run_program(options);
  const Json& touches = output.document.at("touches");
  std::size_t turned = 0;
  for (const std::size_t child : node_named(glb, "contacts")->at("children")) {
    const Json& extras = glb.json.at("nodes").at(child).at("extras");
    const Json& touch = touches.at(extras.at("touch").get<std::size_t>() - 1);
    const bool is_turned = extras.contains("machine_contact_mm");
    turned += is_turned ? 1 : 0;
    const char* const name = is_turned ? "machine_contact_mm" : "contact_mm";
    EXPECT_EQ(point_of(extras.at(name)), point_of(touch.at("contact")));
  }
  EXPECT_GT(turned, 0U);
}

TEST(SceneCommand, TheRootTurnsMillimetresAndZUpToMetresAndYUp) {
  const Glb glb = parse_glb(scene_of(kMeasureRing, "ring.glb").file);
  const std::size_t root_index = glb.json.at("scenes").at(0).at("nodes").at(0);
  const Json& root = glb.json.at("nodes").at(root_index);
  EXPECT_EQ(root.at("name"), "machine coordinates, mm");
  const Point scale = point_of(root.at("scale"));
  const auto in_gltf = [&](const Point& p_M) {
    return Point(turn_of(root) * scale.cwiseProduct(p_M));
  };
  EXPECT_NEAR((in_gltf({0, 0, 1000}) - Point(0, 1, 0)).norm(), 0.0, 1e-15) << "up";
  EXPECT_NEAR((in_gltf({1000, 0, 0}) - Point(1, 0, 0)).norm(), 0.0, 1e-15) << "to the right";
  EXPECT_NEAR((in_gltf({0, 1000, 0}) - Point(0, 0, -1)).norm(), 0.0, 1e-15) << "away";
  std::vector<std::string> groups;
  for (const std::size_t child : root.at("children")) {
    groups.push_back(glb.json.at("nodes").at(child).at("name"));
  }
  EXPECT_EQ(groups, (std::vector<std::string>{"parts", "path", "contacts", "stylus"}));
}

/// One rapid, one feed move, a quarter of an arc, a skip move; then into the wall.
constexpr const char* kMoves =
    "O1\nG59 G90 G00 X0 Y0\nG43 Z-5. H99\nG01 X5. F500.\nG03 X0 Y5. R5.\n"
    "G31 X-30. F100.\nG01 X0\nG00 Y60.\nM30\n";

TEST(SceneCommand, PathsAreSortedByKindAndCollisionsMarked) {
  TemporaryFolder folder;
  const SceneRun run = scene_of(folder.write("moves.nc", kMoves), "moves.glb");
  EXPECT_EQ(run.exit_code, 4) << run.errors;
  const Glb glb = parse_glb(run.file);
  expect_valid(glb);
  const auto line = [&](const char* kind) {
    const std::size_t mesh = node_named(glb, kind)->at("mesh");
    const Json& primitive = glb.json.at("meshes").at(mesh).at("primitives").at(0);
    EXPECT_EQ(primitive.at("mode"), 1);
    return numbers_of(glb, primitive.at("attributes").at("POSITION").get<std::size_t>());
  };
  // G59 is at (250, -180, -300); the line is that of the ball centre, 120 mm below the spindle.
  const std::vector<double> skip = line("skip");
  ASSERT_EQ(skip.size(), 6U);
  EXPECT_NEAR(skip[0], 250.0, 1e-4);
  EXPECT_NEAR(skip[1], -175.0, 1e-4);
  EXPECT_NEAR(skip[2], -305.0, 1e-4);
  EXPECT_LT(skip[3], 250.0 - 15.0);
  // Chords of a quarter circle, 5 mm about (250, -180).
  const std::vector<double> feed = line("feed");
  ASSERT_GE(feed.size() / 6, 1U + 18U + 1U);
  for (std::size_t i = 6; i + 6 < feed.size(); i += 3) {
    EXPECT_NEAR(std::hypot(feed[i] - 250.0, feed[i + 1] + 180.0), 5.0, 1e-4);
  }
  const Json* const crash = node_named(glb, "collision 1, ring");
  ASSERT_NE(crash, nullptr);
  EXPECT_EQ(crash->at("extras").at("what"), "stylus ball touches ring");
  EXPECT_NEAR(point_of(crash->at("translation")).y(), -180.0 + 19.998, 1e-3);
}

TEST(SceneCommand, TheStylusStandsAtTheLastTouchInTrueSize) {
  const Glb glb = parse_glb(scene_of(kMeasureRing, "ring.glb").file);
  const Json* const ball = node_named(glb, "stylus ball");
  ASSERT_NE(ball, nullptr);
  const std::size_t last = node_named(glb, "contacts")->at("children").back();
  const Json& touch = glb.json.at("nodes").at(last);
  EXPECT_EQ(ball->at("translation"), touch.at("extras").at("ball_mm"));
  // The sheet says 6 mm; the ring's wall is a radius away, but for how late the control latches.
  const Point gap = point_of(ball->at("translation")) - point_of(touch.at("translation"));
  EXPECT_NEAR(gap.norm(), 3.0, 0.02);
  const std::size_t mesh = ball->at("mesh");
  const std::vector<double> surface = numbers_of(
      glb, glb.json.at("meshes").at(mesh).at("primitives").at(0).at("attributes").at("POSITION"));
  for (std::size_t i = 0; i + 2 < surface.size(); i += 3) {
    EXPECT_NEAR(Point(surface[i], surface[i + 1], surface[i + 2]).norm(), 3.0, 1e-6);
  }
}

TEST(SceneCommand, PartsHaveTheirEdgesAndWaysAreTubes) {
  const Glb glb = parse_glb(scene_of(kMeasureRing, "ring.glb").file);
  const auto primitives = [&](const char* name) {
    const std::size_t mesh = node_named(glb, name)->at("mesh");
    return glb.json.at("meshes").at(mesh).at("primitives");
  };
  const Json ring = primitives("ring");
  ASSERT_EQ(ring.size(), 2U);
  EXPECT_TRUE(ring.at(0).at("attributes").contains("COLOR_0"));
  EXPECT_EQ(ring.at(1).at("mode"), 1);
  const Json skip = primitives("skip");
  ASSERT_EQ(skip.size(), 2U);
  const auto vertices = [&](const Json& primitive) {
    const std::size_t accessor = primitive.at("attributes").at("POSITION");
    return glb.json.at("accessors").at(accessor).at("count").get<std::size_t>();
  };
  EXPECT_EQ(skip.at(1).at("mode"), 4);
  EXPECT_EQ(vertices(skip.at(1)), 3 * vertices(skip.at(0))) << "a prism of three sides each";
}

TEST(SceneCommand, TheTextFormHoldsTheSameBuffer) {
  const Glb glb = parse_glb(scene_of(kMeasureRing, "ring.glb").file);
  const Json text = Json::parse(scene_of(kMeasureRing, "ring.gltf").file);
  const std::string uri = text.at("buffers").at(0).at("uri");
  EXPECT_EQ(uri, "data:application/octet-stream;base64," + picture::base64(glb.buffer));
  EXPECT_EQ(text.at("nodes"), glb.json.at("nodes"));
}

TEST(SceneCommand, RefusesWhatItCannotWrite) {
  EXPECT_EQ(scene_of(kMeasureRing, "ring.obj").exit_code, 2);
  EXPECT_EQ(scene_of(kMeasureRing, "RING.GLB").exit_code, 0);
  EXPECT_EQ(scene_of(kMeasureRing, "no/such/folder/ring.glb").exit_code, 2);
  EXPECT_EQ(scene_of("no_such_program.nc", "ring.glb").exit_code, 2);
}

TEST(GltfDocument, AnEmptyPictureHasNoEmptyLists) {
  const std::string file = gltf::gltf_document({}, {}, gltf::GltfForm::Binary);
  const Json json = Json::parse(file.substr(20));
  for (const char* list : {"meshes", "materials", "accessors", "bufferViews", "buffers"}) {
    EXPECT_FALSE(json.contains(list)) << list;
  }
  ASSERT_EQ(json.at("nodes").size(), 1U);
  EXPECT_FALSE(json.at("nodes")[0].contains("children"));
  EXPECT_EQ(word_at(file, 8), file.size());
}

TEST(Base64, MatchesTheExamplesOfItsStandard) {
  const std::array<std::array<const char*, 2>, 7> kExamples = {{{"", ""},
                                                                {"f", "Zg=="},
                                                                {"fo", "Zm8="},
                                                                {"foo", "Zm9v"},
                                                                {"foob", "Zm9vYg=="},
                                                                {"fooba", "Zm9vYmE="},
                                                                {"foobar", "Zm9vYmFy"}}};
  for (const auto& [bytes, text] : kExamples) {
    EXPECT_EQ(picture::base64(bytes), text);
  }
  EXPECT_EQ(picture::base64("\xff\xfe"), "//4=");
}

}  // namespace
}  // namespace g31::scene_command_test

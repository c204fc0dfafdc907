#include "tools/gltf/gltf_document.h"

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <string_view>
#include <vector>

#include <Eigen/Geometry>

#include "tools/gltf/gltf_buffer.h"
#include "tools/gltf/gltf_shapes.h"
#include "tools/picture/base64.h"
#include "tools/picture/feature_edges.h"

namespace g31::gltf {
namespace {

/// How the vertices of a primitive are joined, as glTF numbers it.
enum class Mode { Lines = 1, Triangles = 4 };

struct Colour {
  std::string_view name;
  std::array<double, 3> rgb;
};

constexpr Colour kPartColour = {"part", {0.78, 0.80, 0.84}};
constexpr Colour kFixtureColour = {"fixture", {0.50, 0.53, 0.58}};
constexpr Colour kEdgeColour = {"edge", {0.13, 0.15, 0.18}};
constexpr Colour kStylusColour = {"stylus", {0.45, 0.48, 0.52}};
constexpr Colour kBallColour = {"stylus ball", {0.62, 0.09, 0.14}};
constexpr std::array<Colour, picture::kPathKinds> kPathColours = {{
    {"rapid", {0.95, 0.60, 0.10}},
    {"feed", {0.10, 0.40, 0.90}},
    {"skip", {0.10, 0.65, 0.25}},
}};
constexpr Colour kContactColour = {"contact", {0.75, 0.10, 0.75}};
constexpr Colour kCollisionColour = {"collision", {0.90, 0.05, 0.05}};

constexpr double kMarkRadiusMm = 0.5;
constexpr double kWhiskerMm = 5.0;
constexpr double kTubeRadiusMm = 0.12;

Json array_of(const Point& p) {
  return {p.x(), p.y(), p.z()};
}

/// What turns +Z to the direction, as glTF writes it: x, y, z, w.
Json rotation_from_z(const Point& n) {
  // The shortest turn is not defined for the opposite direction; any half turn about X or Y is.
  constexpr double kNearlyOpposite = 1e-12;
  if (n.z() < kNearlyOpposite - 1.0) {
    return {1.0, 0.0, 0.0, 0.0};
  }
  Eigen::Vector4d q(-n.y(), n.x(), 0.0, 1.0 + n.z());
  q.normalize();
  return {q[0], q[1], q[2], q[3]};
}

class Document {
 public:
  Document(std::span<const picture::PicturedPart> parts, const Trace& trace)
      : frame_(trace.is_of_part ? "coordinates of the part, mm" : "machine coordinates, mm") {
    add_parts(parts);
    add_paths(trace);
    add_marks("contacts", trace.contacts, kContactColour);
    add_marks("collisions", trace.collisions, kCollisionColour);
    add_stylus(trace);
    Json machine = {{"name", frame_},
                    {"rotation", {-std::sqrt(0.5), 0.0, 0.0, std::sqrt(0.5)}},
                    {"scale", {0.001, 0.001, 0.001}}};
    if (!groups_.empty()) {  // glTF has no empty lists
      machine["children"] = groups_;
    }
    const std::size_t root = add_node(std::move(machine));
    scene_ = {{"name", "g31"}, {"nodes", Json::array({root})}};
  }

  [[nodiscard]] const std::string& bytes() const { return buffer_.bytes(); }

  /// @param uri  where the buffer is; none in a binary file
  [[nodiscard]] Json json(const std::optional<std::string>& uri) const {
    Json document = {{"asset",
                      {{"version", "2.0"},
                       {"generator", "g31"},
                       {"extras",
                        {{"schema", "g31.scene/1"},
                         {"unit", "metre; below the node '" + frame_ + "' millimetre"},
                         {"up", "+Y; below that node +Z"}}}}},
                     {"scene", 0},
                     {"scenes", Json::array({scene_})},
                     {"nodes", nodes_}};
    // glTF has no empty lists.
    if (!meshes_.empty()) {
      document["meshes"] = meshes_;
      document["materials"] = materials_;
      document["accessors"] = buffer_.accessors();
      document["bufferViews"] = buffer_.views();
      document["buffers"] = Json::array({Json({{"byteLength", buffer_.bytes().size()}})});
      if (uri) {
        document["buffers"][0]["uri"] = *uri;
      }
    }
    if (uses_unlit_) {
      document["extensionsUsed"] = Json::array({"KHR_materials_unlit"});
    }
    return document;
  }

 private:
  enum class Shading { Lit, Unlit };

  std::size_t add_node(Json node) {
    nodes_.push_back(std::move(node));
    return nodes_.size() - 1;
  }

  /// A node below the root that holds others; none where there are none.
  void add_group(std::string_view name, const std::vector<std::size_t>& children) {
    if (!children.empty()) {
      groups_.push_back(add_node({{"name", name}, {"children", children}}));
    }
  }

  std::size_t add_mesh(std::string_view name, const Json& primitives) {
    meshes_.push_back({{"name", name}, {"primitives", primitives}});
    return meshes_.size() - 1;
  }

  std::size_t add_material(const Colour& colour, Shading shading) {
    Json material = {{"name", colour.name},
                     {"pbrMetallicRoughness",
                      {{"baseColorFactor", {colour.rgb[0], colour.rgb[1], colour.rgb[2], 1.0}},
                       {"metallicFactor", 0.0},
                       {"roughnessFactor", 0.8}}},
                     {"doubleSided", true}};
    if (shading == Shading::Unlit) {
      material["extensions"] = {{"KHR_materials_unlit", Json::object()}};
      uses_unlit_ = true;
    }
    materials_.push_back(std::move(material));
    return materials_.size() - 1;
  }

  Json triangles_of(const parts::Mesh& mesh, std::size_t material) {
    const std::size_t positions = buffer_.add_points(mesh.vertices);
    return {{"attributes", {{"POSITION", positions}}},
            {"indices", buffer_.add_triangles(mesh.triangles)},
            {"material", material},
            {"mode", static_cast<int>(Mode::Triangles)}};
  }

  Json lines_of(std::span<const Point> segments, std::size_t material) {
    return {{"attributes", {{"POSITION", buffer_.add_points(segments)}}},
            {"material", material},
            {"mode", static_cast<int>(Mode::Lines)}};
  }

  void add_parts(std::span<const picture::PicturedPart> parts) {
    std::vector<std::size_t> nodes;
    std::array<std::optional<std::size_t>, 2> materials;  // of parts, of fixtures
    std::optional<std::size_t> edge_material;
    for (const picture::PicturedPart& part : parts) {
      if (part.mesh_M->triangles.empty()) {
        continue;
      }
      auto& material = materials[part.is_fixture ? 1 : 0];
      if (!material) {
        material = add_material(part.is_fixture ? kFixtureColour : kPartColour, Shading::Lit);
      }
      Json surface = triangles_of(*part.mesh_M, *material);
      surface["attributes"]["COLOR_0"] = buffer_.add_points(shades_by_height(*part.mesh_M));
      Json primitives = Json::array({surface});
      std::vector<Point> edges;
      for (const picture::Segment& edge : picture::feature_edges(*part.mesh_M)) {
        edges.insert(edges.end(), {edge.p_from, edge.p_to});
      }
      if (!edges.empty()) {
        if (!edge_material) {
          edge_material = add_material(kEdgeColour, Shading::Unlit);
        }
        primitives.push_back(lines_of(edges, *edge_material));
      }
      nodes.push_back(add_node({{"name", part.name},
                                {"mesh", add_mesh(part.name, primitives)},
                                {"extras", {{"fixture", part.is_fixture}}}}));
    }
    add_group("parts", nodes);
  }

  void add_paths(const Trace& trace) {
    std::vector<std::size_t> nodes;
    for (std::size_t kind = 0; kind < picture::kPathKinds; ++kind) {
      const auto segments = segments_of(trace.ways, static_cast<picture::PathKind>(kind));
      if (segments.empty()) {
        continue;
      }
      const Colour& colour = kPathColours[kind];
      const std::size_t material = add_material(colour, Shading::Unlit);
      const Json tubes = triangles_of(tubes_about(segments, kTubeRadiusMm), material);
      const std::size_t mesh =
          add_mesh(colour.name, Json::array({lines_of(segments, material), tubes}));
      nodes.push_back(add_node({{"name", colour.name}, {"mesh", mesh}}));
    }
    add_group("path", nodes);
  }

  void add_marks(std::string_view name, std::span<const picture::Mark> marks,
                 const Colour& colour) {
    if (marks.empty()) {
      return;
    }
    const std::size_t material = add_material(colour, Shading::Unlit);
    const std::array<Point, 2> whisker = {Point::Zero(), Point(0.0, 0.0, kWhiskerMm)};
    const Json ball = triangles_of(small_ball(kMarkRadiusMm), material);
    const Json tube = triangles_of(tubes_about(whisker, kTubeRadiusMm), material);
    const std::size_t mesh =
        add_mesh(colour.name, Json::array({ball, lines_of(whisker, material), tube}));
    std::vector<std::size_t> nodes;
    for (const picture::Mark& mark : marks) {
      Json extras = {{"part", mark.part},
                     {"normal", array_of(mark.n_M)},
                     {"contact_mm", array_of(mark.p_M)},
                     {"ball_mm", array_of(mark.stylus.p_M)}};
      if (mark.touch > 0) {
        extras["touch"] = mark.touch;
      }
      if (mark.p_machine) {
        extras["machine_contact_mm"] = array_of(*mark.p_machine);
      }
      if (!mark.what.empty()) {
        extras["what"] = mark.what;
      }
      nodes.push_back(add_node({{"name", name_of(mark, nodes.size() + 1)},
                                {"mesh", mesh},
                                {"translation", array_of(mark.p_M)},
                                {"rotation", rotation_from_z(mark.n_M)},
                                {"extras", std::move(extras)}}));
    }
    add_group(name, nodes);
  }

  /// "touch 3, ring": as the table of touches counts; "collision 1, ring".
  static std::string name_of(const picture::Mark& mark, std::size_t number) {
    const std::string name = mark.touch > 0 ? "touch " + std::to_string(mark.touch)
                                            : "collision " + std::to_string(number);
    return name + ", " + mark.part;
  }

  /// In true size, where it was at last.
  void add_stylus(const Trace& trace) {
    std::vector<std::size_t> nodes;
    std::array<std::optional<std::size_t>, 2> materials;  // of what holds, of balls
    for (const picture::StylusPiece& piece : trace.stylus) {
      auto& material = materials[piece.is_ball ? 1 : 0];
      if (!material) {
        material = add_material(piece.is_ball ? kBallColour : kStylusColour, Shading::Lit);
      }
      const Eigen::Vector4d turn = trace.stylus_place.turn.coeffs();
      nodes.push_back(add_node(
          {{"name", piece.name},
           {"mesh", add_mesh(piece.name, Json::array({triangles_of(piece.mesh_S, *material)}))},
           {"translation", array_of(trace.stylus_place.p_M)},
           {"rotation", {turn[0], turn[1], turn[2], turn[3]}}}));
    }
    add_group("stylus", nodes);
  }

  std::string frame_;  // of all below the root
  GltfBuffer buffer_;
  Json nodes_ = Json::array();
  Json meshes_ = Json::array();
  Json materials_ = Json::array();
  std::vector<std::size_t> groups_;
  Json scene_;
  bool uses_unlit_ = false;
};

std::string text_of(const Json& json) {
  return json.dump(-1, ' ', false, Json::error_handler_t::replace);
}

void append_word(std::string& bytes, std::size_t word) {
  for (unsigned shift = 0; shift < 32; shift += 8) {
    bytes.push_back(static_cast<char>(word >> shift & 0xFFU));
  }
}

void append_chunk(std::string& file, std::string_view kind, std::string chunk, char filling) {
  chunk.resize((chunk.size() + 3) / 4 * 4, filling);
  append_word(file, chunk.size());
  file += kind;
  file += chunk;
}

std::string binary_file(const Document& document) {
  std::string chunks;
  append_chunk(chunks, "JSON", text_of(document.json(std::nullopt)), ' ');
  if (!document.bytes().empty()) {
    append_chunk(chunks, std::string_view("BIN\0", 4), document.bytes(), '\0');
  }
  constexpr std::size_t kVersion = 2;
  constexpr std::size_t kHeaderBytes = 12;
  std::string file = "glTF";
  append_word(file, kVersion);
  append_word(file, kHeaderBytes + chunks.size());
  return file + chunks;
}

}  // namespace

std::string gltf_document(std::span<const picture::PicturedPart> parts, const Trace& trace,
                          GltfForm form) {
  const Document document(parts, trace);
  if (form == GltfForm::Binary) {
    return binary_file(document);
  }
  return text_of(document.json("data:application/octet-stream;base64," +
                               picture::base64(document.bytes()))) +
         "\n";
}

}  // namespace g31::gltf

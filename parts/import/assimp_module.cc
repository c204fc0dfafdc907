// The scene of a mesh file as triangles, in the module g31_assimp.

#include "parts/import/assimp_module.h"

#include <cstddef>
#include <cstdint>
#include <optional>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>
#include <fmt/format.h>

#include "parts/geometry/triangulate.h"
#include "parts/import/memory_file_system.h"
#include "parts/import/mesh_limits.h"
#include "parts/import/vertex_weld.h"

namespace g31::parts {
namespace {

/// Puts the meshes of a scene together; vertices at the same place become one.
class SceneReader {
 public:
  explicit SceneReader(const aiScene& scene) : scene_(scene) {}

  /// nullopt, or what is wrong with the scene.
  std::optional<std::string> read() { return read_node(*scene_.mRootNode, aiMatrix4x4(), 0); }

  [[nodiscard]] Mesh take_mesh() { return std::move(mesh_); }

 private:
  std::optional<std::string> read_node(const aiNode& node, const aiMatrix4x4& parent, int depth) {
    constexpr int kDeepest = 1000;
    if (depth > kDeepest) {
      return "its nodes are nested deeper than 1000 levels; a part needs one or two";
    }
    const aiMatrix4x4 placed = parent * node.mTransformation;
    for (unsigned int i = 0; i < node.mNumMeshes; ++i) {
      if (node.mMeshes[i] >= scene_.mNumMeshes) {
        return "a node refers to a mesh that is not in the file";
      }
      if (auto wrong = read_mesh(*scene_.mMeshes[node.mMeshes[i]], placed)) {
        return wrong;
      }
    }
    for (unsigned int i = 0; i < node.mNumChildren; ++i) {
      if (auto wrong = read_node(*node.mChildren[i], placed, depth + 1)) {
        return wrong;
      }
    }
    return std::nullopt;
  }

  std::optional<std::string> read_mesh(const aiMesh& part, const aiMatrix4x4& placed) {
    std::vector<std::uint32_t> joined(part.mNumVertices);
    for (unsigned int i = 0; i < part.mNumVertices; ++i) {
      const Point p = transformed(placed, part.mVertices[i]);
      if (!p.allFinite()) {
        return fmt::format("vertex {} is not a finite point; every coordinate must be a number",
                           i + 1);
      }
      joined[i] = weld_.vertex_at(p);
    }
    for (unsigned int i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      if (face.mNumIndices > kMostCorners) {
        return fmt::format("face {} has {} corners; {} are the most", i + 1, face.mNumIndices,
                           kMostCorners);
      }
      std::vector<std::uint32_t> polygon;
      for (unsigned int corner = 0; corner < face.mNumIndices; ++corner) {
        if (face.mIndices[corner] >= part.mNumVertices) {
          return fmt::format("face {} names vertex {}, but there are only {}", i + 1,
                             face.mIndices[corner], part.mNumVertices);
        }
        polygon.push_back(joined[face.mIndices[corner]]);
      }
      const auto triangles = triangulated(mesh_.vertices, polygon);
      mesh_.triangles.insert(mesh_.triangles.end(), triangles.begin(), triangles.end());
    }
    return std::nullopt;
  }

  /// In double, so that an offset in a node costs no digits of the shape.
  static Point transformed(const aiMatrix4x4& m, const aiVector3D& v) {
    const auto row = [&](ai_real x, ai_real y, ai_real z, ai_real shift) {
      return static_cast<double>(x) * static_cast<double>(v.x) +
             static_cast<double>(y) * static_cast<double>(v.y) +
             static_cast<double>(z) * static_cast<double>(v.z) + static_cast<double>(shift);
    };
    return {row(m.a1, m.a2, m.a3, m.a4), row(m.b1, m.b2, m.b3, m.b4), row(m.c1, m.c2, m.c3, m.c4)};
  }

  const aiScene& scene_;
  Mesh mesh_;
  VertexWeld weld_{mesh_};
};

/// @returns what is wrong with the file; "": nothing
std::string read_scene(const std::string& path, std::string bytes, Mesh& mesh) {
  Assimp::Importer importer;
  // The importer deletes the file system when it goes.
  importer.SetIOHandler(new MemoryFileSystem(path, std::move(bytes)));
  // No other step is asked for: assimp's triangulation aborts the process on some damaged polygons.
  const aiScene* scene = importer.ReadFile(path, aiProcess_ValidateDataStructure);
  if (scene == nullptr) {
    // What it says itself names its own loaders.
    return "not understood as a mesh; expected a whole STL, OBJ, PLY, OFF or 3MF file: "
           "export STEP or STL";
  }
  if (scene->mRootNode == nullptr) {
    return "it holds no mesh; expected at least one triangle";
  }
  SceneReader reader(*scene);
  const auto wrong = reader.read();
  mesh = reader.take_mesh();
  return wrong.value_or("");
}

}  // namespace
}  // namespace g31::parts

void g31_read_scene(const char* path, std::string* bytes, g31::parts::Mesh* mesh,
                    std::string* error) {
  *error = g31::parts::read_scene(path, std::move(*bytes), *mesh);
}

#include "parts/import/mesh_file.h"

#include <cmath>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <sstream>
#include <system_error>
#include <utility>
#include <vector>

#include <assimp/Importer.hpp>
#include <assimp/postprocess.h>
#include <assimp/scene.h>

#include "parts/geometry/triangulate.h"
#include "parts/import/memory_file_system.h"
#include "parts/import/step_file.h"
#include "parts/import/vertex_weld.h"

namespace g31::parts {
namespace {

std::string one_line(std::string text) {
  for (char& c : text) {
    if (c == '\n' || c == '\r' || c == '\t') {
      c = ' ';
    }
  }
  text.erase(text.find_last_not_of(' ') + 1);
  return text;
}

std::string complaint(const std::string& path, const std::string& what) {
  return "mesh file '" + path + "': " + one_line(what);
}

/// Puts the meshes of a scene together; vertices at the same place become one.
class SceneReader {
 public:
  explicit SceneReader(const aiScene& scene) : scene_(scene) {}

  /// nullopt, or what is wrong with the scene.
  std::optional<std::string> read() { return read_node(*scene_.mRootNode, aiMatrix4x4(), 0); }

  [[nodiscard]] const Mesh& mesh() const { return mesh_; }

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
        return "vertex " + std::to_string(i + 1) +
               " is not a finite point; every coordinate must be a number";
      }
      joined[i] = weld_.vertex_at(p);
    }
    for (unsigned int i = 0; i < part.mNumFaces; ++i) {
      const aiFace& face = part.mFaces[i];
      std::vector<std::uint32_t> polygon;
      for (unsigned int corner = 0; corner < face.mNumIndices; ++corner) {
        if (face.mIndices[corner] >= part.mNumVertices) {
          return "face " + std::to_string(i + 1) + " names vertex " +
                 std::to_string(face.mIndices[corner]) + ", but there are only " +
                 std::to_string(part.mNumVertices);
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

std::optional<std::string> why_unreadable(const std::string& path) {
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found) {
    return "there is no such file; a path is relative to the set-up sheet";
  }
  if (kind == std::filesystem::file_type::directory) {
    return "this is a folder; name an STL, OBJ, PLY, 3MF or STEP file in it";
  }
  return std::nullopt;
}

std::optional<std::string> bytes_of(const std::string& path) {
  std::ifstream file(path, std::ios::binary);
  std::ostringstream bytes;
  if (!file || (file.peek() != std::ifstream::traits_type::eof() && !(bytes << file.rdbuf()))) {
    return std::nullopt;
  }
  return std::move(bytes).str();
}

Result<Mesh, std::string> import_mesh(const std::string& path) {
  std::optional<std::string> bytes = bytes_of(path);
  if (!bytes) {
    return complaint(path, "it cannot be read; check who may read it");
  }
  if (bytes->empty()) {
    return complaint(path, "it is empty; expected a mesh with at least one triangle");
  }
  Assimp::Importer importer;
  // The importer deletes the file system when it goes.
  importer.SetIOHandler(new MemoryFileSystem(path, *std::move(bytes)));
  // No other step is asked for: assimp's triangulation aborts the process on some damaged polygons.
  const aiScene* scene = importer.ReadFile(path, aiProcess_ValidateDataStructure);
  if (scene == nullptr) {
    return complaint(path, "not understood as a mesh (" + std::string(importer.GetErrorString()) +
                               "); expected a whole STL, OBJ, PLY or 3MF file");
  }
  if (scene->mRootNode == nullptr) {
    return complaint(path, "it holds no mesh; expected at least one triangle");
  }
  SceneReader reader(*scene);
  if (const auto wrong = reader.read()) {
    return complaint(path, *wrong);
  }
  if (reader.mesh().triangles.empty()) {
    return complaint(path, "it holds no triangles; expected a surface, not lines or points");
  }
  return reader.mesh();
}

}  // namespace

Result<Mesh, std::string> read_mesh_file(const std::string& path, double step_sagitta_mm) {
  if (const auto why = why_unreadable(path)) {
    return complaint(path, *why);
  }
  try {
    if (is_step_file(path)) {
      auto mesh = read_step_file(path, step_sagitta_mm);
      return mesh ? mesh : complaint(path, mesh.error());
    }
    return import_mesh(path);
  } catch (const std::exception& error) {
    return complaint(path, "not understood as a mesh (" + std::string(error.what()) +
                               "); expected a whole STL, OBJ, PLY or 3MF file");
  } catch (...) {
    return complaint(path, "not understood as a mesh; expected a whole STL, OBJ, PLY or 3MF file");
  }
}

}  // namespace g31::parts

#include "parts/import/mesh_file.h"

#include <algorithm>
#include <cstddef>
#include <cstdint>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "machine/base/contract.h"
#include "machine/base/letters.h"
#include "parts/geometry/facet_normal.h"
#include "parts/import/assimp_file.h"
#include "parts/import/mesh_limits.h"
#include "parts/import/mesh_unit.h"
#include "parts/import/step_file.h"
#include "parts/import/stl_file.h"
#include "parts/import/three_mf_file.h"
#include "parts/import/whole_file.h"

namespace g31::parts {
namespace {

using Read = Result<Mesh, std::string>;

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
  return fmt::format("mesh file '{}': {}", path, one_line(what));
}

std::optional<std::string> why_unreadable(const std::string& path) {
  std::error_code error;
  const auto kind = std::filesystem::status(path, error).type();
  if (kind == std::filesystem::file_type::not_found) {
    return "there is no such file; in a set-up sheet a path is relative to the sheet";
  }
  if (kind == std::filesystem::file_type::directory) {
    return "this is a folder; name an STL, OBJ, PLY, OFF, 3MF or STEP file in it";
  }
  if (kind != std::filesystem::file_type::regular) {
    return kNoRegularFile;
  }
  return std::nullopt;
}

enum class MeshKind { Stl, Obj, Ply, Off, ThreeMf, Other };

/// In small letters.
std::string ending_of(const std::string& path) {
  return in_small_letters(std::filesystem::path(path).extension().string());
}

/// By the ending of its name; where that says nothing by its beginning.
MeshKind kind_of(const std::string& path, std::string_view beginning) {
  const std::string ending = ending_of(path);
  constexpr std::pair<std::string_view, MeshKind> kEndings[] = {
      {".stl", MeshKind::Stl}, {".obj", MeshKind::Obj},     {".ply", MeshKind::Ply},
      {".off", MeshKind::Off}, {".3mf", MeshKind::ThreeMf},
  };
  constexpr std::pair<std::string_view, MeshKind> kBeginnings[] = {
      {"solid", MeshKind::Stl}, {"ply", MeshKind::Ply}, {"OFF", MeshKind::Off}};
  for (const auto& [name, kind] : kEndings) {
    if (ending == name) {
      return kind;
    }
  }
  for (const auto& [word, kind] : kBeginnings) {
    if (beginning.starts_with(word)) {
      return kind;
    }
  }
  return MeshKind::Other;
}

struct CadFormat {
  std::string_view ending;
  std::string_view name;
};
constexpr CadFormat kCadFormats[] = {
#define CAD_FORMAT(ending, name) {ending, name},
#include "parts/import/cad_formats.def"
#undef CAD_FORMAT
};

/// What to do about a file of a CAD system that g31 does not read; nullopt: it is none.
std::optional<std::string> why_foreign(const std::string& path) {
  const std::string ending = ending_of(path);
  for (const CadFormat& format : kCadFormats) {
    if (ending == format.ending) {
      return fmt::format("this is a file of {}, which g31 does not read: export STEP or STL",
                         format.name);
    }
  }
  return std::nullopt;
}

/// Packed files whose size unpacked nobody can know before; g31 takes those of 3MF alone.
bool is_packed(std::string_view beginning) {
  constexpr std::string_view kPacked[] = {"\x1f\x8b", "PK\x03\x04", "BZh",
                                          "\xfd"
                                          "7zXZ",
                                          "\x28\xb5\x2f\xfd"};
  const bool is_packed_x = beginning.starts_with("xof ") &&
                           beginning.substr(0, 16).find("zip") != std::string_view::npos;
  return is_packed_x || std::ranges::any_of(kPacked, [&](std::string_view magic) {
           return beginning.starts_with(magic);
         });
}

double mm_of(std::string_view unit) {
  const auto* const row = std::ranges::find(kMeshUnits, unit, &MeshUnit::name);
  G31_EXPECTS(row != std::end(kMeshUnits));
  return row->mm;
}

/// What stands between a file and its mesh.
class FileReader {
 public:
  FileReader(const std::string& path, const MeshFileReading& how)
      : path_(path), how_(how), file_(path, std::ios::binary) {
    std::error_code error;
    size_ = std::filesystem::file_size(path, error);
    is_open_ = file_.good() && !error;
  }

  Read read() {
    constexpr std::size_t kBeginning = 84;
    if (!is_open_) {
      return std::string("it cannot be read; check who may read it");
    }
    if (size_ == 0) {
      return std::string("it is empty; expected a mesh with at least one triangle");
    }
    if (size_ > kMostMeshFileBytes) {
      return too_large(kMostMeshFileBytes);
    }
    std::string beginning(static_cast<std::size_t>(std::min<std::uint64_t>(size_, kBeginning)), 0);
    file_.read(beginning.data(), static_cast<std::streamsize>(beginning.size()));
    file_.seekg(0);
    if (auto foreign = why_foreign(path_)) {
      return *std::move(foreign);
    }
    const MeshKind kind = kind_of(path_, beginning);
    if (kind != MeshKind::ThreeMf && is_packed(beginning)) {
      return std::string("it is packed; unpack it first");
    }
    if (kind == MeshKind::Stl && is_binary_stl(beginning, size_)) {
      return read_binary_stl(file_, size_, how_.goes_on);
    }
    return read_whole(kind);
  }

  /// What the file that was read says; nullopt: it cannot say one.
  [[nodiscard]] std::optional<double> unit_mm() const { return unit_mm_; }

 private:
  Read read_whole(MeshKind kind) {
    const std::uint64_t most = kind == MeshKind::Stl ? kMostMeshFileBytes : kMostBytesReadWhole;
    if (size_ > most) {
      return too_large(most);
    }
    std::string bytes(static_cast<std::size_t>(size_), 0);
    if (!file_.read(bytes.data(), static_cast<std::streamsize>(bytes.size()))) {
      return std::string("it cannot be read to its end");
    }
    if (kind == MeshKind::Stl) {
      return read_text_stl(bytes, (how_.unit.empty() ? 1.0 : mm_of(how_.unit)) * how_.scale,
                           how_.goes_on);
    }
    if (auto wrong = why_not_whole(kind, bytes)) {
      return *std::move(wrong);
    }
    Steps(how_.goes_on).ask();
    return read_through_assimp(path_, std::move(bytes), how_.goes_on);
  }

  std::optional<std::string> why_not_whole(MeshKind kind, std::string_view bytes) {
    switch (kind) {
      case MeshKind::Obj:
        return why_no_whole_obj(bytes);
      case MeshKind::Ply:
        return why_no_whole_ply(bytes);
      case MeshKind::Off:
        return why_no_whole_off(bytes);
      case MeshKind::ThreeMf: {
        const auto unit = unit_of_3mf(bytes);
        if (!unit) {
          return unit.error();
        }
        unit_mm_ = unit.value();
        return std::nullopt;
      }
      case MeshKind::Stl:
      case MeshKind::Other:
        break;
    }
    return std::nullopt;
  }

  [[nodiscard]] std::string too_large(std::uint64_t most) const {
    return fmt::format("it has {} bytes; {} are the most", size_, most);
  }

  const std::string& path_;
  const MeshFileReading& how_;
  std::ifstream file_;
  std::uint64_t size_ = 0;
  bool is_open_ = false;
  std::optional<double> unit_mm_;
};

Read read_in_mm(const std::string& path, const MeshFileReading& how) {
  const bool is_step = is_step_file(path);
  FileReader reader(path, how);
  Read read = is_step ? read_step_file(path, how.step_sagitta_mm, how.goes_on) : reader.read();
  if (!read) {
    return read;
  }
  if (!how.unit.empty() && (is_step || reader.unit_mm())) {
    return std::string("it says its unit itself; leave out unit, or use scale to correct it");
  }
  const double unit_mm = how.unit.empty() ? reader.unit_mm().value_or(1.0) : mm_of(how.unit);
  if (unit_mm == 1.0 && how.scale == 1.0) {
    return read;
  }
  Mesh mesh = read.value();
  for (Point& vertex : mesh.vertices) {
    vertex *= unit_mm * how.scale;
  }
  mesh.rounding_mm *= unit_mm * how.scale;
  return mesh;
}

/// Of a mesh that has triangles and finite vertices.
std::optional<std::string> why_no_surface(const Mesh& mesh) {
  Eigen::AlignedBox3d box;
  for (const Point& p : mesh.vertices) {
    box.extend(p);
  }
  if (const double size = box.sizes().maxCoeff(); size < kSmallestMm) {
    return fmt::format("it is {} mm large; {} mm is the least: say its unit, or its scale", size,
                       kSmallestMm);
  }
  for (std::uint32_t t = 0; t < mesh.triangles.size(); ++t) {
    if (facet_normal(mesh, t)) {
      return std::nullopt;
    }
  }
  return "none of its triangles has an area; expected a surface";
}

/// What holds of a mesh from whatever file.
std::optional<std::string> why_unusable(const Mesh& mesh) {
  if (mesh.triangles.empty()) {
    return "it holds no triangles; expected a surface, not lines or points";
  }
  if (mesh.triangles.size() > kMostTriangles) {
    return fmt::format("it has {} triangles; {} are the most", mesh.triangles.size(),
                       kMostTriangles);
  }
  for (std::size_t i = 0; i < mesh.vertices.size(); ++i) {
    const Point& p = mesh.vertices[i];
    if (!p.allFinite()) {
      return fmt::format("vertex {} is not a finite point; every coordinate must be a number",
                         i + 1);
    }
    if (p.cwiseAbs().maxCoeff() > kFarthestMm) {
      return fmt::format("vertex {} is at {}, {}, {} mm; {} mm is the farthest", i + 1, p.x(),
                         p.y(), p.z(), kFarthestMm);
    }
  }
  return why_no_surface(mesh);
}

}  // namespace

Result<Mesh, std::string> read_mesh_file(const std::string& path, const MeshFileReading& how) {
  if (const auto why = why_unreadable(path)) {
    return complaint(path, *why);
  }
  try {
    Read mesh = read_in_mm(path, how);
    if (!mesh) {
      return complaint(path, mesh.error());
    }
    if (const auto wrong = why_unusable(mesh.value())) {
      return complaint(path, *wrong);
    }
    return mesh;
  } catch (const std::exception& error) {
    return complaint(path, fmt::format("not understood as a mesh ({}); expected a whole STL, OBJ, "
                                       "PLY, OFF or 3MF file",
                                       error.what()));
  } catch (const BrokenOff&) {
    throw;
  } catch (...) {
    return complaint(path,
                     "not understood as a mesh; expected a whole STL, OBJ, PLY, OFF or 3MF file");
  }
}

}  // namespace g31::parts

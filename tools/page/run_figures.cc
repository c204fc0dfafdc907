#include <algorithm>
#include <bit>
#include <cmath>
#include <cstring>

#include <nlohmann/json.hpp>

#include "parts/geometry/placement.h"
#include "tools/page/figure_pieces.h"
#include "tools/page/html.h"
#include "tools/page/run_parts.h"
#include "tools/picture/base64.h"
#include "tools/picture/thinned.h"

namespace g31::page {
namespace {

using Json = nlohmann::ordered_json;

// Of a part in a picture: what a screen shows, in a page that is sent by mail.
constexpr std::size_t kMostTriangles = 40'000;
constexpr double kMostErrorMm = 0.05;

/// Values as they lie in memory, least significant byte first, in base64.
template <typename Value>
std::string packed(const std::vector<Value>& values) {
  static_assert(std::endian::native == std::endian::little);
  std::string bytes(values.size() * sizeof(Value), '\0');
  std::memcpy(bytes.data(), values.data(), bytes.size());
  return picture::base64(bytes);
}

/// @param mesh  that stands for the part's own in the picture
Json part_json(const RunPage& run, const picture::PicturedPart& part, const parts::Mesh& mesh) {
  const auto sheet = std::ranges::find(run.job.parts, part.name, &parts::PartSetup::name);
  const bool is_named = sheet != run.job.parts.end();
  const Point p_M_origin = is_named ? sheet->p_M_at : Point(Point::Zero());
  std::vector<float> places;
  for (const Point& p : mesh.vertices) {
    const Point from_origin = p - p_M_origin;
    for (const double value : {from_origin.x(), from_origin.y(), from_origin.z()}) {
      places.push_back(static_cast<float>(value));
    }
  }
  std::vector<std::uint32_t> corners;
  for (const auto& triangle : mesh.triangles) {
    corners.insert(corners.end(), triangle.begin(), triangle.end());
  }
  Json figure = {{"name", part.name},
                 {"shape", is_named && !sheet->shape.empty() ? Json(sheet->shape) : Json()},
                 {"sizes", is_named ? Json(sheet->sizes) : Json::object()},
                 {"fixture", part.is_fixture},
                 {"origin", array_of(p_M_origin)},
                 {"positions", packed(places)},
                 {"triangles", packed(corners)}};
  if (is_named && !sheet->rotate_deg.isZero(0.0)) {
    figure["turn"] = array_of(
        Eigen::Quaterniond(parts::rotation_to_machine({Point::Zero(), sheet->rotate_deg})));
  }
  return figure;
}

/// Whether what carries the ball is turned nowhere on a way.
bool is_upright(const picture::Way& way) {
  return std::ranges::all_of(way.turns, [](const Eigen::Quaterniond& turn) {
    return turn.isApprox(Eigen::Quaterniond::Identity(), 1e-9);
  });
}

/// Ways belong to the moves by the times of their ends, which the same clock has told.
Json ways_json(const RunPage& run) {
  constexpr const char* kKinds[] = {"rapid", "feed", "skip"};
  const std::vector<double>& times = run.recorder.move_times();
  Json list = Json::array();
  std::size_t move = 0;
  for (const picture::Way& way : run.ways) {
    while (move < times.size() && times[move] < way.time_to_s) {
      ++move;
    }
    Json points = Json::array();
    for (const Point& p : way.points) {
      for (const double value : {p.x(), p.y(), p.z()}) {
        points.push_back(std::round(value * 1e6) / 1e6);
      }
    }
    list.push_back({{"move", move < times.size() ? Json(move) : Json(-1)},
                    {"kind", kKinds[static_cast<std::size_t>(way.kind)]},
                    {"time_s", {way.time_from_s, way.time_to_s}},
                    {"points", std::move(points)}});
    if (!is_upright(way)) {
      list.back()["turns"] = {array_of(way.turns[0]), array_of(way.turns[1])};
    }
  }
  return list;
}

/// A place of contact on the part as pictures have it, where that is not where the document has it.
Json contact_json(const Point& p_M, const Point& n_M,
                  const std::optional<machine::Contact>& in_document) {
  if (in_document && in_document->p_M_point == p_M && in_document->n_M == n_M) {
    return Json::object();
  }
  return {{"contact", array_of(p_M)}, {"normal", array_of(n_M)}};
}

Json touches_json(const RunPage& run, const Pictured& pictured, const Report& report) {
  const auto or_null = [](const std::optional<double>& value) {
    return value ? Json(*value) : Json();
  };
  Json list = Json::array();
  for (std::size_t i = 0; i < pictured.geometries.size(); ++i) {
    const TouchGeometry& geometry = pictured.geometries[i];
    const std::optional<Point> p_M_ball =
        geometry.touching ? geometry.touching->p_M : geometry.p_M_ball;
    list.push_back({{"ball", p_M_ball ? array_of(*p_M_ball) : Json()},
                    {"deviation", or_null(geometry.deviation_mm)},
                    {"angle", or_null(geometry.angle_deg)},
                    {"role", report.touches[i].caller}});
    if (geometry.touching) {
      list.back()["radius"] = geometry.touching->radius_mm;
    }
    if (geometry.p_M_contact) {
      list.back().update(
          contact_json(*geometry.p_M_contact, geometry.n_M, run.recorder.touches()[i].contact));
    }
    if (const auto& share = pictured.shares[i]) {
      list.back()["part_deviation"] = share->nominal_to_true_mm;
      if (share->limits_mm) {
        list.back()["limits"] = {share->limits_mm->lower, share->limits_mm->upper};
      }
    }
  }
  return list;
}

/// The place of the collision, as those of touches; null: there is none.
Json collision_json(const RunPage& run) {
  const auto& fault = run.recorder.fault();
  if (!fault || !fault->contact || run.collisions.empty()) {
    return {};
  }
  const picture::Mark& mark = run.collisions.back();
  return contact_json(mark.p_M, mark.n_M, fault->contact);
}

/// What the page calls the files of touches, moves, calls, counts and collision, in their order in
/// the document, which calls several alike; null: as it does.
Json names_json(const RunPage& run, const FileNames& names) {
  if (!names.has_namesakes()) {
    return {};
  }
  const auto name_at = [&](const source::Location& where) {
    return Json(names.at(run.sources.show(where)).file);
  };
  const auto each = [](const auto& list, const auto& name) {
    Json all = Json::array();
    for (const auto& one : list) {
      all.push_back(name(one));
    }
    return all;
  };
  const auto by_place = [&](const auto& event) { return name_at(event.where); };
  Json object = {{"touches", each(run.recorder.touches(), by_place)},
                 {"moves", each(run.recorder.moves(), by_place)}};
  object["calls"] = each(run.result.chronicle->calls(),
                         [&](const report::CallSpan& call) { return name_at(call.call); });
  object["counts"] = each(run.result.coverage,
                          [&](const coverage::FileCoverage& file) { return names.of(file.file); });
  object["collision"] = run.recorder.fault() ? name_at(run.recorder.fault()->where) : Json();
  return object;
}

/// The work coordinates that touches read in, where all of them have the same, not turned; else
/// those that the pictures are in.  A length that counts to the lowest point of the ball puts their
/// origin a radius off that of the work.
Json frame_json(const RunPage& run, const TouchGeometries& geometries, const Report& report) {
  constexpr double kSame = 1e-6;  // mm
  const Word name = run.is_of_part ? Word::PartCoordinates : Word::MachineCoordinates;
  const Json of_pictures = {{"name", text_of(name, report.language)}, {"origin", {0.0, 0.0, 0.0}}};
  std::optional<Point> origin;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    if (geometries[i].p_M_ball) {
      const Point from_here =
          *geometries[i].p_M_ball - linear_axes(run.recorder.touches()[i].view.q_L);
      if (origin && (*origin - from_here).norm() > kSame) {
        return of_pictures;
      }
      origin = from_here;
    }
  }
  return origin ? Json{{"name", text_of(Word::WorkReadings, report.language)},
                       {"origin", array_of(*origin)}}
                : of_pictures;
}

Json words_json(Language language) {
  Json words = Json::object();
  if (language == Language::Japanese) {
#define SCRIPT_WORD(key, japanese) words[key] = japanese;
#include "tools/page/words.def"
  }
  return words;
}

}  // namespace

PictureMeshes meshes_for_picture(const RunPage& run) {
  PictureMeshes meshes;
  for (const picture::PicturedPart& part : run.parts) {
    meshes.push_back(picture::thinned(*part.mesh_M, kMostTriangles, kMostErrorMm));
  }
  return meshes;
}

std::string figures_of(const RunPage& run, const Pictured& pictured, const Report& report) {
  const PictureMeshes& meshes = pictured.meshes;
  Json figures = Json::object();
  figures["parts"] = Json::array();
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (meshes[i]) {
      figures["parts"].push_back(part_json(run, run.parts[i], *meshes[i]));
    }
  }
  figures["probe"] = probe_json(run.job);
  figures["ways"] = ways_json(run);
  figures["track"] = track_json(run.track);
  figures["touch"] = touches_json(run, pictured, report);
  figures["collision"] = collision_json(run);
  figures["names"] = names_json(run, pictured.names);
  figures["frame"] = frame_json(run, pictured.geometries, report);
  figures["words"] = words_json(report.language);
  figures["language"] = name_of(report.language);
  figures["listing"] = Json::array();
  for (const Listing& listing : report.listings) {
    figures["listing"].push_back({{"file", listing.file}, {"text", listing.text}});
  }
  std::string text = figures.dump(-1, ' ', false, Json::error_handler_t::replace);
  // The other run is text already, and may be large.
  text.pop_back();
  return text + ",\"compare\":" + (run.other != nullptr ? run.other->figures : "null") + "}";
}

}  // namespace g31::page

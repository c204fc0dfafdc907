#include "tools/review/review_document.h"

#include <cmath>

#include <nlohmann/json.hpp>

namespace g31::review {
namespace {

using Json = nlohmann::ordered_json;

/// X, Y and Z; null where there is no end.
Json json_of(const Point& p) {
  Json list = Json::array();
  for (int i = 0; i < p.size(); ++i) {
    list.push_back(std::isfinite(p[i]) ? Json(p[i]) : Json(nullptr));
  }
  return list;
}

Json json_of(const source::Diagnostic& finding) {
  const source::ShownPlace& place = finding.in_sheet;
  Json row = {{"code", finding.code},
              {"level", source::name_of(finding.severity)},
              {"message", finding.message},
              {"remedy", finding.remedy}};
  row["file"] = place.file.empty() ? Json(nullptr) : Json(place.file);
  row["line"] = place.line > 0 ? Json(place.line) : Json(nullptr);
  row["column"] = place.column > 0 ? Json(place.column) : Json(nullptr);
  return row;
}

}  // namespace

std::string review_document(const Review& review) {
  Json document = {{"schema", "g31.setup/1"}, {"control", session::name_of(review.control)}};
  document["reach"] = {{"min", json_of(review.reach.p_M_min)},
                       {"max", json_of(review.reach.p_M_max)}};
  document["parts"] = Json::array();
  for (const PlacedPart& part : review.parts) {
    document["parts"].push_back({{"name", part.name},
                                 {"min", json_of(part.box.p_M_min)},
                                 {"max", json_of(part.box.p_M_max)}});
  }
  document["findings"] = Json::array();
  for (const source::Diagnostic& finding : review.findings) {
    document["findings"].push_back(json_of(finding));
  }
  return document.dump(2, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace g31::review

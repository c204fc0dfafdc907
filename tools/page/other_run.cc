#include "tools/page/other_run.h"

#include <optional>

#include <nlohmann/json.hpp>

#include "machine/base/json_nesting.h"
#include "tools/picture/tip.h"

namespace g31::page {
namespace {

using Json = nlohmann::ordered_json;

/// Three numbers, or none.
std::optional<Point> point_of(const Json& list) {
  if (!list.is_array() || list.size() < 3 || !list[0].is_number() || !list[1].is_number() ||
      !list[2].is_number()) {
    return std::nullopt;
  }
  return Point(list[0].get<double>(), list[1].get<double>(), list[2].get<double>());
}

const char* kind_of(int g) {
  constexpr int kSkip = 31;
  return g == 0 ? "rapid" : g == kSkip ? "skip" : "feed";
}

/// A straight way from each move's end to the next one's: what lies between the document does not
/// say.
Json ways_of(const Json& moves, const Point& p_tip) {
  Json ways = Json::array();
  std::optional<Point> from;
  double from_s = 0.0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto to = point_of(moves[i].value("to", Json()));
    const double to_s = moves[i].value("time_s", from_s);
    if (to && from && *to != *from) {
      const Point a = *from + p_tip;
      const Point b = *to + p_tip;
      ways.push_back({{"move", i},
                      {"kind", kind_of(moves[i].value("g", 0))},
                      {"time_s", {from_s, to_s}},
                      {"points", {a.x(), a.y(), a.z(), b.x(), b.y(), b.z()}}});
    }
    from = to ? to : from;
    from_s = to_s;
  }
  return ways;
}

Json touches_of(const Json& touches, const setup::Job& job, const Point& p_tip) {
  const double radius = job.probe ? job.probe->ball_diameter_mm / 2.0 : 0.0;
  Json list = Json::array();
  for (const Json& touch : touches) {
    const auto latched = point_of(touch.value("latched", Json()));
    const auto contact = point_of(touch.value("contact", Json()));
    const auto normal = point_of(touch.value("normal", Json()));
    Json figure = {{"ball", Json()}, {"deviation", Json()}, {"angle", Json()}, {"role", ""}};
    if (latched) {
      const Point ball = *latched + p_tip;
      figure["ball"] = {ball.x(), ball.y(), ball.z()};
      if (contact && normal && job.probe) {
        figure["deviation"] = -(ball - *contact - radius * *normal).dot(*normal);
      }
    }
    list.push_back(std::move(figure));
  }
  return list;
}

}  // namespace

Result<OtherRun, std::string> other_run(const std::string& document, const setup::Job& job) {
  const Json read = nests_too_deep(document) ? Json() : Json::parse(document, nullptr, false);
  if (!read.is_object() || read.value("schema", Json()) != "g31.run/1") {
    return std::string("it is no document g31.run/1, as g31 run --json writes it");
  }
  if (!read.contains("moves") || !read["moves"].is_array() || !read.contains("touches") ||
      !read["touches"].is_array()) {
    return std::string("it has no moves and touches: write it with --json FILE --moves --touches");
  }
  OtherRun other;
  const Json variables = read.value("variables", Json::object());
  for (const auto& [name, value] : variables.items()) {
    if (value.is_number()) {
      other.variables[name] = value.get<double>();
    }
  }
  const Point p_tip = picture::tip_of(job);
  try {
    const Json figures = {{"ways", ways_of(read["moves"], p_tip)},
                          {"touch", touches_of(read["touches"], job, p_tip)}};
    other.figures = Json{{"document", read}, {"figures", figures}}.dump(
        -1, ' ', false, Json::error_handler_t::replace);
  } catch (const Json::exception&) {
    return std::string("a move or a touch of it has a value of a wrong kind");
  }
  return other;
}

}  // namespace g31::page

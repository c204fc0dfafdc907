#include "tools/page/other_run.h"

#include <algorithm>
#include <optional>

#include <nlohmann/json.hpp>

#include "machine/base/json_nesting.h"
#include "machine/kinematics/axis_chain.h"
#include "tools/page/figure_pieces.h"
#include "tools/picture/on_part.h"
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

/// Where axes stand: X Y Z, and A B C behind them where they are not at 0.
std::optional<AxisPositions> axes_of(const Json& list) {
  const auto linear = point_of(list);
  if (!linear) {
    return std::nullopt;
  }
  AxisPositions q = AxisPositions::Zero();
  q.head<kLinearAxisCount>() = *linear;
  for (std::size_t axis = kLinearAxisCount; axis < std::min(list.size(), kAxisCount); ++axis) {
    q[static_cast<Eigen::Index>(axis)] = list[axis].get<double>();
  }
  return q;
}

/// Brings what a document tells of the machine to the frame of the part, which pictures are in.
class PartView {
 public:
  explicit PartView(const setup::Job& job)
      : p_tip_(picture::tip_of(job)), chain_(job.machine.chain, p_tip_) {}

  [[nodiscard]] Point ball_at(const AxisPositions& q_M) const {
    return linear_axes(chain_.for_part(q_M).q) + p_tip_;
  }
  [[nodiscard]] picture::SurfacePlace place_at(const AxisPositions& q_M, const Point& p_M,
                                               const Point& n_M) const {
    return picture::on_part(chain_, q_M, {p_M, n_M});
  }

 private:
  Point p_tip_;
  machine::AxisChain chain_;
};

const char* kind_of(int g) {
  constexpr int kSkip = 31;
  return g == 0 ? "rapid" : g == kSkip ? "skip" : "feed";
}

/// A straight way from each move's end to the next one's: what lies between the document does not
/// say.
Json ways_of(const Json& moves, const PartView& view) {
  Json ways = Json::array();
  std::optional<Point> from;
  double from_s = 0.0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const auto q_M = axes_of(moves[i].value("to", Json()));
    const std::optional<Point> to = q_M ? std::optional(view.ball_at(*q_M)) : std::nullopt;
    const double to_s = moves[i].value("time_s", from_s);
    if (to && from && *to != *from) {
      ways.push_back({{"move", i},
                      {"kind", kind_of(moves[i].value("g", 0))},
                      {"time_s", {from_s, to_s}},
                      {"points", {from->x(), from->y(), from->z(), to->x(), to->y(), to->z()}}});
    }
    from = to ? to : from;
    from_s = to_s;
  }
  return ways;
}

Json touch_of(const Json& touch, const setup::Job& job, const PartView& view) {
  const auto latched = axes_of(touch.value("latched", Json()));
  const auto contact = point_of(touch.value("contact", Json()));
  const auto normal = point_of(touch.value("normal", Json()));
  Json figure = {{"ball", Json()}, {"deviation", Json()}, {"angle", Json()}, {"role", ""}};
  if (!latched) {
    return figure;
  }
  const Point ball = view.ball_at(*latched);
  figure["ball"] = array_of(ball);
  if (contact && normal && job.probe) {
    const auto [p, n] = view.place_at(*latched, *contact, *normal);
    const double radius = job.probe->ball_diameter_mm / 2.0;
    figure["contact"] = array_of(p);
    figure["normal"] = array_of(n);
    figure["deviation"] = -(ball - p - radius * n).dot(n);
  }
  return figure;
}

Json touches_of(const Json& touches, const setup::Job& job, const PartView& view) {
  Json list = Json::array();
  for (const Json& touch : touches) {
    list.push_back(touch_of(touch, job, view));
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
  const PartView view(job);
  try {
    other.has_times = std::ranges::all_of(read["moves"],
                                          [](const Json& move) { return move.contains("time_s"); });
    const Json figures = {{"ways", ways_of(read["moves"], view)},
                          {"touch", touches_of(read["touches"], job, view)}};
    other.figures = Json{{"document", read}, {"figures", figures}}.dump(
        -1, ' ', false, Json::error_handler_t::replace);
  } catch (const Json::exception&) {
    return std::string("a move or a touch of it has a value of a wrong kind");
  }
  return other;
}

}  // namespace g31::page

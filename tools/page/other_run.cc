#include "tools/page/other_run.h"

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/base/json_nesting.h"
#include "machine/kinematics/axis_chain.h"
#include "tools/page/figure_pieces.h"
#include "tools/picture/on_part.h"
#include "tools/picture/tip.h"

namespace g31::page {
namespace {

using Json = nlohmann::ordered_json;

/// What has been read.  Its keys are found by halves: an object that tells of the lines of a long
/// program has a hundred thousand.
using Read = nlohmann::json;

/// Farther away nothing of a machine stands, mm.
constexpr double kFarthest_mm = 1e7;

/// Whether a value is a list of so many numbers that pictures can show.
bool are_numbers(const Read& list, std::size_t least, std::size_t most) {
  return list.is_array() && list.size() >= least && list.size() <= most &&
         std::ranges::all_of(list, [](const Read& value) {
           return value.is_number() && std::abs(value.get<double>()) <= kFarthest_mm;
         });
}

/// What a move or a touch says under a name; null: nothing.
Read member(const Read& object, const char* name) {
  return object.value(name, Read());
}

bool is_place(const Read& list) {
  return are_numbers(list, kLinearAxisCount, kAxisCount);
}

/// Three numbers, or none.
bool is_point_or_null(const Read& list) {
  return list.is_null() || are_numbers(list, kLinearAxisCount, kLinearAxisCount);
}

/// Which value of a move is none, by its name; nullopt: all are as g31 writes them.
std::optional<std::string> wrong_in_move(const Read& move) {
  if (!move.is_object()) {
    return "";
  }
  return !is_place(member(move, "to"))                            ? std::optional(".to")
         : !member(move, "g").is_number_integer()                 ? std::optional(".g")
         : move.contains("time_s") && !move["time_s"].is_number() ? std::optional(".time_s")
                                                                  : std::nullopt;
}

/// The same of a touch.
std::optional<std::string> wrong_in_touch(const Read& touch) {
  if (!touch.is_object()) {
    return "";
  }
  return !is_place(member(touch, "latched"))           ? std::optional(".latched")
         : !is_point_or_null(member(touch, "contact")) ? std::optional(".contact")
         : !is_point_or_null(member(touch, "normal"))  ? std::optional(".normal")
                                                       : std::nullopt;
}

/// The first value of a list that is of a wrong kind, by its place; nullopt: none is.
template <typename Wrong>
std::optional<std::string> wrong_in(const Read& document, const char* list, Wrong wrong) {
  const Read& values = document[list];
  for (std::size_t i = 0; i < values.size(); ++i) {
    if (const std::optional<std::string> name = wrong(values[i])) {
      return fmt::format("{}[{}]{} is of a wrong kind or beyond {:g}", list, i, *name,
                         kFarthest_mm);
    }
  }
  return std::nullopt;
}

/// The first three numbers of a list that has them.
Point point_of(const Read& list) {
  return {list[0].get<double>(), list[1].get<double>(), list[2].get<double>()};
}

/// Where axes stand: X Y Z, and A B C behind them where they are not at 0.
AxisPositions axes_of(const Read& list) {
  AxisPositions q = AxisPositions::Zero();
  for (std::size_t axis = 0; axis < list.size(); ++axis) {
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
Json ways_of(const Read& moves, const PartView& view) {
  Json ways = Json::array();
  std::optional<Point> from;
  double from_s = 0.0;
  for (std::size_t i = 0; i < moves.size(); ++i) {
    const Point to = view.ball_at(axes_of(moves[i]["to"]));
    const double to_s = moves[i].value("time_s", from_s);
    if (from && to != *from) {
      ways.push_back({{"move", i},
                      {"kind", kind_of(moves[i]["g"].get<int>())},
                      {"time_s", {from_s, to_s}},
                      {"points", {from->x(), from->y(), from->z(), to.x(), to.y(), to.z()}}});
    }
    from = to;
    from_s = to_s;
  }
  return ways;
}

Json touch_of(const Read& touch, const setup::Job& job, const PartView& view) {
  const AxisPositions q_M_latched = axes_of(touch["latched"]);
  const Point ball = view.ball_at(q_M_latched);
  Json figure = {{"ball", array_of(ball)}, {"deviation", Json()}, {"angle", Json()}, {"role", ""}};
  const Read contact = member(touch, "contact");
  const Read normal = member(touch, "normal");
  if (!contact.is_null() && !normal.is_null() && job.probe) {
    const auto [p, n] = view.place_at(q_M_latched, point_of(contact), point_of(normal));
    const double radius = job.probe->ball_diameter_mm / 2.0;
    figure["contact"] = array_of(p);
    figure["normal"] = array_of(n);
    figure["deviation"] = -(ball - p - radius * n).dot(n);
  }
  return figure;
}

Json touches_of(const Read& touches, const setup::Job& job, const PartView& view) {
  Json list = Json::array();
  for (const Read& touch : touches) {
    list.push_back(touch_of(touch, job, view));
  }
  return list;
}

}  // namespace

Result<OtherRun, std::string> other_run(const std::string& document, const setup::Job& job) {
  Read read = nests_too_deep(document) ? Read() : Read::parse(document, nullptr, false);
  if (!read.is_object() || read.value("schema", Read()) != "g31.run/1") {
    return std::string("it is no document g31.run/1, as g31 run --json writes it");
  }
  if (!read.contains("moves") || !read["moves"].is_array() || !read.contains("touches") ||
      !read["touches"].is_array()) {
    return std::string("it has no moves and touches: write it with --json FILE --moves --touches");
  }
  auto wrong = wrong_in(read, "moves", wrong_in_move);
  wrong = wrong ? wrong : wrong_in(read, "touches", wrong_in_touch);
  if (wrong) {
    return *std::move(wrong);
  }
  OtherRun other;
  read.erase("counts");  // of lines the page shows those of its own run alone
  const Read variables = member(read, "variables");
  for (const auto& [name, value] : variables.items()) {
    if (value.is_number()) {
      other.variables[name] = value.get<double>();
    }
  }
  const PartView view(job);
  other.has_times =
      std::ranges::all_of(read["moves"], [](const Read& move) { return move.contains("time_s"); });
  const Json figures = {{"ways", ways_of(read["moves"], view)},
                        {"touch", touches_of(read["touches"], job, view)}};
  other.figures = Json{{"document", read}, {"figures", figures}}.dump(
      -1, ' ', false, Json::error_handler_t::replace);
  return other;
}

}  // namespace g31::page

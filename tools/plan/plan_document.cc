#include "tools/plan/plan_document.h"

#include <algorithm>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "machine/units/rounded_length.h"
#include "tools/plan/judgement_document.h"

namespace g31::plan {
namespace {

using PlanDocument = nlohmann::ordered_json;
using parts::Side;

PlanDocument list_of(const Point& p) {
  return PlanDocument::array({rounded_length(p.x()), rounded_length(p.y()), rounded_length(p.z())});
}

PlanDocument feature_row(const PlannedPart& planned, std::size_t index) {
  const parts::Feature& feature = planned.part.features[index];
  PlanDocument open = PlanDocument::array();
  for (std::size_t side = 0; side < parts::kSides; ++side) {
    if (feature.open[side]) {
      open.push_back(name_of(static_cast<Side>(side)));
    }
  }
  const Point size = feature.own.max - feature.own.min;
  PlanDocument row{{"id", feature_id(index)},
                   {"kind", name_of(feature.kind)},
                   {"min", list_of(feature.box_P.min)},
                   {"max", list_of(feature.box_P.max)},
                   {"open", open},
                   {"sizes",
                    {{"X", rounded_length(size.x())},
                     {"Y", rounded_length(size.y())},
                     {"Z", rounded_length(size.z())}}}};
  if (feature.axes.angle_deg != 0.0) {
    row["angle_deg"] = feature.axes.angle_deg;
  }
  if (const probe::PlannedRound* const round = round_of(planned, index)) {
    row[round->by_points.empty() ? "cycle" : "by_points"] =
        round->by_points.empty() ? std::string(planned.cycle) : round->by_points;
  }
  return row;
}

PlanDocument measure_row(const PlannedPart& planned, std::size_t index) {
  const probe::PlannedMeasure& measure = planned.plan.measures[index];
  const PrintedMeasure& printed = planned.program.measures[index];
  const auto& points = planned.plan.points;
  const bool is_place = measure.what == probe::Characteristic::Place;
  PlanDocument row{
      {"id", measure.id},
      {"feature", feature_id(measure.feature)},
      {"axis", std::string(1, measure.axis)},
      {"what", is_place ? "place" : "size"},
      {"nominal", measure.nominal},
      {"tolerance", measure.tolerance
                        ? PlanDocument::array({measure.tolerance->lower, measure.tolerance->upper})
                        : PlanDocument(nullptr)},
      {"points", PlanDocument::array({points[measure.first].id, points[measure.second].id})},
      {"direction", list_of(measure.direction_P)},
      {"printed", printed.name},
      {"decimals", printed.decimals},
      {"variable", printed.variable}};
  if (is_place) {
    row["origin"] = rounded_length(measure.origin_mm);
  }
  return row;
}

PlanDocument point_row(const probe::PlannedPoint& point) {
  PlanDocument row{{"id", point.id},
                   {"at", list_of(point.at_P)},
                   {"normal", list_of(point.normal_P)},
                   {"start", list_of(point.start_P)}};
  if (!point.moved.empty()) {
    row["moved"] = point.moved;
  }
  return row;
}

PlanDocument not_measured(const PlannedPart& planned) {
  PlanDocument rows = PlanDocument::array();
  for (std::size_t i = 0; i < planned.part.unknown.size(); ++i) {
    const parts::UnknownVolume& unknown = planned.part.unknown[i];
    rows.push_back({{"id", feature_id(planned.part.features.size() + i)},
                    {"min", list_of(unknown.box_P.min)},
                    {"max", list_of(unknown.box_P.max)},
                    {"why", unknown.why}});
  }
  for (const probe::LeftOut& left : planned.plan.left_out) {
    rows.push_back({{"feature", feature_id(left.feature)},
                    {"axis", std::string(1, left.axis)},
                    {"why", left.why}});
  }
  return rows;
}

}  // namespace

const probe::PlannedRound* round_of(const PlannedPart& planned, std::size_t feature) {
  const auto& rounds = planned.plan.rounds;
  const auto found = std::ranges::find(rounds, feature, &probe::PlannedRound::feature);
  return found == rounds.end() ? nullptr : &*found;
}

std::string feature_id(std::size_t index) {
  return fmt::format("F{}", index + 1);
}

std::vector<Measure> measures_of(const PlannedPart& planned) {
  std::vector<Measure> measures;
  for (std::size_t i = 0; i < planned.plan.measures.size(); ++i) {
    const probe::PlannedMeasure& measure = planned.plan.measures[i];
    measures.push_back(
        {measure.id, planned.program.measures[i].name, measure.nominal, measure.tolerance});
  }
  return measures;
}

std::string plan_document(const PlannedPart& planned) {
  PlanDocument document{{"schema", "g31.plan/1"},
                        {"product", planned.product},
                        {"control", planned.control},
                        {"features", PlanDocument::array()},
                        {"measures", PlanDocument::array()},
                        {"points", PlanDocument::array()},
                        {"not_measured", not_measured(planned)},
                        {"proof",
                         {{"touches", planned.touches},
                          {"largest_deviation", rounded_length(planned.largest_deviation_mm)},
                          {"out_of_tolerance", PlanDocument::array()}}}};
  for (const JudgedMeasure& row : planned.on_product.measures) {
    if (row.verdict == Verdict::Bad) {
      document["proof"]["out_of_tolerance"].push_back(row.measure.id);
    }
  }
  for (std::size_t i = 0; i < planned.part.features.size(); ++i) {
    document["features"].push_back(feature_row(planned, i));
  }
  for (std::size_t i = 0; i < planned.plan.measures.size(); ++i) {
    document["measures"].push_back(measure_row(planned, i));
  }
  for (const probe::PlannedPoint& point : planned.plan.points) {
    document["points"].push_back(point_row(point));
  }
  if (planned.as_machined) {
    document["as_machined"] = PlanDocument::parse(judgement_document(*planned.as_machined));
  }
  constexpr int kIndent = 2;
  return document.dump(kIndent) + "\n";
}

}  // namespace g31::plan

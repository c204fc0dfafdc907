#include <fmt/format.h>

#include "probe/metrology/path_speed.h"
#include "tools/evaluate/charts.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/recorded_path.h"

namespace g31::evaluate {
namespace {

constexpr double kSecondsPerMinute = 60.0;

/// Speed in mm/min by time in s: the one curve that is no deviation.
Curve speed_over_time(const metrology::SpeedRecord& record) {
  Curve curve{"speed", {}};
  curve.points.reserve(record.t.size());
  for (std::size_t i = 0; i < record.t.size(); ++i) {
    curve.points.push_back({record.t[i], kSecondsPerMinute * record.speed[i]});
  }
  return curve;
}

}  // namespace

PathEvaluation evaluate_speed(const RecordedPath& path, const Request& request) {
  const metrology::PlaneSamples samples = path.samples();
  if (samples.size() < 3) {
    return std::string("speed needs at least three rows");
  }
  const metrology::SpeedRecord record = metrology::speed_of(samples);
  const auto speed = metrology::evaluate_speed(record);
  if (!speed) {
    return std::string("the path does not move");
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Speed;
  evaluation.samples = samples.size();
  evaluation.results = {{"speed_max", kSecondsPerMinute * speed->most, "mm/min"},
                        {"speed_min", kSecondsPerMinute * speed->least, "mm/min"},
                        {"speed_usual", kSecondsPerMinute * speed->usual, "mm/min"}};
  evaluation.dips.emplace();
  for (const metrology::SpeedDip& dip : speed->dips) {
    evaluation.dips->push_back({dip.time, kSecondsPerMinute * dip.speed, dip.width});
  }
  if (request.wants_curves || request.wants_drawing) {
    evaluation.curves = {speed_over_time(record)};
  }
  evaluation.notes.emplace_back(
      "speed_min is the least speed between the first and the last time that 90 percent of the "
      "usual speed is reached");
  if (record.interval > 1) {
    evaluation.notes.push_back(fmt::format(
        "the record is rough: speeds are taken over {} rows instead of one", record.interval));
  }
  if (request.wants_drawing) {
    plot::CurvePlot chart = chart_of(evaluation, request);
    chart.title = text_of(plot::Word::TitleSpeed, request.language);
    chart.x_label = text_of(plot::Word::TimeS, request.language);
    chart.y_label = text_of(plot::Word::SpeedMmMin, request.language);
    chart.traces = {{"", evaluation.curves.front().points, plot::CurveStyle::Line, 0}};
    chart.facts.push_back(
        said(request.language, plot::Word::Dips, fmt::arg("count", speed->dips.size())));
    chart.begins_at_zero = true;
    evaluation.svg = plot::draw(chart);
  }
  return evaluation;
}

}  // namespace g31::evaluate

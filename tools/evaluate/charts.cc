#include "tools/evaluate/charts.h"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include "tools/plot/scale.h"

namespace g31::evaluate {
namespace {

constexpr std::size_t kColours = 4;

std::string shown_unit(std::string_view unit) {
  return unit == "um" ? "µm" : unit == "um/m" ? "µm/m" : std::string(unit);
}

plot::CurveTrace trace_of(const Curve& curve) {
  plot::CurveTrace trace;
  trace.name = curve.name;
  trace.points.reserve(curve.points.size());
  for (const auto& [place, deviation] : curve.points) {
    trace.points.push_back({place, kUmPerMm * deviation});
  }
  return trace;
}

}  // namespace

std::vector<std::string> facts_of(const Evaluation& evaluation) {
  std::vector<std::string> facts;
  for (const Quantity& quantity : evaluation.results) {
    if (!quantity.value) {
      continue;
    }
    const int digits = quantity.unit == "mm" ? 8 : 4;
    std::string fact = fmt::format("{} {:.{}g} {}", quantity.name, *quantity.value + 0.0, digits,
                                   shown_unit(quantity.unit));
    if (quantity.u) {
      fact += fmt::format(" (u {:.2g})", *quantity.u);
    }
    facts.push_back(std::move(fact));
  }
  return facts;
}

std::vector<plot::CurveTrace> deviation_traces(const std::vector<Curve>& curves,
                                               plot::CurveStyle style) {
  std::vector<plot::CurveTrace> traces;
  for (const Curve& curve : curves) {
    plot::CurveTrace trace = trace_of(curve);
    trace.style = style;
    trace.colour = traces.size() % kColours;
    if (traces.size() >= kColours) {
      trace.name.clear();
    }
    traces.push_back(std::move(trace));
  }
  return traces;
}

std::string deviation_chart(const Evaluation& evaluation, const std::string& title,
                            const std::string& x_label) {
  plot::CurvePlot chart;
  chart.title = title;
  chart.x_label = x_label;
  chart.y_label = "deviation µm";
  chart.traces = deviation_traces(evaluation.curves, plot::CurveStyle::Marked);
  chart.facts = facts_of(evaluation);
  return plot::draw(chart);
}

std::string stacked_chart(const Evaluation& evaluation, const std::vector<double>& heights,
                          const std::string& title) {
  double largest = 0.0;
  for (const Curve& curve : evaluation.curves) {
    for (const auto& point : curve.points) {
      largest = std::max(largest, std::abs(point[1]));
    }
  }
  const auto [low, high] = std::ranges::minmax_element(heights);
  const double spacing =
      heights.size() > 1 ? (*high - *low) / static_cast<double>(heights.size() - 1) : 1.0;
  // Neighbours may just touch.
  const double enlarged = largest > 0.0 ? plot::round_down(std::max(spacing, 1e-9) / largest) : 1.0;
  plot::CurvePlot chart;
  chart.title = title;
  chart.x_label = "place along the work mm";
  chart.y_label = "theta deg";
  for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
    plot::CurveTrace line{"", {}, plot::CurveStyle::Line, 0};
    plot::CurveTrace base{"", {}, plot::CurveStyle::Dashed, 3};
    for (const auto& [place, deviation] : evaluation.curves[i].points) {
      line.points.push_back({place, heights[i] + enlarged * deviation});
      base.points.push_back({place, heights[i]});
    }
    chart.traces.push_back(std::move(base));
    chart.traces.push_back(std::move(line));
  }
  chart.facts = facts_of(evaluation);
  chart.facts.push_back(fmt::format("10 µm of radius are drawn as {:.3g} deg", 0.010 * enlarged));
  return plot::draw(chart);
}

std::string positioning_chart(const Evaluation& evaluation, const std::string& axis) {
  plot::CurvePlot chart;
  chart.title = fmt::format("Positioning of axis {}", axis);
  chart.x_label = "target mm";
  chart.y_label = "deviation µm";
  constexpr const char* kNames[] = {"mean, up",   "mean + 2 s, mean - 2 s, up",   "",
                                    "mean, down", "mean + 2 s, mean - 2 s, down", ""};
  for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
    plot::CurveTrace trace = trace_of(evaluation.curves[i]);
    trace.name = evaluation.curves[i].points.empty() ? "" : kNames[i];
    trace.style = i % 3 == 0 ? plot::CurveStyle::Marked : plot::CurveStyle::Dashed;
    trace.colour = i / 3;
    chart.traces.push_back(std::move(trace));
  }
  chart.facts = facts_of(evaluation);
  return plot::draw(chart);
}

}  // namespace g31::evaluate

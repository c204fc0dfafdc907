#include "tools/evaluate/charts.h"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <iterator>
#include <optional>
#include <string_view>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "tools/plot/scale.h"

namespace g31::evaluate {
namespace {

constexpr std::size_t kColours = 4;
/// Curves that can be told apart: the second four are dashed.
constexpr std::size_t kNamed = 2 * kColours;

std::string shown_unit(std::string_view unit) {
  return unit == "um" ? "µm" : unit == "um/m" ? "µm/m" : std::string(unit);
}

/// Its value to the second digit of its uncertainty.
std::string value_of(const Quantity& quantity) {
  const double value = *quantity.value + 0.0;
  if (const auto decimals = decimals_by_u(quantity)) {
    const std::string text = fmt::format("{:.{}f}", value, *decimals);
    return text.find_first_of("123456789") == std::string::npos ? "0" : text;
  }
  return fmt::format("{:.{}g}", value, quantity.unit == "mm" ? 8 : 4);
}

std::string fact_of(const Quantity& quantity) {
  std::string fact =
      fmt::format("{} {} {}", quantity.name, value_of(quantity), shown_unit(quantity.unit));
  if (quantity.u) {
    fact += fmt::format(" (u {:.2g})", *quantity.u);
  }
  return fact;
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

/// What a legend calls a curve: others are letters and numbers, the same everywhere.
std::string legend_name(const std::string& curve, plot::Language language) {
  constexpr std::pair<std::string_view, plot::Word> kNames[] = {
      {"motion", plot::Word::Motion}, {"work", plot::Word::Work}, {"across", plot::Word::Across}};
  const auto* const known =
      std::ranges::find(kNames, curve, &std::pair<std::string_view, plot::Word>::first);
  if (known != std::end(kNames)) {
    return std::string(text_of(known->second, language));
  }
  constexpr std::string_view kLine = "y_";
  double y = 0.0;
  if (curve.starts_with(kLine) &&
      std::from_chars(curve.data() + kLine.size(), curve.data() + curve.size(), y).ec ==
          std::errc()) {
    return fmt::format("y = {} mm", std::round(y * kUmPerMm) / kUmPerMm + 0.0);
  }
  return curve;
}

}  // namespace

plot::CurvePlot chart_of(const Evaluation& evaluation, const Request& request) {
  plot::CurvePlot chart;
  chart.language = request.language;
  chart.growth = request.growth;
  chart.facts = facts_of(evaluation);
  return chart;
}

std::vector<std::string> facts_of(const Evaluation& evaluation) {
  std::vector<std::string> facts;
  for (const Quantity& quantity : evaluation.results) {
    if (quantity.value) {
      facts.push_back(fact_of(quantity));
    }
  }
  return facts;
}

std::vector<plot::CurveTrace> deviation_traces(const std::vector<Curve>& curves,
                                               const Request& request) {
  std::vector<plot::CurveTrace> traces;
  traces.reserve(curves.size());
  for (const Curve& curve : curves) {
    if (request.growth) {
      request.growth(0);
    }
    plot::CurveTrace trace = trace_of(curve);
    const bool is_second_row = traces.size() / kColours % 2 != 0;
    trace.style = is_second_row ? plot::CurveStyle::DashedMarked : plot::CurveStyle::Marked;
    trace.colour = traces.size() % kColours;
    trace.name = traces.size() < kNamed ? legend_name(curve.name, request.language) : std::string();
    traces.push_back(std::move(trace));
  }
  return traces;
}

std::string deviation_chart(const Evaluation& evaluation, const ChartWords& words,
                            const Request& request) {
  const plot::Language language = request.language;
  plot::CurvePlot chart = chart_of(evaluation, request);
  chart.title = text_of(words.title, language);
  chart.x_label = text_of(words.x_label, language);
  chart.y_label = text_of(plot::Word::DeviationUm, language);
  chart.traces = deviation_traces(evaluation.curves, request);
  if (chart.traces.size() > kNamed) {
    chart.facts.push_back(said(language, plot::Word::LinesWithoutName,
                               fmt::arg("count", chart.traces.size() - kNamed)));
  }
  return plot::draw(chart);
}

std::string deviation_map(const Evaluation& evaluation, const std::vector<MapPoint>& points,
                          const Request& request) {
  constexpr double kLeast = 1.5;    // px, radius of a point that does not deviate
  constexpr double kLargest = 9.0;  // px
  const plot::Language language = request.language;
  double largest = 0.0;
  for (const MapPoint& point : points) {
    largest = std::max(largest, std::abs(point.deviation));
  }
  plot::CurvePlot chart = chart_of(evaluation, request);
  chart.title = text_of(plot::Word::TitleFlatnessMap, language);
  chart.x_label = text_of(plot::Word::PlaceX, language);
  chart.y_label = text_of(plot::Word::PlaceY, language);
  chart.has_equal_scales = true;
  chart.traces = {
      {std::string(text_of(plot::Word::AbovePlane, language)), {}, plot::CurveStyle::Dots, 0},
      {std::string(text_of(plot::Word::BelowPlane, language)), {}, plot::CurveStyle::Dots, 1}};
  for (const MapPoint& point : points) {
    plot::CurveTrace& trace = chart.traces[point.deviation < 0.0 ? 1 : 0];
    const double share = largest > 0.0 ? std::abs(point.deviation) / largest : 0.0;
    trace.points.push_back({point.x, point.y});
    trace.radii.push_back(std::max(kLeast, kLargest * std::sqrt(share)));
  }
  chart.facts.push_back(said(language, plot::Word::LargestDot,
                             fmt::arg("amount", fmt::format("{:.3g}", kUmPerMm * largest))));
  std::size_t drawn = 0;
  for (const plot::CurveTrace& trace : chart.traces) {
    drawn += plot::shown_points(trace.radii).size();
  }
  if (drawn < points.size()) {
    chart.facts.push_back(said(language, plot::Word::DotsDrawn, fmt::arg("drawn", drawn),
                               fmt::arg("all", points.size())));
  }
  return plot::draw(chart);
}

std::string stacked_chart(const Evaluation& evaluation, const std::vector<double>& heights,
                          const ChartWords& words, const Request& request) {
  const plot::Language language = request.language;
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
  plot::CurvePlot chart = chart_of(evaluation, request);
  chart.title = text_of(words.title, language);
  chart.x_label = text_of(words.x_label, language);
  chart.y_label = text_of(plot::Word::ThetaDeg, language);
  for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
    plot::CurveTrace line{"", {}, plot::CurveStyle::Line, 0};
    plot::CurveTrace base{"", {}, plot::CurveStyle::Dashed, 3};
    if (i == 0) {
      line.name = text_of(plot::Word::Radius, language);
      base.name = text_of(plot::Word::ItsAngle, language);
    }
    for (const auto& [place, deviation] : evaluation.curves[i].points) {
      line.points.push_back({place, heights[i] + enlarged * deviation});
      base.points.push_back({place, heights[i]});
    }
    chart.traces.push_back(std::move(base));
    chart.traces.push_back(std::move(line));
  }
  chart.facts.push_back(said(language, plot::Word::DrawnAs,
                             fmt::arg("angle", fmt::format("{:.3g}", 0.010 * enlarged))));
  return plot::draw(chart);
}

std::string positioning_chart(const Evaluation& evaluation, const std::string& axis,
                              const Request& request) {
  const plot::Language language = request.language;
  plot::CurvePlot chart = chart_of(evaluation, request);
  chart.title = said(language, plot::Word::TitlePositioning, fmt::arg("axis", axis));
  chart.x_label = text_of(plot::Word::TargetMm, language);
  chart.y_label = text_of(plot::Word::DeviationUm, language);
  // Of each direction the mean and the two limits about it, which share a name.
  constexpr std::optional<plot::Word> kNames[] = {plot::Word::MeanUp,     plot::Word::SpreadUp,
                                                  std::nullopt,           plot::Word::MeanDown,
                                                  plot::Word::SpreadDown, std::nullopt};
  for (std::size_t i = 0; i < evaluation.curves.size(); ++i) {
    plot::CurveTrace trace = trace_of(evaluation.curves[i]);
    const bool is_named = kNames[i] && !evaluation.curves[i].points.empty();
    trace.name = is_named ? text_of(*kNames[i], language) : std::string_view();
    trace.style = i % 3 == 0 ? plot::CurveStyle::Marked : plot::CurveStyle::Dashed;
    trace.colour = i / 3;
    chart.traces.push_back(std::move(trace));
  }
  return plot::draw(chart);
}

}  // namespace g31::evaluate

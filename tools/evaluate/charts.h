#pragma once

#include <string>
#include <vector>

#include "tools/evaluate/evaluate.h"
#include "tools/evaluate/evaluation.h"
#include "tools/plot/curve_plot.h"
#include "tools/plot/words.h"

namespace g31::evaluate {

/// The results as lines beside a drawing.
std::vector<std::string> facts_of(const Evaluation& evaluation);

/// What a drawing is called, and what its numbers to the right are.
struct ChartWords {
  plot::Word title;
  plot::Word x_label;
};

/// Curves of deviations in mm as traces in um over places in mm, in the colours' order: the second
/// four are dashed, further ones have no name; points of all are marked.
std::vector<plot::CurveTrace> deviation_traces(const std::vector<Curve>& curves,
                                               const Request& request);

/// A chart as a request has it, with the results beside it.
plot::CurvePlot chart_of(const Evaluation& evaluation, const Request& request);

/// The drawing of an evaluation whose curves are deviations over a way.
std::string deviation_chart(const Evaluation& evaluation, const ChartWords& words,
                            const Request& request);

/// A point seen from above, and how far it is above a plane, mm.
struct MapPoint {
  double x = 0.0;
  double y = 0.0;
  double deviation = 0.0;
};

/// Points seen from above as dots, the area of each as large as its deviation.
std::string deviation_map(const Evaluation& evaluation, const std::vector<MapPoint>& points,
                          const Request& request);

/// Curves one above the other, each at its height, their deviations enlarged: a work unrolled.
std::string stacked_chart(const Evaluation& evaluation, const std::vector<double>& heights,
                          const ChartWords& words, const Request& request);

/// ISO 230-2: means of both directions with two standard deviations beside them.
std::string positioning_chart(const Evaluation& evaluation, const std::string& axis,
                              const Request& request);

}  // namespace g31::evaluate

#pragma once

#include <string>
#include <vector>

#include "tools/evaluate/evaluation.h"
#include "tools/plot/curve_plot.h"

namespace g31::evaluate {

/// The results as lines beside a drawing.
std::vector<std::string> facts_of(const Evaluation& evaluation);

/// Curves of deviations in mm as traces in um over places in mm, in the colours' order; names of
/// the first four.
std::vector<plot::CurveTrace> deviation_traces(const std::vector<Curve>& curves,
                                               plot::CurveStyle style);

/// The drawing of an evaluation whose curves are deviations over a way.
std::string deviation_chart(const Evaluation& evaluation, const std::string& title,
                            const std::string& x_label);

/// Curves one above the other, each at its height, their deviations enlarged: a work unrolled.
std::string stacked_chart(const Evaluation& evaluation, const std::vector<double>& heights,
                          const std::string& title);

/// ISO 230-2: means of both directions with two standard deviations beside them.
std::string positioning_chart(const Evaluation& evaluation, const std::string& axis);

}  // namespace g31::evaluate

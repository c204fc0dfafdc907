#include "tools/plan/plan_summary.h"

#include <algorithm>
#include <iterator>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/source/printable.h"
#include "tools/plan/judgement_document.h"

namespace g31::plan {
namespace {

std::string box_text(const parts::Box& box) {
  constexpr std::string_view kAxes = "XYZ";
  std::string text;
  for (int axis = 0; axis < 3; ++axis) {
    const std::string range = fmt::format("{:g}..{:g}", box.min[axis], box.max[axis]);
    text += fmt::format("  {} {:<15}", kAxes[static_cast<std::size_t>(axis)], range);
  }
  return text;
}

std::string sizes_of(const PlannedPart& planned, std::size_t feature) {
  std::string text;
  for (const probe::PlannedMeasure& measure : planned.plan.measures) {
    if (measure.feature == feature && measure.what == probe::Characteristic::Size) {
      text += fmt::format(" {} {:g}", measure.axis, measure.nominal);
    }
  }
  return text;
}

std::string cycle_of(const PlannedPart& planned, std::size_t feature) {
  const probe::PlannedRound* const round = round_of(planned, feature);
  return round != nullptr && round->by_points.empty() ? fmt::format(" by {}", planned.cycle) : "";
}

std::string features_text(const PlannedPart& planned) {
  std::string text;
  for (std::size_t i = 0; i < planned.part.features.size(); ++i) {
    const parts::Feature& feature = planned.part.features[i];
    text += fmt::format("{:<4} {:<14}{}  sizes{}{}\n", feature_id(i), words_of(feature.kind),
                        box_text(feature.box_P), sizes_of(planned, i), cycle_of(planned, i));
  }
  for (const probe::PlannedRound& round : planned.plan.rounds) {
    if (!round.by_points.empty()) {
      text += fmt::format("{:<4} point by point: {}\n", feature_id(round.feature), round.by_points);
    }
  }
  for (const probe::PlannedPoint& point : planned.plan.points) {
    if (!point.moved.empty()) {
      text += fmt::format("{:<4} moved: {}\n", point.id, point.moved);
    }
  }
  for (std::size_t i = 0; i < planned.part.unknown.size(); ++i) {
    text += fmt::format("{:<4} not measured: {}\n", feature_id(planned.part.features.size() + i),
                        planned.part.unknown[i].why);
  }
  for (const probe::LeftOut& left : planned.plan.left_out) {
    text += fmt::format("{}.{} not measured: {}\n", feature_id(left.feature), left.axis, left.why);
  }
  return text;
}

/// What the run on the product says of the program.
std::string proof_text(const PlannedPart& planned) {
  constexpr double kUmPerMm = 1e3;
  const std::string run = fmt::format(
      "{} touches in {:.0f} s of machine time, nothing else was touched; largest deviation {:.4f} "
      "um\n",
      planned.touches, planned.machine_time_s, planned.largest_deviation_mm * kUmPerMm);
  if (planned.is_proven()) {
    return fmt::format("proven on {}: {}", source::printable(planned.product), run);
  }
  Judgement bad;
  std::ranges::copy_if(planned.on_product.measures, std::back_inserter(bad.measures),
                       [](const JudgedMeasure& row) { return row.verdict == Verdict::Bad; });
  return fmt::format(
      "not proven on {}: {}{} of {} measures of the part as drawn come out of tolerance with the "
      "machine and the probe of the sheet:\n{}expected: a probe whose calibration the program "
      "knows, a machine that is compensated, a finer mesh, or a wider "
      "tolerance\n",
      source::printable(planned.product), run, bad.measures.size(),
      planned.on_product.measures.size(), measures_table(bad));
}

}  // namespace

std::string plan_summary(const PlannedPart& planned) {
  std::string text = features_text(planned);
  if (planned.plan.measures.empty()) {
    text += planned.leaves_something_out() ? "nothing is measured\n"
                                           : "nothing was cut from the stock\n";
  }
  if (!planned.plan.measures.empty()) {
    text += proof_text(planned);
  }
  if (planned.as_machined) {
    text += "as machined:\n" + judgement_table(*planned.as_machined);
  }
  return text;
}

}  // namespace g31::plan

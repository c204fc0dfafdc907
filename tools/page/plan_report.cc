#include <algorithm>

#include <fmt/format.h>

#include "tools/page/html.h"
#include "tools/page/judged_measures.h"
#include "tools/page/other_reports.h"
#include "tools/page/said.h"
#include "tools/plan/plan_document.h"
#include "tools/plan/plan_drawing.h"

namespace g31::page {
namespace {

constexpr int kPlanDecimals = 3;

std::string range_of(const parts::Box& box, int axis, Language language) {
  return said(language, Word::FromTo, fmt::arg("from", number(box.min[axis], kPlanDecimals)),
              fmt::arg("to", number(box.max[axis], kPlanDecimals)));
}

Word word_of(parts::FeatureKind kind) {
  switch (kind) {
    case parts::FeatureKind::ClosedPocket:
      return Word::ClosedPocket;
    case parts::FeatureKind::OpenPocket:
      return Word::OpenPocket;
    case parts::FeatureKind::ClosedSlot:
      return Word::ClosedSlot;
    case parts::FeatureKind::OpenSlot:
      return Word::OpenSlot;
    case parts::FeatureKind::Step:
      return Word::StepFeature;
    case parts::FeatureKind::ThroughPocket:
      return Word::ThroughPocket;
    case parts::FeatureKind::BlindHole:
      return Word::BlindHole;
    case parts::FeatureKind::ThroughHole:
      return Word::ThroughHole;
    case parts::FeatureKind::Boss:
      return Word::Boss;
    case parts::FeatureKind::Rib:
      break;
  }
  return Word::Rib;
}

std::string drawing_of(const plan::PlannedPart& planned, Language language) {
  return plan::plan_drawing(
      planned,
      {said(language, Word::FromAbove, fmt::arg("product", planned.product)),
       [language](parts::FeatureKind kind) {
         return std::string(text_of(word_of(kind), language));
       },
       std::string(text_of(Word::WayBetween, language)),
       {said(language, Word::CountsOfPlan, fmt::arg("features", planned.part.features.size()),
             fmt::arg("points", planned.plan.points.size()),
             fmt::arg("measures", planned.plan.measures.size())),
        said(language, Word::BallOf,
             fmt::arg("size", fmt::format("{:g}", 2.0 * planned.ball_radius_mm)))}});
}

Table features_table(const plan::PlannedPart& planned, Language language) {
  const auto word = [language](Word which) { return std::string(text_of(which, language)); };
  Table table{word(Word::Features),
              {word(Word::Feature), word(Word::Kind), "X", "Y", "Z", word(Word::OpenSides)},
              {},
              {}};
  for (std::size_t i = 0; i < planned.part.features.size(); ++i) {
    const parts::Feature& feature = planned.part.features[i];
    std::string open;
    for (std::size_t side = 0; side < parts::kSides; ++side) {
      if (feature.open[side]) {
        open +=
            fmt::format("{}{}", open.empty() ? "" : " ", name_of(static_cast<parts::Side>(side)));
      }
    }
    const probe::PlannedRound* const round = plan::round_of(planned, i);
    const bool is_by_cycle = round != nullptr && round->by_points.empty();
    const std::string cycle = is_by_cycle ? fmt::format(" ({})", planned.cycle) : "";
    table.rows.push_back({plan::feature_id(i), word(word_of(feature.kind)) + cycle,
                          range_of(feature.box_P, 0, language),
                          range_of(feature.box_P, 1, language),
                          range_of(feature.box_P, 2, language), open});
  }
  return table;
}

Table points_table(const plan::PlannedPart& planned, Language language) {
  Table table{std::string(text_of(Word::Points, language)), {"", "X", "Y", "Z", ""}, {}, 4};
  for (const probe::PlannedPoint& point : planned.plan.points) {
    table.rows.push_back({point.id, number(point.at_P.x(), kPlanDecimals),
                          number(point.at_P.y(), kPlanDecimals),
                          number(point.at_P.z(), kPlanDecimals), point.moved});
  }
  return table;
}

/// What is not measured, and why.
struct NotMeasured {
  std::string name;
  std::string why;
};

std::vector<NotMeasured> not_measured(const plan::PlannedPart& planned) {
  std::vector<NotMeasured> all;
  for (std::size_t i = 0; i < planned.part.unknown.size(); ++i) {
    all.push_back(
        {plan::feature_id(planned.part.features.size() + i), planned.part.unknown[i].why});
  }
  for (const probe::LeftOut& left : planned.plan.left_out) {
    all.push_back({fmt::format("{}.{}", plan::feature_id(left.feature), left.axis), left.why});
  }
  return all;
}

Table left_out_table(const plan::PlannedPart& planned, Language language) {
  Table table{
      std::string(text_of(Word::NotMeasured, language)),
      {std::string(text_of(Word::Feature, language)), std::string(text_of(Word::Why, language))},
      {},
      1};
  for (const NotMeasured& one : not_measured(planned)) {
    table.rows.push_back({one.name, one.why});
  }
  return table;
}

/// The numbers of the touches that came: ways down are touches that do not.
std::vector<std::size_t> numbers_of_touches(const Report& report) {
  std::vector<std::size_t> numbers;
  for (std::size_t i = 0; i < report.touches.size(); ++i) {
    if (report.touches[i].is_triggered) {
      numbers.push_back(i + 1);
    }
  }
  return numbers;
}

/// What was printed on the part as machined; without one the run on the product.
/// @param touches  the numbers of those that came
std::vector<Characteristic> characteristics(const plan::PlannedPart& planned,
                                            const std::vector<std::size_t>& touches) {
  const plan::Judgement& judged = planned.as_machined ? *planned.as_machined : planned.on_product;
  std::vector<Characteristic> rows;
  for (std::size_t i = 0; i < planned.plan.measures.size(); ++i) {
    const probe::PlannedMeasure& measure = planned.plan.measures[i];
    Characteristic row = characteristic_of(judged.measures[i]);
    row.variable = planned.program.measures[i].variable;
    if (!planned.as_machined) {
      row.measured = planned.proven_values[i];
    }
    const auto& of_points = planned.program.touches_of_points;
    if (touches.size() == planned.program.touches) {
      row.touches = {touches[of_points[measure.first]], touches[of_points[measure.second]]};
    }
    rows.push_back(std::move(row));
  }
  return rows;
}

/// What is left out is a finding, as it is for the command.
void add_left_out(const plan::PlannedPart& planned, Report& report) {
  const Language language = report.language;
  std::vector<std::string> names;
  for (const NotMeasured& one : not_measured(planned)) {
    report.findings.push_back(
        {source::Severity::Error,
         "",
         said(language, Word::SaysLeftOut, fmt::arg("name", one.name), fmt::arg("why", one.why)),
         {}});
    names.push_back(one.name);
  }
  report.verdict.sign = Sign::Bad;
  report.verdict.state = text_of(Word::StateIncomplete, language);
  report.verdict.headline = said(language, Word::SaysNotAll, fmt::arg("names", named(names)));
}

/// What of the part as machined is not good: the page says it first.
void add_as_machined(const plan::PlannedPart& planned, Report& report) {
  const Language language = report.language;
  const plan::Judgement& judged = *planned.as_machined;
  report.verdict.sentence += " " + said(language, Word::SaysAsMachined,
                                        fmt::arg("good", count(judged, plan::Verdict::Good)),
                                        fmt::arg("all", judged.measures.size()));
  report.results_of = text_of(Word::AsMachined, language);
  report.motion_of = text_of(Word::AsDrawn, language);
  add_not_good(judged,
               {Word::SaysMachinedBad, Word::SaysMachinedMissing, Word::SaysMachinedOut,
                Word::SaysMachinedSeveralOut},
               report);
}

/// The document of the page is the plan; figures are of the run that proved it.
void take_document(const std::string& document, Report& report) {
  report.figures.pop_back();
  report.figures += ",\"run\":" + report.document + "}";
  report.document = document;
}

}  // namespace

void add_plan(const plan::PlannedPart& planned, const PlanCommand& command, Report& report) {
  const Language language = report.language;
  report.title = planned.product;
  report.what = "g31 plan";
  report.verdict.headline =
      said(language, Word::SaysPlan, fmt::arg("features", planned.part.features.size()),
           fmt::arg("measures", planned.plan.measures.size()),
           fmt::arg("touches", planned.plan.points.size()));
  report.verdict.sentence =
      said(language, planned.is_proven() ? Word::SaysProof : Word::SaysNoProof,
           fmt::arg("bad", count(planned.on_product, plan::Verdict::Bad)),
           fmt::arg("all", planned.on_product.measures.size()),
           fmt::arg("deviation", micrometres(planned.largest_deviation_mm)));
  if (planned.leaves_something_out()) {
    add_left_out(planned, report);
  }
  add_not_good(
      planned.on_product,
      {Word::SaysDrawnBad, Word::SaysJudgedMissing, Word::SaysDrawnOut, Word::SaysDrawnSeveralOut},
      report);
  report.command = command.line;
  for (auto& [name, value] : report.facts) {
    if (name == text_of(Word::ExitCode, language)) {
      value = fmt::format("{}", command.exit_code);  // till here that of the run
    }
  }
  report.results = characteristics(planned, numbers_of_touches(report));
  if (planned.as_machined) {
    add_as_machined(planned, report);
  }
  take_document(plan::plan_document(planned), report);
  report.drawings.push_back({planned.product, drawing_of(planned, language), ""});
  report.tables.push_back(features_table(planned, language));
  report.tables.push_back(points_table(planned, language));
  if (planned.leaves_something_out()) {
    report.tables.push_back(left_out_table(planned, language));
  }
}

}  // namespace g31::page

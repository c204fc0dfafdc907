#include "tools/plan/program_steps.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>
#include <utility>

#include <fmt/format.h>

#include "tools/plan/measures.h"
#include "tools/plan/plan_uses.h"

namespace g31::plan {
namespace {

/// Hands out the variables of contacts and takes them back.
class Pool {
 public:
  explicit Pool(int first) : next_(first) {}

  int take() {
    if (free_.empty()) {
      return next_++;
    }
    const int variable = *free_.begin();
    free_.erase(free_.begin());
    return variable;
  }

  void give_back(int variable) { free_.insert(variable); }

 private:
  int next_;
  std::set<int> free_;
};

/// No feature has more points than these, and one is done with before the next.
constexpr int kContacts = 8;

class StepMaker {
 public:
  explicit StepMaker(const probe::InspectionPlan& plan)
      : plan_(plan),
        uses_(plan),
        keeps_(static_cast<int>(plan.measures.size()) + kContacts <= kProgramVariables),
        pool_(keeps_ ? static_cast<int>(plan.measures.size()) : 1),
        contact_(plan.points.size(), -1) {}

  ProgramSteps made() {
    ProgramSteps made;
    for (std::size_t point = 0; point < plan_.points.size(); ++point) {
      const probe::PlannedRound* const round = uses_.round_of(point);
      if (round == nullptr) {
        made.steps.push_back(step_of(point));
      } else if (point == std::ranges::min(round->points)) {
        made.steps.push_back(step_of(*round, point));
      }
    }
    for (std::size_t i = 1; i < made.steps.size(); ++i) {
      made.steps[i].begins_feature = made.steps[i].feature != made.steps[i - 1].feature;
    }
    if (!made.steps.empty()) {
      made.steps.front().begins_feature = true;
    }
    for (std::size_t i = 0; i < plan_.measures.size(); ++i) {
      made.variables.push_back(keeps_ ? static_cast<int>(i) : -1);
    }
    return made;
  }

 private:
  /// @pre its points are touched
  [[nodiscard]] StepResult result_of(std::size_t index) const {
    const probe::PlannedMeasure& measure = plan_.measures[index];
    StepResult result{index, keeps_ ? static_cast<int>(index) : 0, contact_[measure.first],
                      contact_[measure.second]};
    if (const probe::PlannedRound* const wall = uses_.wall_across(index)) {
      const auto& [minus_x, plus_x, minus_y, plus_y] = wall->points;
      const bool is_x = measure.first == minus_x || measure.first == plus_x;
      result.round = wall;
      result.first_across = contact_[is_x ? minus_y : minus_x];
      result.second_across = contact_[is_x ? plus_y : plus_x];
    }
    return result;
  }

  ProgramStep step_of(const probe::PlannedRound& round, std::size_t first) {
    ProgramStep step;
    step.point = first;
    step.feature = round.feature;
    step.round = &round;
    for (std::size_t i = 0; i < round.points.size(); ++i) {
      step.contacts[i] = contact_[round.points[i]] = pool_.take();
    }
    for (const std::size_t measure : round.measures) {
      step.results.push_back(result_of(measure));
    }
    for (const int contact : step.contacts) {
      pool_.give_back(contact);
    }
    return step;
  }

  ProgramStep step_of(std::size_t point) {
    ProgramStep step;
    step.point = point;
    step.contact = contact_[point] = pool_.take();
    for (const std::size_t i : uses_.measures_at(point)) {
      step.feature = plan_.measures[i].feature;
      step.direction_P = plan_.measures[i].direction_P;
    }
    for (const std::size_t i : uses_.measures_ready_at(point)) {
      step.results.push_back(result_of(i));
    }
    for (const std::size_t touched : uses_.points_done_at(point)) {
      pool_.give_back(contact_[touched]);
    }
    return step;
  }

  const probe::InspectionPlan& plan_;
  PlanUses uses_;
  bool keeps_;
  Pool pool_;
  std::vector<int> contact_;  // of each point; -1: not touched so far
};

/// As few decimals as a value has, with a point.
std::string trimmed(std::string text) {
  text.erase(text.find_last_not_of('0') + 1);
  return text == "-0." ? "0." : text;
}

}  // namespace

ProgramSteps program_steps(const probe::InspectionPlan& plan) {
  return StepMaker(plan).made();
}

std::vector<std::string> printed_names(const probe::InspectionPlan& plan) {
  std::vector<std::string> names;
  std::set<std::string> taken;
  for (const probe::PlannedMeasure& measure : plan.measures) {
    const std::string name = printed_name(measure.id);
    std::string unlike = name;
    for (int number = 2; !taken.insert(unlike).second; ++number) {
      unlike = fmt::format("{}-{}", name, number);
    }
    names.push_back(unlike);
  }
  return names;
}

int decimals_of(const probe::PlannedMeasure& measure) {
  constexpr int kLeastWhole = 3;
  // Room for a part that is not as it should be.
  const double largest = 1.1 * std::abs(measure.nominal) + 10.0;
  int whole = kLeastWhole;
  for (double limit = 1000.0; largest >= limit && whole < kPrintedDigits; limit *= 10.0) {
    ++whole;
  }
  return kPrintedDigits - whole;
}

std::string coordinate(double mm) {
  return trimmed(fmt::format("{:.3f}", mm));
}

std::string exact(double value) {
  constexpr int kDigits = 8;
  constexpr double kClosely = 1e-8;
  const double whole = std::floor(std::abs(value));
  const int before = whole < 1.0 ? 1 : static_cast<int>(std::log10(whole)) + 1;
  std::string text = trimmed(fmt::format("{:.{}f}", value, std::clamp(kDigits - before, 1, 7)));
  const double rest = value - std::stod(text);
  if (std::abs(rest) > kClosely) {
    text += (rest < 0.0 ? "-" : "+") + trimmed(fmt::format("{:.8f}", std::abs(rest))).substr(1);
  }
  return text;
}

std::string less_exact(double value) {
  const std::string number = exact(-value);
  if (number == "0.") {
    return "";
  }
  return number.front() == '-' ? number : "+" + number;
}

std::string nominal_text(double mm) {
  return trimmed(fmt::format("{:.5f}", mm));
}

std::string less(const std::string& number) {
  if (number == "0.") {
    return "";
  }
  return number.front() == '-' ? "+" + number.substr(1) : "-" + number;
}

int axis_along(const Point& direction) {
  for (int axis = 0; axis < 3; ++axis) {
    if (std::abs(direction[axis]) == 1.0) {
      return axis;
    }
  }
  return -1;
}

std::string angle_text(const Point& direction) {
  return exact(std::atan2(direction.y(), direction.x()) * 180.0 / std::numbers::pi);
}

char axis_letter(int axis) {
  return "XYZ"[axis];
}

std::string variable_name(ProgramLanguage language, int variable) {
  constexpr int kFirstCommon = 110;
  constexpr int kFirstR = 10;
  constexpr int kRowA9[] = {168, 183, 198};
  if (language == ProgramLanguage::Sinumerik) {
    return fmt::format("R{}", kFirstR + variable);
  }
  int number = kFirstCommon + variable;
  for (const int taken : kRowA9) {
    number += number >= taken ? 1 : 0;
  }
  return fmt::format("#{}", number);
}

InspectionProgram inspection_program(const probe::InspectionPlan& plan,
                                     const ProgramOptions& options) {
  InspectionProgram program;
  const ProgramSteps steps = program_steps(plan);
  const bool is_fanuc = options.language == ProgramLanguage::Fanuc;
  WrittenProgram written =
      is_fanuc ? fanuc_program(plan, steps, options) : sinumerik_program(plan, steps, options);
  program.text = std::move(written.text);
  program.touches = written.touches;
  program.touches_of_points = std::move(written.of_points);
  const auto names = printed_names(plan);
  for (std::size_t i = 0; i < plan.measures.size(); ++i) {
    const int variable = steps.variables[i];
    program.measures.push_back({names[i], decimals_of(plan.measures[i]),
                                variable < 0 ? "" : variable_name(options.language, variable)});
  }
  return program;
}

}  // namespace g31::plan

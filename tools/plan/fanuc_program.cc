#include "tools/plan/program_writer.h"

namespace g31::plan {
namespace {

/// #5063 includes the length of the tool.
constexpr ProgramWords kFanucWords = {
    .language = ProgramLanguage::Fanuc,
    .open = "[",
    .close = "]",
    .rapid = "G00",
    .feed = "G01",
    .ways_feed = "F#101",
    .radius = "#100",
    .across = "#104",
    .along = "#105",
    .point = "#103",
    .dwell = "G04 X",
    .cycle = "O9010, the macro of G100",
    .skip = {"#5061", "#5062", "#5063-#5083"},
};
constexpr double kNearlyThereMm = 0.01;

class FanucWriter final : public ProgramWriter {
 public:
  FanucWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
              const ProgramOptions& options)
      : ProgramWriter(plan, steps, options, kFanucWords) {}

 private:
  /// Capitals, no brackets, which would end it, and no %, which would end the tape.
  void comment(std::string_view text) override {
    std::string shown;
    for (const char c : text) {
      const bool is_plain = c >= ' ' && c <= '~' && c != '(' && c != ')' && c != '%';
      const char plain = is_plain ? c : '-';
      shown += plain >= 'a' && plain <= 'z' ? static_cast<char>(plain - 'a' + 'A') : plain;
    }
    line("({})", shown);
  }

  void write_head() override {
    line("%\nO6900");
    comment("inspection of " + options().product);
    comment("made by g31 plan, and run on the model before");
    comment("origin of G54: that of the model");
    write_places();
    if (options().tool) {
      line("T{} M06", *options().tool);
    }
    line("G90 G94 G17 G40 G69 G80{}", options().has_metric_code ? " G21" : "");
    line("G54");
    write_switch_on();
    line("M05");
    line("#100={} (RADIUS OF THE BALL)", exact(options().ball_radius_mm));
    line("#101={} (FEED OF THE WAYS)", coordinate(options().approach_feed));
    line("#102={} (FEED OF THE TOUCHES)", coordinate(options().touch_feed));
    line("POPEN");
    line("G00 G43 H{} Z{}", options().length_offset, height(options().clear_z_P));
  }

  /// Which variables get the results, and where the macro of round walls reads.
  void write_places() {
    const std::vector<int>& results = steps().variables;
    std::string ranges;
    for (std::size_t i = 0; i < results.size() && results[i] >= 0; ++i) {
      const bool begins = i == 0 || number_of(results[i]) != number_of(results[i - 1]) + 1;
      const bool ends =
          i + 1 == results.size() || number_of(results[i]) + 1 != number_of(results[i + 1]);
      ranges +=
          begins ? fmt::format("{}{}", ranges.empty() ? "" : ", ", number_of(results[i])) : "";
      ranges += ends && !begins ? fmt::format(" to {}", number_of(results[i])) : "";
    }
    if (!ranges.empty()) {
      comment("results: " + ranges);
    }
    if (const std::string features = features_by_cycle(); !features.empty()) {
      comment(features + " by O9010, the macro of G100; its calibration:");
      comment("515 ball, 517 518 overtravel in X and Y, 530 531 eccentricity");
    }
  }

  [[nodiscard]] int number_of(int result) const { return std::stoi(variable(result).substr(1)); }

  void write_way_down(const std::string& z, std::size_t point) override {
    constexpr std::size_t kZ = 2;
    line("G31 Z{} {}", z, kFanucWords.ways_feed);
    line("IF [ABS[{}{}] LT {}] GOTO {}", kFanucWords.skip[kZ], less(z), kNearlyThereMm,
         10 * point - 1);
    line("#3000= 102 (IN THE WAY TO P{})", point);
    line("N{}", 10 * point - 1);
  }

  void write_skip(const Skip& skip) override {
    line("G31 {} F#102", skip.words);
    line("IF [ABS[{}{}] GT {}] GOTO {}", kFanucWords.skip[static_cast<std::size_t>(skip.axis)],
         less(skip.target), kNearlyThereMm, 10 * skip.point);
    line("#3000= 101 (P{} IS NOT TOUCHED)", skip.point);
    line("N{}", 10 * skip.point);
  }

  /// The macro stays at the height of the call, since both its heights are that one.  It does not
  /// say whether it has touched.
  void write_cycle(const ProgramStep& step) override {
    const probe::PlannedRound& round = *step.round;
    for (std::size_t i = 0; i < round.points.size(); ++i) {
      const std::size_t number = round.points[i] + 1;
      const probe::PlannedPoint& point = plan().points[round.points[i]];
      const Point& start = round.is_standing ? point.start_P : round.centre_P;
      const auto axis = static_cast<int>(i / 2);
      const std::string contact = variable(step.contacts[i]);
      const std::string z = height(start.z());
      line("{}={}", kFanucWords.point, number);
      go_to(start, number);
      line("G65 P9010 {}{} R{} Z{} A9.", "UV"[axis],
           coordinate(end_of_touch(point)[axis] - start[axis]), z, z);
      line("{}={}", contact, axis == 0 ? "#168" : "#183");
      line("IF [ABS[{}{}] LT {}] GOTO {}", contact, less(coordinate(point.at_P[axis])),
           coordinate(options().overtravel_mm), 10 * number);
      line("#3000= 101 (P{} IS NOT TOUCHED)", number);
      line("N{}", 10 * number);
      constexpr std::size_t kFastAndSlow = 2;
      count_touches(kFastAndSlow, round.points[i]);
    }
    for (const StepResult& result : step.results) {
      write_result(result);
    }
  }

  /// The square of less than that is none that every control has.
  void write_no_less(std::string_view variable) override {
    line("{0}=FIX[{0}*10000000.]/10000000.", variable);
  }

  void write_print(const std::string& name, const std::string& variable, int decimals) override {
    line("DPRNT[{}*{}[{}{}]]", name, variable, kPrintedDigits - decimals, decimals);
  }

  void write_end() override { line("PCLOS\nM30\n%"); }
};

}  // namespace

WrittenProgram fanuc_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                             const ProgramOptions& options) {
  return FanucWriter(plan, steps, options).program();
}

}  // namespace g31::plan

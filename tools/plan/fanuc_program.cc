#include "tools/plan/program_writer.h"

namespace g31::plan {
namespace {

/// #5063 includes the length of the tool.
constexpr ProgramWords kWords = {
    .language = ProgramLanguage::Fanuc,
    .open = "[",
    .close = "]",
    .rapid = "G00",
    .feed = "G01",
    .ways_feed = "F#101",
    .radius = "#100",
    .point = "#103",
    .dwell = "G04 X",
    .skip = {"#5061", "#5062", "#5063-#5083"},
};
constexpr double kNearlyThereMm = 0.01;

class FanucWriter final : public ProgramWriter {
 public:
  FanucWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
              const ProgramOptions& options)
      : ProgramWriter(plan, steps, options, kWords) {}

 private:
  /// Capitals, and no brackets, which would end it.
  void comment(std::string_view text) override {
    std::string shown;
    for (const char c : text) {
      const bool is_plain = c >= ' ' && c <= '~' && c != '(' && c != ')';
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
    if (!steps().variables.empty() && steps().variables.front() >= 0) {
      comment(fmt::format("results: {} to {}", variable(steps().variables.front()).substr(1),
                          variable(steps().variables.back()).substr(1)));
    }
    if (options().tool) {
      line("T{} M06", *options().tool);
    }
    line("G90 G17 G40 G80{}", options().has_metric_code ? " G21" : "");
    line("G54");
    write_switch_on();
    line("M05");
    line("#100={} (RADIUS OF THE BALL)", exact(options().ball_radius_mm));
    line("#101={} (FEED OF THE WAYS)", coordinate(options().approach_feed));
    line("#102={} (FEED OF THE TOUCHES)", coordinate(options().touch_feed));
    line("POPEN");
    line("G00 G43 H{} Z{}", options().length_offset, height(options().clear_z_P));
  }

  void write_way_down(const std::string& z, std::size_t point) override {
    constexpr std::size_t kZ = 2;
    line("G31 Z{} {}", z, kWords.ways_feed);
    line("IF [ABS[{}{}] LT {}] GOTO {}", kWords.skip[kZ], less(z), kNearlyThereMm, 10 * point - 1);
    line("#3000= 102 (SOMETHING IS IN THE WAY TO P{})", point);
    line("N{}", 10 * point - 1);
  }

  void write_skip(const Skip& skip) override {
    line("G31 {} F#102", skip.words);
    line("IF [ABS[{}{}] GT {}] GOTO {}", kWords.skip[static_cast<std::size_t>(skip.axis)],
         less(skip.target), kNearlyThereMm, 10 * skip.point);
    line("#3000= 101 (P{} IS NOT TOUCHED)", skip.point);
    line("N{}", 10 * skip.point);
  }

  void write_print(const std::string& name, const std::string& variable, int decimals) override {
    line("DPRNT[{}*{}[{}{}]]", name, variable, kPrintedDigits - decimals, decimals);
  }

  void write_end() override { line("PCLOS\nM30\n%"); }
};

}  // namespace

std::string fanuc_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                          const ProgramOptions& options) {
  return FanucWriter(plan, steps, options).text();
}

}  // namespace g31::plan

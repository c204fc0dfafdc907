#include "tools/plan/program_writer.h"

namespace g31::plan {
namespace {

constexpr ProgramWords kWords = {
    .language = ProgramLanguage::Sinumerik,
    .open = "(",
    .close = ")",
    .rapid = "G0",
    .feed = "G1",
    .ways_feed = "F=R3",
    .radius = "R1",
    .point = "R2",
    .dwell = "G4 F",
    .skip = {"$AA_MW[X]", "$AA_MW[Y]", "$AA_MW[Z]"},
};

class SinumerikWriter final : public ProgramWriter {
 public:
  SinumerikWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                  const ProgramOptions& options)
      : ProgramWriter(plan, steps, options, kWords) {}

 private:
  /// To the end of a line.
  void comment(std::string_view text) override {
    std::string shown;
    for (const char c : text) {
      shown += c >= ' ' && c <= '~' ? c : '-';
    }
    line("; {}", shown);
  }

  void write_head() override {
    comment("Inspection of " + options().product);
    comment("made by g31 plan, and run on the model before");
    comment("Origin of G54: that of the model.  Results go to the file INSPECT_LOG");
    if (!steps().variables.empty() && steps().variables.front() >= 0) {
      comment(fmt::format("and stay in {} to {}", variable(steps().variables.front()),
                          variable(steps().variables.back())));
    }
    line("DEF INT FAULT");
    line("G90 G17 G40 G71 G94");
    line("G54");
    line("T{}", options().tool_name.empty() ? fmt::format("{}", options().length_offset)
                                            : fmt::format("=\"{}\"", options().tool_name));
    line("M6");
    line("D1");
    write_switch_on();
    line("M5");
    line("R1={}  ; radius of the ball", exact(options().ball_radius_mm));
    line("R3={}  ; feed of the ways", coordinate(options().approach_feed));
    line("R4={}  ; feed of the touches", coordinate(options().touch_feed));
    line("IF ISFILE(\"INSPECT_LOG\")");
    line("  DELETE(FAULT,\"INSPECT_LOG\")");
    line("ENDIF");
    line("G0 Z{}", height(options().clear_z_P));
  }

  void write_way_down(const std::string& z, std::size_t point) override {
    line("MEAS=1 G1 Z{} {}", z, kWords.ways_feed);
    write_check("$AC_MEA[1]<>0", 65001, fmt::format("Something is in the way to P{}", point));
  }

  void write_skip(const Skip& skip) override {
    line("MEAS=1 G1 {} F=R4", skip.words);
    write_check("$AC_MEA[1]==0", 65000, fmt::format("P{} is not touched", skip.point));
  }

  /// The alarm of a move that did not come to what it should.
  void write_check(std::string_view wrong, int alarm, const std::string& text) {
    line("STOPRE");
    line("IF {}", wrong);
    line("  SETAL({},\"{}\")", alarm, text);
    line("  M0");
    line("ENDIF");
  }

  void write_print(const std::string& name, const std::string& variable, int decimals) override {
    line("WRITE(FAULT,\"INSPECT_LOG\",SPRINT(\"{} %.{}f\",{}))", name, decimals, variable);
  }

  void write_end() override { line("M30"); }
};

}  // namespace

std::string sinumerik_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                              const ProgramOptions& options) {
  return SinumerikWriter(plan, steps, options).text();
}

}  // namespace g31::plan

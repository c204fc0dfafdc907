#include "tools/plan/program_writer.h"

namespace g31::plan {
namespace {

constexpr ProgramWords kSinumerikWords = {
    .language = ProgramLanguage::Sinumerik,
    .open = "(",
    .close = ")",
    .rapid = "G0",
    .feed = "G1",
    .ways_feed = "F=R3",
    .radius = "R1",
    .across = "R5",
    .along = "R6",
    .point = "R2",
    .dwell = "G4 F",
    .cycle = "CYCLE977",
    .skip = {"$AA_MW[X]", "$AA_MW[Y]", "$AA_MW[Z]"},
};

class SinumerikWriter final : public ProgramWriter {
 public:
  SinumerikWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                  const ProgramOptions& options)
      : ProgramWriter(plan, steps, options, kSinumerikWords) {}

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
    if (const std::string features = features_by_cycle(); !features.empty()) {
      comment(features + " by CYCLE977, with record 1 of the calibrated probe");
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
    line("MEAS=1 G1 Z{} {}", z, kSinumerikWords.ways_feed);
    write_check("$AC_MEA[1]<>0", 65001, fmt::format("Something is in the way to P{}", point));
  }

  void write_skip(const Skip& skip) override {
    line("MEAS=1 G1 {} F=R4", skip.words);
    write_check("$AC_MEA[1]==0", 65000, fmt::format("P{} is not touched", skip.point));
  }

  /// Each call begins in the middle; bosses are passed over at the clear height.  The diameter is
  /// that of the second pair of touches, which goes through the middle that the first has found:
  /// along X when the first goes along Y.
  void write_cycle(const ProgramStep& step) override {
    const probe::PlannedRound& round = *step.round;
    const auto& [minus_x, plus_x, minus_y, plus_y] = round.points;
    line("{}={}", kSinumerikWords.point, step.point + 1);
    if (round.is_standing) {
      go_above(round.centre_P);
    } else {
      go_to(round.centre_P, step.point + 1);
    }
    const auto origin = [&](std::size_t i) {
      return less_exact(plan().measures[step.results[i].measure].origin_mm);
    };
    write_call(round, "90.");
    count_touches(3, minus_x);
    count_touches(1, plus_x);
    write_value(step.results[0], "_OVR[4]");
    write_call(round, "");
    count_touches(3, plus_y);
    count_touches(1, minus_y);
    write_value(step.results[1], "_OVR[5]" + origin(1));
    write_value(step.results[2], "_OVR[4]");
    write_value(step.results[3], "_OVR[6]" + origin(3));
    leave();
  }

  void write_call(const probe::PlannedRound& round, std::string_view angle) {
    const double way = round.is_standing ? round.approach_mm : options().overtravel_mm;
    // No wall is touched farther off than that, and so no circle is believed to be.
    std::string call = fmt::format("CYCLE977({},,,1,{},,,{},{}", round.is_standing ? 2 : 1,
                                   exact(round.diameter_mm), coordinate(way), coordinate(way));
    if (round.is_standing || !angle.empty()) {
      call += fmt::format(",{}", angle);
    }
    if (round.is_standing) {
      call += "," + coordinate(round.centre_P.z() - options().clear_z_P);
    }
    line("{})", call);
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

WrittenProgram sinumerik_program(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                                 const ProgramOptions& options) {
  return SinumerikWriter(plan, steps, options).program();
}

}  // namespace g31::plan

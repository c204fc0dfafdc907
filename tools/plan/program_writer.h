#pragma once

#include <array>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/plan/program_steps.h"

namespace g31::plan {

/// What a language calls the things that an inspection program works with.
struct ProgramWords {
  ProgramLanguage language = ProgramLanguage::Fanuc;
  std::string_view open;  ///< of an expression
  std::string_view close;
  std::string_view rapid;  ///< moves
  std::string_view feed;
  std::string_view ways_feed;            ///< "F#101"
  std::string_view radius;               ///< of the ball: "#100"
  std::string_view across;               ///< variables of diameters: off the middle, ...
  std::string_view along;                ///< ... and half a chord
  std::string_view point;                ///< the variable that has the number of the point
  std::string_view dwell;                ///< before seconds: "G04 X"
  std::string_view cycle;                ///< what measures round walls, for comments
  std::array<std::string_view, 3> skip;  ///< where a touch was, as coordinates are programmed
};

/// Writes the touches of a program one after the other; a language adds its blocks.
class ProgramWriter {
 public:
  ProgramWriter(const ProgramWriter&) = delete;
  ProgramWriter& operator=(const ProgramWriter&) = delete;
  virtual ~ProgramWriter() = default;

  WrittenProgram program();

 protected:
  /// @param words  outlives the writer, as all else does
  ProgramWriter(const probe::InspectionPlan& plan, const ProgramSteps& steps,
                const ProgramOptions& options, const ProgramWords& words)
      : plan_(plan),
        steps_(steps),
        options_(options),
        words_(words),
        names_(printed_names(plan)),
        of_points_(plan.points.size()) {}

  template <typename... Parts>
  void line(fmt::format_string<Parts...> form, Parts&&... parts) {
    text_ += fmt::format(form, std::forward<Parts>(parts)...);
    text_ += '\n';
  }

  [[nodiscard]] const probe::InspectionPlan& plan() const { return plan_; }
  [[nodiscard]] const ProgramSteps& steps() const { return steps_; }
  [[nodiscard]] const ProgramOptions& options() const { return options_; }
  [[nodiscard]] const ProgramWords& words() const { return words_; }
  /// "#110"
  [[nodiscard]] std::string variable(int number) const {
    return variable_name(words_.language, number);
  }
  /// Z of the ball's centre as the control counts it.
  [[nodiscard]] std::string height(double z_P) const {
    return coordinate(z_P - options_.tip_below_centre_mm);
  }

  /// A skip move to where the ball ends if it does not touch.
  struct Skip {
    std::string words;   ///< "Y45."
    int axis = 0;        ///< along which it is mostly
    std::string target;  ///< in that axis
    std::size_t point = 0;
  };

  /// Switches the probe on and waits until it is ready.
  void write_switch_on();
  /// Where the ball's centre is at the end of a touch that does not come.
  [[nodiscard]] Point end_of_touch(const probe::PlannedPoint& point) const {
    return point.at_P + (options_.ball_radius_mm - options_.overtravel_mm) * point.normal_P;
  }
  /// Over a place at the clear height.
  void go_above(const Point& p_P);
  /// And down to it.
  /// @param point  the number that an alarm names
  void go_to(const Point& p_P, std::size_t point);
  /// Up to the clear height; where the ball is over the part is not known from here on.
  void leave();
  /// So many touches come; the last of them is that of a point.
  void count_touches(std::size_t touches, std::size_t point);
  /// From the contacts that its variables have.
  void write_result(const StepResult& result);
  void write_value(const StepResult& result, const std::string& value);
  /// "F3 F5": whose walls a cycle measures; "": of none.
  [[nodiscard]] std::string features_by_cycle() const;

  virtual void comment(std::string_view text) = 0;
  virtual void write_head() = 0;
  /// Along Z, as a touch too: nothing breaks on what should not be there.
  virtual void write_way_down(const std::string& z, std::size_t point) = 0;
  virtual void write_skip(const Skip& skip) = 0;
  /// The four touches of a round wall by a cycle, and its values.
  virtual void write_cycle(const ProgramStep& step) = 0;
  virtual void write_print(const std::string& name, const std::string& variable, int decimals) = 0;
  /// Before the square of a variable is computed.
  virtual void write_no_less(std::string_view variable) { static_cast<void>(variable); }
  /// Behind the last way up, the probe switched off.
  virtual void write_end() = 0;

 private:
  void write_feature(std::size_t feature);
  void write_round(const ProgramStep& step);
  void write_touch(const ProgramStep& step);
  [[nodiscard]] Skip skip_of(const probe::PlannedPoint& point, std::size_t number) const;
  [[nodiscard]] std::string contact(const probe::PlannedPoint& point,
                                    const ProgramStep& step) const;
  void write_diameter(const StepResult& result, const std::string& from, const std::string& to);

  const probe::InspectionPlan& plan_;
  const ProgramSteps& steps_;
  const ProgramOptions& options_;
  const ProgramWords& words_;
  std::vector<std::string> names_;
  std::string text_;
  std::size_t touches_ = 0;
  std::vector<std::size_t> of_points_;
  // Where the probe is: in X and Y, in Z.
  std::string above_;
  std::string z_;
};

}  // namespace g31::plan

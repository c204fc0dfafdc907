#include <algorithm>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/explain/entry.h"

namespace g31::fanuc::reference {
namespace {

std::string macro_alarm_text(const MacroAlarmRule& rule) {
  return rule.number == MacroAlarmRule::Number::BasePlusValue
             ? fmt::format("alarm {} + n, n {} to {}; the screen shows {} characters of its text",
                           rule.base, rule.smallest, rule.largest, rule.text_length)
             : fmt::format("alarm {}, n {} to {}; the screen shows {} characters of its text",
                           rule.base, rule.smallest, rule.largest, rule.text_length);
}

std::string missing_codes(const Profile& profile) {
  std::string list;
  for (const GNumber code : profile.missing_g_codes) {
    list += (list.empty() ? "" : ", ") + to_text(code);
  }
  return list.empty() ? "none" : list;
}

Entry entry_of(const Profile& profile) {
  const OutputRule& output = profile.output;
  const FeedCounts& feeds = profile.feed_counts;
  return {
      "control",
      std::string(profile.name),
      std::string(profile.text),
      {{"digits of a number", fmt::format("{} in expressions, {} behind an address",
                                          profile.digit_limit, profile.word_digit_limit)},
       {"sequence numbers", fmt::format("1 to {}{}", profile.largest_sequence,
                                        profile.smallest_target == 0 ? "; GOTO also 0" : "")},
       {"loops",
        fmt::format("DO 1 to {}, {} deep", profile.loops.largest_number, profile.loops.nesting)},
       {"alarms", fmt::format("{}{:03} is division by zero", profile.alarm_prefix,
                              number_of(AlarmId::DivisionByZero, profile.alarm_numbers))},
       {"X#1+10 without brackets", profile.has_bare_expressions ? "yes" : "no"},
       {"IF [] THEN", profile.has_then ? "yes" : "no"},
       {"calls", fmt::format("{} macros, {} subprograms, {} together deep", profile.calls.macros,
                             profile.calls.subprograms, profile.calls.together)},
       {"#3000=n", macro_alarm_text(profile.macro_alarm)},
       {"G53 and the tool length", profile.machine_move_length == MachineMoveLength::Cancels
                                       ? "cancelled until the next G43, G44 or H"
                                       : "left out in its own move only"},
       {"G43 H1 or G49 alone",
        profile.length_change == LengthChange::MovesAxis
            ? "moves the tool's axis by the length; not with parameter 5006.6"
            : "moves nothing"},
       {"G53", profile.machine_moves_by_mode ? "at rapid, behind G01 at feed"
                                             : "at rapid, behind G01 too"},
       {"G20, G21", find_g_code(20.0, profile) == nullptr ? "none: parameter 0.2 says the unit"
                    : profile.unit_is_setting             ? "check setting 9 (#20009)"
                                                          : "set the unit"},
       {"G53 under G91", profile.machine_moves_add ? "moves by its values" : "ignored"},
       {"G00", profile.rapids.positioning == machine::RapidPath::Independent
                   ? "each axis at its own rapid rate; straight with parameter 1401.1"
                   : "straight; [control] rapids of the set-up sheet says otherwise"},
       {"P in G31", profile.skip_selection == SkipSelection::Mask
                        ? "1 to 255, one bit for each signal"
                        : "1 to 4, the signals of parameters 6202 to 6205"},
       {"AND, OR between comparisons", profile.joins_conditions ? "yes" : "with parameter 6006.0"},
       {"IF [#1], IF [...] M98 P1", profile.conditions_rule_blocks ? "yes" : "no"},
       {"M98 <NAME>, G65 <NAME>",
        profile.has_program_names ? "yes, 0i-F too; not 0i-D" : "no, by number only"},
       {"M97 P, M96 P Q", profile.has_local_calls ? "yes" : "no"},
       {"F without a point",
        fmt::format("counts {} mm/min, or {} inch/min", 1.0 / feeds.per_mm, 1.0 / feeds.per_inch)},
       {"F in G31",
        profile.skip_feed == SkipFeed::Modal ? "stays in force" : "counts for its block only"},
       {"DPRNT",
        fmt::format(
            "{} to {} digits {}{}", output.fewest_digits, output.most_digits,
            output.counts_sides_apart ? "on either side of the point" : "a variable",
            output.without_popen == OutputRule::WithoutPopen::Alarm ? ", after POPEN" : "")},
       {"G codes of the family it lacks", missing_codes(profile)}}};
}

}  // namespace

Entries controls(std::string_view topic) {
  const auto same_letter = [](char a, char b) {
    return a == (b >= 'a' && b <= 'z' ? static_cast<char>(b - 'a' + 'A') : b);
  };
  for (const Profile& profile : profiles()) {
    if (std::ranges::equal(topic, profile.name, same_letter)) {
      return {entry_of(profile)};
    }
  }
  return {};
}

}  // namespace g31::fanuc::reference

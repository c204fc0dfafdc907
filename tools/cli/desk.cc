#include "tools/cli/desk.h"

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <iterator>
#include <span>

#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "interpreter/source/printable.h"
#include "tools/report/event_json.h"
#include "tools/session/ending.h"

namespace g31::cli {
namespace {

/// As https://no-color.org asks for it.
bool wants_colours(const RunOptions& options) {
  const char* const refusal = std::getenv("NO_COLOR");
  const bool is_refused = refusal != nullptr && *refusal != '\0';
  return !options.no_colour && !is_refused && takes_control_codes();
}

std::string_view colour_of(source::Severity severity) {
  switch (severity) {
    case source::Severity::Error:
      return "\033[1;31m";
    case source::Severity::Warning:
      return "\033[1;33m";
    case source::Severity::Note:
      return "\033[1;36m";
  }
  return {};
}

/// The word for the severity in colour.
std::string coloured(std::string text, source::Severity severity) {
  const std::string word = fmt::format("{}: ", source::name_of(severity));
  if (const std::size_t at = text.find(word); at != std::string::npos) {
    text.replace(at, word.size(), fmt::format("{}{}\033[0m", colour_of(severity), word));
  }
  return text;
}

/// "X12.5 Y-3 Z0", to a tenth of a micrometre; rotary axes where one is not 0.
std::string shown_axes(const AxisPositions& q) {
  std::string text;
  const bool has_rotary = !rotary_axes(q).isZero(0.0);
  for (std::size_t axis = 0; axis < kAxisCount; ++axis) {
    const double value = std::round(1e4 * q[static_cast<Eigen::Index>(axis)]) / 1e4 + 0.0;
    if (axis < static_cast<std::size_t>(kLinearAxisCount) || has_rotary) {
      text += fmt::format("{}{}{}", text.empty() ? "" : " ", kAxisLetters[axis], value);
    }
  }
  return text;
}

std::string shown_value(const runtime::ShownValue& value) {
  return std::visit(
      runtime::Overloaded{
          [](runtime::Cell cell) {
            return cell.is_vacant() ? std::string("vacant") : fmt::format("{}", cell.raw());
          },
          [](const std::string& text) { return fmt::format("\"{}\"", source::text_as_utf8(text)); },
      },
      value);
}

/// "G1"; whatever the language has for a skip move, G31, MEAS or MEAWA.
std::string name_of_move(int g) {
  constexpr int kSkip = 31;
  return g == kSkip ? "measuring move" : fmt::format("G{}", g);
}

std::string counted(std::size_t count, std::string_view what) {
  return fmt::format("{} {}{}", count, what, count == 1 ? "" : "s");
}

std::string end_of(const report::RunResult& result) {
  const runtime::Outcome& outcome = result.outcome;
  std::string text = session::status_name(outcome);
  if (outcome.alarm) {
    text += fmt::format(" {} {}", outcome.alarm->number, outcome.alarm->text);
  }
  const auto failed = std::ranges::count(result.expectations, false, &expect::Judged::holds);
  const auto warnings = std::ranges::count(outcome.diagnostics, source::Severity::Warning,
                                           &source::Diagnostic::severity);
  if (failed > 0) {
    text += fmt::format(", {} not as expected", failed);
  }
  if (warnings > 0) {
    text += fmt::format(", {}", counted(static_cast<std::size_t>(warnings), "warning"));
  }
  return source::printable(text);
}

/// Behind the message of what ended the program; without one, before what was expected of it.
std::size_t end_of_program(std::span<const source::Diagnostic> messages) {
  const std::string_view failed = source::info(source::DiagnosticId::ExpectationFailed).code;
  const auto first = std::ranges::find(messages, failed, &source::Diagnostic::code);
  const auto is_error = [](const source::Diagnostic& message) {
    return message.severity == source::Severity::Error;
  };
  const auto error = std::find_if(std::reverse_iterator(first), messages.rend(), is_error);
  const auto end = error == messages.rend() ? first : error.base();
  return static_cast<std::size_t>(end - messages.begin());
}

}  // namespace

Desk::Desk(const RunOptions& options, const source::SourceMap& sources)
    : options_(options),
      sources_(sources),
      is_coloured_(wants_colours(options)),
      line_(shows_progress(options.talk == Talk::Quiet)) {}

/// What is printed has its place before it.
void Desk::say(const std::string& text) const {
  line_.clear();
  std::fflush(stdout);
  std::fputs(text.c_str(), stderr);
}

void Desk::progress(std::uint64_t blocks, double machine_time_s) {
  show_run(line_, blocks, machine_time_s);
}

std::string Desk::place(source::Location where) const {
  const source::ShownPlace shown = sources_.show(where);
  return shown.file.empty() ? std::string("g31: ")
                            : fmt::format("{}:{}: ", source::printable(shown.file), shown.line);
}

void Desk::stop(const runtime::StopEvent& event) {
  if (options_.talk == Talk::Quiet || ++stops_ > kMostStops + 1) {
    return;
  }
  if (stops_ > kMostStops) {
    say("g31: further stops are not shown\n");
    return;
  }
  const bool is_passed = report::is_optional(event) && !options_.optional_stop;
  say(fmt::format("{}{}{}{}\n", place(event.where), event.kind,
                  event.text.empty() ? "" : fmt::format(": {}", source::printable(event.text)),
                  is_passed ? " passed: --optional-stop is off" : ""));
}

void Desk::message(std::string_view utf8) {
  if (options_.talk != Talk::Quiet) {
    const bool is_line = utf8.ends_with('\n');
    say(source::printable(utf8.substr(0, utf8.size() - (is_line ? 1 : 0))) + (is_line ? "\n" : ""));
  }
}

void Desk::touch(const runtime::TouchEvent& event) const {
  if (options_.talk != Talk::Verbose) {
    return;
  }
  const std::string what = !event.triggered ? std::string("no touch")
                           : event.contact  ? fmt::format("touch on '{}'", event.contact->part)
                                            : std::string("touch");
  say(fmt::format("{}{} at {} (machine {}), F{:.6g}\n", place(event.where), what,
                  shown_axes(event.view.q_L), shown_axes(event.q_M_latched), event.feed_mm_min));
}

void Desk::print(const source::Diagnostic& message) const {
  const std::string text = render_text(message, sources_);
  say(is_coloured_ ? coloured(text, message.severity) : text);
}

void Desk::tell(const report::RunResult& result, const report::RunRecorder& recorder) const {
  const std::span<const source::Diagnostic> messages = result.outcome.diagnostics;
  const std::size_t end = end_of_program(messages);
  const auto print_all = [&](std::span<const source::Diagnostic> some) {
    if (options_.tells_findings) {
      std::ranges::for_each(some, [&](const source::Diagnostic& message) { print(message); });
    }
  };
  print_all(messages.first(end));
  if (options_.talk != Talk::Quiet) {
    tell_details(result, recorder);
  }
  print_all(messages.subspan(end));
}

/// Belongs to what ended the program.
void Desk::tell_details(const report::RunResult& result,
                        const report::RunRecorder& recorder) const {
  if (const auto& fault = recorder.fault()) {
    say(fmt::format("      = at {} in work coordinates, {} in those of the machine\n",
                    shown_axes(fault->view.q_L), shown_axes(fault->q_M_at)));
    if (fault->move) {
      say(fmt::format(
          "      = {}{} on the way to {} in those of the machine\n", name_of_move(fault->move->g),
          fault->move->feed_mm_min > 0.0 ? fmt::format(" F{:.6g}", fault->move->feed_mm_min) : "",
          shown_axes(fault->move->q_M_to)));
    }
  }
  constexpr std::size_t kMostLocals = 40;
  std::string locals;
  for (std::size_t i = 0; i < std::min(kMostLocals, result.locals.size()); ++i) {
    const auto& [name, value] = result.locals[i];
    locals += fmt::format("{}{} = {}", locals.empty() ? "" : ", ", name, shown_value(value));
  }
  if (!locals.empty()) {
    say(fmt::format("      = with {}{}\n", source::printable(locals),
                    result.locals.size() > kMostLocals ? " and others" : ""));
  }
}

void Desk::end(const report::RunResult& result, const report::RunRecorder& recorder) const {
  if (options_.talk == Talk::Quiet) {
    return;
  }
  say(fmt::format(
      "g31: {}: {}, {}, {:.1f} s of machine time\n", end_of(result),
      counted(result.outcome.blocks, "block"),
      recorder.touch_count() == 1 ? "1 touch" : fmt::format("{} touches", recorder.touch_count()),
      result.machine_time_s));
}

}  // namespace g31::cli

#include "tools/page/run_report.h"

#include <algorithm>
#include <filesystem>
#include <set>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/latin_1.h"
#include "parts/geometry/placement.h"
#include "tools/page/html.h"

namespace g31::page {
namespace {

std::array<double, 3> linear(const AxisPositions& q) {
  const Point p = linear_axes(q);
  return {p.x(), p.y(), p.z()};
}

std::string shown(const runtime::ShownValue& value) {
  return std::visit(runtime::Overloaded{
                        [](runtime::Cell cell) {
                          return cell.is_vacant() ? std::string("–")
                                                  : fmt::format("{:.6g}", cell.raw());
                        },
                        [](const std::string& text) { return source::as_utf8(text); },
                    },
                    value);
}

/// The comment of a line, (DIAMETER) or ; diameter: what the variable is that it assigns.
std::string comment_of(std::string_view line) {
  const std::size_t open = line.rfind('(');
  const std::size_t close = line.rfind(')');
  const std::size_t semicolon = line.find(';');
  std::string_view text;
  if (semicolon != std::string_view::npos) {
    text = line.substr(semicolon + 1);
  } else if (open != std::string_view::npos && close != std::string_view::npos && close > open &&
             line.find_first_not_of(" \t\r", close + 1) == std::string_view::npos) {
    text = line.substr(open + 1, close - open - 1);
  }
  const std::size_t first = text.find_first_not_of(" \t");
  const std::size_t last = text.find_last_not_of(" \t\r");
  return first == std::string_view::npos ? std::string()
                                         : source::as_utf8(text.substr(first, last - first + 1));
}

/// Names and touches of what variables came to, by what wrote them last.
class Writers {
 public:
  explicit Writers(const RunPage& run) : run_(run) {}

  [[nodiscard]] std::string meaning_of(const std::string& variable) const {
    const report::VariableHistory* const history = find(variable);
    return history == nullptr ? "" : comment_of(run_.sources.show(history->last_write).text);
  }

  /// Touches in the call of the main program that the variable got its last value in.
  [[nodiscard]] std::vector<std::size_t> touches_of(const std::string& variable) const {
    const report::VariableHistory* const history = find(variable);
    std::vector<std::size_t> numbers;
    if (history == nullptr) {
      return numbers;
    }
    for (const report::CallSpan& call : run_.result.chronicle->calls()) {
      const bool is_it = call.level == 1 && call.first_block < history->last_block &&
                         history->last_block <= call.last_block;
      const auto& touches = run_.recorder.touches();
      for (std::size_t i = 0; is_it && i < touches.size(); ++i) {
        if (touches[i].triggered && is_within(touches[i].time_s, call)) {
          numbers.push_back(i + 1);
        }
      }
    }
    return numbers;
  }

  /// The program that the main program called for what happened at a time; "": it did it itself.
  [[nodiscard]] std::string caller_at(double time_s) const {
    std::string name;
    for (const report::CallSpan& call : run_.result.chronicle->calls()) {
      if (call.level == 1 && is_within(time_s, call)) {
        name = call.program;
      }
    }
    return name;
  }

 private:
  /// What a call touches comes behind its beginning.
  static bool is_within(double time_s, const report::CallSpan& call) {
    return time_s > call.time_from_s && time_s <= call.time_to_s;
  }

  [[nodiscard]] const report::VariableHistory* find(const std::string& variable) const {
    const auto histories = run_.result.chronicle->histories();
    const auto found = std::ranges::find(histories, variable, &report::VariableHistory::name);
    return found == histories.end() ? nullptr : &*found;
  }

  const RunPage& run_;
};

/// What is expected of numbers, then what --print has asked for besides.
std::vector<Characteristic> results_of(const RunPage& run, const Writers& writers) {
  std::vector<Characteristic> rows;
  std::set<std::string> known;
  const auto add = [&](const std::string& variable, const expect::Within* within,
                       std::optional<double> measured) {
    Characteristic row;
    row.variable = variable;
    const std::string meaning = writers.meaning_of(variable);
    row.name = meaning.empty() ? variable : meaning;
    row.measured = measured;
    if (within != nullptr) {
      row.nominal = within->value;
      row.tolerance = {-within->tolerance, within->tolerance};
    }
    row.touches = writers.touches_of(variable);
    if (run.other != nullptr) {
      const auto there = run.other->variables.find(variable);
      row.other = there == run.other->variables.end() ? std::nullopt : std::optional(there->second);
    }
    known.insert(variable);
    rows.push_back(std::move(row));
  };
  for (const expect::Expectation& expectation : run.expectations.rows) {
    if (const auto* const variable = std::get_if<expect::Variable>(&expectation.what)) {
      if (const auto* const within = std::get_if<expect::Within>(&variable->value)) {
        add(variable->name, within, run.value(expectation.what));
      }
    } else if (const auto* const offset = std::get_if<expect::WorkOffset>(&expectation.what)) {
      add(fmt::format("{} {}", offset->name, offset->axis), &offset->value,
          run.value(expectation.what));
    }
  }
  for (const auto& [name, value] : run.result.variables) {
    const auto* const cell = std::get_if<runtime::Cell>(&value);
    if (cell != nullptr && !known.contains(name)) {
      add(name, nullptr, cell->is_vacant() ? std::nullopt : std::optional(cell->raw()));
    }
  }
  return rows;
}

std::vector<Finding> findings_of(const RunPage& run) {
  std::vector<Finding> findings;
  for (const source::Diagnostic& message : run.result.outcome.diagnostics) {
    findings.push_back({message.severity, message.code, message.message,
                        place_at(source::place_of(message, run.sources)),
                        excerpt_of(message, run.sources)});
  }
  std::ranges::stable_sort(findings, std::greater(), &Finding::severity);
  return findings;
}

std::string place_text(const AxisPositions& q) {
  return fmt::format("X {} Y {} Z {}", number(q[0], 3), number(q[1], 3), number(q[2], 3));
}

Frame frame_of(const std::string& program, const source::Location& where,
               const source::SourceMap& sources) {
  const source::ShownPlace place = sources.show(where);
  return {program, place_at(place), source::as_utf8(place.text)};
}

/// The innermost frame and those that called it.
std::vector<Frame> stack_of(const source::Location& where,
                            const std::vector<runtime::CallSite>& calls,
                            const source::SourceMap& sources) {
  std::vector<Frame> stack;
  stack.push_back(frame_of("", where, sources));
  for (const runtime::CallSite& call : calls) {
    stack.push_back(frame_of(call.program, call.where, sources));
  }
  return stack;
}

std::optional<Ending> ending_of(const RunPage& run) {
  const runtime::Outcome& outcome = run.result.outcome;
  Ending ending;
  if (const auto& fault = run.recorder.fault()) {
    ending.title = fault->what;
    ending.stack = stack_of(fault->where, fault->view.calls, run.sources);
    ending.facts = {{"machine", place_text(fault->q_M_at)}, {"work", place_text(fault->view.q_L)}};
    if (fault->contact) {
      const Point& p = fault->contact->p_M_point;
      ending.facts.emplace_back("part", fault->contact->part);
      ending.facts.emplace_back("contact", fmt::format("X {} Y {} Z {}", number(p.x(), 3),
                                                       number(p.y(), 3), number(p.z(), 3)));
    }
    if (fault->move) {
      ending.facts.emplace_back("commanded", place_text(fault->move->q_M_to));
      ending.facts.emplace_back(
          "feed", fault->move->feed_mm_min > 0.0 ? number(fault->move->feed_mm_min, 0) : "rapid");
    }
  } else if (outcome.alarm) {
    ending.title = fmt::format("{} {}", outcome.alarm->number, outcome.alarm->text);
    ending.stack = stack_of(outcome.alarm->where, outcome.alarm->calls, run.sources);
    if (!outcome.alarm->detail.empty()) {
      ending.facts.emplace_back("detail", outcome.alarm->detail);
    }
  } else {
    return std::nullopt;
  }
  for (const auto& [name, value] : run.result.locals) {
    ending.variables.emplace_back(name, shown(value));
  }
  return ending;
}

/// A place in the frame of the part that was touched.
std::optional<std::array<double, 3>> in_part(const RunPage& run, const std::string& name,
                                             const Point& p_M) {
  const auto part = std::ranges::find(run.job.parts, name, &parts::PartSetup::name);
  if (part == run.job.parts.end()) {
    return std::nullopt;
  }
  const Eigen::Matrix3d R_MP = parts::rotation_to_machine({part->p_M_at, part->rotate_deg, {}});
  const Point p = R_MP.transpose() * (p_M - part->p_M_at);
  return std::array<double, 3>{p.x(), p.y(), p.z()};
}

std::vector<TouchRow> touches_of(const RunPage& run, const Meetings& meetings,
                                 const Writers& writers) {
  std::vector<TouchRow> rows;
  for (std::size_t i = 0; i < meetings.size(); ++i) {
    const runtime::TouchEvent& touch = run.recorder.touches()[i];
    TouchRow row;
    row.block = std::string(touch.block);
    row.place = place_at(run.sources.show(touch.where));
    row.time_s = touch.time_s;
    row.feed = touch.feed_mm_min;
    row.is_triggered = touch.triggered;
    row.commanded = linear(touch.view.q_L_commanded);
    row.latched = linear(touch.view.q_L);
    if (touch.contact) {
      row.part = touch.contact->part;
      row.contact =
          meetings[i].p_M_contact ? in_part(run, row.part, *meetings[i].p_M_contact) : std::nullopt;
    }
    row.deviation_mm = meetings[i].deviation_mm;
    row.angle_deg = meetings[i].angle_deg;
    row.caller = writers.caller_at(touch.time_s);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The main program first, then the others by name.
std::vector<Listing> listings_of(const RunPage& run) {
  std::vector<Listing> listings;
  for (const coverage::FileCoverage& file : run.result.coverage) {
    const auto text = run.sources.files().read(file.file);
    if (text) {
      const auto at = file.file == run.result.program ? listings.begin() : listings.end();
      listings.insert(
          at, {without_folder(file.file), source::as_utf8(*text), file.lines, file.conditions});
    }
  }
  return listings;
}

std::vector<VariableRow> variables_of(const RunPage& run) {
  std::vector<VariableRow> rows;
  for (const report::VariableHistory& history : run.result.chronicle->histories()) {
    VariableRow row;
    row.name = history.name;
    row.meaning = comment_of(run.sources.show(history.last_write).text);
    row.writes = history.writes;
    for (const auto& [time_s, value] : history.values) {
      const auto* const cell = std::get_if<runtime::Cell>(&value);
      const bool is_number = cell != nullptr && !cell->is_vacant();
      row.values.emplace_back(time_s, is_number ? std::optional(cell->raw()) : std::nullopt);
    }
    row.last = shown(history.values.back().second);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Printout> printouts_of(const RunPage& run) {
  std::vector<Printout> rows;
  if (!run.recorder.output().empty()) {
    rows.push_back({"", source::as_utf8(run.recorder.output()), {}});
  }
  for (const runtime::StopEvent& stop : run.recorder.stops()) {
    rows.push_back({stop.kind, source::as_utf8(stop.text), place_at(run.sources.show(stop.where))});
  }
  return rows;
}

std::vector<Input> inputs_of(const RunPage& run) {
  std::vector<Input> inputs;
  for (const report::InputFile& file : run.result.inputs) {
    const std::string ending = std::filesystem::path(file.file).extension().string();
    const bool is_shipped = file.file.starts_with("<g31>");
    const bool is_sheet = ending == ".toml" || ending == ".TOML";
    const bool is_ours = std::ranges::any_of(run.job.parts, [&](const parts::PartSetup& part) {
      return part.file.ends_with(file.file);
    });
    inputs.push_back({file.file,
                      is_sheet                          ? "set-up sheet"
                      : is_ours                         ? "part"
                      : is_shipped                      ? "program, comes with g31"
                      : file.file == run.result.program ? "program"
                                                        : "read by the run",
                      file.sha256});
  }
  return inputs;
}

std::vector<std::string> limits_of(const RunPage& run, const PictureMeshes& meshes) {
  std::vector<std::string> limits;
  if (run.job.probe) {
    const probe::ProbeSetup& probe = *run.job.probe;
    constexpr double kMsPerSecond = 1000.0;
    limits.push_back(fmt::format(
        "Probe as the sheet says: ball {} mm, signal {} ms late, scatter {} mm, pre-travel {} mm.",
        probe.ball_diameter_mm, probe.trigger_delay_s * kMsPerSecond, probe.repeatability_mm,
        probe.at_switch.pre_travel_mm));
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!meshes[i]) {
      limits.push_back(fmt::format("{} is not drawn: its {} triangles are too many for a page.",
                                   run.parts[i].name, run.parts[i].mesh_M->triangles.size()));
    }
  }
  limits.emplace_back(
      "Not simulated: cutting, chips, coolant, deformation of parts and machine by forces, and "
      "what the sheet does not name of the machine's errors.");
  if (std::ranges::any_of(run.result.inputs, [](const report::InputFile& file) {
        return file.file.starts_with("<g31>/macros/sinumerik");
      })) {
    limits.emplace_back(
        "The measuring cycles are g31's own, written after the published interface; they are not "
        "the maker's.");
  }
  return limits;
}

}  // namespace

std::string without_folder(const std::string& path) {
  return std::filesystem::path(path).filename().string();
}

Place place_at(const source::ShownPlace& place) {
  return {without_folder(place.file), place.line};
}

Report report_of(const RunPage& run, Language language) {
  const report::RunResult& result = run.result;
  const Writers writers(run);
  const Meetings meetings = meetings_of(run);
  const PictureMeshes meshes = meshes_for_picture(run);
  Report report;
  report.language = language;
  report.title = without_folder(result.program);
  report.what = result.control;
  report.results = results_of(run, writers);
  report.verdict = verdict_of(run, report.results);
  report.findings = findings_of(run);
  const auto fact = [&](Word name, std::string value) {
    report.facts.emplace_back(text_of(name, language), std::move(value));
  };
  fact(Word::Program, report.title);
  fact(Word::Control, result.control);
  std::string sheets;
  for (const std::string& sheet : run.job.sheets) {
    sheets += (sheets.empty() ? "" : " + ") + without_folder(sheet);
  }
  fact(Word::SetUp, sheets.empty() ? "–" : sheets);
  fact(Word::MachineTime, number(result.machine_time_s, 2) + " s");
  fact(Word::Blocks, std::to_string(result.outcome.blocks));
  fact(Word::Touches,
       fmt::format("{} / {}", run.recorder.touch_count(), run.recorder.touches().size()));
  fact(Word::Seed, std::to_string(result.seed));
  fact(Word::ExitCode, std::to_string(result.exit_code));
  fact(Word::Version, result.version);
  report.command = run.command;
  report.ending = ending_of(run);
  report.has_motion = !run.recorder.moves().empty() || !run.parts.empty();
  report.duration_s = result.machine_time_s;
  report.frame = text_of(Word::WorkCoordinates, language);
  report.touches = touches_of(run, meetings, writers);
  report.listings = listings_of(run);
  report.variables = variables_of(run);
  report.has_printouts = true;
  report.printouts = printouts_of(run);
  report.inputs = inputs_of(run);
  report.limits = limits_of(run, meshes);
  report::write_run_document(result, run.recorder, run.sources,
                             [&](std::string_view piece) { report.document += piece; });
  report.figures = figures_of(run, meetings, meshes, report);
  return report;
}

}  // namespace g31::page

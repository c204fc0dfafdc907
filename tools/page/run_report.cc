#include "tools/page/run_report.h"

#include <algorithm>
#include <utility>

#include <Eigen/Geometry>
#include <fmt/format.h>

#include "interpreter/runtime/overloaded.h"
#include "interpreter/source/file_system.h"
#include "interpreter/source/readable_text.h"
#include "parts/geometry/placement.h"
#include "tools/page/html.h"
#include "tools/page/run_parts.h"

namespace g31::page {
namespace {

std::array<double, 3> linear(const AxisPositions& q) {
  const Point p = linear_axes(q);
  return {p.x(), p.y(), p.z()};
}

std::vector<Finding> findings_of(const RunPage& run, const FileNames& names) {
  std::vector<Finding> findings;
  for (const source::Diagnostic& message : run.result.outcome.diagnostics) {
    findings.push_back(finding_of(message, names, run.sources));
  }
  std::ranges::stable_sort(findings, std::greater(), &Finding::severity);
  return findings;
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

std::vector<TouchRow> touches_of(const RunPage& run, const TouchGeometries& geometries,
                                 const Writers& writers, const FileNames& names) {
  std::vector<TouchRow> rows;
  for (std::size_t i = 0; i < geometries.size(); ++i) {
    const runtime::TouchEvent& touch = run.recorder.touches()[i];
    TouchRow row;
    row.block = std::string(touch.block);
    row.place = names.at(run.sources.show(touch.where));
    row.time_s = touch.time_s;
    row.feed = touch.feed_mm_min;
    row.is_triggered = touch.triggered;
    row.commanded = linear(touch.view.q_L_commanded);
    row.latched = linear(touch.view.q_L);
    if (touch.contact) {
      row.part = touch.contact->part;
      row.contact = geometries[i].p_M_contact ? in_part(run, row.part, *geometries[i].p_M_contact)
                                              : std::nullopt;
    }
    row.deviation_mm = geometries[i].deviation_mm;
    row.angle_deg = geometries[i].angle_deg;
    row.caller = writers.caller_at(touch.time_s);
    rows.push_back(std::move(row));
  }
  return rows;
}

/// The files that ran: the main program first, then the others by name.
std::vector<const coverage::FileCoverage*> files_that_ran(const RunPage& run) {
  std::vector<const coverage::FileCoverage*> files;
  for (const coverage::FileCoverage& file : run.result.coverage) {
    files.insert(file.file == run.result.program ? files.begin() : files.end(), &file);
  }
  return files;
}

FileNames names_of(const std::vector<const coverage::FileCoverage*>& files) {
  std::vector<std::string> paths;
  for (const coverage::FileCoverage* const file : files) {
    paths.push_back(file->file);
  }
  return FileNames(paths);
}

std::vector<Listing> listings_of(const RunPage& run, const FileNames& names) {
  std::vector<Listing> listings;
  for (const coverage::FileCoverage* const file : files_that_ran(run)) {
    if (const auto text = source::read_program(run.sources.files(), file->file)) {
      listings.push_back(
          {names.of(file->file), source::readable_text(*text), file->lines, file->conditions});
    }
  }
  return listings;
}

std::vector<VariableRow> variables_of(const RunPage& run, const Writers& writers) {
  std::vector<VariableRow> rows;
  for (const report::VariableHistory& history : run.result.chronicle->histories()) {
    VariableRow row;
    row.name = history.name;
    row.meaning = writers.meaning_of(history);
    row.writes = history.writes;
    for (const auto& [time_s, value] : history.values) {
      const auto* const cell = std::get_if<runtime::Cell>(&value);
      const bool is_number = cell != nullptr && !cell->is_vacant();
      row.values.emplace_back(time_s, is_number ? std::optional(cell->raw()) : std::nullopt);
    }
    row.last = shown_value(history.values.back().second);
    rows.push_back(std::move(row));
  }
  return rows;
}

std::vector<Printout> printouts_of(const RunPage& run, const FileNames& names) {
  std::vector<Printout> rows;
  if (!run.recorder.output().empty()) {
    rows.push_back({"", run.recorder.output(), {}});
  }
  for (const runtime::StopEvent& stop : run.recorder.stops()) {
    rows.push_back(
        {stop.kind, source::readable_text(stop.text), names.at(run.sources.show(stop.where))});
  }
  return rows;
}

}  // namespace

std::string shown_value(const runtime::ShownValue& value) {
  return std::visit(runtime::Overloaded{
                        [](runtime::Cell cell) {
                          return cell.is_vacant() ? std::string("–")
                                                  : fmt::format("{:.6g}", cell.raw());
                        },
                        [](const std::string& text) { return source::readable_text(text); },
                    },
                    value);
}

Report report_of(const RunPage& run, Language language) {
  const report::RunResult& result = run.result;
  const Writers writers(run);
  const FileNames names = names_of(files_that_ran(run));
  const TouchGeometries geometries = geometries_of(run);
  const PictureMeshes meshes = meshes_for_picture(run);
  Report report;
  report.language = language;
  report.title = without_folder(result.program);
  report.what = result.control;
  report.results = results_of(run, writers);
  report.verdict = verdict_of(run, report.results, language);
  report.findings = findings_of(run, names);
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
  report.ending = ending_of(run, names, language);
  report.has_motion = !run.recorder.moves().empty() || !run.parts.empty();
  report.duration_s = result.machine_time_s;
  report.frame = text_of(Word::WorkCoordinates, language);
  report.touches = touches_of(run, geometries, writers, names);
  report.listings = listings_of(run, names);
  add_listings_of_errors(run.result.outcome.diagnostics, names, run.sources, report.listings);
  report.variables = variables_of(run, writers);
  report.has_printouts = true;
  report.printouts = printouts_of(run, names);
  report.inputs = inputs_of(run, language);
  report.limits = limits_of(run, meshes, language);
  report::write_run_document(result, run.recorder, run.sources, {true, true, true},
                             [&](std::string_view piece) { report.document += piece; });
  report.figures =
      figures_of(run, {geometries, wall_shares(run, geometries, writers), meshes, names}, report);
  return report;
}

}  // namespace g31::page

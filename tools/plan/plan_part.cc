#include "tools/plan/plan_part.h"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <limits>
#include <system_error>
#include <utility>

#include <fmt/format.h>

#include "interpreter/runtime/time_budget.h"
#include "machine/base/utf_8.h"
#include "parts/features/recognise.h"
#include "parts/solids/removal.h"
#include "tools/disk/disk.h"
#include "tools/plan/plan_sheet.h"
#include "tools/plan/plan_touches.h"
#include "tools/plan/program_options.h"
#include "tools/plan/prove.h"
#include "tools/plan/round_cycles.h"
#include "tools/plan/stock_choice.h"
#include "tools/plan/touch_order.h"
#include "tools/session/prepare.h"
#include "tools/setup/toml_reader.h"

namespace g31::plan {
namespace {

namespace fs = std::filesystem;
using session::Control;
using session::Refusal;
using Wrong = std::optional<Refusal>;

/// A path as a file in another folder is to name it.
std::string seen_from(const std::string& folder, const std::string& path) {
  return fs::absolute(path)
      .lexically_normal()
      .lexically_relative(fs::absolute(folder).lexically_normal())
      .string();
}

class PartPlanner {
 public:
  explicit PartPlanner(const PlanRequest& request) : request_(request) {}

  Result<PlannedPart, Refusal> planned() {
    for (const auto step : {&PartPlanner::look_for_machined_part, &PartPlanner::find_features,
                            &PartPlanner::choose_control, &PartPlanner::write_sheet,
                            &PartPlanner::plan_touches_and_program, &PartPlanner::run_on_product,
                            &PartPlanner::run_on_machined_part}) {
      if (auto wrong = (this->*step)()) {
        return *std::move(wrong);
      }
    }
    return std::move(planned_);
  }

 private:
  /// Planning takes its time: a file that is not there is told before.
  Wrong look_for_machined_part() {
    const std::string& path = request_.as_machined;
    std::error_code ignored;
    return path.empty() || std::filesystem::exists(path, ignored)
               ? std::nullopt
               : Wrong(session::bad_input(
                     fmt::format("--as-machined {}: {}", path, disk::why_unreadable(path))));
  }

  Wrong find_features() {
    if (as_valid_utf_8(request_.product) != request_.product) {
      return session::bad_input(
          fmt::format("{}: the name is no UTF-8, which a set-up sheet has to be: give the file "
                      "another one",
                      as_valid_utf_8(request_.product)));
    }
    const auto stock = stock_choice(request_.stock);
    if (!stock) {
      return stock.error();
    }
    std::optional<Result<parts::Removal, std::string>> removal;
    try {
      removal = parts::removal_of(request_.product, stock.value(), [this] {
        request_.watch(PlanWork::Features, 0);
        return !runtime::is_interrupted(request_.interruption);
      });
    } catch (const parts::BrokenOff&) {
      return session::interrupted();
    }
    if (runtime::is_interrupted(request_.interruption)) {
      return session::interrupted();
    }
    if (!*removal) {
      return session::bad_input(removal->error());
    }
    planned_.product = fs::path(request_.product).filename().string();
    const parts::Removal& removed = removal->value();
    planned_.product_P = removed.product_P;
    planned_.part = parts::recognise(removed.stock_P, removed.volumes);
    planned_.part.dimensions = removed.dimensions;
    return std::nullopt;
  }

  Wrong choose_control() {
    std::vector<std::string> sheets;
    if (!request_.sheet.empty()) {
      sheets.push_back(request_.sheet);
    }
    const auto read = session::prepare(sheet_request(std::move(sheets)), disk_);
    if (!read) {
      return read.error();
    }
    control_ = read.value().control;
    planned_.control = session::name_of(*control_);
    planned_.program_file = std::holds_alternative<session::SinumerikControl>(*control_)
                                ? kSinumerikProgram
                                : kFanucProgram;
    return std::nullopt;
  }

  [[nodiscard]] session::Request sheet_request(std::vector<std::string> sheets) const {
    session::Request request;
    request.setups = std::move(sheets);
    request.control = request_.control;
    return request;
  }

  [[nodiscard]] std::string path(const std::string& name) const {
    return (fs::path(request_.folder) / name).string();
  }

  Wrong write(const std::string& name, const std::string& text) const {
    const auto why = disk::write_whole_file(path(name), text);
    return why ? Wrong(session::bad_input(*why)) : std::nullopt;
  }

  Wrong write_sheet() {
    const SheetContents contents{
        planned_.control, planned_.program_file,
        std::holds_alternative<session::SinumerikControl>(*control_),
        seen_from(request_.folder, request_.product),
        std::max(planned_.product_P.max.z(), planned_.part.stock_P.max.z())};
    if (request_.sheet.empty()) {
      return write(std::string(kSheetFile), usual_sheet(contents));
    }
    const auto sheet = sheet_with_product(request_.sheet, request_.folder, contents);
    return sheet ? write(std::string(kSheetFile), sheet.value()) : Wrong(sheet.error());
  }

  Wrong plan_touches_and_program() {
    const auto prepared = session::prepare(sheet_request({path(std::string(kSheetFile))}), disk_);
    if (!prepared) {
      return prepared.error();
    }
    const setup::Job& job = prepared.value().job;
    constexpr double kNoEnd = std::numeric_limits<double>::infinity();
    const runtime::TimeBudget time(kNoEnd, request_.interruption);
    const auto built = session::build_parts(job, &time);
    if (!built) {
      return not_built(job, built.error());
    }
    planned_.built = built.value();
    const auto touches = plan_touches(job, planned_.built, planned_, request_.tolerance_mm);
    if (!touches) {
      return touches.error();
    }
    planned_.plan = touches.value().plan;
    planned_.ball_radius_mm = touches.value().ball_radius_mm;
    const auto options = program_options(job, *control_, touches.value());
    if (!options) {
      return options.error();
    }
    options_ = options.value();
    options_.product = planned_.product;
    planned_.cycle = cycle_of(options_.language);
    if (request_.by_points) {
      give_up_cycles("as asked for", planned_.plan);
    }
    choose_cycles(job, options_, planned_.plan);
    put_in_order(planned_.plan);
    return write_program();
  }

  /// A product that is not read is what was given, not a mistake of the sheet made from it.
  [[nodiscard]] Refusal not_built(const setup::Job& job, const Refusal& refusal) const {
    for (std::size_t i = 0; i < job.parts.size(); ++i) {
      std::error_code unknown;
      for (const setup::SetupError& error : refusal.sheet_errors) {
        if (error.line == job.part_places[i].line &&
            fs::equivalent(job.parts[i].file, request_.product, unknown)) {
          return session::bad_input(error.message);
        }
      }
    }
    return refusal;
  }

  Wrong write_program() {
    planned_.program = inspection_program(planned_.plan, options_);
    return write(planned_.program_file, planned_.program.text);
  }

  [[nodiscard]] ProofRequest proof_request(PlanWork work) const {
    ProofRequest proof;
    proof.touched = [this, work] { request_.watch(work, planned_.program.touches); };
    proof.run = sheet_request({path(std::string(kSheetFile))});
    proof.run.programs = {path(planned_.program_file)};
    proof.interruption = request_.interruption;
    for (const PrintedMeasure& measure : planned_.program.measures) {
      proof.variables.push_back(measure.variable);
    }
    return proof;
  }

  Wrong run_on_product() {
    auto proof = proof_on_product();
    if (!proof) {
      return proof.error();
    }
    // Not every control, and not every sheet, has what the cycles take for granted.
    if (proof.value().ending != session::Ending::Completed &&
        !runtime::is_interrupted(request_.interruption) &&
        give_up_cycles(fmt::format("{} does not run here: {}", planned_.cycle,
                                   first_message(proof.value().messages)),
                       planned_.plan)) {
      if (auto wrong = write_program()) {
        return wrong;
      }
      proof = proof_on_product();
      if (!proof) {
        return proof.error();
      }
    }
    const Proof& run = proof.value();
    if (run.ending != session::Ending::Completed) {
      return Refusal{
          run.ending == session::Ending::Findings ? session::Ending::BadInput : run.ending,
          fmt::format("the program does not run against {} as it should; nothing is "
                      "written:\n{}",
                      planned_.product, run.messages)};
    }
    planned_.touches = run.touches;
    planned_.machine_time_s = run.machine_time_s;
    planned_.notes = run.messages;
    return take_values(run);
  }

  [[nodiscard]] Result<Proof, Refusal> proof_on_product() const {
    ProofRequest request = proof_request(PlanWork::Proof);
    request.parts = &planned_.built;
    return prove(request);
  }

  /// Without the place, which may be in a folder that is gone soon.
  static std::string first_message(const std::string& messages) {
    const std::string line = messages.substr(0, messages.find('\n'));
    constexpr std::string_view kBeforeText = "error: ";
    const std::size_t before = line.find(kBeforeText);
    return before == std::string::npos ? line : line.substr(before + kBeforeText.size());
  }

  /// Of the measures: from their variables, and from the printout where they do not stay there.
  Wrong take_values(const Proof& run) {
    const Judgement printed = judged(measures_of(planned_), run.printed);
    for (std::size_t i = 0; i < printed.measures.size(); ++i) {
      const JudgedMeasure& row = printed.measures[i];
      const bool stays = !planned_.program.measures[i].variable.empty();
      const auto value = stays ? run.values[i] : row.actual;
      if (!value || !row.actual) {
        return Refusal{session::Ending::Defect,
                       fmt::format("the program did not print {}", row.measure.id)};
      }
      planned_.proven_values.push_back(value);
      planned_.largest_deviation_mm =
          std::max(planned_.largest_deviation_mm, std::abs(*value - row.measure.nominal));
    }
    planned_.on_product = printed;
    return std::nullopt;
  }

  Wrong run_on_machined_part() {
    if (request_.as_machined.empty()) {
      return std::nullopt;
    }
    ProofRequest request = proof_request(PlanWork::ProofAsMachined);
    request.other_product = request_.as_machined;
    const auto proof = prove(request);
    if (!proof) {
      // The sheet has run before: it is the file.
      const setup::SetupErrors& errors = proof.error().sheet_errors;
      return session::bad_input(
          fmt::format("--as-machined {}: {}", request_.as_machined,
                      errors.empty() ? proof.error().message : errors.front().message));
    }
    planned_.as_machined = judged(measures_of(planned_), proof.value().printed);
    if (!planned_.measures_as_machined()) {
      planned_.notes += proof.value().messages;
    }
    return std::nullopt;
  }

  const PlanRequest& request_;
  disk::Disk disk_;
  std::optional<Control> control_;
  ProgramOptions options_;
  PlannedPart planned_;
};

}  // namespace

Result<PlannedPart, Refusal> plan_part(const PlanRequest& request) {
  return PartPlanner(request).planned();
}

}  // namespace g31::plan

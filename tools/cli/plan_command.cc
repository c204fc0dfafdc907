#include "tools/cli/plan_command.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/progress.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_page.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/disk/shipped.h"
#include "tools/plan/plan_document.h"
#include "tools/plan/plan_part.h"
#include "tools/plan/plan_sheet.h"
#include "tools/plan/plan_summary.h"
#include "tools/setup/job_files.h"
#include "tools/setup/toml_reader.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;
using session::Refusal;
using Wrong = std::optional<Refusal>;

constexpr std::string_view kPlanSchema = "g31.plan/1";

/// A folder beside another one, so that relative paths in its files hold there too; gone at its
/// end, as are those on the way to it that stay empty.
class FolderBeside {
 public:
  static Result<std::shared_ptr<FolderBeside>, Refusal> make(const std::string& folder) {
    std::string name = fs::absolute(folder).lexically_normal().string();
    while (name.size() > 1 && name.ends_with('/')) {
      name.pop_back();
    }
    std::vector<fs::path> on_the_way;
    std::error_code unmade;  // what is wrong then shows below
    for (fs::path way = fs::path(name).parent_path();
         !fs::exists(way, unmade) && way.has_filename(); way = way.parent_path()) {
      on_the_way.push_back(way);
    }
    fs::create_directories(fs::path(name).parent_path(), unmade);
    name += ".g31-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {
      return session::bad_input(
          fmt::format("-o {}: cannot make a folder beside it: {}; expected a name in a folder that "
                      "is there and can be written to",
                      folder, std::strerror(errno)));
    }
    return std::shared_ptr<FolderBeside>(new FolderBeside(name, std::move(on_the_way)));
  }
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;
  ~FolderBeside() {
    std::error_code gone;
    fs::remove_all(path_, gone);
    for (const fs::path& folder : on_the_way_) {
      fs::remove(folder, gone);  // unless something is in it now
    }
  }

  [[nodiscard]] std::string path(const std::string& name = {}) const {
    return name.empty() ? path_ : (fs::path(path_) / name).string();
  }

 private:
  FolderBeside(std::string path, std::vector<fs::path> on_the_way)
      : path_(std::move(path)), on_the_way_(std::move(on_the_way)) {}
  std::string path_;
  std::vector<fs::path> on_the_way_;  ///< made for it, the innermost first
};

/// How far planning is, on a terminal.
class PlanProgress {
 public:
  explicit PlanProgress(bool shows) : shows_(shows) {}

  /// @param touches  of the program; 0: not known
  void go_on(plan::PlanWork work, std::size_t touches) {
    if (!progress_ || work != work_) {
      end();
      work_ = work;
      progress_.emplace(touches, name_of(work), shows_);
    }
    progress_->one_done();
  }

  /// The line is gone until the work goes on.
  void end() { progress_.reset(); }

 private:
  static std::string name_of(plan::PlanWork work) {
    switch (work) {
      case plan::PlanWork::Features:
        return "looking for features";
      case plan::PlanWork::Proof:
        return "touches on the part as drawn";
      case plan::PlanWork::ProofAsMachined:
        return "touches on the part as machined";
      case plan::PlanWork::Page:
        return "touches for plan.html";
    }
    return {};
  }

  bool shows_;
  plan::PlanWork work_ = plan::PlanWork::Features;
  std::optional<Progress> progress_;
};

std::string command_of(const PlanOptions& options) {
  ShownCommand command("g31 plan");
  command.add(options.product);
  command.add("--stock", options.stock);
  command.add("-o", options.folder);
  command.add("--control", options.control);
  command.add("-s", options.setup);
  if (options.tolerance_mm) {
    command.add("--tolerance", fmt::format("{}", *options.tolerance_mm));
  }
  command.add("--as-machined", options.as_machined);
  if (options.by_points) {
    command.add("--point-by-point");
  }
  command.add("--json", options.json);
  command.add("--lang", language_given(options.language));
  return command.line();
}

ExitCode code_of_plan(const plan::PlannedPart& planned) {
  return planned.is_whole() ? ExitCode::Completed : ExitCode::Findings;
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The page of the run that proves the program, with what the plan adds.
std::string page_of(const PlanOptions& options, const plan::PlannedPart& planned,
                    const FolderBeside& folder, PlanProgress& progress) {
  std::string html;
  Watch watch;
  watch.take = [&html](std::string page) { html = std::move(page); };
  watch.looked = [](const std::string& /*path*/) {};
  watch.touched = [&] { progress.go_on(plan::PlanWork::Page, planned.program.touches); };
  RunOptions run;
  run.version = options.version;
  run.programs = {folder.path(planned.program_file)};
  run.setups = {folder.path(std::string(plan::kSheetFile))};
  run.control = options.control;
  run.language = options.language;
  run.parts = &planned.built;
  run.talk = Talk::Quiet;
  run.tells_findings = false;
  run.printer = "/dev/null";
  run.watch = &watch;
  run.budget.interruption = options.interruption;
  run.amend_page = [&](page::Report& report) {
    replace_all(report.document, folder.path(), fs::path(options.folder).string());
    for (page::Input& input : report.inputs) {
      input.file = fs::path(input.file).filename().string();  // where it was run says nothing
    }
    page::add_plan(planned, {command_of(options), static_cast<int>(code_of_plan(planned))}, report);
  };
  run_command(run);
  progress.end();
  return html;
}

/// Brings what was made where it is wanted, once all of it is made.
Wrong hand_over(const PlanOptions& options, const plan::PlannedPart& planned,
                const std::string& document, const std::string& html, const FolderBeside& made) {
  for (const auto& [name, text] : {std::pair("plan.html", &html), {"plan.json", &document}}) {
    if (auto unwritten = write_out(made.path(name), *text)) {
      replace_all(unwritten->message, made.path(), fs::path(options.folder).string());
      return unwritten;
    }
  }
  std::error_code wrong;
  const fs::path folder(options.folder);
  fs::create_directories(folder, wrong);
  const std::string program = planned.program_file;
  for (const std::string_view earlier : {plan::kFanucProgram, plan::kSinumerikProgram}) {
    // An earlier plan's program for the other language would be beside a plan that is not its own.
    if (!wrong && earlier != program && fs::exists(folder / "plan.json")) {
      fs::remove(folder / earlier, wrong);
    }
  }
  for (const std::string& name : {program, std::string(plan::kSheetFile), std::string("plan.html"),
                                  std::string("plan.json")}) {
    if (!wrong) {
      fs::rename(made.path(name), folder / name, wrong);
    }
  }
  return wrong
             ? Wrong(session::bad_input(fmt::format("-o {}: {}", options.folder, wrong.message())))
             : std::nullopt;
}

/// What to do with what was made, as a shell takes it.
std::string next_command(const PlanOptions& options, const plan::PlannedPart& planned) {
  const auto made = [&](const std::string& name) { return options.folder + "/" + name; };
  ShownCommand command("g31 run");
  command.add(made(planned.program_file));
  command.add("-s", made(std::string(plan::kSheetFile)));
  return "now: " + command.line() + "\n";
}

/// Plans in a folder whose files are handed over later; a refusal names the one that they get to.
Result<plan::PlannedPart, Refusal> plan_in(const FolderBeside& made, const PlanOptions& options,
                                           PlanProgress& progress) {
  plan::PlanRequest request;
  request.product = options.product;
  request.stock = options.stock;
  request.control = options.control;
  request.sheet = options.setup;
  request.tolerance_mm = options.tolerance_mm;
  request.as_machined = options.as_machined;
  request.by_points = options.by_points;
  request.folder = made.path();
  request.interruption = options.interruption;
  request.watch = [&progress](plan::PlanWork work, std::size_t touches) {
    progress.go_on(work, touches);
  };
  auto planned = plan::plan_part(request);
  progress.end();
  if (planned) {
    return planned;
  }
  const std::string folder = fs::path(options.folder).string();
  Refusal wrong = planned.error();
  replace_all(wrong.message, made.path(), folder);
  for (setup::SetupError& error : wrong.sheet_errors) {
    for (std::string* const text : {&error.file, &error.message}) {
      replace_all(*text, made.path(), folder);
    }
  }
  return wrong;
}

/// Files of an earlier plan are replaced, those of the user are not.
Wrong wrong_folder(const PlanOptions& options) {
  std::error_code unreadable;
  const fs::path folder(options.folder);
  if (fs::exists(folder, unreadable) && !fs::is_directory(folder, unreadable)) {
    return session::bad_input(fmt::format("-o {} is no folder", options.folder));
  }
  if (fs::exists(folder / "plan.json", unreadable)) {
    return std::nullopt;
  }
  for (const std::string_view name :
       {plan::kSheetFile, plan::kFanucProgram, plan::kSinumerikProgram}) {
    if (fs::exists(folder / name, unreadable)) {
      return session::bad_input(
          fmt::format("-o {}: {} is there already, and no plan.json of an earlier plan: it would "
                      "be replaced; expected a folder of its own",
                      options.folder, name));
    }
  }
  return std::nullopt;
}

std::vector<OutputPlace> plan_outputs(const PlanOptions& options) {
  std::vector<OutputPlace> outputs;
  for (const std::string_view name :
       {std::string_view("plan.json"), std::string_view("plan.html"), plan::kSheetFile,
        plan::kFanucProgram, plan::kSinumerikProgram}) {
    outputs.push_back({"-o", (fs::path(options.folder) / name).string()});
  }
  outputs.push_back({"--json", options.json, true});
  return outputs;
}

/// What a plan reads: files of the command line, and what the sheet names, as far as it can be
/// read: what is wrong with it is told by the planning.
InputLists read_by_plan(const PlanOptions& options) {
  InputLists read = {{options.product, options.stock, options.setup, options.as_machined}};
  if (!options.setup.empty()) {
    const auto job = setup::read_job(std::vector<std::string>{options.setup},
                                     disk::shipped_folder("machine/library").value_or(""));
    if (job) {
      read.push_back(setup::files_of(job.value()));
    }
  }
  return read;
}

}  // namespace

ExitCode plan_command(const PlanOptions& options) {
  const auto refused = [&options](const Refusal& wrong) {
    return refuse(wrong, options.json, kPlanSchema);
  };
  const std::vector<OutputPlace> outputs = plan_outputs(options);
  const InputLists read = read_by_plan(options);
  if (const auto wrong = wrong_outputs(outputs, read)) {
    return refuse(*wrong, sound_place("--json", outputs, read), kPlanSchema);
  }
  for (const auto& wrong : {wrong_folder(options), why_no_page("plan.html")}) {
    if (wrong) {
      return refused(*wrong);
    }
  }
  const auto made = FolderBeside::make(options.folder);
  if (!made) {
    return refused(made.error());
  }
  PlanProgress progress(shows_progress(options.is_quiet));
  const auto planned = plan_in(*made.value(), options, progress);
  if (!planned) {
    return refused(planned.error());
  }
  std::string notes = planned.value().notes;
  replace_all(notes, made.value()->path(), fs::path(options.folder).string());
  std::fputs(notes.c_str(), stderr);
  const std::string document = plan::plan_document(planned.value());
  const std::string html = page_of(options, planned.value(), *made.value(), progress);
  if (const auto wrong = hand_over(options, planned.value(), document, html, *made.value())) {
    return refused(*wrong);
  }
  const auto for_people = [&] {
    return plan::plan_summary(planned.value()) + next_command(options, planned.value());
  };
  if (const auto wrong = write_result(options.json, for_people, [&] { return document; })) {
    return refuse(*wrong);
  }
  return code_of_plan(planned.value());
}

}  // namespace g31::cli

#include "tools/cli/plan_command.h"

#include <cerrno>
#include <cstdlib>
#include <cstring>
#include <filesystem>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "tools/cli/interruption.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/run_command.h"
#include "tools/cli/run_page.h"
#include "tools/cli/shown_command.h"
#include "tools/cli/write_out.h"
#include "tools/plan/plan_document.h"
#include "tools/plan/plan_part.h"
#include "tools/plan/plan_sheet.h"
#include "tools/plan/plan_summary.h"

namespace g31::cli {
namespace {

namespace fs = std::filesystem;
using session::Refusal;
using Wrong = std::optional<Refusal>;

/// A folder beside another one, so that relative paths in its files hold there too; gone at its
/// end.
class FolderBeside {
 public:
  static Result<std::shared_ptr<FolderBeside>, Refusal> make(const std::string& folder) {
    std::string name = fs::absolute(folder).lexically_normal().string();
    while (name.size() > 1 && name.ends_with('/')) {
      name.pop_back();
    }
    name += ".g31-XXXXXX";
    if (::mkdtemp(name.data()) == nullptr) {
      return session::bad_input(
          fmt::format("-o {}: cannot make a folder beside it: {}; expected a name in a folder that "
                      "is there and can be written to",
                      folder, std::strerror(errno)));
    }
    return std::shared_ptr<FolderBeside>(new FolderBeside(name));
  }
  FolderBeside(const FolderBeside&) = delete;
  FolderBeside& operator=(const FolderBeside&) = delete;
  ~FolderBeside() {
    std::error_code gone;
    fs::remove_all(path_, gone);
  }

  [[nodiscard]] std::string path(const std::string& name = {}) const {
    return name.empty() ? path_ : (fs::path(path_) / name).string();
  }

 private:
  explicit FolderBeside(std::string path) : path_(std::move(path)) {}
  std::string path_;
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
  command.add("--lang", language_given(options.language));
  return command.line();
}

void replace_all(std::string& text, const std::string& from, const std::string& to) {
  for (std::size_t at = text.find(from); at != std::string::npos;
       at = text.find(from, at + to.size())) {
    text.replace(at, from.size(), to);
  }
}

/// The page of the run that proves the program, with what the plan adds.
std::string page_of(const PlanOptions& options, const plan::PlannedPart& planned,
                    const FolderBeside& folder) {
  std::string html;
  Watch watch;
  watch.take = [&html](std::string page) { html = std::move(page); };
  watch.looked = [](const std::string& /*path*/) {};
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
    page::add_plan(planned, command_of(options), report);
  };
  run_command(run);
  return html;
}

/// Brings what was made where it is wanted.
Wrong hand_over(const PlanOptions& options, const plan::PlannedPart& planned,
                const std::string& document, const std::string& html, const FolderBeside& made) {
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
  for (const std::string& name : {program, std::string(plan::kSheetFile)}) {
    if (!wrong) {
      fs::rename(made.path(name), folder / name, wrong);
    }
  }
  if (wrong) {
    return session::bad_input(fmt::format("-o {}: {}", options.folder, wrong.message()));
  }
  if (auto unwritten = write_out((folder / "plan.html").string(), html)) {
    return unwritten;
  }
  return write_out((folder / "plan.json").string(), document);
}

/// What to do with what was made, as a shell takes it.
std::string next_command(const PlanOptions& options, const plan::PlannedPart& planned) {
  const auto made = [&](const std::string& name) { return options.folder + "/" + name; };
  ShownCommand command("g31 run");
  command.add(made(planned.program_file));
  command.add("-s", made(std::string(plan::kSheetFile)));
  return "now: " + command.line() + "\n";
}

Wrong wrong_folder(const PlanOptions& options) {
  std::error_code unreadable;
  if (fs::exists(options.folder, unreadable) && !fs::is_directory(options.folder, unreadable)) {
    return session::bad_input(fmt::format("-o {} is no folder", options.folder));
  }
  std::vector<OutputPlace> outputs;
  for (const char* const name : {"plan.json", "plan.html", "setup.toml"}) {
    outputs.push_back({"-o", (fs::path(options.folder) / name).string()});
  }
  return wrong_place(outputs,
                     {{options.product, options.stock, options.setup, options.as_machined}});
}

}  // namespace

ExitCode plan_command(const PlanOptions& options) {
  for (const auto& wrong : {wrong_folder(options), why_no_page("plan.html")}) {
    if (wrong) {
      return refuse(*wrong);
    }
  }
  catch_termination();
  const auto made = FolderBeside::make(options.folder);
  if (!made) {
    return refuse(made.error());
  }
  plan::PlanRequest request;
  request.product = options.product;
  request.stock = options.stock;
  request.control = options.control;
  request.sheet = options.setup;
  request.tolerance_mm = options.tolerance_mm;
  request.as_machined = options.as_machined;
  request.by_points = options.by_points;
  request.folder = made.value()->path();
  request.interruption = options.interruption;
  const auto planned = plan::plan_part(request);
  if (!planned) {
    Refusal wrong = planned.error();
    const std::string folder = fs::path(options.folder).string();
    replace_all(wrong.message, made.value()->path(), folder);
    for (setup::SetupError& error : wrong.sheet_errors) {
      for (std::string* const text : {&error.file, &error.message}) {
        replace_all(*text, made.value()->path(), folder);
      }
    }
    return refuse(wrong);
  }
  std::string notes = planned.value().notes;
  replace_all(notes, made.value()->path(), fs::path(options.folder).string());
  std::fputs(notes.c_str(), stderr);
  const std::string document = plan::plan_document(planned.value());
  const std::string html = page_of(options, planned.value(), *made.value());
  if (const auto wrong = hand_over(options, planned.value(), document, html, *made.value())) {
    return refuse(*wrong);
  }
  const std::string summary = plan::plan_summary(planned.value());
  if (const auto wrong = write_out("-", summary + next_command(options, planned.value()))) {
    return refuse(*wrong);
  }
  const bool is_whole = !planned.value().leaves_something_out() && planned.value().is_proven() &&
                        planned.value().measures_as_machined();
  return is_whole ? ExitCode::Completed : ExitCode::Findings;
}

}  // namespace g31::cli

#include "tools/cli/view_command.h"

#include <chrono>
#include <deque>
#include <optional>
#include <thread>
#include <utility>

#include <fmt/format.h>
#include <nlohmann/json.hpp>

#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/run_expectations.h"
#include "tools/cli/run_page.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/session/prepare.h"
#include "tools/view/file_watch.h"
#include "tools/view/page_server.h"

namespace g31::cli {
namespace {

constexpr const char* kViewSchema = "g31.view/1";

/// How soon runs follow each other: four at once, and no more than that in two seconds.  An input
/// that is another one at each look, bad or good, keeps the computer busy no more than that.
class Pace {
 public:
  /// Returns when the next run may begin, or the view is to end.
  void wait(const runtime::Interruption* interruption) {
    constexpr std::size_t kAtOnce = 4;
    constexpr std::chrono::seconds kFor(2);
    constexpr std::chrono::milliseconds kBetweenLooks(50);
    while (begun_.size() >= kAtOnce && Clock::now() < begun_.front() + kFor &&
           !runtime::is_interrupted(interruption)) {
      std::this_thread::sleep_for(kBetweenLooks);
    }
    begun_.push_back(Clock::now());
    if (begun_.size() > kAtOnce) {
      begun_.pop_front();
    }
  }

 private:
  using Clock = std::chrono::steady_clock;
  std::deque<Clock::time_point> begun_;
};

/// Runs the program once in a thread of its own, until it has ended and something is saved, or the
/// view is to end.
void view_once(const ViewOptions& options, view::FileWatch& files, const Watch& watch,
               runtime::Interruption& interruption) {
  constexpr std::chrono::milliseconds kBetweenLooks(50);
  RunOptions run = options.run;
  run.talk = Talk::Quiet;
  run.watch = &watch;
  run.budget.interruption = &interruption;
  std::thread work([&run] { run_command(run); });
  while (!runtime::is_interrupted(options.interruption) && !files.has_changed()) {
    std::this_thread::sleep_for(kBetweenLooks);
  }
  interruption = true;
  if (!runtime::is_interrupted(options.interruption)) {
    files.wait_for_rest();
  }
  work.join();
}

/// What is wrong with words of the command line, whatever the files hold: no save mends it.
std::optional<session::Refusal> wrong_words(const RunOptions& run) {
  setup::Job of_no_sheet;
  disk::Disk disk;
  if (const auto control = session::named_control(run.control, of_no_sheet); !control) {
    return control.error();
  }
  if (auto wrong = session::take_variables(run.assignments, disk, of_no_sheet)) {
    return wrong;
  }
  const auto expectations = expectations_of(of_no_sheet, run.expects);
  return expectations ? std::nullopt : std::optional(expectations.error());
}

/// The document g31.view/1.
std::string document_of(const std::string& address) {
  const nlohmann::ordered_json document = {{"schema", kViewSchema}, {"address", address}};
  constexpr int kIndent = 2;
  return document.dump(kIndent) + "\n";
}

}  // namespace

ExitCode view_command(const ViewOptions& options) {
  if (const auto wrong = wrong_outputs({{"--json", options.json, true}},
                                       {options.run.programs, options.run.setups})) {
    return refuse(*wrong);
  }
  const auto refused = [&options](const session::Refusal& wrong) {
    return refuse(wrong, options.json, kViewSchema);
  };
  for (const auto& wrong : {wrong_words(options.run), why_no_page("g31 view")}) {
    if (wrong) {
      return refused(*wrong);
    }
  }
  const auto server = view::PageServer::open(options.port);
  if (!server) {
    return refused(session::bad_input(fmt::format("--port {}: {}", options.port, server.error())));
  }
  const std::string address = server.value()->address();
  if (const auto wrong = write_result(
          options.json, [&] { return address + "\n"; }, [&] { return document_of(address); })) {
    return refused(*wrong);  // nobody would know where it is
  }
  view::FileWatch files;
  for (const auto* const list : {&options.run.programs, &options.run.setups}) {
    for (const std::string& path : *list) {
      files.add(path);
    }
  }
  Pace pace;
  for (std::uint64_t edition = 1; !runtime::is_interrupted(options.interruption); ++edition) {
    pace.wait(options.interruption);
    runtime::Interruption interruption = false;
    files.begin();
    server.value()->work();
    const Watch watch{edition,
                      [&](std::string html) {
                        if (!interruption) {  // else what is shown would be of files of before
                          server.value()->show(edition, std::move(html));
                        }
                      },
                      [&](const std::string& path) { files.add(path); }};
    view_once(options, files, watch, interruption);
  }
  return ExitCode::Interrupted;
}

}  // namespace g31::cli

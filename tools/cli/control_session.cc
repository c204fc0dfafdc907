#include "tools/cli/control_session.h"

#include <filesystem>
#include <optional>
#include <system_error>

#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/session.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "tools/cli/disk.h"
#include "tools/cli/shipped.h"

namespace g31::cli {
namespace {

/// The programs, the folder of the first one, --lib and the shipped macros, in this order.
template <typename Library>
std::optional<Refusal> load_programs(Library& library, const RunOptions& options,
                                     const std::string& shipped) {
  for (const std::string& program : options.programs) {
    if (library.add_file(program) == Library::Added::Unreadable) {
      return refusal(ExitCode::BadUsage, fmt::format("cannot read the program {}", program));
    }
  }
  library.add_folder(std::filesystem::path(options.programs.front()).parent_path().string());
  for (const std::string& folder : options.libraries) {
    std::error_code unreadable;
    if (!std::filesystem::is_directory(folder, unreadable)) {
      return refusal(ExitCode::BadUsage, fmt::format("--lib {}: no such folder", folder));
    }
    library.add_folder(folder);
  }
  if (const auto folder = shipped_folder(shipped)) {
    library.add_folder(*folder);
  }
  return std::nullopt;
}

class FanucSession final : public ControlSession {
 public:
  FanucSession(const fanuc::Profile& profile, fanuc::ProgramLibrary& library,
               machine::MachinePort& port, runtime::Observer& observer)
      : session_(profile, library, port, observer) {}

  void connect(runtime::PrinterPort& printer) override { session_.connect(printer); }
  std::vector<std::string> configure(const runtime::ControlSetup& setup) override {
    return session_.configure(setup);
  }
  runtime::Outcome run(const runtime::Budget& budget) override { return session_.run(budget); }
  Result<runtime::ShownValue, std::string> variable(const std::string& name) override {
    const auto value = session_.variable(name);
    return value ? Result<runtime::ShownValue, std::string>(runtime::ShownValue(value.value()))
                 : value.error();
  }
  [[nodiscard]] std::map<std::string, double> permanent_variables() const override {
    return session_.permanent_variables();
  }
  [[nodiscard]] std::map<std::string, std::string> files() const override { return {}; }

 private:
  fanuc::Session session_;
};

/// Programs of a Fanuc control and the session that runs them.
struct FanucRun {
  Disk disk;
  fanuc::ProgramLibrary library{disk};
  std::optional<FanucSession> session;
};

class SinumerikSession final : public ControlSession {
 public:
  SinumerikSession() : library_(disk_) {}

  std::optional<Refusal> load(const RunOptions& options) {
    return load_programs(library_, options, "macros/sinumerik");
  }
  void open(machine::MachinePort& port, runtime::Observer& observer) {
    session_.emplace(library_, port, observer);
  }

  std::vector<std::string> configure(const runtime::ControlSetup& setup) override {
    return session_->configure(setup);
  }
  runtime::Outcome run(const runtime::Budget& budget) override { return session_->run(budget); }
  Result<runtime::ShownValue, std::string> variable(const std::string& name) override {
    return session_->variable(name);
  }
  [[nodiscard]] std::map<std::string, double> permanent_variables() const override {
    return session_->permanent_variables();
  }
  void give_files(const std::map<std::string, std::string>& files) override {
    session_->give_files(files);
  }
  [[nodiscard]] std::map<std::string, std::string> files() const override {
    return session_->files();
  }

 private:
  Disk disk_;
  sinumerik::ProgramLibrary library_;
  std::optional<sinumerik::Session> session_;
};

}  // namespace

std::optional<Refusal> fill_library(fanuc::ProgramLibrary& library, const RunOptions& options) {
  return load_programs(library, options, "macros/fanuc");
}

SessionPointer open_session(const fanuc::Profile& profile, fanuc::ProgramLibrary& library,
                            machine::MachinePort& port, runtime::Observer& observer) {
  return std::make_shared<FanucSession>(profile, library, port, observer);
}

Result<SessionPointer, Refusal> open_session(const ChosenControl& control,
                                             const RunOptions& options, machine::MachinePort& port,
                                             runtime::Observer& observer) {
  if (control.profile == nullptr) {
    auto session = std::make_shared<SinumerikSession>();
    if (const auto wrong = session->load(options)) {
      return *wrong;
    }
    session->open(port, observer);
    return SessionPointer(session);
  }
  const auto run = std::make_shared<FanucRun>();
  if (const auto wrong = fill_library(run->library, options)) {
    return *wrong;
  }
  run->session.emplace(*control.profile, run->library, port, observer);
  return SessionPointer(run, &*run->session);
}

}  // namespace g31::cli

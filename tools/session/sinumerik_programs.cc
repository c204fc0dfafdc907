#include "tools/session/sinumerik_programs.h"

#include <mutex>
#include <optional>
#include <utility>

#include "interpreter/dialects/sinumerik/code/library.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "tools/session/load_programs.h"

namespace g31::session {
namespace {

using Library = std::unique_ptr<sinumerik::ProgramLibrary>;

class SinumerikSession final : public Session {
 public:
  SinumerikSession(Library library, machine::MachinePort& machine, runtime::Observer& observer)
      : library_(std::move(library)), session_(*library_, machine, observer) {}

  std::vector<std::string> configure(const runtime::ControlSetup& setup) override {
    return session_.configure(setup);
  }
  runtime::Outcome run(const runtime::Budget& budget) override { return session_.run(budget); }
  Result<runtime::ShownValue, std::string> variable(const std::string& name) override {
    return session_.variable(name);
  }
  [[nodiscard]] std::map<std::string, double> permanent_variables() const override {
    return session_.permanent_variables();
  }
  void give_files(const std::map<std::string, std::string>& files) override {
    session_.give_files(files);
  }
  [[nodiscard]] std::map<std::string, std::string> files() const override {
    return session_.files();
  }

 private:
  Library library_;
  sinumerik::Session session_;
};

/// What programs define belongs to one session, so each reads them anew.
class SinumerikPrograms final : public Programs {
 public:
  SinumerikPrograms(ProgramPaths paths, source::FileSystem& files)
      : paths_(std::move(paths)), files_(files) {}

  std::unique_ptr<Session> session(machine::MachinePort& machine,
                                   runtime::Observer& observer) override {
    return std::make_unique<SinumerikSession>(take(), machine, observer);
  }

  /// @returns what cannot be read
  std::optional<Refusal> load_first() {
    first_ = std::make_unique<sinumerik::ProgramLibrary>(files_);
    return load(*first_);
  }

 private:
  std::optional<Refusal> load(sinumerik::ProgramLibrary& library) {
    return load_programs(library, paths_, files_, "macros/sinumerik");
  }
  Library take() {
    {
      const std::lock_guard lock(mutex_);
      if (first_ != nullptr) {
        return std::move(first_);
      }
    }
    auto library = std::make_unique<sinumerik::ProgramLibrary>(files_);
    // That every file can be read was seen when the programs were opened.
    (void)load(*library);
    return library;
  }

  ProgramPaths paths_;
  source::FileSystem& files_;
  std::mutex mutex_;
  Library first_;
};

}  // namespace

Result<std::shared_ptr<Programs>, Refusal> open_sinumerik_programs(const ProgramPaths& paths,
                                                                   source::FileSystem& files) {
  const auto programs = std::make_shared<SinumerikPrograms>(paths, files);
  if (const auto wrong = programs->load_first()) {
    return *wrong;
  }
  return std::shared_ptr<Programs>(programs);
}

}  // namespace g31::session

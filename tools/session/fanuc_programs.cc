#include "tools/session/fanuc_programs.h"

#include <mutex>
#include <optional>
#include <utility>

#include "interpreter/dialects/fanuc/code/library.h"
#include "interpreter/dialects/fanuc/code/program_windows.h"
#include "interpreter/dialects/fanuc/run/session.h"
#include "tools/session/load_programs.h"

namespace g31::session {
namespace {

using Library = std::unique_ptr<fanuc::ProgramLibrary>;

/// Libraries are for one session at a time: one that a session gave back serves the next.
class FanucPrograms final : public Programs {
 public:
  FanucPrograms(const fanuc::Profile& profile, ProgramPaths paths, source::FileSystem& files)
      : Programs(files), profile_(profile), paths_(std::move(paths)) {}

  std::unique_ptr<Session> session(machine::MachinePort& machine,
                                   runtime::Observer& observer) override;

  /// @returns what cannot be read
  std::optional<Refusal> load_first() {
    idle_.push_back(std::make_unique<fanuc::ProgramLibrary>(own_sources()));
    return load(*idle_.back());
  }
  [[nodiscard]] const fanuc::Profile& profile() const { return profile_; }
  void give_back(Library library);

 private:
  std::optional<Refusal> load(fanuc::ProgramLibrary& library) {
    return load_programs(library, paths_, own_sources().files(), "macros/fanuc");
  }
  Library take();

  const fanuc::Profile& profile_;
  ProgramPaths paths_;
  std::mutex mutex_;
  std::vector<Library> idle_;
};

Result<runtime::ShownValue, std::string> shown(const Result<runtime::Cell, std::string>& value) {
  return value ? Result<runtime::ShownValue, std::string>(runtime::ShownValue(value.value()))
               : value.error();
}

class FanucSession final : public Session {
 public:
  FanucSession(FanucPrograms& programs, Library library, machine::MachinePort& machine,
               runtime::Observer& observer)
      : programs_(programs), library_(std::move(library)) {
    session_.emplace(programs.profile(), *library_, machine, observer);
  }
  ~FanucSession() override {
    session_.reset();
    programs_.give_back(std::move(library_));
  }

  void connect(runtime::PrinterPort& printer) override { session_->connect(printer); }
  std::vector<runtime::RefusedSetting> configure(const runtime::ControlSetup& setup) override {
    return session_->configure(setup);
  }
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener) override {
    session_->begin(budget, listener);
  }
  runtime::Advance advance() override { return session_->advance(); }
  runtime::Outcome finish() override { return session_->finish(); }
  [[nodiscard]] std::unique_ptr<runtime::Keyframe> keyframe() const override {
    return session_->keyframe();
  }
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const override {
    return session_->call_levels();
  }
  runtime::NamedValues values(std::size_t level, runtime::Scope scope) override {
    return session_->values(level, scope);
  }
  Result<runtime::ShownValue, std::string> evaluate(std::size_t level,
                                                    const std::string& text) override {
    return shown(session_->evaluate(level, text));
  }
  std::optional<std::string> wrong_name(const std::string& name) override {
    const auto value = session_->variable(name);
    return value ? std::nullopt : std::optional(value.error());
  }
  Result<runtime::ShownValue, std::string> variable(const std::string& name) override {
    return shown(session_->variable(name));
  }
  [[nodiscard]] std::optional<double> work_offset(const std::string& name,
                                                  int axis) const override {
    return session_->work_offset(name, axis);
  }
  [[nodiscard]] runtime::Cell unset_number() const override { return {}; }
  [[nodiscard]] std::map<std::string, runtime::TableValue> tables() const override {
    return session_->tables();
  }
  [[nodiscard]] std::map<std::string, double> permanent_variables() const override {
    return session_->permanent_variables();
  }
  [[nodiscard]] const std::map<std::string, std::string>& files() const override {
    return no_files_;
  }

 private:
  FanucPrograms& programs_;
  Library library_;
  std::optional<fanuc::Session> session_;
  const std::map<std::string, std::string> no_files_;
};

std::unique_ptr<Session> FanucPrograms::session(machine::MachinePort& machine,
                                                runtime::Observer& observer) {
  return std::make_unique<FanucSession>(*this, take(), machine, observer);
}

Library FanucPrograms::take() {
  {
    const std::lock_guard lock(mutex_);
    if (!idle_.empty()) {
      Library library = std::move(idle_.back());
      idle_.pop_back();
      return library;
    }
  }
  auto library = std::make_unique<fanuc::ProgramLibrary>(own_sources());
  // That every file can be read was seen when the programs were opened.
  (void)load(*library);
  return library;
}

void FanucPrograms::give_back(Library library) {
  // A program in windows can be gone through once only.
  const bool is_long =
      own_sources().files().size(paths_.programs.front()).value_or(0) > fanuc::kWholeFileBytes;
  if (!is_long) {
    const std::lock_guard lock(mutex_);
    idle_.push_back(std::move(library));
  }
}

}  // namespace

Result<std::shared_ptr<Programs>, Refusal> open_fanuc_programs(const FanucControl& control,
                                                               const ProgramPaths& paths,
                                                               source::FileSystem& files) {
  const auto programs = std::make_shared<FanucPrograms>(control.profile, paths, files);
  if (const auto wrong = programs->load_first()) {
    return *wrong;
  }
  return std::shared_ptr<Programs>(programs);
}

}  // namespace g31::session

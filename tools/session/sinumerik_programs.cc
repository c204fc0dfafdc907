#include "tools/session/sinumerik_programs.h"

#include "interpreter/dialects/sinumerik/code/library.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "tools/session/load_programs.h"

namespace g31::session {
namespace {

class SinumerikSession final : public Session {
 public:
  SinumerikSession(sinumerik::ProgramLibrary& library, machine::MachinePort& machine,
                   runtime::Observer& observer)
      : session_(library, machine, observer) {}

  std::vector<std::string> configure(const runtime::ControlSetup& setup) override {
    return session_.configure(setup);
  }
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener) override {
    session_.begin(budget, listener);
  }
  runtime::Advance advance() override { return session_.advance(); }
  runtime::Outcome finish() override { return session_.finish(); }
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const override {
    return session_.call_levels();
  }
  runtime::NamedValues values(std::size_t level, runtime::Scope scope) override {
    return session_.values(level, scope);
  }
  Result<runtime::ShownValue, std::string> evaluate(std::size_t level,
                                                    const std::string& text) override {
    return session_.evaluate(level, text);
  }
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
  sinumerik::Session session_;
};

class SinumerikPrograms final : public Programs {
 public:
  explicit SinumerikPrograms(source::FileSystem& files)
      : Programs(files), library_(own_sources()) {}

  sinumerik::ProgramLibrary& library() { return library_; }

  std::unique_ptr<Session> session(machine::MachinePort& machine,
                                   runtime::Observer& observer) override {
    return std::make_unique<SinumerikSession>(library_, machine, observer);
  }

 private:
  sinumerik::ProgramLibrary library_;
};

}  // namespace

Result<std::shared_ptr<Programs>, Refusal> open_sinumerik_programs(const ProgramPaths& paths,
                                                                   source::FileSystem& files) {
  const auto programs = std::make_shared<SinumerikPrograms>(files);
  if (const auto wrong = load_programs(programs->library(), paths, files, "macros/sinumerik")) {
    return *wrong;
  }
  return std::shared_ptr<Programs>(programs);
}

}  // namespace g31::session

#include "tools/session/sinumerik_programs.h"

#include "interpreter/dialects/sinumerik/code/library.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "interpreter/source/readable_text.h"
#include "tools/session/load_programs.h"

namespace g31::session {
namespace {

class SinumerikSession final : public Session {
 public:
  SinumerikSession(sinumerik::ProgramLibrary& library, machine::MachinePort& machine,
                   runtime::Observer& observer)
      : session_(library, machine, observer) {}

  std::vector<runtime::RefusedSetting> configure(const runtime::ControlSetup& setup) override {
    return session_.configure(setup);
  }
  void begin(const runtime::Budget& budget, runtime::BlockListener* listener) override {
    session_.begin(budget, listener);
  }
  runtime::Advance advance() override { return session_.advance(); }
  runtime::Outcome finish() override { return session_.finish(); }
  [[nodiscard]] std::unique_ptr<runtime::Keyframe> keyframe() const override {
    return session_.keyframe();
  }
  [[nodiscard]] std::vector<runtime::CallLevel> call_levels() const override {
    return session_.call_levels();
  }
  runtime::NamedValues values(std::size_t level, runtime::Scope scope) override {
    return session_.values(level, scope);
  }
  runtime::NamedValues values_at_start() override { return session_.values_at_start(); }
  Result<runtime::ShownValue, std::string> evaluate(std::size_t level,
                                                    const std::string& text) override {
    return session_.evaluate(level, text);
  }
  std::optional<std::string> wrong_name(const std::string& name) override {
    auto wrong = session_.wrong_expression(name);
    if (wrong && name.starts_with('#')) {
      *wrong += ": variables of this control are called R1, _OVR[4] or $AA_MW[X]";
    }
    return wrong;
  }
  Result<runtime::ShownValue, std::string> variable(const std::string& name) override {
    return session_.variable(name);
  }
  [[nodiscard]] std::optional<double> work_offset(const std::string& name,
                                                  int axis) const override {
    return session_.work_offset(name, axis);
  }
  [[nodiscard]] runtime::Cell unset_number() const override { return runtime::Cell(0.0); }
  [[nodiscard]] std::map<std::string, runtime::TableValue> tables() const override {
    return session_.tables();
  }
  [[nodiscard]] std::map<std::string, double> permanent_variables() const override {
    return session_.permanent_variables();
  }
  void give_files(const std::map<std::string, std::string>& files) override {
    session_.give_files(files);
  }
  [[nodiscard]] const std::map<std::string, std::string>& files() const override {
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

/// As archives that a panel saves whole.
bool is_binary(source::FileSystem& files, const std::string& path) {
  constexpr std::size_t kBeginning = 4096;
  const auto beginning = files.read_part(path, 0, kBeginning);
  return beginning && source::is_no_text(*beginning);
}

}  // namespace

Result<std::shared_ptr<Programs>, Refusal> open_sinumerik_programs(
    const ProgramPaths& paths, source::FileSystem& files, const runtime::ControlSetup& setup) {
  for (const std::string& program : paths.programs) {
    if (is_binary(files, program)) {
      return bad_input(
          fmt::format("{}: a binary file, no program text; save the archive as text (on the panel: "
                      "ASCII or punched tape format), or take the programs out of it",
                      program));
    }
  }
  const auto programs = std::make_shared<SinumerikPrograms>(files);
  programs->library().expect_data(setup.data);
  programs->library().expect_axes(setup.axis_names);
  if (const auto wrong = load_programs(programs->library(), paths, files, "macros/sinumerik")) {
    return *wrong;
  }
  return std::shared_ptr<Programs>(programs);
}

}  // namespace g31::session

// Programs of both dialects through tools/session alone, without a command line.

#include <string>
#include <thread>
#include <vector>

#include <gtest/gtest.h>

#include "interpreter/runtime/observer.h"
#include "machine/base/contract.h"
#include "machine/sim/machining_centre.h"
#include "tests/support/control_run.h"
#include "tests/support/run_program.h"
#include "tools/disk/disk.h"
#include "tools/session/manual.h"
#include "tools/session/prepare.h"
#include "tools/session/run.h"
#include "tools/session/world.h"

namespace g31::session::session_test {
namespace {

using testing::FilesInMemory;
using testing::TemporaryFolder;

/// A number by its name; NaN where there is none.
double number_of(Session& session, const std::string& name) {
  const auto value = session.variable(name);
  const auto* const cell = value.ok() ? std::get_if<runtime::Cell>(&value.value()) : nullptr;
  return cell != nullptr && !cell->is_vacant() ? cell->raw() : std::nan("");
}

/// What each dialect's part of a test is called by.
struct Dialect {
  const char* control;
  const char* file;
};
constexpr Dialect kFanuc{"fanuc-30i", "main.nc"};
constexpr Dialect kSinumerik{"sinumerik-828d", "MAIN.MPF"};

/// A program in memory, run over a machine without anything around it.
class RunInMemory {
 public:
  RunInMemory(const Dialect& dialect, std::map<std::string, std::string> files,
              const setup::Job& job = {})
      : files_(std::move(files)), machine_(job.machine, nullptr) {
    const auto programs =
        open_programs(control_named(dialect.control).value(), {{dialect.file}}, files_);
    EXPECT_TRUE(programs.ok());
    programs_ = programs.value();
    const auto run = Run::open(job, *programs_, machine_, nobody_);
    EXPECT_TRUE(run.ok()) << (run.ok() ? "" : render(run.error()));
    run_ = run.value();
    outcome_ = run_->session().run({});
  }
  [[nodiscard]] Ending ending() const { return ending_of(outcome_); }
  [[nodiscard]] double value(const std::string& name) { return number_of(run_->session(), name); }
  [[nodiscard]] const Run& run() const { return *run_; }
  [[nodiscard]] std::size_t level_count() const { return run_->session().call_levels().size(); }
  [[nodiscard]] double machine_time_s() const { return machine_.time_s(); }

 private:
  FilesInMemory files_;
  runtime::Observer nobody_;
  machine::MachiningCentre machine_;
  std::shared_ptr<Programs> programs_;
  std::shared_ptr<Run> run_;
  runtime::Outcome outcome_;
};

TEST(Session, RunsAFanucProgramFromMemory) {
  setup::Job job;
  job.control.variables["#110"] = 5.0;
  RunInMemory run(
      kFanuc,
      {{"main.nc", "O0001\n#100=#110*2\nG91G01X3.F60.\nM98P2\nM30\nO0002\n#101=#100+1\nM99\n"}},
      job);
  EXPECT_EQ(run.ending(), Ending::Completed);
  EXPECT_DOUBLE_EQ(run.value("#101"), 11.0);
  EXPECT_GT(run.machine_time_s(), 3.0);  // 3 mm at 60 mm/min, and the acceleration
}

TEST(Session, RunsASinumerikProgramFromMemory) {
  setup::Job job;
  job.control.variables["R10"] = 5.0;
  RunInMemory run(kSinumerik,
                  {{"MAIN.MPF",
                    "%_N_MAIN_MPF\nDEF INT ERROR\nR1=R10*2\nG91 G1 X3 F60\nSUB(4)\n"
                    "WRITE(ERROR,\"LOG\",\"R2=\"<<R2)\nM30\n"
                    "%_N_SUB_SPF\nPROC SUB(REAL A)\nR2=R1+A\nM17\n"}},
                  job);
  EXPECT_EQ(run.ending(), Ending::Completed);
  EXPECT_DOUBLE_EQ(run.value("R2"), 14.0);
  EXPECT_GT(run.machine_time_s(), 3.0);
  const auto written = run.run().changed_files();
  ASSERT_EQ(written.size(), 1U);
  EXPECT_NE(written.begin()->second.find("R2=14"), std::string::npos) << written.begin()->second;
}

TEST(Session, AnAlarmIsAnEndingOfItsOwn) {
  EXPECT_EQ(RunInMemory(kFanuc, {{"main.nc", "O0001\n#3000=1(NO)\nM30\n"}}).ending(),
            Ending::Alarm);
  EXPECT_EQ(RunInMemory(kSinumerik, {{"MAIN.MPF", "SETAL(65000)\nM30\n"}}).ending(), Ending::Alarm);
  EXPECT_EQ(RunInMemory(kFanuc, {{"main.nc", "O0001\nG31X1.F100\n#1=#5061\nM30\n"}}).ending(),
            Ending::Findings);
}

TEST(Session, WhatHasNotBegunHasNoLevelsToLookInto) {
  struct Case {
    const char* name;
    const char* text;
    Ending ending;
  };
  const Case kCases[] = {
      {"no program at all", "", Ending::BadInput},
      {"an alarm in a definition file", "%_N_MGUD_DEF\nDEF CHAN REAL LAST\nG77\n%_N_MAIN_MPF",
       Ending::Alarm},
      {"an alarm in a program that a definition file calls",
       "%_N_UGUD_DEF\nSUB\n%_N_SUB_SPF\nPROC SUB\nDEF REAL OWN\nG77\nM17\n%_N_MAIN_MPF\nM30\n",
       Ending::Alarm},
  };
  for (const Case& c : kCases) {
    SCOPED_TRACE(c.name);
    RunInMemory run(kSinumerik, {{"MAIN.MPF", c.text}});
    EXPECT_EQ(run.ending(), c.ending);
    EXPECT_EQ(run.value("R3"), 0.0);
    EXPECT_EQ(run.level_count(), 0U);
    EXPECT_EQ(run.value("R4"), 0.0) << "the first look has left nothing";
  }
  EXPECT_EQ(RunInMemory(kFanuc, {{"main.nc", ""}}).level_count(), 0U);
}

/// A box whose wall towards -X stands at X = 50, and a ball of 6 mm.
constexpr const char* kSheet = R"([probe]
ball_diameter = 6.0
length = 100.0
[[part]]
name = "box"
shape = "block"
height = 40.0
at = [80.0, 0.0, 0.0]
)";

/// Prepares, builds the world and runs; @returns the value of `name`
double measured(const Request& request, const std::string& name) {
  disk::Disk disk;
  const auto prepared = prepare(request, disk);
  EXPECT_TRUE(prepared.ok()) << (prepared.ok() ? "" : render(prepared.error()));
  const auto world = build_world(prepared.value().job, request.seed);
  EXPECT_TRUE(world.ok()) << (world.ok() ? "" : render(world.error()));
  const auto programs = open_programs(prepared.value().control, request, disk);
  EXPECT_TRUE(programs.ok()) << (programs.ok() ? "" : render(programs.error()));
  runtime::Observer nobody;
  const auto run =
      Run::open(prepared.value().job, *programs.value(), *world.value().machine, nobody);
  EXPECT_TRUE(run.ok()) << (run.ok() ? "" : render(run.error()));
  EXPECT_EQ(ending_of(run.value()->session().run({})), Ending::Completed);
  EXPECT_EQ(run.value()->keep_state(), std::nullopt);
  return number_of(run.value()->session(), name);
}

TEST(Session, MeasuresAWallInBothDialects) {
  const TemporaryFolder folder;
  Request request;
  request.setups = {folder.write("sheet.toml", kSheet)};
  request.programs = {folder.write("wall.nc", "O0001\nG90G53G0Z80.\nG53X0Y0\nG31X60.F100\nM30\n")};
  // The ball's centre is 3 mm before the wall.
  EXPECT_NEAR(measured(request, "#5061"), 47.0, 1e-6);
  request.programs = {folder.write("WALL.MPF", "G53 G0 Z80\nG53 X0 Y0\nMEAS=1 G1 X60 F100\nM30\n")};
  EXPECT_NEAR(measured(request, "$AA_MM[X]"), 47.0, 1e-6);
}

TEST(Session, KeepsVariablesAndFilesForTheNextRun) {
  const TemporaryFolder folder;
  std::filesystem::create_directory(folder.path("files"));
  Request request;
  request.setups = {
      folder.write("sheet.toml", "[control]\nvariables_file = \"kept.txt\"\nfiles = \"files\"\n")};
  request.programs = {folder.write(
      "COUNT.MPF", "DEF INT ERROR\nR5=R5+1\nWRITE(ERROR,\"COUNTED\",\"ONCE\")\nM30\n")};
  EXPECT_EQ(measured(request, "R5"), 1.0);
  EXPECT_EQ(measured(request, "R5"), 2.0);
  request.assignments = {"R5=7"};
  EXPECT_EQ(measured(request, "R5"), 8.0);
  EXPECT_EQ(testing::text_of(folder.path("kept.txt")), "R5=8\n");
  EXPECT_FALSE(std::filesystem::is_empty(folder.path("files")));
}

TEST(Session, ManySessionsOfOneProgramRunAtATime) {
  for (const Dialect& dialect : {kFanuc, kSinumerik}) {
    SCOPED_TRACE(dialect.control);
    const bool is_fanuc = dialect.control == kFanuc.control;
    const std::string in = is_fanuc ? "#100" : "R100";
    const std::string out = is_fanuc ? "#101" : "R101";
    FilesInMemory files({{"main.nc",
                          "O0001\n#1=0\nWHILE[#1LT200]DO1\nM98P2\n#1=#1+1\nEND1\nM30\nO0002\n#101=#"
                          "101+#100\nM99\n"},
                         {"MAIN.MPF",
                          "%_N_MAIN_MPF\nDEF INT I\nFOR I=1 TO 200\nSUB(R100)\nENDFOR\nM30\n"
                          "%_N_SUB_SPF\nPROC SUB(REAL A)\nEXECSTRING(\"R101=R101+\"<<A)\nM17\n"}});
    const auto programs =
        open_programs(control_named(dialect.control).value(), {{dialect.file}}, files);
    ASSERT_TRUE(programs.ok());
    std::vector<double> sums(8, 0.0);
    const auto run_one = [&](std::size_t which) {
      for (int round = 0; round < 5; ++round) {
        runtime::Observer nobody;
        machine::MachiningCentre machine({}, nullptr);
        const auto session = programs.value()->session(machine, nobody);
        runtime::ControlSetup setup;
        setup.variables = {{in, static_cast<double>(which + 1)}, {out, 0.0}};
        EXPECT_TRUE(session->configure(setup).empty());
        EXPECT_EQ(ending_of(session->run({})), Ending::Completed);
        sums[which] += number_of(*session, out);
      }
    };
    std::vector<std::thread> threads;
    for (std::size_t i = 0; i < sums.size(); ++i) {
      threads.emplace_back(run_one, i);
    }
    for (std::thread& thread : threads) {
      thread.join();
    }
    for (std::size_t i = 0; i < sums.size(); ++i) {
      EXPECT_EQ(sums[i], 5.0 * 200.0 * static_cast<double>(i + 1)) << i;
    }
  }
}

TEST(Session, EveryControlRunsAProgramOfItsDialect) {
  FilesInMemory files({{"main.nc", "O0001\nM30\n"}, {"MAIN.MPF", "M30\n"}});
  for (const Dialect& dialect : {kFanuc, kSinumerik}) {
    const auto control = control_named(dialect.control);
    ASSERT_TRUE(control.ok());
    EXPECT_EQ(name_of(control.value()), dialect.control);
    EXPECT_TRUE(open_programs(control.value(), {{dialect.file}}, files).ok());
  }
  EXPECT_EQ(name_of(default_control()), "fanuc-16i");
}

TEST(Session, TheControlIsThatOfRequestSheetEndingOrText) {
  FilesInMemory files({{"a.nc", "%_N_A_MPF\nM30\n"}, {"b.nc", "O0001\n"}, {"c.Mpf", ""}});
  Request request;
  setup::Job job;
  const auto chosen = [&](const std::string& program) {
    request.programs = {program};
    return std::string(name_of(chosen_control(request, job, files).value()));
  };
  EXPECT_EQ(chosen("a.nc"), "sinumerik-828d");
  EXPECT_EQ(chosen("b.nc"), "fanuc-16i");
  EXPECT_EQ(chosen("c.Mpf"), "sinumerik-828d");
  job.control.profile = "haas";
  EXPECT_EQ(chosen("a.nc"), "haas");
  request.control = "fanuc-0i";
  EXPECT_EQ(chosen("a.nc"), "fanuc-0i");
}

TEST(Session, RefusalsSayWhatIsWrongAndWhere) {
  const TemporaryFolder folder;
  disk::Disk disk;
  Request request;
  request.control = "fanuc-30j";
  const auto unknown = prepare(request, disk);
  ASSERT_FALSE(unknown.ok());
  EXPECT_EQ(unknown.error().ending, Ending::Setup);
  EXPECT_NE(unknown.error().message.find("did you mean 'fanuc-30i'"), std::string::npos);

  request.control = "";
  request.setups = {folder.write("profile.toml", "[control]\nprofile = \"fanuc-30j\"\n")};
  const auto in_sheet = prepare(request, disk);
  ASSERT_FALSE(in_sheet.ok());
  EXPECT_EQ(in_sheet.error().ending, Ending::Setup);
  ASSERT_EQ(in_sheet.error().sheet_errors.size(), 1U);
  EXPECT_EQ(in_sheet.error().sheet_errors.front().line, 2);

  request.control = "fanuc-30i";
  request.setups = {folder.write("sheet.toml", "[probe]\nball_diametre = 6.0\n")};
  const auto sheet = prepare(request, disk);
  ASSERT_FALSE(sheet.ok());
  EXPECT_EQ(sheet.error().ending, Ending::BadInput);
  ASSERT_EQ(sheet.error().sheet_errors.size(), 1U);
  EXPECT_EQ(sheet.error().sheet_errors.front().line, 2);

  request.setups = {
      folder.write("part.toml", "[probe]\n[[part]]\nname = \"a\"\nfile = \"no.stl\"\n")};
  const auto part = prepare(request, disk);
  const auto refused =
      part.ok() ? build_world(part.value().job, 0) : Result<World, Refusal>(part.error());
  ASSERT_FALSE(refused.ok());
  EXPECT_EQ(refused.error().ending, Ending::Setup);
  EXPECT_EQ(refused.error().sheet_errors.front().line, 4);

  const Control control = control_named("fanuc-30i").value();
  const auto missing = open_programs(control, {{folder.path("none.nc")}}, disk);
  ASSERT_FALSE(missing.ok());
  EXPECT_EQ(missing.error().ending, Ending::BadInput);
  EXPECT_EQ(render(missing.error()),
            "g31: error: cannot read the program " + folder.path("none.nc") + ": no such file\n");
  const std::string program = folder.write("a.nc", "O0001\nM30\n");
  const auto library = open_programs(control, {{program}, {folder.path("none")}}, disk);
  ASSERT_FALSE(library.ok());
  EXPECT_EQ(library.error().ending, Ending::BadInput);

  setup::Job job;
  job.control.work_offsets["G77"] = AxisPositions::Zero();
  machine::MachiningCentre machine({}, nullptr);
  runtime::Observer nobody;
  const auto run =
      Run::open(job, *open_programs(control, {{program}}, disk).value(), machine, nobody);
  ASSERT_FALSE(run.ok());
  EXPECT_EQ(run.error().ending, Ending::Setup);
}

TEST(Session, WordsOfAProgramTellItsControlWhereItsEndingDoesNot) {
  for (const char* const program :
       {"T=\"PROBE\" D1 M6\nM30\n", "G54\nCYCLE973(1,,,1,3,60,3,8,,,,,1,1)\nM30\n",
        "MSG(\"A\")\nM30\n", "G0 SUPA Z0 D0\nM30\n", "DIAMON\nG0 X1\nM30\n",
        "; drawing #12\nDEF REAL A\nM30\n"}) {
    EXPECT_EQ(name_of(control_of_program("p.nc", program)), "sinumerik-828d") << program;
  }
  for (const char* const program :
       {"O1\nG65 P9810 X1.\nM30\n", "(CYCLE 977, DIAMOND TIP, SUPA1)\nG0 X1.\nM30\n",
        "O1\n#100=1;(MSG()\nM30\n"}) {
    EXPECT_EQ(name_of(control_of_program("p.nc", program)), name_of(default_control())) << program;
  }
}

TEST(Session, TheManualKnowsBothDialects) {
  const Control fanuc = control_named("fanuc-30i").value();
  const Control sinumerik = control_named("sinumerik-828d").value();
  EXPECT_FALSE(explain("#5061", fanuc).empty());
  EXPECT_TRUE(explain("#5061", sinumerik).empty());
  EXPECT_FALSE(explain("$AA_MW", sinumerik).empty());
  const auto other = suggestion_for("$AA_MW", fanuc).other_control;
  ASSERT_TRUE(other.has_value());
  EXPECT_EQ(name_of(*other), "sinumerik-828d");
}

}  // namespace
}  // namespace g31::session::session_test

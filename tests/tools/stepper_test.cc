// Every program of tests/conformance block by block: the run pauses before each block, all
// variables are read, expressions are evaluated, and it is what a run without a listener is; steps
// back are runs again up to an earlier block, where the control holds what it held there.

#include "tests/support/stepper.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <utility>
#include <vector>

#include <gtest/gtest.h>

#include "tests/support/conformance_run.h"
#include "tests/support/effort.h"
#include "tests/support/temporary_folder.h"

namespace g31::stepper_test {
namespace {

using runtime::Advance;
using testing::ConformanceCase;
using testing::Pauses;
using testing::SteppedRun;

/// Loops of a million blocks are looked at for this long.
const std::uint64_t kMostPauses = testing::of_many(300U);
const runtime::Budget kBudget = {testing::of_many(200'000U), 20.0};

struct Dialect {
  std::string folder;
  std::string ending;
  std::vector<std::string> expressions;  ///< some can be evaluated everywhere, some nowhere
};

const Dialect kFanuc = {"tests/conformance/fanuc",
                        ".nc",
                        {"#1+#100*2", "#500 EQ #0", "#5041", "#5061", "#3001", "#4001", "1/0"}};
const Dialect kSinumerik = {
    "tests/conformance/sinumerik",
    ".mpf",
    {"R1+2*R2", "R1==R2", "$AA_IW[X]", "$AA_MW[X]", "$P_EP[Y]", "$P_TOOLNO", "NO_SUCH_NAME"}};

/// A pause of a run: what can be seen, and all that the control holds.
struct Pause {
  std::string shown;
  std::unique_ptr<runtime::Keyframe> kept;
};

/// The pauses of a run; it stands at its end behind.  Being looked at changes nothing.
std::vector<Pause> pauses_of(SteppedRun& run, const std::vector<std::string>& expressions) {
  std::vector<Pause> pauses;
  while (run.session().advance() == Advance::Paused) {
    auto kept = run.session().keyframe();
    std::string shown = run.state(expressions);
    EXPECT_TRUE(*kept == *run.session().keyframe()) << shown;
    pauses.push_back({std::move(shown), std::move(kept)});
  }
  return pauses;
}

/// Some blocks to step back to: the last but one, the middle, the first.
std::vector<std::size_t> steps_back(std::size_t count) {
  if (count < 2) {
    return {};
  }
  return count < 4 ? std::vector<std::size_t>{count - 2}
                   : std::vector<std::size_t>{count - 2, count / 2, 0};
}

void expect_steps(const session::Request& request, const Dialect& dialect,
                  const std::string& place) {
  SCOPED_TRACE(place);
  SteppedRun plain(request, nullptr, kBudget);
  if (!plain.refused().empty()) {
    return;  // a set-up that the control does not understand
  }
  EXPECT_EQ(plain.session().advance(), Advance::Ended);
  const std::string result = plain.result();

  Pauses each = Pauses::at_each(kMostPauses);
  SteppedRun stepped(request, &each, kBudget);
  const std::vector<Pause> pauses = pauses_of(stepped, dialect.expressions);
  EXPECT_EQ(stepped.result(), result);

  for (const std::size_t index : steps_back(pauses.size())) {
    Pauses there = Pauses::at({index + 1});
    SteppedRun again(request, &there, kBudget);
    const std::vector<Pause> back = pauses_of(again, dialect.expressions);
    ASSERT_EQ(back.size(), 1U);
    EXPECT_EQ(back.front().shown, pauses[index].shown);
    EXPECT_TRUE(*back.front().kept == *pauses[index].kept) << pauses[index].shown;
    EXPECT_EQ(again.result(), result);
  }
}

/// #100 to #999 and the R parameters: what a level does not change, and programs alone write; codes
/// that call leave their numbers in #146 to #149.
bool is_common(const std::string& name) {
  if (name >= "#146" && name <= "#149") {
    return false;
  }
  const bool is_digit = name.size() > 1 && name[1] >= '0' && name[1] <= '9';
  return is_digit && (name[0] == 'R' || (name[0] == '#' && name.size() == 4));
}

/// What a listener hears of writes is how the common variables change.
void expect_writes(const session::Request& request, const std::string& place) {
  SCOPED_TRACE(place);
  testing::WatchedVariables watched(kMostPauses);
  SteppedRun run(request, &watched, kBudget);
  if (!run.refused().empty()) {
    return;
  }
  bool is_first = true;
  while (run.session().advance() == Advance::Paused) {
    std::map<std::string, std::string> found;
    for (const auto& [name, value] : run.session().values(0, runtime::Scope::Common)) {
      if (is_common(name)) {
        found[name] = testing::shown(value);
      }
    }
    if (std::exchange(is_first, false)) {
      watched.values = found;
    }
    for (const auto& [name, value] : found) {
      // Through a VAR parameter it is written under the name of the parameter.
      const bool by_parameter =
          std::ranges::any_of(watched.events, [&now = value](const auto& event) {
            return !is_common(event.name) && testing::shown(event.now) == now;
          });
      EXPECT_TRUE(watched.values[name] == value || by_parameter)
          << name << " is " << value << ", heard was " << watched.values[name];
      watched.values[name] = value;
    }
    watched.events.clear();
    for (const auto& [name, value] : watched.values) {
      if (is_common(name) && !found.contains(name)) {
        EXPECT_TRUE(value == "vacant" || value == "0") << name << " = " << value;
      }
    }
  }
}

void expect_file_steps(const std::string& name, const Dialect& dialect) {
  const std::string path = dialect.folder + "/" + name + dialect.ending;
  const auto cases = testing::read_conformance_file(path);
  ASSERT_TRUE(cases) << cases.error();
  for (const ConformanceCase& test : testing::some_of(cases.value())) {
    const testing::TemporaryFolder folder;
    session::Request request;
    request.programs = {folder.write("case" + dialect.ending, test.program)};
    request.setups = {folder.write("sheet.toml", testing::sheet_of(test))};
    request.control = test.controls.empty() ? "" : test.controls.front();
    if (dialect.ending == kSinumerik.ending) {
      request.control = "sinumerik-828d";
    }
    expect_steps(request, dialect, path + ": " + test.title.text);
    expect_writes(request, path + ": " + test.title.text);
  }
}

class FanucSteps : public ::testing::TestWithParam<std::string> {};
TEST_P(FanucSteps, MeetAPlainRun) {
  expect_file_steps(GetParam(), kFanuc);
}
INSTANTIATE_TEST_SUITE_P(Fanuc, FanucSteps, ::testing::ValuesIn(testing::case_files(kFanuc.folder)),
                         [](const auto& test) { return test.param; });

class SinumerikSteps : public ::testing::TestWithParam<std::string> {};
TEST_P(SinumerikSteps, MeetAPlainRun) {
  expect_file_steps(GetParam(), kSinumerik);
}
INSTANTIATE_TEST_SUITE_P(Sinumerik, SinumerikSteps,
                         ::testing::ValuesIn(testing::case_files(kSinumerik.folder)),
                         [](const auto& test) { return test.param; });

}  // namespace
}  // namespace g31::stepper_test

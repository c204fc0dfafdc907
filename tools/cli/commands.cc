#include "tools/cli/commands.h"

#include <CLI/CLI.hpp>

#include "tools/cli/check_options.h"
#include "tools/cli/evaluate_options.h"
#include "tools/cli/explain_options.h"
#include "tools/cli/judge_options.h"
#include "tools/cli/new_options.h"
#include "tools/cli/pages_command.h"
#include "tools/cli/plan_options.h"
#include "tools/cli/run_options.h"
#include "tools/cli/scene_options.h"
#include "tools/cli/setup_options.h"
#include "tools/cli/study_options.h"
#include "tools/cli/view_options.h"

namespace g31::cli {
namespace {

constexpr bool kLasts = true;
constexpr bool kIsShort = false;

constexpr CommandRow kCommands[] = {
    {"run", "Run an NC program on the simulated machine.", kLasts, "g31.run/1",
     [](CLI::App& command, Options& options) { add_run_options(command, options.run); },
     run_examples,
     [](const Options& options, const WordsOfAll&) { return run_command(options.run); }},
    {"view", "Show the run of an NC program in a browser, anew whenever a file of it is saved.",
     kLasts, "g31.view/1",
     [](CLI::App& command, Options& options) { add_view_options(command, options.view); },
     view_examples,
     [](const Options& options, const WordsOfAll&) { return view_command(options.view); }},
    {"explain",
     "Say what a variable, code, alarm, parameter, function, statement, key of a set-up sheet, "
     "shape, control, message or exit code means; other words are looked for in all texts.",
     kIsShort, "g31.explain/1",
     [](CLI::App& command, Options& options) { add_explain_options(command, options.explain); },
     explain_examples,
     [](const Options& options, const WordsOfAll&) { return explain_command(options.explain); }},
    {"scene",
     "Run an NC program and write parts, ways and touches as a glTF 2.0 scene or a picture.  What "
     "[expect] of a sheet says is judged by g31 run.",
     kLasts, "g31.scene/1",
     [](CLI::App& command, Options& options) { add_scene_options(command, options.scene); },
     scene_examples,
     [](const Options& options, const WordsOfAll&) { return scene_command(options.scene); }},
    {"study",
     "Run a program many times, with varied set-ups, and report statistics.  What [expect] of a "
     "sheet says is judged by g31 run.",
     kLasts, "g31.study/1",
     [](CLI::App& command, Options& options) { add_study_options(command, options.study); },
     study_examples,
     [](const Options& options, const WordsOfAll&) { return study_command(options.study); }},
    {"check", "Say what is wrong with NC programs without running them: all of it at once.", kLasts,
     "g31.check/1",
     [](CLI::App& command, Options& options) { add_check_options(command, options.check); },
     check_examples,
     [](const Options& options, const WordsOfAll&) { return check_command(options.check); }},
    {"setup",
     "Say what is wrong with set-up sheets, and how they fit a program, without running it.",
     kIsShort, "g31.setup/1",
     [](CLI::App& command, Options& options) { add_setup_options(command, options.setup); },
     setup_examples,
     [](const Options& options, const WordsOfAll&) { return setup_command(options.setup); }},
    {"new", "Make a folder with a measuring program that runs, its set-up sheet and a CI file.",
     kIsShort, "g31.new/1",
     [](CLI::App& command, Options& options) { add_new_options(command, options.starter); },
     new_examples,
     [](const Options& options, const WordsOfAll&) { return new_command(options.starter); }},
    {"evaluate", "Say what a recorded motion or a file of readings shows about a machine.", kLasts,
     "g31.evaluation/1",
     [](CLI::App& command, Options& options) { add_evaluate_options(command, options.evaluate); },
     evaluate_examples,
     [](const Options& options, const WordsOfAll&) { return evaluate_command(options.evaluate); }},
    {"plan", "Make a probing program for a part from its CAD model, run against it before.", kLasts,
     "g31.plan/1",
     [](CLI::App& command, Options& options) { add_plan_options(command, options.plan); },
     plan_examples,
     [](const Options& options, const WordsOfAll&) { return plan_command(options.plan); }},
    {"judge", "Compare what an inspection program printed with its plan: good, bad, missing.",
     kLasts, "g31.judgement/1",
     [](CLI::App& command, Options& options) { add_judge_options(command, options.judge); },
     judge_examples,
     [](const Options& options, const WordsOfAll&) { return judge_command(options.judge); }},
    {"completion", "Print a script by which a shell completes what is typed for g31.", kIsShort, "",
     [](CLI::App& command, Options& options) { add_completion_options(command, options.pages); },
     completion_examples,
     [](const Options& options, const WordsOfAll& words) {
       return completion_command(words(), options.pages);
     }},
    {"manual", "Print a page of the manual in the language of man.", kIsShort, "",
     [](CLI::App& command, Options& options) { add_manual_options(command, options.pages); },
     manual_examples,
     [](const Options& options, const WordsOfAll& words) {
       return manual_command(words(), options.pages);
     }},
};

}  // namespace

std::span<const CommandRow> commands() {
  return kCommands;
}

}  // namespace g31::cli

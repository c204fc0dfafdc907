#include "tools/cli/scene_command.h"

#include <optional>
#include <string>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/runtime/observer.h"
#include "tools/cli/messages.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/gltf/gltf_document.h"
#include "tools/picture/pictured_part.h"
#include "tools/picture/tip.h"
#include "tools/picture/way_recorder.h"
#include "tools/session/heard.h"
#include "tools/session/run.h"
#include "tools/session/world.h"

namespace g31::cli {
namespace {

std::optional<gltf::GltfForm> form_of(std::string_view path) {
  if (path.ends_with(".glb")) {
    return gltf::GltfForm::Binary;
  }
  return path.ends_with(".gltf") ? std::optional(gltf::GltfForm::Text) : std::nullopt;
}

}  // namespace

ExitCode scene_command(const SceneOptions& options) {
  const auto form = form_of(options.output);
  if (!form) {
    return refuse(session::bad_input(
        fmt::format("-o {}: a scene is a .glb or a .gltf file", options.output)));
  }
  disk::Disk disk;
  const auto prepared = session::prepare(options.run, disk);
  if (!prepared) {
    return refuse(prepared.error());
  }
  const setup::Job& job = prepared.value().job;
  const session::Control& control = prepared.value().control;
  runtime::TimeBudget time(options.run.budget.wall_seconds, options.run.budget.interruption);
  const auto world = session::build_world(job, options.run.seed, &time);
  if (!world) {
    return refuse(world.error());
  }
  runtime::OutputBudget output(options.run.max_output);
  picture::WayRecorder recorder(*world.value().machine, job.machine, picture::tip_of(job), output);
  runtime::Observer nobody;
  const auto programs = session::open_programs(control, options.run, disk, job.control);
  if (!programs) {
    return refuse(programs.error());
  }
  const auto run = session::Run::open(job, *programs.value(), recorder, nobody);
  if (!run) {
    return refuse(run.error());
  }
  runtime::Budget budget = options.run.budget;
  budget.output = &output;
  budget.wall_seconds = time.left_s();
  session::ProgramComments comments(disk, control);
  const runtime::Outcome outcome =
      session::heard(
          session::with_findings(world.value().findings, run.value()->session().run(budget)),
          comments, options.run.programs.front(), {}, programs.value()->sources())
          .outcome;
  print_diagnostics(outcome, programs.value()->sources());
  if (outcome.status == runtime::Status::SyntaxError) {
    return ExitCode::BadUsage;
  }
  const std::string document =
      gltf::gltf_document(picture::parts_of(world.value()),
                          {recorder.ways(), recorder.contacts(), recorder.collisions()}, *form);
  if (const auto wrong = write_out(options.output, document)) {
    return refuse(*wrong);
  }
  return exit_code_of(session::ending_of(outcome));
}

}  // namespace g31::cli

#include "tools/cli/scene_command.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/runtime/observer.h"
#include "tools/cli/messages.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/gltf/gltf_document.h"
#include "tools/gltf/path_recorder.h"
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

/// From the spindle gauge point to the ball's centre; without a probe the gauge point is drawn.
Point drawn_tip(const setup::Job& job) {
  if (!job.probe) {
    return Point::Zero();
  }
  const auto& [x, y] = job.probe->eccentricity_mm;
  return {x, y, -job.probe->length_mm};
}

std::vector<gltf::PicturedPart> pictured(const session::World& world) {
  std::vector<gltf::PicturedPart> parts;
  for (const probe::ProbedPart& part : world.parts) {
    parts.push_back({part.name, &part.mesh_M});
  }
  return parts;
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
  gltf::PathRecorder recorder(*world.value().machine, job.machine, drawn_tip(job), output);
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
      gltf::gltf_document(pictured(world.value()), recorder.trace(), *form);
  if (const auto wrong = write_out(options.output, document)) {
    return refuse(*wrong);
  }
  return exit_code_of(session::ending_of(outcome));
}

}  // namespace g31::cli

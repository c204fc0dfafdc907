#include "tools/cli/scene_command.h"

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/runtime/observer.h"
#include "tools/cli/control_session.h"
#include "tools/cli/run_preparation.h"
#include "tools/cli/scene.h"
#include "tools/disk/disk.h"
#include "tools/gltf/gltf_document.h"
#include "tools/gltf/path_recorder.h"

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

std::vector<gltf::PicturedPart> pictured(const Scene& scene) {
  std::vector<gltf::PicturedPart> parts;
  for (const probe::ProbedPart& part : scene.parts) {
    parts.push_back({part.name, &part.mesh_M});
  }
  return parts;
}

}  // namespace

ExitCode scene_command(const SceneOptions& options) {
  const auto form = form_of(options.output);
  if (!form) {
    return refuse(refusal(ExitCode::BadUsage,
                          fmt::format("-o {}: a scene is a .glb or a .gltf file", options.output)));
  }
  const auto prepared = prepare(options.run);
  if (!prepared) {
    return refuse(prepared.error());
  }
  const setup::Job& job = prepared.value().job;
  const auto scene = build_scene(job, options.run.seed);
  if (!scene) {
    return refuse({ExitCode::Setup, setup::render(scene.error())});
  }
  gltf::PathRecorder recorder(*scene.value().machine, drawn_tip(job));
  runtime::Observer nobody;
  const auto opened = open_session(prepared.value().control, options.run, recorder, nobody);
  if (!opened) {
    return refuse(opened.error());
  }
  ControlSession& session = *opened.value();
  if (const auto refused = session.configure(job.control); !refused.empty()) {
    return refuse(refusal(ExitCode::Setup, fmt::format("{}", fmt::join(refused, "; "))));
  }
  const runtime::Outcome outcome = session.run(options.run.budget);
  print_diagnostics(outcome);
  if (outcome.status == runtime::Status::SyntaxError) {
    return ExitCode::BadUsage;
  }
  const std::string document =
      gltf::gltf_document(pictured(scene.value()), recorder.trace(), *form);
  if (const auto problem = disk::write_whole_file(options.output, document)) {
    return refuse(refusal(ExitCode::BadUsage, *problem));
  }
  return exit_code_of(outcome);
}

}  // namespace g31::cli

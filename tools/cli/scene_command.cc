#include "tools/cli/scene_command.h"

#include <algorithm>
#include <cstdint>
#include <functional>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include <fmt/format.h>

#include "interpreter/runtime/observer.h"
#include "machine/base/letters.h"
#include "tools/cli/messages.h"
#include "tools/cli/output_places.h"
#include "tools/cli/refusal_document.h"
#include "tools/cli/status_line.h"
#include "tools/cli/svg_to_png.h"
#include "tools/cli/write_out.h"
#include "tools/disk/disk.h"
#include "tools/disk/remembering_disk.h"
#include "tools/disk/waiting.h"
#include "tools/gltf/gltf_document.h"
#include "tools/picture/pictured_part.h"
#include "tools/picture/still.h"
#include "tools/picture/stylus_shape.h"
#include "tools/picture/way_recorder.h"
#include "tools/session/heard.h"
#include "tools/session/run.h"
#include "tools/session/world.h"
#include "tools/setup/job_files.h"

namespace g31::cli {
namespace {

constexpr std::string_view kSceneSchema = "g31.scene/1";

/// What the end of the file's name says; empty: nothing that g31 writes.
std::string_view form_of(std::string_view path) {
  const std::string small = in_small_letters(path);
  const auto form =
      std::ranges::find_if(kSceneForms, [&](std::string_view end) { return small.ends_with(end); });
  return form == kSceneForms.end() ? std::string_view() : *form;
}

/// Why nothing can be written there whatever the run comes to.
std::optional<session::Refusal> refused(const SceneOptions& options) {
  const std::string_view form = form_of(options.output);
  if (form.empty()) {
    return session::bad_input(fmt::format(
        "-o {}: a scene is a .glb or a .gltf file, a picture of it a .svg or a .png file",
        options.output));
  }
  const bool is_picture = form == ".svg" || form == ".png";
  if (!is_picture && (options.width || options.theme)) {
    return session::bad_input(fmt::format(
        "-o {}: --width and --theme are of a picture, a .svg or a .png file", options.output));
  }
  if (form == ".png" && !has_svg_drawer()) {
    return session::bad_input(
        fmt::format("-o {}: {} draws it and is not installed (Debian: librsvg2-bin); a .svg file "
                    "needs nothing more",
                    options.output, kSvgDrawer));
  }
  return std::nullopt;
}

picture::StillScene still_of(const setup::Job& job, const picture::WayRecorder& recorder) {
  picture::StillScene scene;
  scene.ways = recorder.ways();
  scene.contacts = recorder.contacts();
  scene.collisions = recorder.collisions();
  scene.has_y = job.machine.axes[1].present;
  scene.last = recorder.shown();
  scene.tip_radius_mm = picture::tip_radius(job, scene.last.tool);
  return scene;
}

std::string file_name(const std::string& path) {
  return path.substr(path.find_last_of('/') + 1);
}

/// The file that was asked for.
Result<std::string, session::Refusal> document_of(const SceneOptions& options,
                                                  const setup::Job& job,
                                                  const session::World& world,
                                                  const picture::WayRecorder& recorder) {
  const std::string_view form = form_of(options.output);
  picture::StillScene scene = still_of(job, recorder);
  const auto parts = picture::parts_of(world, job, scene.last.q_M);
  const auto stylus = picture::stylus_shape(job, scene.last.tool);
  if (form == ".glb" || form == ".gltf") {
    return gltf::gltf_document(
        parts,
        {scene.ways, scene.contacts, scene.collisions, stylus, scene.last, recorder.is_of_part()},
        form == ".glb" ? gltf::GltfForm::Binary : gltf::GltfForm::Text);
  }
  scene.title = file_name(options.run.programs.front());
  scene.parts = parts;
  scene.stylus = stylus;
  const std::string svg = picture::still_svg(
      scene, {options.width.value_or(picture::StillLook{}.width),
              options.theme == "dark" ? picture::Theme::Dark : picture::Theme::Light});
  if (form == ".svg") {
    return svg;
  }
  const auto png = svg_to_png(svg);
  if (!png) {
    return session::bad_input(fmt::format("-o {}: {}", options.output, png.error()));
  }
  return png.value().bytes;
}

/// Says how the run ended: on standard error, and in the document where one is asked for.
/// @returns why that could not be written
std::optional<session::Refusal> tell(const SceneOptions& options, const runtime::Outcome& outcome,
                                     ExitCode code, const source::SourceMap& sources) {
  print_diagnostics(outcome, sources);
  const std::string& json = options.run.json;
  if (json.empty()) {
    return std::nullopt;
  }
  auto unwritten = why_not_replaced("--json", json);
  return unwritten ? unwritten : write_out(json, document_of(outcome, code, kSceneSchema, sources));
}

/// A program that has run for a scene.
struct DoneRun {
  const setup::Job& job;
  const session::World& world;
  const picture::WayRecorder& recorder;
  const runtime::Outcome& outcome;
  const source::SourceMap& sources;
};

/// Writes the scene of a program that could be read, and how its run ended.
Result<ExitCode, session::Refusal> deliver(const SceneOptions& options, const DoneRun& done) {
  const bool is_unreadable = done.outcome.status == runtime::Status::SyntaxError;
  const ExitCode code =
      is_unreadable ? ExitCode::BadUsage : exit_code_of(session::ending_of(done.outcome));
  if (!is_unreadable) {
    const auto document = document_of(options, done.job, done.world, done.recorder);
    if (!document) {
      return document.error();
    }
    if (const auto wrong = write_out(options.output, document.value())) {
      return *wrong;
    }
  }
  const auto wrong = tell(options, done.outcome, code, done.sources);
  return wrong ? Result<ExitCode, session::Refusal>(*wrong) : code;
}

std::vector<OutputPlace> scene_outputs(const SceneOptions& options) {
  return {{"-o", options.output, true}, {"--json", options.run.json, true}};
}

/// @param read  gets what is read beside the files of the command line
Result<ExitCode, session::Refusal> do_scene(const SceneOptions& options, InputLists& read) {
  if (const auto wrong = refused(options)) {
    return *wrong;
  }
  disk::Disk real_disk;
  disk::RememberingDisk disk(real_disk);
  const auto prepared = session::prepare(options.run, disk);
  if (!prepared) {
    return prepared.error();
  }
  const setup::Job& job = prepared.value().job;
  const session::Control& control = prepared.value().control;
  read.push_back(setup::files_of(job));
  if (const auto wrong = wrong_place(scene_outputs(options), read)) {
    return *wrong;
  }
  runtime::TimeBudget time(options.run.budget.wall_seconds, options.run.budget.interruption);
  const auto world = session::build_world(job, options.run.seed, &time);
  if (!world) {
    return world.error();
  }
  runtime::OutputBudget output(options.run.max_output);
  picture::WayRecorder recorder(*world.value().machine, job, output);
  runtime::Observer nobody;
  const auto programs = session::open_programs(control, options.run, disk, job.control);
  if (!programs) {
    return programs.error();
  }
  const auto run = session::Run::open(job, *programs.value(), recorder, nobody);
  if (!run) {
    return run.error();
  }
  runtime::Budget budget = options.run.budget;
  budget.output = &output;
  budget.wall_seconds = time.left_s();
  StatusLine line(shows_progress(options.is_quiet));
  const std::function<void(std::uint64_t)> progress = [&](std::uint64_t blocks) {
    show_run(line, blocks, recorder.time_s());
  };
  budget.progress = &progress;
  session::ProgramComments comments(disk, control);
  const runtime::Outcome outcome =
      session::heard(
          session::with_findings(world.value().findings, run.value()->session().run(budget)),
          comments, options.run.programs.front(), {}, programs.value()->sources())
          .outcome;
  line.clear();
  // Which programs are called shows while it runs.
  read.push_back(disk.paths());
  if (const auto wrong = wrong_place(scene_outputs(options), read)) {
    return *wrong;
  }
  return deliver(options, {job, world.value(), recorder, outcome, programs.value()->sources()});
}

}  // namespace

ExitCode scene_command(const SceneOptions& options) {
  const disk::WaitingLimit limit(options.run.budget.wall_seconds);
  const std::vector<OutputPlace> outputs = scene_outputs(options);
  InputLists read = {options.run.programs, options.run.setups};
  const auto refused = [&](const session::Refusal& wrong) {
    return refuse(wrong, sound_place("--json", outputs, read), kSceneSchema);
  };
  if (const auto wrong = wrong_outputs(outputs, read)) {
    return refused(*wrong);
  }
  const auto done = do_scene(options, read);
  return done ? done.value() : refused(done.error());
}

}  // namespace g31::cli

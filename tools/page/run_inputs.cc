#include <algorithm>
#include <filesystem>

#include "tools/page/run_parts.h"
#include "tools/page/said.h"

namespace g31::page {
namespace {

constexpr std::string_view kShipped = "<g31>";

Word kind_of(const report::InputFile& file, const RunPage& run) {
  const std::string ending = std::filesystem::path(file.file).extension().string();
  if (ending == ".toml" || ending == ".TOML") {
    return Word::InputSheet;
  }
  if (std::ranges::any_of(run.job.parts, [&](const parts::PartSetup& part) {
        return part.file.ends_with(file.file);
      })) {
    return Word::InputPart;
  }
  if (file.file.starts_with(kShipped)) {
    return Word::InputShipped;
  }
  return file.file == run.result.program ? Word::InputProgram : Word::InputRead;
}

std::string probe_text(const probe::ProbeSetup& probe, Language language) {
  constexpr double kMsPerSecond = 1000.0;
  return said(language, Word::LimitProbe, fmt::arg("ball", probe.ball_diameter_mm),
              fmt::arg("delay", probe.trigger_delay_s * kMsPerSecond),
              fmt::arg("scatter", probe.repeatability_mm),
              fmt::arg("travel", probe.at_switch.pre_travel_mm));
}

}  // namespace

std::vector<Input> inputs_of(const RunPage& run, Language language) {
  std::vector<Input> inputs;
  for (const report::InputFile& file : run.result.inputs) {
    inputs.push_back({file.file, std::string(text_of(kind_of(file, run), language)), file.sha256});
  }
  return inputs;
}

std::vector<std::string> limits_of(const RunPage& run, const PictureMeshes& meshes,
                                   Language language) {
  std::vector<std::string> limits;
  if (run.job.probe) {
    limits.push_back(probe_text(*run.job.probe, language));
  }
  for (std::size_t i = 0; i < meshes.size(); ++i) {
    if (!meshes[i]) {
      limits.push_back(said(language, Word::LimitNotDrawn, fmt::arg("part", run.parts[i].name),
                            fmt::arg("triangles", run.parts[i].mesh_M->triangles.size())));
    }
  }
  if (run.other != nullptr && !run.other->has_times) {
    limits.emplace_back(text_of(Word::LimitOtherTimes, language));
  }
  limits.emplace_back(text_of(Word::LimitNotSimulated, language));
  if (std::ranges::any_of(run.result.inputs, [](const report::InputFile& file) {
        return file.file.starts_with("<g31>/macros/sinumerik");
      })) {
    limits.emplace_back(text_of(Word::LimitCycles, language));
  }
  return limits;
}

}  // namespace g31::page

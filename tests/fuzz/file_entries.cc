// What g31 reads beside programs.  Its readers want files: the bytes become one, in a folder of
// this process.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <memory>
#include <string>

#include "interpreter/dialects/fanuc/run/session.h"
#include "interpreter/dialects/sinumerik/run/session.h"
#include "machine/base/contract.h"
#include "parts/artefacts/artefact.h"
#include "parts/geometry/mesh_defects.h"
#include "parts/import/mesh_file.h"
#include "tests/fuzz/entry.h"
#include "tests/fuzz/world.h"
#include "tests/support/temporary_folder.h"
#include "tools/printer/line_code.h"
#include "tools/printer/line_spec.h"
#include "tools/setup/toml_reader.h"
#include "tools/study/read_study.h"

namespace g31::fuzz {
namespace {

/// Written over by the next file of that ending.
std::string as_file(std::string_view bytes, std::string_view ending) {
  static const testing::TemporaryFolder folder;
  return folder.write("fuzz." + std::string(ending), bytes);
}

/// The first line, without its end; it is taken off.
std::string_view take_line(std::string_view& bytes) {
  const std::size_t end = std::min(bytes.find('\n'), bytes.size());
  const std::string_view line = bytes.substr(0, end);
  bytes.remove_prefix(std::min(end + 1, bytes.size()));
  return line;
}

void judge_errors(const setup::SetupErrors& errors) {
  G31_EXPECTS(!errors.empty());
  for (const setup::SetupError& error : errors) {
    G31_EXPECTS(!error.message.empty() && setup::render(error).ends_with('\n'));
  }
}

/// A session of either dialect over a short program.
template <typename Library, typename MakeSession>
void run_with(const setup::Job& job, std::string_view program, const std::string& path,
              const MakeSession& make_session) {
  OneFile files(path, program);
  source::SourceMap sources(files);
  Library library(sources);
  library.add_file(path);
  machine::MachiningCentre machine(job.machine, nullptr);
  Listener listener;
  const auto session = make_session(library, machine, listener);
  if (session->configure(job.control).empty()) {
    judge(session->run({kBlocks, kWallSeconds}), sources, machine);
  }
}

}  // namespace

void read_sheet_text(std::string_view bytes) {
  const std::array<std::string, 1> paths = {as_file(bytes, "toml")};
  const auto job = setup::read_job(paths);
  if (!job) {
    judge_errors(job.error());
    return;
  }
  for (const parts::PartSetup& part : job.value().parts) {
    if (!part.shape.empty()) {
      const auto mesh = parts::make_artefact(part);
      G31_EXPECTS(mesh || !mesh.error().empty());
    }
  }
  run_with<fanuc::ProgramLibrary>(job.value(), "O1\nG0X1.\nM30\n", "sheet.nc",
                                  [](auto& library, auto& machine, auto& listener) {
                                    return std::make_unique<fanuc::Session>(
                                        *fanuc::find_profile("fanuc-30i"), library, machine,
                                        listener);
                                  });
  run_with<sinumerik::ProgramLibrary>(
      job.value(), "G0 X1\nM30\n", "sheet.mpf", [](auto& library, auto& machine, auto& listener) {
        return std::make_unique<sinumerik::Session>(library, machine, listener);
      });
}

void read_study_text(std::string_view bytes) {
  const auto study = study::read_study(as_file(bytes, "toml"));
  if (!study) {
    judge_errors(study.error());
  }
}

void read_mesh_bytes(std::string_view bytes) {
  constexpr std::array<std::string_view, 5> kEndings = {"stl", "ply", "off", "obj", "3mf"};
  const std::string_view wanted = take_line(bytes);
  const auto ending = std::ranges::find(kEndings, wanted);
  const std::string path = as_file(bytes, ending != kEndings.end() ? *ending : kEndings[0]);
  const auto read = parts::read_mesh_file(path);
  if (!read) {
    G31_EXPECTS(!read.error().empty() && read.error().find('\n') == std::string::npos);
    // So ends a process of its own in which a sanitizer has found something.  A name in an archive
    // may say the same, but stands further back.
    const std::string found = "mesh file '" + path +
                              "': not understood as a mesh: assimp does not get through it "
                              "(its process ends with exit code";
    G31_EXPECTS(!read.error().starts_with(found));
    return;
  }
  const parts::Mesh& mesh = read.value();
  G31_EXPECTS(!mesh.triangles.empty());
  for (const Point& p : mesh.vertices) {
    G31_EXPECTS(p.allFinite());
  }
  for (const auto& triangle : mesh.triangles) {
    for (const std::uint32_t corner : triangle) {
      G31_EXPECTS(corner < mesh.vertices.size());
    }
  }
  const parts::MeshDefects found = parts::defects_of(mesh);
  G31_EXPECTS(found.flat_facets.count <= mesh.triangles.size());
}

void read_printer_line(std::string_view bytes) {
  const auto line = printer::parse_line_spec(take_line(bytes));
  for (const char received : bytes) {
    static_cast<void>(printer::control_code(received));
  }
  if (!line) {
    G31_EXPECTS(!line.error().empty());
    return;
  }
  const double time_s = printer::character_time_s(line.value());
  G31_EXPECTS(time_s > 0.0 && time_s < 1.0);
  const printer::Frame frame = printer::frame_of(line.value());
  G31_EXPECTS(frame.data_bits == 7 || frame.data_bits == 8);
  const auto text = printer::encoded(bytes, runtime::PrintCode::Iso, line.value());
  G31_EXPECTS(text && text->size() == bytes.size());
  const auto binary = printer::encoded(bytes, runtime::PrintCode::Binary, line.value());
  G31_EXPECTS(!binary || binary->size() == bytes.size());
}

}  // namespace g31::fuzz

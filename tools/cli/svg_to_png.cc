#include "tools/cli/svg_to_png.h"

#include <array>
#include <cerrno>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <memory>
#include <sstream>

#include <fmt/format.h>
#include <spawn.h>
#include <sys/wait.h>
#include <unistd.h>

extern char** environ;

namespace g31::cli {
namespace {

struct CloseFile {
  void operator()(std::FILE* file) const { std::fclose(file); }
};
/// Without a name, gone once it is closed.
using NamelessFile = std::unique_ptr<std::FILE, CloseFile>;

/// The drawer from a file to a file; how it ended as waitpid() tells, or why it did not begin.
Result<int, std::string> carry_out(std::FILE* from, std::FILE* to) {
  posix_spawn_file_actions_t actions;
  posix_spawn_file_actions_init(&actions);
  posix_spawn_file_actions_adddup2(&actions, fileno(from), STDIN_FILENO);
  posix_spawn_file_actions_adddup2(&actions, fileno(to), STDOUT_FILENO);
  std::string name = kSvgDrawer;
  const std::array<char*, 2> arguments = {name.data(), nullptr};
  pid_t process = 0;
  const int error =
      posix_spawnp(&process, kSvgDrawer, &actions, nullptr, arguments.data(), environ);
  posix_spawn_file_actions_destroy(&actions);
  if (error != 0) {
    return fmt::format("{} cannot be started: {}", kSvgDrawer, std::strerror(error));
  }
  int ended = 0;
  while (waitpid(process, &ended, 0) < 0 && errno == EINTR) {
  }
  return ended;
}

}  // namespace

bool has_svg_drawer() {
  const char* const path = std::getenv("PATH");
  std::istringstream folders(path != nullptr ? path : "");
  for (std::string folder; std::getline(folders, folder, ':');) {
    if (access((folder + "/" + kSvgDrawer).c_str(), X_OK) == 0) {
      return true;
    }
  }
  return false;
}

Result<PngFile, std::string> svg_to_png(const std::string& svg) {
  const NamelessFile from(std::tmpfile());
  const NamelessFile to(std::tmpfile());
  if (!from || !to || std::fwrite(svg.data(), 1, svg.size(), from.get()) != svg.size() ||
      std::fflush(from.get()) != 0) {
    return fmt::format("no room for a file on the way to {}", kSvgDrawer);
  }
  std::rewind(from.get());
  const auto ended = carry_out(from.get(), to.get());
  if (!ended) {
    return ended.error();
  }
  std::rewind(to.get());
  PngFile png;
  std::array<char, 65536> piece;
  while (const std::size_t count = std::fread(piece.data(), 1, piece.size(), to.get())) {
    png.bytes.append(piece.data(), count);
  }
  if (ended.value() != 0 || !png.bytes.starts_with("\x89PNG")) {
    return fmt::format("{} has drawn nothing", kSvgDrawer);
  }
  return png;
}

}  // namespace g31::cli

#pragma once

#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "interpreter/runtime/observer.h"
#include "interpreter/runtime/outcome.h"
#include "interpreter/source/diagnostic.h"
#include "interpreter/source/file_system.h"
#include "machine/sim/machining_centre.h"

namespace g31::fuzz {

/// A run must never be waited for; blocks are limited, what one of them does is limited by this.
inline constexpr double kWallSeconds = 0.2;

/// The only file of the world.
class OneFile final : public source::FileSystem {
 public:
  OneFile(std::string path, std::string_view text) : path_(std::move(path)), text_(text) {}
  std::optional<std::string> read(const std::string& path) override;
  std::vector<std::string> list(const std::string&) override { return {}; }

 private:
  std::string path_;
  std::string text_;
};

/// Hears everything and holds what every document relies on: its numbers are numbers.
class Listener final : public runtime::Observer {
 public:
  void on_move(const runtime::MoveEvent& event) override;
  void on_touch(const runtime::TouchEvent& event) override;
};

/// Makes the text of a message; there must be one.
void render(const source::Diagnostic& diagnostic, const source::SourceMap& sources);

/// What the end of every run must be like.
void judge(const runtime::Outcome& outcome, const source::SourceMap& sources,
           machine::MachiningCentre& machine);

}  // namespace g31::fuzz

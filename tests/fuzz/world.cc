#include "tests/fuzz/world.h"

#include <cmath>

#include "machine/base/contract.h"

namespace g31::fuzz {

std::optional<std::string> OneFile::read(const std::string& path) {
  return path == path_ ? std::optional(text_) : std::nullopt;
}

void Listener::on_move(const runtime::MoveEvent& event) {
  G31_EXPECTS(event.q_M_to.allFinite() && std::isfinite(event.feed_mm_min));
  G31_EXPECTS(std::isfinite(event.seconds) && event.seconds >= 0.0);
}

void Listener::on_touch(const runtime::TouchEvent& event) {
  G31_EXPECTS(event.q_M_commanded.allFinite() && event.q_M_latched.allFinite());
  G31_EXPECTS(event.q_M_stopped.allFinite());
}

void render(const source::Diagnostic& diagnostic, const source::SourceMap& sources) {
  G31_EXPECTS(!diagnostic.message.empty());
  G31_EXPECTS(!source::render_text(diagnostic, sources).empty());
}

void judge(const runtime::Outcome& outcome, const source::SourceMap& sources,
           machine::MachiningCentre& machine) {
  for (const source::Diagnostic& diagnostic : outcome.diagnostics) {
    render(diagnostic, sources);
  }
  G31_EXPECTS(outcome.status == runtime::Status::Completed || !outcome.diagnostics.empty());
  G31_EXPECTS(machine.position().allFinite() && std::isfinite(machine.time_s()));
}

}  // namespace g31::fuzz

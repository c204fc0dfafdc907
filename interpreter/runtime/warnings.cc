#include "interpreter/runtime/warnings.h"

#include <fmt/format.h>

namespace g31::runtime {
namespace {

std::vector<source::DiagnosticId> complaints_of(const machine::SensorState& state) {
  using source::DiagnosticId;
  if (!state.in_place) {
    return {DiagnosticId::ProbeNotInPlace};
  }
  std::vector<DiagnosticId> complaints;
  if (!state.switched_on) {
    complaints.push_back(DiagnosticId::ProbeSwitchedOff);
  }
  if (!state.stands) {
    complaints.push_back(DiagnosticId::ProbeTurning);
  } else if (!state.angle_known) {
    complaints.push_back(DiagnosticId::ProbeAnywhere);
  }
  return complaints;
}

}  // namespace

void Warnings::add(std::vector<source::Diagnostic>& diagnostics, source::DiagnosticId id,
                   source::Location where, std::string_view detail) {
  const auto [row, is_new] =
      repeats_.try_emplace({id, where.file, where.begin}, Repeat{diagnostics.size(), 0});
  ++row->second.times;
  if (is_new) {
    diagnostics.push_back(make_diagnostic(id, where, detail));
  }
}

void Warnings::tell_repeats(std::vector<source::Diagnostic>& diagnostics) const {
  for (const auto& [place, repeat] : repeats_) {
    if (repeat.times > 1) {
      source::Diagnostic& diagnostic = diagnostics[repeat.diagnostic];
      diagnostic.notes.push_back({diagnostic.where, fmt::format("{} times in all", repeat.times)});
    }
  }
}

void Warnings::add_missed(std::vector<source::Diagnostic>& diagnostics,
                          const std::vector<source::Location>& places) {
  for (const source::Location where : places) {
    add(diagnostics, source::DiagnosticId::SkipWithoutSignal, where);
  }
}

void Warnings::add_complaints(std::vector<source::Diagnostic>& diagnostics,
                              const std::optional<machine::SensorState>& sensor,
                              source::Location where) {
  for (const source::DiagnosticId id :
       sensor ? complaints_of(*sensor) : std::vector<source::DiagnosticId>()) {
    add(diagnostics, id, where);
  }
}

}  // namespace g31::runtime

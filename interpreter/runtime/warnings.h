#pragma once

#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string_view>
#include <tuple>
#include <vector>

#include "interpreter/source/diagnostic.h"
#include "machine/port/skip_signal.h"

namespace g31::runtime {

/// Warnings of what blocks did, each place once: a loop may do it a million times.
class Warnings {
 public:
  /// @param diagnostics  the same at each call
  void add(std::vector<source::Diagnostic>& diagnostics, source::DiagnosticId id,
           source::Location where, std::string_view detail = {});
  /// Of skip moves without a signal whose results count.
  void add_missed(std::vector<source::Diagnostic>& diagnostics,
                  const std::vector<source::Location>& places);
  /// What a move deserves to be told that listens to a sensor so placed; without one nothing.
  void add_complaints(std::vector<source::Diagnostic>& diagnostics,
                      const std::optional<machine::SensorState>& sensor, source::Location where);

  /// Says at each warning how often it happened; to be called once, at the end.
  void tell_repeats(std::vector<source::Diagnostic>& diagnostics) const;

 private:
  struct Repeat {
    std::size_t diagnostic = 0;  ///< its place among the diagnostics
    std::uint64_t times = 0;
  };
  std::map<std::tuple<source::DiagnosticId, source::FileId, std::uint64_t>, Repeat> repeats_;
};

}  // namespace g31::runtime

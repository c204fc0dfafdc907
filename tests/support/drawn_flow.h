#pragma once

#include <string>
#include <string_view>

#include <fmt/format.h>

#include "interpreter/analysis/flow.h"

namespace g31::testing {

/// A flow as text, a line a block: its number and text, the blocks that may follow (`~` by a jump,
/// `*` by REPEAT), how it may be left; below it its calls and faults, then the labels.
inline std::string drawn(const analysis::Flow& flow) {
  const auto text_at = [&](syntax::ShortSpan span) {
    return flow.file->text().substr(span.begin, span.end - span.begin);
  };
  std::string text;
  for (std::size_t i = 0; i < flow.blocks.size(); ++i) {
    const analysis::Block& block = flow.blocks[i];
    text += fmt::format("{} {}", i, text_at(block.span));
    text += block.edges.count > 0 ? " >" : "";
    for (const analysis::Edge& edge : flow.edges_of(block)) {
      constexpr std::string_view kMarks[] = {"", "~", "*"};
      text += fmt::format(" {}{}", kMarks[static_cast<std::size_t>(edge.kind)], edge.to);
    }
    text += block.to_any_label ? " any" : "";
    text += block.leaves.by_end ? " end" : "";
    text += block.leaves.by_return ? " return" : "";
    text += block.leaves.by_alarm ? " alarm" : "";
    text += block.leaves.by_running_out ? " out" : "";
    text += "\n";
    for (const analysis::Call& call : flow.calls_of(block)) {
      constexpr std::string_view kKinds[] = {"call", "macro", "modal"};
      text += fmt::format("  {} {} '{}'\n", kKinds[static_cast<std::size_t>(call.kind)],
                          call.target.empty() ? "?" : call.target, text_at(call.where));
    }
    for (const analysis::Fault& fault : flow.faults_of(block)) {
      constexpr std::string_view kKinds[] = {"fault", "target", "fault", "not simulated"};
      text += fmt::format("  {} {} '{}' {}\n", kKinds[static_cast<std::size_t>(fault.kind)],
                          fault.alarm, text_at(fault.where), fault.message);
    }
  }
  if (!flow.labels.empty()) {
    text += "labels";
    for (const analysis::Label& label : flow.labels) {
      text += fmt::format(" {}={}", label.name, label.block);
    }
    text += "\n";
  }
  return text;
}

/// What blocks do with variables, a line a block: r reads, w writes, h hands over.
inline std::string drawn_accesses(const analysis::Flow& flow) {
  std::string text;
  for (std::size_t i = 0; i < flow.blocks.size(); ++i) {
    const auto accesses = flow.accesses_of(flow.blocks[i]);
    text += accesses.empty() ? "" : fmt::format("{}:", i);
    for (const analysis::Access& access : accesses) {
      text += fmt::format(" {}{}", "rwh"[static_cast<std::size_t>(access.kind)],
                          flow.variables[access.variable].name);
      text += access.element >= 0 ? fmt::format("[{}]", access.element) : "";
    }
    text += accesses.empty() ? "" : "\n";
  }
  return text;
}

/// The moves that blocks command, a line a block.
inline std::string drawn_moves(const analysis::Flow& flow) {
  constexpr std::string_view kKinds[] = {"as before", "rapid",     "line", "arc",
                                         "measuring", "reference", "cycle"};
  std::string text;
  for (std::size_t i = 0; i < flow.blocks.size(); ++i) {
    for (const analysis::Move& move : flow.moves_of(flow.blocks[i])) {
      text += fmt::format("{}: {}", i, kKinds[static_cast<std::size_t>(move.kind)]);
      for (const analysis::AxisTarget& axis : flow.axes_of(move)) {
        text += fmt::format(" {}{}", axis.letter,
                            axis.is_computed ? "?" : fmt::format("{}", axis.value));
      }
      text += "\n";
    }
  }
  return text;
}

}  // namespace g31::testing

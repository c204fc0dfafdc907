#include "interpreter/analysis/sinumerik_flow.h"

#include <algorithm>
#include <cstdint>
#include <map>
#include <string>
#include <utility>
#include <vector>

#include <fmt/format.h>

#include "interpreter/analysis/flow_builder.h"
#include "interpreter/analysis/mixed_comparisons.h"
#include "interpreter/analysis/sinumerik_accesses.h"
#include "interpreter/analysis/sinumerik_moves.h"
#include "interpreter/analysis/sinumerik_ways.h"
#include "interpreter/source/diagnostic.h"

namespace g31::analysis {
namespace {

/// What a step of a program makes one doubt.
void tell(SinumerikWays& ways, std::size_t step, Fault doubt) {
  ways.blocks[ways.block_of[step]].faults.push_back(std::move(doubt));
}

void tell_mixed_comparisons(const sinumerik::CompiledProgram& program, SinumerikWays& ways) {
  for (const std::int32_t mixed : mixed_comparisons(program)) {
    const auto step = static_cast<std::size_t>(mixed);
    tell(ways, step,
         {Fault::Kind::Comparison, 0, program.spans[step],
          "AND, OR, XOR and NOT bind closer than comparisons",
          "put each comparison in brackets: (R1 == 0) AND (R2 == 0), NOT (R1 == 3)"});
  }
}

/// A run passes over them and tells it.
void tell_surplus_ends(const sinumerik::CompiledProgram& program, SinumerikWays& ways) {
  const std::string remedy(source::info(source::DiagnosticId::SurplusEnd).remedy);
  for (std::size_t step = 0; step < program.ops.size(); ++step) {
    if (program.ops[step].code == sinumerik::OpCode::SurplusEnd) {
      tell(ways, step,
           {Fault::Kind::SurplusEnd, 0, program.spans[step], "ENDIF without IF", remedy});
    }
  }
}

std::map<BlockIndex, std::vector<std::string>> label_names(
    const sinumerik::CompiledProgram& program, const SinumerikWays& ways) {
  std::map<BlockIndex, std::vector<std::string>> names;
  for (const auto& [name, steps] : program.labels) {
    for (const std::int32_t step : steps) {
      names[ways.block_of[static_cast<std::size_t>(step)]].push_back(name);
    }
  }
  for (const sinumerik::BlockNumber& block : program.block_numbers) {
    names[ways.block_of[static_cast<std::size_t>(block.step)]].push_back(
        fmt::format("N{}", block.number));
  }
  for (auto& [block, list] : names) {
    std::ranges::sort(list);  // the map of labels has no order of its own
  }
  return names;
}

}  // namespace

Flow flow_of(const sinumerik::CompiledProgram& program) {
  SinumerikWays ways = ways_of(program);
  tell_mixed_comparisons(program, ways);
  tell_surplus_ends(program, ways);
  const auto names = label_names(program, ways);
  const SinumerikAccesses accesses(program);
  FlowBuilder builder(program.name, *program.file);
  for (BlockIndex i = 0; i < ways.blocks.size(); ++i) {
    SinumerikBlock& block = ways.blocks[i];
    builder.begin_block(block.span);
    builder.block().leaves = block.leaves;
    builder.block().to_any_label = block.to_any_label;
    for (const Edge& edge : block.edges) {
      builder.edge(edge.to, edge.kind);
    }
    for (Fault& fault : block.faults) {
      builder.fault(std::move(fault));
    }
    for (Call& call : block.calls) {
      builder.call(std::move(call));
    }
    const bool is_last = i + 1 == ways.blocks.size();
    const std::int32_t end =
        is_last ? static_cast<std::int32_t>(program.ops.size()) : ways.blocks[i + 1].first_step;
    accesses.add(block.first_step, end, builder);
    add_moves(program, block.first_step, end, builder);
    if (const auto found = names.find(i); found != names.end()) {
      for (const std::string& name : found->second) {
        builder.label(name);
      }
    }
  }
  builder.writes(ways.written);
  return builder.finish();
}

}  // namespace g31::analysis

#pragma once

#include <cstddef>
#include <cstdint>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "interpreter/runtime/block_listener.h"
#include "interpreter/runtime/output_budget.h"
#include "machine/port/machine_port.h"
#include "tools/coverage/block_counts.h"

namespace g31::report {

/// One call of a program.
struct CallSpan {
  std::string program;       ///< "O9010", "CYCLE977"
  std::uint16_t level = 0;   ///< 0: the main program
  source::Location call;     ///< the block that calls it; not known at level 0
  double time_from_s = 0.0;  ///< machine time
  double time_to_s = 0.0;
  std::uint64_t first_block = 0;  ///< by its number in the run, that of the call before it
  std::uint64_t last_block = 0;
};

/// What a program has given to one variable.
struct VariableHistory {
  /// Of more values every second one is left out, as often as it needs.
  static constexpr std::size_t kMostValues = 1000;

  std::string name;
  std::uint64_t writes = 0;
  std::vector<std::pair<double, runtime::ShownValue>> values;  ///< with machine time, s
  std::uint64_t stride = 1;  ///< how many writes each but the last of the values stands for
  source::Location last_write;
  std::uint64_t last_block = 0;  ///< the number of that block in the run
};

/// Keeps when which program was called, how often each block ran, and what variables were, as far
/// as the budget lets it.
class RunChronicle final : public runtime::BlockListener {
 public:
  /// @param main    name of the main program
  /// @param clock   its time; outlives the chronicle
  /// @param budget  is charged for what is kept; outlives the chronicle
  RunChronicle(std::string main, const machine::MachinePort& clock, runtime::OutputBudget& budget);

  runtime::Verdict on_block(const runtime::BlockPlace& place) override;
  void on_level(std::uint16_t depth, const std::string& program) override;
  [[nodiscard]] bool hears_writes() const override { return true; }
  void on_write(const runtime::WriteEvent& event) override;
  void on_condition(const source::Location& where, bool is_met) override;
  /// The run has ended: so have all calls.
  void finish();

  /// In the order of their beginnings.
  [[nodiscard]] std::span<const CallSpan> calls() const { return calls_; }
  /// In the order of their first writes.
  [[nodiscard]] std::span<const VariableHistory> histories() const { return histories_; }
  [[nodiscard]] const coverage::BlockCounts& counts() const { return counts_; }

 private:
  void open(std::uint16_t level, const std::string& program);
  void close_to(std::size_t levels);

  const machine::MachinePort& clock_;
  runtime::OutputBudget& budget_;
  coverage::BlockCounts counts_;
  std::vector<CallSpan> calls_;
  std::vector<std::size_t> open_;  ///< calls that have not returned, by level
  std::vector<VariableHistory> histories_;
  std::unordered_map<std::string, std::size_t> known_;
  source::Location block_;  ///< that runs
  std::uint64_t number_ = 0;
};

}  // namespace g31::report

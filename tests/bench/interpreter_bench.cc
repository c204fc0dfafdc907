// How fast programs run: plain blocks with parsing, macro arithmetic, calls.  The machine is the
// simulated one without surroundings.

#include <map>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include "interpreter/dialects/fanuc/run/session.h"
#include "machine/sim/machining_centre.h"

namespace g31 {
namespace {

class OneFile final : public source::FileSystem {
 public:
  explicit OneFile(std::string text) : text_(std::move(text)) {}
  std::optional<std::string> read(const std::string&) override { return text_; }
  std::vector<std::string> list(const std::string&) override { return {}; }

 private:
  std::string text_;
};

/// Reads, compiles and runs a program; the count of executed blocks is the items processed.
void run_text(benchmark::State& state, const std::string& text) {
  std::uint64_t blocks = 0;
  for (auto _ : state) {
    OneFile files(text);
    source::SourceMap sources(files);
    fanuc::ProgramLibrary library(sources);
    library.add_file("bench.nc");
    machine::MachiningCentre machine({}, nullptr);
    runtime::Observer silent;
    fanuc::Session session(*fanuc::find_profile("fanuc-16i"), library, machine, silent);
    const runtime::Outcome outcome = session.run({});
    if (outcome.status != runtime::Status::Completed) {
      state.SkipWithError("the program did not complete");
      return;
    }
    blocks += outcome.blocks;
  }
  state.SetItemsProcessed(static_cast<std::int64_t>(blocks));
}

void plain_blocks(benchmark::State& state) {
  std::string text = "O1\nG21 G90 G17 G40 G49 G80 G94\nG00 X0. Y0. Z0.\n";
  for (int i = 0; i < 20000; ++i) {
    text += fmt::format("N{} G1 X{:.4f} Y{:.4f} Z{:.4f} F{}.\n", i + 1, i * 0.013 - 100.0,
                        50.0 - i * 0.007, -0.0001 * (i % 10000), 800 + i % 7 * 100);
  }
  run_text(state, text + "M30\n");
}
BENCHMARK(plain_blocks)->Unit(benchmark::kMillisecond);

void macro_arithmetic(benchmark::State& state) {
  run_text(state,
           "O1\n#100=0\n#101=0\n#102=1\n#103=0\nWHILE [#100 LT 20000] DO1\n"
           "#101=#101+#100*0.5-#102/3\n#102=#102*0.999+SIN[#100]\n#103=#103+SQRT[ABS[#102]]\n"
           "IF [#101 LE 1000000] GOTO 10\n#101=#101-1000000\nN10 #100=#100+1\nEND1\nM30\n");
}
BENCHMARK(macro_arithmetic)->Unit(benchmark::kMillisecond);

void macro_calls(benchmark::State& state) {
  run_text(state,
           "O1\n#100=0\n#110=0\nWHILE [#100 LT 20000] DO1\nG65 P9100 A#100 B2.5 C#110\n"
           "#100=#100+1\nEND1\nM30\nO9100\n#4=#1*2+#2\n#5=#4-#3/7\n#110=#110+#5\nM99\n");
}
BENCHMARK(macro_calls)->Unit(benchmark::kMillisecond);

}  // namespace
}  // namespace g31

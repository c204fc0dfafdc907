#pragma once

#include <cstdint>
#include <map>
#include <optional>
#include <vector>

namespace g31::runtime {

/// When a digital input takes a value: one `[[input]]` of a set-up sheet.
struct InputStep {
  enum class From {
    Start,
    Time,   ///< `at` seconds after the start of the program
    Block,  ///< once `at` blocks have run
    Reads,  ///< when the program looks for the `at`-th time
    Code    ///< at each M code `at`
  };
  int number = 0;  ///< as programs count digital inputs
  bool value = true;
  From from = From::Start;
  double at = 0.0;

  bool operator==(const InputStep&) const = default;
};

/// Digital inputs that answer as a set-up sheet says: what waits for a handshake meets it.
///
/// A step is taken once, one of an M code at each such code; the value is that of the step taken
/// last, and 0 before any.  Steps that have become due between two looks are taken in the order of
/// the sheet.
class InputScripts {
 public:
  InputScripts() = default;
  explicit InputScripts(const std::vector<InputStep>& steps);

  /// How far the program is.
  struct Now {
    double time_s = 0.0;
    std::uint64_t blocks = 0;
  };

  /// The program looks at an input; nullopt: no step is about it.
  std::optional<bool> look(int number, const Now& now);
  /// The value without a look of the program's.
  [[nodiscard]] std::optional<bool> shown(int number) const;
  /// The program commands an M code.
  void hear(int code, const Now& now);

  bool operator==(const InputScripts&) const = default;

 private:
  struct Step {
    InputStep what;
    bool is_taken = false;

    bool operator==(const Step&) const = default;
  };
  struct Input {
    bool value = false;
    std::uint64_t looks = 0;

    bool operator==(const Input&) const = default;
  };

  void take_due(const Now& now);
  void take(Step& step);

  std::vector<Step> steps_;
  std::map<int, Input> inputs_;
};

}  // namespace g31::runtime

#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace g31::runtime {

/// Rows of outputs.def.
enum class Output : std::uint8_t {
#define OUTPUT(name, text) name,
#include "interpreter/runtime/outputs.def"
#undef OUTPUT
};

/// How much one run may put out, all its outputs together: who keeps or writes something charges it
/// here before.  Sizes are those in files: texts of the document with their escapes, rows of tables
/// as they are, lists of the document and lines of a scene by a fixed size for each entry, which is
/// within a factor of three of the true one.
class OutputBudget {
 public:
  static constexpr std::uint64_t kUsualBytes = 256'000'000;

  explicit OutputBudget(std::uint64_t bytes = kUsualBytes) : most_(bytes) {}

  /// Charges what is about to be put out.
  /// @returns whether it may be; false once the budget is spent: then it is left out
  /// @throws BudgetSpent  the first time that it may not
  bool charge(Output output, std::uint64_t bytes) {
    if (!is_spent_ && bytes <= most_ - total_) [[likely]] {
      total_ += bytes;
      charged_[static_cast<std::size_t>(output)] += bytes;
      return true;
    }
    refuse(output, bytes);
    return false;
  }

  /// What was charged is there no more.
  void give_back(Output output, std::uint64_t bytes);

  [[nodiscard]] bool is_spent() const { return is_spent_; }

 private:
  static constexpr std::size_t kOutputs = 0
#define OUTPUT(name, text) +1
#include "interpreter/runtime/outputs.def"
#undef OUTPUT
      ;

  void refuse(Output output, std::uint64_t bytes);

  std::uint64_t most_;
  std::uint64_t total_ = 0;
  bool is_spent_ = false;
  std::array<std::uint64_t, kOutputs> charged_ = {};
};

/// The size of a text of Latin-1 characters in a JSON document, escapes included, quotes not.
std::uint64_t size_in_document(std::string_view latin_1);

/// A size for people: "812 bytes", "1.5 kB", "256.0 MB", "2.0 GB".
std::string shown_size(std::uint64_t bytes);

}  // namespace g31::runtime

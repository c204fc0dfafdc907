#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "interpreter/dialects/sinumerik/code/code_writer.h"

namespace g31::sinumerik {

/// Jumps to labels and parts to repeat between labels.  Where labels are is known at the end of the
/// text.
class LabelJumps {
 public:
  /// Ends a part of whose end REPEAT says nothing.
  static constexpr std::string_view kEndOfPart = "ENDLABEL";

  struct Jump {
    std::int32_t step = 0;
    std::string label;
    Direction direction = Direction::Forward;
  };
  struct Part {
    std::size_t site = 0;  ///< of CompiledProgram::repeats
    std::int32_t step = 0;
    std::string first;
    std::string end;
    bool one_block = false;
  };

  void add(Jump jump) { jumps_.push_back(std::move(jump)); }
  void add(Part part) { parts_.push_back(std::move(part)); }
  /// The steps from this one on are taken back.
  void take_back(std::size_t first_step);
  /// All labels of the program are there: jumps and parts get their steps, or an alarm.
  void resolve(CompiledProgram& program, CodeWriter& code) const;

 private:
  static RepeatSite site_of(const Part& part, const CompiledProgram& program);

  std::vector<Jump> jumps_;
  std::vector<Part> parts_;
};

}  // namespace g31::sinumerik

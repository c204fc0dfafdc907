#pragma once

#include <array>
#include <cstddef>
#include <functional>
#include <optional>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/state/failure.h"
#include "interpreter/dialects/sinumerik/state/tool_carrier.h"
#include "machine/base/result.h"

namespace g31::sinumerik {

/// Transformation n of the machine data is seen as the tool carrier of this number and n: TRAORI
/// takes it, and the cycles read what it says.
inline constexpr int kFirstOfData = 2000;

/// What the data of an orientation transformation say.
struct DataTransformation {
  ToolCarrier carrier;              ///< vectors, axes and basic positions
  Eigen::Vector3d basic_direction;  ///< of the tool with all angles at 0
  bool operator==(const DataTransformation&) const = default;
};

/// The machine data of the first two orientation transformations (MD24100 to 24682), by their
/// places among the numbers of a channel.
///
/// Types 24, 40 and 56 turn the tool, the part, or both; 72 takes the tool carrier of MD24582.
/// Source: SINUMERIK Operate commissioning 12/2017, 6FC5397-1DP40-6BA1, page 572; the errors of
/// alarm 4342: Diagnostics Manual 11/2006, page 2-59.
class TransformationData {
 public:
  static constexpr int kCount = 2;

  explicit TransformationData(const Globals& globals);

  /// As the machine has it: transformation 1 takes tool carrier 1.
  /// @param axes  storage indices of its rotary axes; -1: none
  void take(const std::array<int, 2>& axes, std::vector<double>& numbers) const;

  /// The tool carrier that TRAORI(n) takes: one of its own number where the data say nothing,
  /// kFirstOfData and n where they say what it is.  Alarm 14100 for a type that is not simulated.
  [[nodiscard]] Result<int, Failure> carrier_of(const std::vector<double>& numbers, int n) const;

  /// What the data say of transformation n of kCount; nullopt: they say nothing.  Alarm 4342.
  /// @param travel_of  of a rotary axis
  [[nodiscard]] Result<std::optional<DataTransformation>, Failure> told(
      const std::vector<double>& numbers, int n,
      const std::function<machine::RotaryTravel(int)>& travel_of) const;

 private:
  struct Places {
    std::size_t type;           // MD24100
    std::size_t axes;           // MD24110
    std::size_t part_offset;    // MD24500
    std::size_t basic_deg;      // MD24510
    std::size_t is_plus;        // MD24520
    std::size_t base_tool;      // MD24550
    std::size_t joint_of_part;  // MD24558
    std::size_t joint;          // MD24560
    std::size_t axis1;          // MD24570
    std::size_t axis2;          // MD24572
    std::size_t orientation;    // MD24574
    std::size_t carrier;        // MD24582
  };
  std::array<Places, kCount> places_;
};

}  // namespace g31::sinumerik

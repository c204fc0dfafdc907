#pragma once

#include <cstddef>
#include <optional>
#include <set>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "machine/port/machine_port.h"

namespace g31::sinumerik {

/// The machine data that say how smoothly axes move and where they have arrived: by their places
/// among the numbers of a channel.  Source of MD32310: 828D function manual B1, 6FC5397-0BP40-2BA0,
/// page 157.
class MotionData {
 public:
  explicit MotionData(const Globals& globals);

  /// The data become those of a machine: MD36010 and MD36000 its windows, MD32431 the jerk of its
  /// linear axes where it limits it; MD20150 [20] is SOFT then.  MD32431, MD32310, MD35100,
  /// MD36100, MD36110, SD43220 and SD43230 count once they are written.
  void take(const machine::AxisData& of_machine, std::vector<double>& numbers);

  /// A datum was written that counts from then on.  @param place  among the numbers
  void written(std::size_t place) { is_new_ = written_.insert(place).second || is_new_; }

  [[nodiscard]] bool is_written(std::size_t place) const { return written_.contains(place); }

  /// What the data say of the axes; nullopt: what they said the last time.  Windows times MD36012;
  /// one that is not > 0 leaves the machine's.
  std::optional<machine::AxisData> changed(const std::vector<double>& numbers);

  /// MD20550: how rapids, and other motions, stop; nullopt: as G601 to G603 say.
  [[nodiscard]] std::optional<machine::BlockEnd> stop(const std::vector<double>& numbers,
                                                      bool is_rapid) const;

  /// MD20480, thousands: G644 begins to round at a distance and not by a tolerance.
  [[nodiscard]] bool rounds_by_distance(const std::vector<double>& numbers) const;

  /// MD20170, mm: longer lines are not compressed.
  [[nodiscard]] double longest_compressed(const std::vector<double>& numbers) const {
    return numbers[longest_compressed_];
  }

 private:
  [[nodiscard]] machine::AxisData data_of(const std::vector<double>& numbers) const;

  std::size_t stop_fine_;     // place of MD36010
  std::size_t stop_coarse_;   // of MD36000
  std::size_t stop_factor_;   // of MD36012
  std::size_t jerk_;          // of MD32431
  std::size_t acceleration_;  // of MD32300
  std::size_t overload_;      // of MD32310
  std::size_t limit_minus_;   // of MD36100
  std::size_t limit_plus_;    // of MD36110
  std::size_t clock_;         // of MD10050
  std::size_t clock_ratio_;   // of MD10070
  std::size_t stop_mode_;     // of MD20550
  std::size_t rounding_;      // of MD20480
  std::size_t longest_compressed_;
  std::size_t codes_at_start_;  // of MD20150
  machine::AxisData of_machine_;
  std::vector<double> taken_;  // of the data, when they were looked at last
  std::set<std::size_t> written_;
  bool is_new_ = false;
};

}  // namespace g31::sinumerik

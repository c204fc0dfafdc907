#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "interpreter/dialects/sinumerik/code/globals.h"
#include "interpreter/dialects/sinumerik/state/channel_state.h"
#include "interpreter/dialects/sinumerik/state/failure.h"
#include "machine/port/axis_data.h"

namespace g31::sinumerik {

/// The compensation tables of a control: $AA_ENC_COMP of an axis by its own place, $AN_CEC (sag and
/// angularity) of one axis by the place of another.  What programs write is kept data of the
/// channel; this says what of it is in force.
///
/// A positive value moves the axis in the negative direction.  Values are straight between the
/// points and constant outside them; places are machine coordinates.  $AN_CEC_DIRECTION 1 or -1:
/// the table counts while its input axis goes, or last went, that way.  $AN_CEC_MULT_BY_TABLE: the
/// number (index + 1) of a table by whose value it is multiplied; the product takes the place of
/// its own value, and the factor need not be switched on.  Source: Extended Functions 03/2013,
/// 6FC5397-1BP40-3BA1, K3, 4.4, page 249; that $AN_CEC counts in the same sense as $AA_ENC_COMP is
/// read off tables that a shop's tool writes, and that the product counts alone is decided here.
class CompensationData {
 public:
  /// What an 828D has.
  static constexpr int kSagTables = 8;
  /// More points of an axis are none.
  static constexpr int kMostPoints = 5000;

  explicit CompensationData(const Globals& globals);

  /// A table was written: it is looked at before the next motion.
  void written() { has_tables_ = is_new_ = true; }

  /// Whether a variable is one of $AA_ENC_COMP; else of $AN_CEC.
  static bool is_of_encoder(SystemId id);
  /// NEWCONF, or the start of a program: MD32700 and MD32710 as they are now protect tables, which
  /// a builder's program writes behind a new enabling up to then.
  void activate(const ChannelState& state);

  /// MD32700 and MD32710 protect the tables of their axis, once they are activated.
  /// @param id  of a row of system_variables.def  @param indices  as it is accessed
  [[nodiscard]] bool is_protected(const ChannelState& state, SystemId id,
                                  const std::vector<int>& indices) const;
  /// MD18342: how many points a sag table may have.
  [[nodiscard]] int most_points(const ChannelState& state, int table) const;

  /// The tables in force; nullopt: the same as the last time.
  /// Fails for one of too many points, and for one that is multiplied by a table without points.
  Result<std::optional<std::vector<machine::CompensationTable>>, Failure> changed(
      const ChannelState& state);

 private:
  using Tables = std::vector<machine::CompensationTable>;
  using Factor = machine::CompensationTable::Factor;
  [[nodiscard]] bool enabling_changed(const ChannelState& state);
  [[nodiscard]] MaybeFailure add_encoder_table(const ChannelState& state, int axis,
                                               Tables& tables) const;
  /// What a table of $AN_CEC makes of its input axis, times a weight; nullopt: it has no points.
  [[nodiscard]] Result<std::optional<Factor>, Failure> sag_factor(const ChannelState& state,
                                                                  int table, double weight) const;
  [[nodiscard]] MaybeFailure add_sag_table(const ChannelState& state, int table,
                                           Tables& tables) const;

  std::size_t encoder_enable_;  // place of MD32700
  std::size_t sag_enable_;      // of MD32710
  std::size_t table_enable_;    // of SD41300
  std::size_t table_weight_;    // of SD41310
  std::size_t most_points_;     // of MD18342
  bool has_tables_ = false;
  bool is_new_ = false;
  std::vector<double> enabling_;   // as looked at last
  std::vector<double> activated_;  // MD32700 of both encoders, then MD32710
};

}  // namespace g31::sinumerik

#pragma once

#include <limits>

namespace g31::errors {

/// What an axis does when it reverses; mm or deg.
struct PlaySetup {
  double backlash = 0.0;    ///< >= 0: the encoder goes this far before the table follows
  double spike = 0.0;       ///< >= 0: how far the table at most sticks behind after a reversal
  double spike_way = 0.05;  ///< > 0: distance after the reversal at which it lags the most
};

/// The play of one axis: backlash and stick motion.  A value; a move makes a new one.
///
/// The backlash counts from the positive direction: without it the table is where the encoder says
/// when the last move was positive, and one backlash further up when it was negative.
/// After a reversal, the backlash taken up, the table stays behind by
/// spike (w / spike_way) exp(1 - w / spike_way), w the way since then; what it was behind before
/// the reversal dies away as exp(-w / spike_way).  With a spike up to a quarter of spike_way the
/// table never goes back because of it.
class AxisPlay {
 public:
  AxisPlay(const PlaySetup& setup, double q_start) : setup_(setup), q_(q_start) {}

  /// The play after a move in one direction to a position.
  [[nodiscard]] AxisPlay after(double q) const;

  /// True minus encoder position.
  [[nodiscard]] double offset() const;

  [[nodiscard]] bool is_zero() const { return setup_.backlash == 0.0 && setup_.spike == 0.0; }

 private:
  /// How far stick motion keeps the table behind in its direction.
  [[nodiscard]] double behind() const;

  PlaySetup setup_;
  double q_;
  double slack_ = 0.0;
  double direction_ = 0.0;                                // +1, -1; 0 before the first move
  double way_ = std::numeric_limits<double>::infinity();  // of the table since then
  double behind_at_reversal_ = 0.0;
};

/// A shorter way back is rounding, not a reversal.
inline constexpr double kLeastReversal = 1e-9;

}  // namespace g31::errors

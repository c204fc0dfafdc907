#pragma once

#include <optional>

#include "interpreter/dialects/sinumerik/execute/execute.h"

namespace g31::sinumerik {

/// X along a circle: centre + out cos(angle) + ahead sin(angle), and evenly what is left to its
/// end.
struct CircleInX {
  double centre_mm = 0.0;
  double out_mm = 0.0;
  double ahead_mm = 0.0;
  double sweep_rad = 0.0;
};

/// What a feed may depend on: how long a way is and how far from the turning centre.
struct FeedWay {
  double length_mm = 0.0;           ///< G93
  double radius_from_mm = 0.0;      ///< G96: work coordinate X where the way begins
  double radius_to_mm = 0.0;        ///< and where it ends
  std::optional<CircleInX> circle;  ///< G96: nullopt: X changes evenly
  Feed feed;                        ///< F or FB
  bool turns = false;               ///< rotary axes move alone: F counts degrees
  double share = 1.0;               ///< feed of the machine over that of the axes of FGROUP
};

/// The way from where the axes stand.
/// @param length_mm  along the path
FeedWay feed_way(Channel& channel, const Block& block, const AxisPositions& q_W_end,
                 double length_mm);

/// mm/min, override and dry run included.  With G96 the mean over the way, so that its time is
/// right.  A feed per revolution is told where the spindle stands.
Result<double, Failure> feed_in_force(Channel& channel, const Block& block, const FeedWay& way);

/// Tells of a feed per revolution or a lead while the spindle stands.  What codes of the builder's
/// do to it is not known.
void tell_standing_spindle(Channel& channel, const Block& block);

/// What a word F, FB or FRC says now.
Feed programmed(const Channel& channel, double word);

/// FB, or the feed in force.
Feed feed_of_block(const Channel& channel, const Block& block);

/// On a helix: the feed of the machine over that of the axes of FGROUP.  Alarm 12140 where FGROUP
/// has one axis of the plane only.
/// @param arc_mm   length in the plane
/// @param rise_mm  square to it
Result<double, Failure> helix_share(const Channel& channel, double arc_mm, double rise_mm);

/// Override and dry run on a feed.
double switched(const Channel& channel, double feed_mm_min);

/// FA of an axis that goes alone, with its overrides, mm/min or deg/min; 0: rapid.
double positioning_feed(const Channel& channel, int axis);

/// rev/min that MD35100 and SD43220 let a spindle turn.
double highest_speed(const Channel& channel, int spindle);

/// rev/min of the master spindle with OVRA and within its limits: those of G25 and G26, and LIMS
/// under G97 (programming manual, fundamentals 11/2006: LIMS does not work with G971).
/// @param programmed  > 0
double limited_speed(const Channel& channel, double programmed);

/// rev/min of a way, with G96 the mean, so that its time is right
Result<double, Failure> mean_speed(const Channel& channel, const FeedWay& way);

/// rev/min at a distance from the turning centre, mm; 0 where G96 has no limit at X0
double spindle_speed(const Channel& channel, double radius_mm);

/// rev/min that the master spindle keeps where it leaves G96: without OVRA, which counts for it,
/// too
double kept_speed(Channel& channel);

/// What S of G96 counts, m: feet with G70 and G700 (programming manual, fundamentals: G96).
double metres_of_cutting(const Channel& channel);

/// G96 or G961: S is a cutting speed.
bool cuts_at_constant_speed(int feed_type);

/// G97 or G971: the spindle stays at the speed that it has behind G96.
bool keeps_speed(int feed_type);

/// What of a feed type F means: programs give F anew when it changes.
enum class FeedMeaning { InverseTime, PerMinute, PerRevolution };
FeedMeaning feed_meaning(int feed_type);

/// As the machine counts feed: the linear axes, or rotary ones that move alone.
double feed_length(const AxisPositions& q_M_from, const AxisPositions& q_M_to);

}  // namespace g31::sinumerik

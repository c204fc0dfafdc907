#pragma once

#include <optional>
#include <string>

#include "machine/port/contact.h"
#include "machine/port/machine_events.h"
#include "machine/port/skip_signal.h"
#include "machine/port/way.h"

namespace g31::machine {

/// How the tool goes its way.
enum class Travel {
  Rapid,
  Feed,
  Skip,  ///< until a signal: what senses may touch
};

/// What the tool is as far as the machine's own motion depends on it.
struct ToolExtent {
  /// mm, the tip from the gauge point: what angular errors and rotary axes move; nullopt: as the
  /// machine's set-up says.
  std::optional<Point> p_T_tip;
  // How far what the tool carries reaches from its tip: what turns is asked about in steps so fine
  // that this makes no difference.
  double signal_mm = 0.0;  ///< what a skip signal may come from
  double body_mm = 0.0;    ///< all of it
};

/// The skip signal: where on the way it is caused, and how late the control sees it.
struct SkipTrigger {
  double fraction = 0.0;           ///< 0..1 of the way, where the probe's contact opens
  bool on_at_start = false;        ///< the signal is already there before the move
  double delay_s = 0.0;            ///< from the opening to the latch; the axes go on meanwhile
  std::optional<Contact> contact;  ///< none for a signal that no part caused
  int signals = 1;                 ///< how many the probe gives; the first one counts
};

/// Something touches that must not.
struct Obstacle {
  double fraction = 0.0;  ///< 0..1 of the way
  std::string what;       ///< "stylus ball touches ring": for people
  Contact contact;
};

/// The world around the machine, as the machine asks about it: *what does this way meet first?*
///
/// `probe/sensor` answers with tools, probes and parts; a test answers from a script.
class Surroundings {
 public:
  Surroundings() = default;
  Surroundings(const Surroundings&) = delete;
  Surroundings& operator=(const Surroundings&) = delete;
  virtual ~Surroundings() = default;

  /// The first edge of the signal listened to; nullopt: none on the whole way, or nothing is wired
  /// to the input.  Called once per skip move, in order: random models and scripts count these
  /// calls.
  virtual std::optional<SkipTrigger> first_signal(const Way& way, const Listening& to) = 0;

  /// The first forbidden touch; nullopt: the way is free.  A way that leaves a contact in which the
  /// last skip move ended is free.  With Travel::Skip, of the way that a skip move has taken:
  /// anything but a sensing tip touches, or a tip is pushed in further than it gives way.
  virtual std::optional<Obstacle> first_obstacle(const Way& way, Travel travel) = 0;

  /// Whether the signal listened to is on while the tool stands there.
  [[nodiscard]] virtual bool signals_at(const Waypoint& at, const Listening& to) const = 0;

  /// The part in whose material the middle of a sensing tip is while the tool stands there; "":
  /// none.
  [[nodiscard]] virtual std::string stands_inside(const Waypoint& /*at*/) const { return {}; }

  /// Of what is wired to a measuring input; nullopt: nothing is.
  [[nodiscard]] virtual std::optional<SensorState> sensor_state(int input) const = 0;

  /// Where the displacement sensor of an analog input is, mm from the gauge point; nullopt: none is
  /// wired to it.
  [[nodiscard]] virtual std::optional<Point> displacement_sensor(int /*input*/) const { return {}; }

  /// What it reads, mm.  @pre there is one
  /// @param at  told for a tip in the sensor's place
  [[nodiscard]] virtual double displacement(const Waypoint& /*at*/, int /*input*/) const {
    return 0.0;
  }

  /// Of the tool in the spindle.
  [[nodiscard]] virtual ToolExtent tool_extent() const = 0;

  /// What the program has told the machine, in order.
  virtual void take(const MachineEvent& event) = 0;

  /// Seconds since the start of the program, told before anything above is asked; for what takes
  /// its time.  @param now_s  never less than before
  virtual void time_is(double /*now_s*/) {}
};

}  // namespace g31::machine

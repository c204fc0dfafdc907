#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <vector>

#include "interpreter/source/location.h"

namespace g31::runtime {

/// Skip moves that ended without a signal, and what has their result since.
///
/// Such a move is no mistake: a positioning move is protected so, and a program that compares what
/// it reads with the end of the way has looked.  What is a mistake is to take the result for a
/// measured one: to put it into an offset, to print it, to leave it behind in a variable.
///
/// A dialect says, statement by statement, what is read and then what becomes of it.  A comparison
/// of a result with the end of its way, some play about it, settles the move, wherever else its
/// result is.  Any other comparison may have found that out or not (a limit, the least of several,
/// the scatter of two, a test for 0): it excuses the variables that keep the result now, but what
/// is made of it afterwards counts.  While nothing is owed, nothing has to be said.
class MissedTouches {
  struct Held;

 public:
  /// A variable as the dialect counts them, the same number for the same variable.
  using Holder = std::uint64_t;

  /// What a part of a statement has read: an argument that a called program gets.
  using Reading = std::shared_ptr<const Held>;

  /// What a program reads as the result of such a move.
  enum class Result : std::uint8_t {
    End,     ///< the end of its way
    Former,  ///< what was there before: only where the axes are tells of the end
  };

  /// A move without a signal, for the program.
  struct Miss {
    Result result = Result::End;
    double mm_per_unit = 1.0;  ///< of the lengths that the program reads: 1 or 25.4
    int input = 0;             ///< which signal it listened to; 0: more than one

    bool operator==(const Miss&) const = default;
  };

  /// One side of a comparison.
  struct Side {
    double value = 0.0;
    Reading reading;
  };

  /// Whether a move without a signal is still unsettled.
  [[nodiscard]] bool any() const { return is_owed_; }

  // The last measuring move of the program.

  void touched();
  void missed(source::Location where, const Miss& miss);
  /// Where it was, if it had no signal and the program has not looked.
  [[nodiscard]] std::optional<source::Location> last() const { return last_; }

  // What the present statement reads.

  /// The position that the signal would have latched.
  void reads_result();
  /// Where the axes are: good for comparing only.
  void looks();
  /// A signal: whoever compares that which the move listened to has looked.
  void looks_at_signal(int input);
  /// Another input, which may tell of the signal for all that is known: the program has looked
  /// behind the move.
  void looks_at_input() { is_last_read_ = true; }
  void reads(Holder holder);
  /// What the statement has read so far, which counts as not read then.  @returns nullptr: nothing
  [[nodiscard]] Reading set_aside();
  void reads(const Reading& reading);

  // What becomes of it, which ends the statement.

  /// Two values of it are compared with each other.
  void compares(const Side& left, const Side& right);
  /// The way through the program depends on it.
  void decides();
  /// It is in a variable now; what was there is gone.
  void assigns(Holder holder);
  /// The axes go there: the result serves as a position.
  void moves() {
    if (!read_.is_empty()) {
      serves_as_way();
    }
  }
  /// Nothing comes of it that is followed.
  void passes_on() {
    if (!read_.is_empty()) {
      end_statement();
    }
  }
  /// It counts as measured.  @returns the moves that gave none; each is told once
  std::vector<source::Location> uses();

  /// The program has asked whether the last measuring move had its signal.
  void asks();
  /// The same of one signal.
  void asks(int input);

  /// These variables are gone: those of a call that ends.
  void forget(Holder first, Holder last);

  /// The end of the program.  @returns the moves whose result is left in a variable, and the last
  /// one when nothing was made of it
  std::vector<source::Location> ends();
  /// The program is broken off: it may still have looked at what it keeps.  @returns the last move
  /// when nothing was made of it
  std::vector<source::Location> breaks_off();

  bool operator==(const MissedTouches&) const = default;

 private:
  /// Where moves stand, by how many were before them: two ends at one place are two moves.
  class Moves {
   public:
    void add(source::Location where, std::uint64_t number);
    void add(const Moves& others);
    void remove(const Moves& others);
    [[nodiscard]] bool has_any_of(const Moves& others) const;
    [[nodiscard]] bool empty() const { return places_.empty(); }
    [[nodiscard]] std::size_t size() const { return places_.size(); }
    [[nodiscard]] bool contains(std::uint64_t number) const { return places_.contains(number); }
    /// Each place once.
    [[nodiscard]] std::vector<source::Location> in_order() const;
    bool operator==(const Moves&) const = default;

   private:
    std::map<std::uint64_t, source::Location> places_;
  };

  struct Held {
    Moves results;        ///< whose result it is made of
    Moves measured;       ///< of them: not by way of such a position
    Moves looks;          ///< whose end it shows
    Moves signals;        ///< whose signal it shows
    Moves excused;        ///< of the results: they were compared while they stood here
    bool is_way = false;  ///< it has served as a position
    std::vector<Holder> made_of;

    /// Whether it is made of no move, or of none that is owed any longer.
    [[nodiscard]] bool is_of_none() const {
      return results.empty() && looks.empty() && signals.empty();
    }
    [[nodiscard]] bool is_empty() const { return is_of_none() && made_of.empty(); }
    void add(const Held& other);
    bool operator==(const Held&) const = default;
  };

  void serves_as_way();
  void serves_as_way(Holder holder, const Moves& moves);
  [[nodiscard]] bool listened_to(int input) const {
    return miss_.input == 0 || miss_.input == input;
  }
  void settle(const Moves& moves);
  void excuse(const Moves& moves);
  void add_unread(Moves& moves) const;
  std::vector<source::Location> told(const Moves& moves);
  void end_statement();
  void count();

  std::map<Holder, Held> holders_;
  Held read_;                             ///< by the present statement
  std::optional<source::Location> last_;  ///< measuring move, while it is owed
  std::uint64_t missed_count_ = 0;
  Miss miss_;  ///< the last one
  bool is_last_read_ = false;
  bool is_owed_ = false;
};

}  // namespace g31::runtime

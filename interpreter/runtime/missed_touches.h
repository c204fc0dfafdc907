#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <utility>
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
/// settles the moves whose result goes into it, wherever else that result is.  While nothing is
/// owed, nothing has to be said.
class MissedTouches {
  struct Held;

 public:
  /// A variable as the dialect counts them, the same number for the same variable.
  using Holder = std::uint64_t;

  /// What a part of a statement has read: an argument that a called program gets.
  using Reading = std::shared_ptr<const Held>;

  /// Whether a move without a signal is still unsettled.
  [[nodiscard]] bool any() const { return is_owed_; }

  // The last measuring move of the program.

  void touched();
  void missed(source::Location where);
  /// Where it was, if it had no signal and the program has not looked.
  [[nodiscard]] std::optional<source::Location> last() const { return last_; }

  // What the present statement reads.

  /// The position that the signal would have latched.
  void reads_result();
  /// Where the axes are, or the signal itself: good for comparing only.
  void looks();
  void reads(Holder holder);
  /// What the statement has read so far, which counts as not read then.  @returns nullptr: nothing
  [[nodiscard]] Reading set_aside();
  void reads(const Reading& reading);

  // What becomes of it, which ends the statement.

  /// It is compared with something.
  void compares();
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

  /// These variables are gone: those of a call that ends.
  void forget(Holder first, Holder last);

  /// The end of the program.  @returns the moves whose result is left in a variable, and the last
  /// one when nothing was made of it
  std::vector<source::Location> ends();

  bool operator==(const MissedTouches&) const = default;

 private:
  /// Where moves stand, each with how many were before it: what is told is told in their order.
  class Moves {
   public:
    void add(source::Location where, std::uint64_t number);
    void add(const Moves& others);
    void remove(const Moves& others);
    [[nodiscard]] bool has_any_of(const Moves& others) const;
    [[nodiscard]] bool empty() const { return places_.empty(); }
    [[nodiscard]] bool contains(source::Location where) const;
    [[nodiscard]] std::vector<source::Location> in_order() const;
    bool operator==(const Moves&) const = default;

   private:
    using Place = std::pair<source::FileId, std::uint64_t>;
    struct Move {
      source::Location where;
      std::uint64_t number = 0;
      bool operator==(const Move&) const = default;
    };
    static Place place_of(source::Location where) { return {where.file, where.begin}; }
    std::map<Place, Move> places_;
  };

  struct Held {
    Moves results;        ///< whose result it is made of
    Moves looks;          ///< whose end it shows
    bool is_way = false;  ///< it has served as a position
    std::vector<Holder> made_of;

    [[nodiscard]] bool is_empty() const {
      return results.empty() && looks.empty() && made_of.empty();
    }
    bool operator==(const Held&) const = default;
  };

  void serves_as_way();
  void serves_as_way(Holder holder, const Moves& moves);
  void settle(const Moves& moves);
  std::vector<source::Location> told(const Moves& moves);
  void end_statement();
  void count();

  std::map<Holder, Held> holders_;
  Held read_;                             ///< by the present statement
  std::optional<source::Location> last_;  ///< measuring move, while it is owed
  std::uint64_t missed_count_ = 0;
  bool is_last_read_ = false;
  bool is_owed_ = false;
};

}  // namespace g31::runtime

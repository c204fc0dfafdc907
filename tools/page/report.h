#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <map>
#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "interpreter/source/diagnostic.h"
#include "tools/expect/characteristic.h"
#include "tools/page/language.h"
#include "tools/plot/growth.h"

namespace g31::page {

/// A place in a program that the page can show; line 0: none.
struct Place {
  std::string file;  ///< without its folder
  int line = 0;
};

/// How it ended, for the sign beside the headline.
enum class Sign : std::uint8_t {
  Good,
  Bad,     ///< ran to its end, and something is not as it should be
  Broken,  ///< did not come to its end
};

/// The answer first.
struct Verdict {
  Sign sign = Sign::Good;
  std::string state;     ///< in two or three words
  std::string headline;  ///< a sentence
  std::string sentence;  ///< why
};

/// What is to be looked at.
struct Finding {
  source::Severity severity = source::Severity::Note;
  std::string code;
  std::string text;
  Place place;
  std::string excerpt = {};               ///< the line with a mark under it; "": none
  std::vector<std::string> remarks = {};  ///< what would be right, what led to it
};

struct Frame {
  std::string program;
  Place place;
  std::string text;  ///< of the block
};

/// Where a run ended before its time.
struct Ending {
  std::string title;
  std::vector<Frame> stack;  ///< innermost first
  std::vector<std::pair<std::string, std::string>> variables;
  std::vector<std::pair<std::string, std::string>> facts;  ///< positions, what met what
};

/// One row of the table of results; all numbers in its unit.
struct Characteristic {
  std::string name;                        ///< for people
  std::string variable;                    ///< "_OVR[4]"
  std::optional<expect::ResultUnit> unit;  ///< nullopt: nobody says which
  std::optional<double> nominal;
  std::optional<expect::Limits> tolerance;  ///< from the nominal; nullopt: it is not judged
  std::optional<double> measured;           ///< nullopt: not reached
  std::optional<bool> is_as_expected;       ///< of what is to be vacant; nullopt: it is a size
  std::optional<double> true_size;          ///< of the simulated part, where it is known
  std::optional<double> other;              ///< in the run that is compared, where it tells
  std::vector<std::size_t> touches;         ///< numbers
};

/// Measured less nominal; nullopt where one of them is not there.
std::optional<double> deviation_of(const Characteristic& row);

/// By how much the deviation is beyond a limit, by the rule that runs are judged by; 0: it is in
/// tolerance, or there is none.
double excess_of(const Characteristic& row);
/// Whether it is beyond one.
bool is_out(const Characteristic& row);

/// How a value of the row is written: one digit more than nominal and tolerance have, and as many
/// more as tell one that is out from its limit.
int decimals_of(const Characteristic& row);

/// "mm"; "" where nobody says which.
std::string_view unit_name(const Characteristic& row);

/// A difference of two values of the row, with its sign: "+15.0 µm" of a length, "+0.0150" or
/// "+0.0150 deg" of all else; a dash where there is none.
std::string difference_text(const Characteristic& row, const std::optional<double>& difference);

/// One skip move.
struct TouchRow {
  std::string block;  ///< "G31", "MEAS"
  Place place;
  double time_s = 0.0;
  double feed = 0.0;
  bool is_triggered = false;
  std::array<double, 3> commanded = {};  ///< work coordinates
  std::array<double, 3> latched = {};
  std::string part;                              ///< "": none
  std::optional<std::array<double, 3>> contact;  ///< in the frame of the part
  std::optional<double> deviation_mm;            ///< how much too deep the ball was latched
  std::optional<double> angle_deg;               ///< between the move and the inward normal
  std::string caller;  ///< the call of the main program that it belongs to
};

/// A program that ran.
struct Listing {
  std::string file;  ///< without its folder
  std::string text;  ///< UTF-8
  std::map<int, std::uint64_t> counts;
  std::map<int, std::array<std::uint64_t, 2>> conditions;  ///< not met, met
};

struct VariableRow {
  std::string name;
  std::string meaning;
  std::uint64_t writes = 0;
  std::vector<std::pair<double, std::optional<double>>> values;  ///< over time; null: vacant
  std::string last;
};

struct Printout {
  std::string kind;  ///< "M00", "MSG"; "": printed
  std::string text;
  Place place;
};

struct Input {
  std::string file;
  std::string what;
  std::string sha256;
};

/// A drawing of its own: histogram, run chart, plot.
struct Drawing {
  std::string title;
  std::string svg;
  std::string caption;
  bool is_half = false;  ///< where there is room, beside the next one
};

/// A plain table; cells of numbers are right-aligned.
struct Table {
  std::string title;
  std::vector<std::string> head;
  std::vector<std::vector<std::string>> rows;
  std::optional<std::size_t>
      english_column;       ///< whose cells are messages, the same in all languages
  bool is_results = false;  ///< of the command: `#results`, which the contract names
};

/// Everything that a page shows.  Empty parts are left out of it.
struct Report {
  Language language = Language::English;
  std::string title;  ///< the file that it is about
  std::string what;   ///< beside the title
  Verdict verdict;
  std::vector<Finding> findings;
  std::vector<std::pair<std::string, std::string>> facts;
  std::string command;  ///< that repeats it
  std::optional<Ending> ending;
  std::vector<Characteristic> results;
  std::string results_of;   ///< "the part as machined"; "": there is one alone
  bool has_motion = false;  ///< plan, scene and time line are to be drawn
  double duration_s = 0.0;
  std::string frame;  ///< "G54": of commanded and latched positions
  std::vector<TouchRow> touches;
  std::string motion_of;  ///< the part that moves and touches are of; "": there is one alone
  std::vector<Drawing> drawings;
  std::vector<Table> tables;
  std::vector<Listing> listings;
  std::vector<VariableRow> variables;
  bool has_printouts = false;  ///< the part is there, though nothing was printed
  std::vector<Printout> printouts;
  std::vector<Input> inputs;
  std::vector<std::string> limits;  ///< what was not simulated
  Word caution = Word::CarefulRun;  ///< the last word of the page
  std::string document;             ///< JSON of the command
  std::string figures;              ///< JSON of what only pictures need; "": none
  plot::Growth growth = {};         ///< told of the page as a long document goes into it
  /// Of a page that is served and makes way for the next one; 0: it stays as it is.
  std::uint64_t edition = 0;
};

}  // namespace g31::page

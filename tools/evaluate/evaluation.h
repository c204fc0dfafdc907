#pragma once

#include <array>
#include <cstddef>
#include <optional>
#include <span>
#include <string>
#include <string_view>
#include <vector>

#include "tools/plot/growth.h"

namespace g31::evaluate {

/// Rows of evaluation_kinds.def.
enum class Kind {
#define EVALUATION_KIND(name, word, columns, leads, text) name,
#include "tools/evaluate/evaluation_kinds.def"
#undef EVALUATION_KIND
};

struct KindRow {
  Kind kind;
  std::string_view word;     ///< on the command line and in the document
  std::string_view columns;  ///< of the file
  std::string_view leads;    ///< names of results as of ResultRow, blanks between them
  std::string_view text;
};

/// Rows of evaluation_options.def.
enum class OptionId {
#define EVALUATION_OPTION(name, option, value, kinds, text) name,
#include "tools/evaluate/evaluation_options.def"
#undef EVALUATION_OPTION
};

struct OptionRow {
  OptionId id;
  std::string_view option;  ///< "--radius"
  std::string_view value;   ///< what stands for its value in help
  std::string_view kinds;   ///< words, blanks between them
  std::string_view text;
};

std::span<const OptionRow> options();
bool belongs_to(const OptionRow& option, Kind kind);

/// Rows of evaluation_results.def.
struct ResultRow {
  std::string_view kinds;  ///< words, blanks between them
  std::string_view name;   ///< of results, * for any letter or digit
  std::string_view unit;
  std::string_view text;
};

std::span<const ResultRow> results();
bool belongs_to(const ResultRow& result, Kind kind);
/// Whether a result of this name is of the row.
bool names(const ResultRow& result, std::string_view name);

std::span<const KindRow> kinds();
const KindRow& info(Kind kind);

/// One result.
struct Quantity {
  std::string name;
  std::optional<double> value;  ///< nothing: the record does not say
  std::string_view unit;
  std::optional<double> u = {};  ///< standard uncertainty, where it is known
};

/// Decimals that show a value to the second digit of its uncertainty; nothing where that is not
/// known, is next to nothing, or is 1 and more.
std::optional<int> decimals_by_u(const Quantity& quantity);

inline constexpr double kUmPerMm = 1e3;

/// Micrometres.
inline std::optional<double> um(const std::optional<double>& mm) {
  return mm ? std::optional(kUmPerMm * *mm) : std::nullopt;
}

/// The letter of an axis as results write it: "x".
std::string lower(std::string_view axis);

/// A fall of speed.
struct Dip {
  double time_s = 0.0;
  double speed_mm_min = 0.0;
  double width_s = 0.0;
};

/// Deviations along a way, mm: pairs of place and deviation.
struct Curve {
  std::string name;
  std::vector<std::array<double, 2>> points;
};

/// An error of the machine along an axis.
struct MachineError {
  std::string name;  ///< ISO 230-1: EYX is along Y while X moves, EXX that of X itself
  Curve deviations;  ///< by rising places of the moving axis
};

/// What a record says.
struct Evaluation {
  Kind kind = Kind::Circle;
  std::size_t samples = 0;  ///< rows of the file
  std::vector<Quantity> results;
  std::optional<std::vector<Dip>> dips = {};
  std::vector<Curve> curves = {};
  std::optional<MachineError> machine_error = {};  ///< what a compensation can take away
  std::string svg = {};                            ///< the drawing, where one was asked for
  std::vector<std::string> notes = {};             ///< what has to be known to read the results
};

/// The results that answer first, of each name of `leads` the one that is largest in size; the
/// first of all where none of them has a value.
std::vector<const Quantity*> leading(const Evaluation& evaluation);

/// The document g31.evaluation/1.
/// @param growth  here and below: told of it as it grows; may end the work
std::string evaluation_document(const Evaluation& evaluation, bool with_curves,
                                const plot::Growth& growth = {});

/// The results for a person.
std::string evaluation_table(const Evaluation& evaluation, const plot::Growth& growth = {});

}  // namespace g31::evaluate

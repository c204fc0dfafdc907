#pragma once

#include <array>
#include <cstdint>
#include <optional>
#include <string>
#include <variant>
#include <vector>

#include "machine/base/result.h"
#include "tools/evaluate/data_error.h"
#include "tools/evaluate/data_table.h"
#include "tools/evaluate/evaluation.h"
#include "tools/plot/growth.h"
#include "tools/plot/language.h"

namespace g31::evaluate {

/// What a sensor's reading does as the work comes nearer: rise, or fall.
enum class Sense : std::uint8_t { Travel, Gap };

using Pair = std::array<double, 2>;

/// What is to be evaluated, and what is known beside the file.  Lengths in mm.
struct Request {
  Kind kind = Kind::Circle;
  ColumnRules columns = {};
  std::optional<double> interval_s = {};  ///< between rows, in the place of a column t
  std::array<std::string, 2> plane = {"X", "Y"};
  std::optional<double> radius = {};
  std::optional<Pair> centre = {};
  std::array<std::optional<double>, 2> pitches = {};  ///< of cyclic errors, by axis of the plane
  std::optional<double> side = {};
  std::optional<std::array<double, 3>> detail = {};  ///< of a drawing: its middle and its width
  std::optional<Pair> target = {};
  std::optional<double> on = {};
  std::optional<double> step = {};
  Sense sense = Sense::Travel;
  std::optional<double> uncertainty = {};  ///< of a reading, standard
  std::optional<double> from = {};
  std::optional<DataFile> diameters = {};
  std::optional<std::string> axis = {};
  std::string error = "EYX";  ///< what a straightness is, by ISO 230-1
  bool wants_curves = false;  ///< of paths: every sample's deviation
  bool wants_drawing = false;
  plot::Language language = plot::Language::English;  ///< of a drawing
  plot::Growth growth = {};  ///< told of a drawing as it grows; may end the work
  double magnify = 0.0;      ///< how many times a drawing enlarges errors; 0: so that they are seen
};

/// Evaluates a file.  Error: what is wrong with it, at its place.
Result<Evaluation, DataError> evaluate(const DataFile& file, const Request& request);

}  // namespace g31::evaluate

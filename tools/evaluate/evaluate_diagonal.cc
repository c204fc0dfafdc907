#include <cmath>

#include "tools/evaluate/evaluate_path.h"

namespace g31::evaluate {
namespace {

constexpr double kUsualLength = 300.0;  // mm, what limits of squareness are given on

}  // namespace

Result<Evaluation, DataError> evaluate_diagonal(const DataFile& file, const Request& request) {
  std::vector<WantedColumn> wanted;
  for (const std::string& axis : request.plane) {
    wanted.push_back({axis, ColumnKind::Length, axis + "_true"});
  }
  const auto table = read_table(file, wanted, request.columns);
  if (!table) {
    return table.error();
  }
  Evaluation evaluation;
  evaluation.kind = Kind::Diagonal;
  evaluation.samples = table.value().size();
  std::vector<Quantity> scaled;
  for (std::size_t i : {0U, 1U}) {
    const std::string& axis = request.plane.at(i);
    const double target = request.target->at(i);
    const double error = table.value().numbers(axis).back() - target;
    const double factor = request.on.value_or(kUsualLength) / std::abs(target);
    evaluation.results.push_back({"error_" + axis, um(error), "um"});
    scaled.push_back(
        {"error_" + axis + "_on", target != 0.0 ? um(error * factor) : std::nullopt, "um"});
  }
  evaluation.results.insert(evaluation.results.end(), scaled.begin(), scaled.end());
  return evaluation;
}

}  // namespace g31::evaluate

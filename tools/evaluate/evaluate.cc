#include "tools/evaluate/evaluate.h"

#include <utility>

#include "machine/base/contract.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/evaluate_readings.h"

namespace g31::evaluate {
namespace {

Result<Evaluation, DataError> evaluate_file_of_path(const DataFile& file, const Request& request) {
  const auto path = read_path(file, request);
  if (!path) {
    return path.error();
  }
  auto evaluation = evaluate_path(path.value(), request);
  if (!evaluation) {
    return data_error(DataErrorId::CannotEvaluate, file, {}, {evaluation.error()});
  }
  return std::move(evaluation.value());
}

}  // namespace

bool is_of_path(Kind kind) {
  return kind == Kind::Circle || kind == Kind::Square || kind == Kind::Speed ||
         kind == Kind::Diagonal;
}

PathEvaluation evaluate_path(const RecordedPath& path, const Request& request) {
  G31_EXPECTS(is_of_path(request.kind));
  if (path.x.empty()) {
    return std::string("nothing was recorded");
  }
  if (request.kind == Kind::Circle) {
    return evaluate_circle(path, request);
  }
  if (request.kind == Kind::Square) {
    return evaluate_square(path, request);
  }
  return request.kind == Kind::Speed ? evaluate_speed(path, request)
                                     : evaluate_diagonal(path, request);
}

Result<Evaluation, DataError> evaluate(const DataFile& file, const Request& request) {
  if (is_of_path(request.kind)) {
    return evaluate_file_of_path(file, request);
  }
  if (request.kind == Kind::Straightness) {
    return evaluate_straightness(file, request);
  }
  if (request.kind == Kind::Flatness) {
    return evaluate_flatness(file, request);
  }
  if (request.kind == Kind::Cylindricity) {
    return evaluate_cylindricity(file, request);
  }
  G31_EXPECTS(request.kind == Kind::Positioning);
  return evaluate_positioning(file, request);
}

}  // namespace g31::evaluate

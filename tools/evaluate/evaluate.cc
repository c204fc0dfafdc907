#include "tools/evaluate/evaluate.h"

#include "machine/base/contract.h"
#include "tools/evaluate/evaluate_path.h"
#include "tools/evaluate/evaluate_readings.h"

namespace g31::evaluate {

Result<Evaluation, DataError> evaluate(const DataFile& file, const Request& request) {
  switch (request.kind) {
    case Kind::Circle:
      return evaluate_circle(file, request);
    case Kind::Square:
      return evaluate_square(file, request);
    case Kind::Speed:
      return evaluate_speed(file, request);
    case Kind::Diagonal:
      return evaluate_diagonal(file, request);
    case Kind::Straightness:
      return evaluate_straightness(file, request);
    case Kind::Flatness:
      return evaluate_flatness(file, request);
    case Kind::Cylindricity:
      return evaluate_cylindricity(file, request);
    case Kind::Positioning:
      return evaluate_positioning(file, request);
  }
  contract_violated("every kind has its evaluation", __FILE__, __LINE__);
}

}  // namespace g31::evaluate

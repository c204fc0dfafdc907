#include "tools/evaluate/evaluate.h"

#include "machine/base/contract.h"
#include "tools/evaluate/evaluate_path.h"

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
  }
  contract_violated("every kind has its evaluation", __FILE__, __LINE__);
}

}  // namespace g31::evaluate

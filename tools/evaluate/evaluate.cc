#include "tools/evaluate/evaluate.h"

#include "machine/base/contract.h"
#include "tools/evaluate/evaluate_path.h"

namespace g31::evaluate {

Result<Evaluation, DataError> evaluate(const DataFile& file, const Request& request) {
  switch (request.kind) {
    case Kind::Circle:
      return evaluate_circle(file, request);
  }
  contract_violated("every kind has its evaluation", __FILE__, __LINE__);
}

}  // namespace g31::evaluate

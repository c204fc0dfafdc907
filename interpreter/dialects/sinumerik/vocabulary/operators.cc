#include "interpreter/dialects/sinumerik/vocabulary/operators.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kOperatorRows = std::to_array<OperatorInfo>({
#define OPERATOR(name, level, kind, code, text) \
  {name, level, OperatorKind::kind, OpCode::code, text},
#include "interpreter/dialects/sinumerik/vocabulary/operators.def"
#undef OPERATOR
});

}  // namespace

std::span<const OperatorInfo> operators() {
  return kOperatorRows;
}

}  // namespace g31::sinumerik

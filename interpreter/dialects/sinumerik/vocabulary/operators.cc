#include "interpreter/dialects/sinumerik/vocabulary/operators.h"

#include <array>

namespace g31::sinumerik {
namespace {

constexpr auto kRows = std::to_array<OperatorInfo>({
#define OPERATOR(name, level, code, text) {name, level, OpCode::code, text},
#include "interpreter/dialects/sinumerik/vocabulary/operators.def"
#undef OPERATOR
});

}  // namespace

std::span<const OperatorInfo> operators() {
  return kRows;
}

}  // namespace g31::sinumerik

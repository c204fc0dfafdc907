#include "interpreter/dialects/sinumerik/vocabulary/functions.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include "interpreter/dialects/sinumerik/vocabulary/names.h"
#include "interpreter/runtime/angles.h"
#include "machine/base/contract.h"

namespace g31::sinumerik {
namespace {

constexpr auto kFunctionRows = std::to_array<FunctionInfo>({
#define FUNCTION(name, result, parameters, form, text) \
  {#name, Type::result, parameters, form, text},
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
});

constexpr double kRadians = std::numbers::pi / 180.0;

std::optional<double> within(double limit, double value, double result) {
  return std::abs(value) <= limit ? std::optional(result) : std::nullopt;
}

std::optional<double> one_number(FunctionId id, double a) {
  switch (static_cast<int>(id)) {
    case static_cast<int>(FunctionId::SIN):
      return runtime::sine_deg(a);
    case static_cast<int>(FunctionId::COS):
      return runtime::cosine_deg(a);
    case static_cast<int>(FunctionId::TAN):
      return runtime::cosine_deg(a) == 0.0
                 ? std::nullopt
                 : std::optional(runtime::sine_deg(a) / runtime::cosine_deg(a));
    case static_cast<int>(FunctionId::ASIN):
      return within(1.0, a, std::asin(a) / kRadians);
    case static_cast<int>(FunctionId::ACOS):
      return within(1.0, a, std::acos(a) / kRadians);
    case static_cast<int>(FunctionId::SQRT):
      return a < 0.0 ? std::nullopt : std::optional(std::sqrt(a));
    case static_cast<int>(FunctionId::ABS):
      return std::abs(a);
    case static_cast<int>(FunctionId::POT):
      return a * a;
    case static_cast<int>(FunctionId::TRUNC):
      return std::trunc(a);
    case static_cast<int>(FunctionId::ROUND):
      return rounded(a);
    case static_cast<int>(FunctionId::ROUNDUP):
      return std::ceil(a) + 0.0;  // no -0
    case static_cast<int>(FunctionId::LN):
      return a <= 0.0 ? std::nullopt : std::optional(std::log(a));
    case static_cast<int>(FunctionId::EXP):
      return std::exp(a);
    default:
      contract_violated("this function takes no single number", __FILE__, __LINE__);
  }
}

}  // namespace

std::span<const FunctionInfo> functions() {
  return kFunctionRows;
}

const FunctionInfo& info(FunctionId id) {
  return kFunctionRows.at(static_cast<std::size_t>(id));
}

std::optional<FunctionId> find_function(std::string_view name) {
  static const NameMap<FunctionId> kByName = [] {
    NameMap<FunctionId> map;
    for (std::size_t i = 0; i < kFunctionRows.size(); ++i) {
      map.emplace(std::string(kFunctionRows[i].name), static_cast<FunctionId>(i));
    }
    return map;
  }();
  const auto found = kByName.find(name);
  return found != kByName.end() ? std::optional(found->second) : std::nullopt;
}

double rounded(double value) {
  return std::floor(value + 0.5);
}

std::optional<double> kept_as(Type type, double value) {
  const double whole = rounded(value);
  switch (type) {
    case Type::Bool:
      return value != 0.0 ? 1.0 : 0.0;
    case Type::Char:
      return whole >= 0.0 && whole <= 255.0 ? std::optional(whole) : std::nullopt;
    case Type::Int:
      return whole >= -2147483648.0 && whole <= 2147483647.0 ? std::optional(whole) : std::nullopt;
    case Type::None:
    case Type::Real:
    case Type::Axis:
    case Type::String:
    case Type::Frame:
      return value;
  }
  return value;
}

std::optional<double> mathematics(FunctionId id, double a, double b) {
  std::optional<double> result;
  if (id == FunctionId::ATAN2) {
    result = a == 0.0 && b == 0.0 ? 0.0 : std::atan2(a, b) / kRadians;
  } else if (id == FunctionId::MINVAL) {
    result = std::min(a, b);
  } else if (id == FunctionId::MAXVAL) {
    result = std::max(a, b);
  } else {
    result = one_number(id, a);
  }
  return result && std::isfinite(*result) ? result : std::nullopt;
}

}  // namespace g31::sinumerik

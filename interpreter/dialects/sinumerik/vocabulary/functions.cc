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
#define FUNCTION(name, result, parameters, work, form, text) \
  {#name, Type::result, parameters, form, text},
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
});

constexpr double kRadians = std::numbers::pi / 180.0;

std::optional<double> within(double limit, double value, double result) {
  return std::abs(value) <= limit ? std::optional(result) : std::nullopt;
}

double sine(double degrees) {
  return runtime::sine_deg(degrees);
}
double cosine(double degrees) {
  return runtime::cosine_deg(degrees);
}
std::optional<double> tangent(double degrees) {
  return cosine(degrees) == 0.0 ? std::nullopt : std::optional(sine(degrees) / cosine(degrees));
}
std::optional<double> arc_sine(double a) {
  return within(1.0, a, std::asin(a) / kRadians);
}
std::optional<double> arc_cosine(double a) {
  return within(1.0, a, std::acos(a) / kRadians);
}
double angle_of(double y, double x) {
  return x == 0.0 && y == 0.0 ? 0.0 : std::atan2(y, x) / kRadians;
}
std::optional<double> square_root(double a) {
  return a < 0.0 ? std::nullopt : std::optional(std::sqrt(a));
}
double magnitude(double a) {
  return std::abs(a);
}
double square(double a) {
  return a * a;
}
double truncated(double a) {
  return std::trunc(a);
}
double rounded_up(double a) {
  return std::ceil(a) + 0.0;  // no -0
}
std::optional<double> logarithm(double a) {
  return a <= 0.0 ? std::nullopt : std::optional(std::log(a));
}
double exponential(double a) {
  return std::exp(a);
}
double smaller(double a, double b) {
  return std::min(a, b);
}
double larger(double a, double b) {
  return std::max(a, b);
}

/// Whether the column `parameters` has as many numbers as `work` takes; 0: what a step takes is its
/// own.
consteval bool takes(std::string_view parameters, std::size_t numbers) {
  return numbers == 0 || parameters == std::string_view("NN").substr(0, numbers);
}
#define OfOne(f) 1
#define OfTwo(f) 2
#define Called(f) 0
#define FUNCTION(name, result, parameters, work, form, text) \
  static_assert(takes(parameters, work), #name);
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
#undef Called
#undef OfTwo
#undef OfOne

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
  switch (id) {
#define OfOne(f) result = f(a)
#define OfTwo(f) result = f(a, b)
#define Called(f) contract_violated("this function takes more than numbers", __FILE__, __LINE__)
#define FUNCTION(name, result, parameters, work, form, text) \
  case FunctionId::name:                                     \
    work;                                                    \
    break;
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
#undef Called
#undef OfTwo
#undef OfOne
  }
  return result && std::isfinite(*result) ? result : std::nullopt;
}

}  // namespace g31::sinumerik

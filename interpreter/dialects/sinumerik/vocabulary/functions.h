#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string_view>

#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"

namespace g31::sinumerik {

/// Rows of functions.def.
enum class FunctionId : std::uint8_t {
#define FUNCTION(name, result, parameters, work, form, text) name,
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
};

struct FunctionInfo {
  std::string_view name;
  Type result;
  std::string_view parameters;
  std::string_view form;
  std::string_view text;
};

std::span<const FunctionInfo> functions();

const FunctionInfo& info(FunctionId id);

/// @param name  upper case
std::optional<FunctionId> find_function(std::string_view name);

/// Functions of one or two numbers that are computed on the spot; angles in degrees.
constexpr bool is_plain_mathematics(FunctionId id) {
  switch (id) {
#define OfOne(f) true
#define OfTwo(f) true
#define Called(f) false
#define FUNCTION(name, result, parameters, work, form, text) \
  case FunctionId::name:                                     \
    return work;
#include "interpreter/dialects/sinumerik/vocabulary/functions.def"
#undef FUNCTION
#undef Called
#undef OfTwo
#undef OfOne
  }
  return false;
}

/// The value of such a function; nullopt outside its domain (SQRT(-1), LN(0), ASIN(2)).
std::optional<double> mathematics(FunctionId id, double a, double b);

/// As TO INT rounds: halves upwards, as the control does.
double rounded(double value);

/// The bits of a mask that is kept as a number.  @param mask  of INT
constexpr std::uint32_t bits_of(double mask) {
  return static_cast<std::uint32_t>(static_cast<std::int64_t>(mask));
}

/// A number as a variable of this type keeps it; nullopt: it is no INT or no CHAR.
std::optional<double> kept_as(Type type, double value);

}  // namespace g31::sinumerik

#pragma once

#include <string>

#include "interpreter/dialects/sinumerik/vocabulary/value_type.h"
#include "interpreter/runtime/shown_value.h"

namespace g31::sinumerik {

/// A value as --print shows it.
struct ShownValue {
  Type type = Type::None;
  double number = 0.0;
  std::string text;
};

/// The same as reports show it: an axis by its name.
runtime::ShownValue shown_value(const ShownValue& value);

}  // namespace g31::sinumerik

#pragma once

#include <string_view>

#include "interpreter/source/diagnostic.h"
#include "tools/page/report.h"

namespace g31::page {

// Signs are shapes, so that they tell without colour: circle, diamond, octagon, triangle.

std::string_view svg_of(Sign sign);
std::string_view svg_of(source::Severity severity);

/// The class by which the style sheet knows it.
std::string_view class_of(Sign sign);

}  // namespace g31::page

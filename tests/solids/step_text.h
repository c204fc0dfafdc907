#pragma once

#include <string>

#include <TopoDS_Shape.hxx>

namespace g31::testing {

/// Writes a shape (lengths in mm) as STEP, AP214: the same bytes at every time and on every
/// computer.
/// @param name  of the product, which the head of the file says, too
/// @param unit  of the lengths in the file, a value of Open CASCADE's write.step.unit
void write_step(const TopoDS_Shape& shape, const std::string& name, const std::string& path,
                const std::string& unit = "MM");

}  // namespace g31::testing

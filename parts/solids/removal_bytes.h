#pragma once

#include "parts/import/byte_stream.h"
#include "parts/solids/removal.h"

// A removal as bytes, as byte_stream.h says.

namespace g31::parts {

template <typename Stream>
void pass(Stream& stream, RemovedFace& face) {
  pass(stream, face.surface);
  pass(stream, face.is_open);
  for (Point* const p : {&face.at_P, &face.normal_P, &face.axis_at_P, &face.axis_P}) {
    pass(stream, *p);
  }
  pass(stream, face.radius_mm);
  pass(stream, face.area_mm2);
  pass(stream, face.border_P);
}

template <typename Stream>
void pass(Stream& stream, RemovedVolume& volume) {
  pass(stream, volume.box_P);
  pass(stream, volume.volume_mm3);
  pass(stream, volume.faces);
  pass(stream, volume.is_beside);
  pass(stream, volume.rounding_mm);
}

template <typename Stream>
void pass(Stream& stream, DrawnDimension& dimension) {
  pass(stream, dimension.nominal_mm);
  pass(stream, dimension.lower_mm);
  pass(stream, dimension.upper_mm);
  pass(stream, dimension.faces);
}

template <typename Stream>
void pass(Stream& stream, Removal& removal) {
  pass(stream, removal.product_P);
  pass(stream, removal.stock_P);
  pass(stream, removal.volumes);
  pass(stream, removal.dimensions);
}

}  // namespace g31::parts

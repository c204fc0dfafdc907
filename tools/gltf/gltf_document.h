#pragma once

#include <span>
#include <string>

#include "tools/gltf/trace.h"
#include "tools/picture/pictured_part.h"

namespace g31::gltf {

enum class GltfForm {
  Binary,  ///< .glb
  Text,    ///< .gltf, the numbers in it as base64
};

/// A picture of a run as one glTF 2.0 file, for any viewer.
///
/// All of it hangs under one node that turns machine coordinates (mm, +Z up) to those of glTF
/// (metres, +Y up), or, where rotary axes turn part and tool against each other, coordinates of the
/// part as it stands with these axes at 0; its name says which.  There are parts by name with their
/// edges, darker towards their lowest place; ways as lines and thin tubes by kind of motion; each
/// touch ("touch 3, ring") and each collision as a node with a small ball and a whisker along the
/// normal; what the spindle holds in true size. What is only known in double stands in the extras
/// of the nodes, in mm; positions in the buffer are float32.
///
/// The same picture gives the same bytes.
std::string gltf_document(std::span<const picture::PicturedPart> parts, const Trace& trace,
                          GltfForm form);

}  // namespace g31::gltf

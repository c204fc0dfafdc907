#pragma once

#include "tools/picture/base64.h"

namespace g31::gltf {

using picture::base64;

}  // namespace g31::gltf

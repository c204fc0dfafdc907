#pragma once

#include <string>

#include "parts/geometry/mesh.h"

// A function of the module g31_assimp, which is loaded when a mesh that g31 does not read by itself
// is to be read: assimp and its libraries would add 1 ms to each start of g31, which takes 3 ms.

/// Reads the scene of a mesh file, as parts::read_through_assimp says.
/// @param path   says the kind
/// @param bytes  of the file; taken
/// @param mesh   what was read
/// @param error  what is wrong, without the path; "": nothing
extern "C" __attribute__((visibility("default"))) void g31_read_scene(const char* path,
                                                                      std::string* bytes,
                                                                      g31::parts::Mesh* mesh,
                                                                      std::string* error);

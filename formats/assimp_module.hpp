// The door of the module mansard_meshes.
#pragma once

#include <string>

#include "geometry/mesh.hpp"

/// Everything Assimp reads (glTF, GLB, FBX, COLLADA, PLY, ...) as one mesh in its root's frame.
/// False on failure, with the reason in `problem`.
extern "C" bool mansard_read_mesh(const char* path, mansard::Mesh& mesh, std::string& problem);

#include "formats/meshes.hpp"

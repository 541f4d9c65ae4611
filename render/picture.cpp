#include "render/picture.hpp"

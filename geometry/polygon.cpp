#include "geometry/polygon.hpp"

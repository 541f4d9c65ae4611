#include "interpreter/footprint.hpp"

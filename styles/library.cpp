#include "styles/library.hpp"

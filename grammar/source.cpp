#include "grammar/source.hpp"

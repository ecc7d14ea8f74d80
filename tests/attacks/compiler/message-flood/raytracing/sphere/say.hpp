#if __INCLUDE_LEVEL__ < 20
#pragma message("a note of some length, again and again and again and again")
#include "say.hpp"
#include "say.hpp"
#endif

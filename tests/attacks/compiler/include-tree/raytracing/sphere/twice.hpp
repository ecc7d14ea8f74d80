#if __INCLUDE_LEVEL__ < 150
#include "twice.hpp"
#include "twice.hpp"
#endif

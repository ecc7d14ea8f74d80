#include <umbral/core/not_implemented.hpp>
#include <umbral/core/not_implemented_count.hpp>

namespace umbral {
namespace {
unsigned stubs_reached = 0;  // the one piece of state of a run; hidden, so that no other library can reach it
}

void mark_not_implemented() noexcept { ++stubs_reached; }
unsigned not_implemented_count() noexcept { return stubs_reached; }

}

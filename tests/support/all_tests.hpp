#pragma once

#include <cstdlib>

namespace umbral {

/// Is there time for everything, as in `./umbral test --all`, or for what CI runs?
inline bool tests_all() { return std::getenv("UMBRAL_TEST_ALL") != nullptr; }

/// So many samples for everything, a fifth of them for CI.
inline int samples_for_tests(int all) { return tests_all() ? all : all / 5; }

}

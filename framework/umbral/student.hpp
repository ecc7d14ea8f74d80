#pragma once

// What every student's file sees before its first line, with the interfaces of all topics
// (framework/umbral/<topic>/*.hpp): they are precompiled and force-included, so that a macro of the student's cannot
// change the layout of anything the driver shares with it. Keep them light: they are read on every check.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <limits>
#include <memory>
#include <optional>
#include <string>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <vector>

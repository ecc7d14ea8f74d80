#pragma once

// What every student's file sees before its first line, precompiled. The headers that the unit's stub includes follow
// it, so that a macro of the student's cannot change the layout of anything the driver shares with it. What several
// interfaces include stands here, since it is then read once for all.

#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <glm/gtc/type_ptr.hpp>
#include <iostream>
#include <limits>
#include <map>
#include <memory>
#include <numbers>
#include <optional>
#include <span>
#include <stdexcept>
#include <string>
#include <string_view>
#include <tuple>
#include <type_traits>
#include <umbral/core/grid.hpp>
#include <umbral/core/not_implemented.hpp>
#include <umbral/core/random.hpp>
#include <umbral/core/ray.hpp>
#include <utility>
#include <variant>
#include <vector>

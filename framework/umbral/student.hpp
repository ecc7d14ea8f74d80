#pragma once

// What every student's file sees before its first line: this header is precompiled and force-included, so that a macro
// of the student's cannot change the layout of anything the driver shares with it. Keep it light: it is read on every check.

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
#include <umbral/interaction/callbacks.hpp>
#include <umbral/interaction/orbit_camera.hpp>
#include <umbral/meshes/mesh.hpp>
#include <umbral/meshes/normals.hpp>
#include <umbral/pipeline/draw.hpp>
#include <umbral/pipeline/rasterize.hpp>
#include <umbral/projections/view.hpp>
#include <umbral/raytracing/intersect.hpp>
#include <umbral/texturing/lookup.hpp>
#include <umbral/transforms/rotation.hpp>
#include <vector>

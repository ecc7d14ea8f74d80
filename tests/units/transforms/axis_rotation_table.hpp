#pragma once

#include <umbral/transforms/rotation.hpp>

namespace umbral::tests {

/// All functions of one solution of transforms/axis-rotation.
struct Rotations {
    decltype(transforms::rotate_vector)* vector;
    decltype(transforms::rotation_matrix)* matrix;
    decltype(transforms::compose_rotations)* chain;
};

}

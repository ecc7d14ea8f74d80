#pragma once

#include <umbral/meshes/area.hpp>

namespace umbral::tests {

/// Both functions of one solution of meshes/area.
struct Areas {
    decltype(meshes::triangle_area)* triangle;
    decltype(meshes::surface_area)* mesh;
};

}

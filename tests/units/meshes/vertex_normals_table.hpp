#pragma once

#include <umbral/meshes/normals.hpp>

namespace umbral::tests {

/// Both functions of one solution of meshes/vertex-normals.
struct Normals {
    decltype(meshes::face_normals)* faces;
    decltype(meshes::vertex_normals)* vertices;
};

}

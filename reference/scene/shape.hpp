#pragma once

#include <glm/glm.hpp>
#include <string>
#include <variant>
#include <vector>

/// What things are made of: shapes in coordinates of their own, front counter-clockwise as seen from outside.
namespace umbral::scene {

/// The unit sphere, poles on the y axis; u goes round once, v from the south pole to the north pole.
struct Sphere {
    int rings = 32;    ///< between the poles
    int sectors = 64;  ///< round the axis
};

/// A ring of radius 1 round the y axis; u goes along it, v round the tube.
struct Torus {
    int rings = 96;      ///< along the ring
    int sectors = 48;    ///< round the tube
    float tube = 0.35F;  ///< the tube's radius
};

/// The square from (-1, 0, -1) to (1, 0, 1), facing +y; u goes along x, v along -z.
struct Plane {
    int rows = 1;
    int columns = 1;
};

/// The same square, lifted to y = amplitude · sin(2π waves.x u) · cos(2π waves.y v).
struct Wave {
    int rows = 96;
    int columns = 96;
    float amplitude = 0.1F;
    glm::vec2 waves{2};  ///< periods along u and v
};

/// A triangle mesh, written out in the scene or read from a file. Triangles may be degenerate; counter-clockwise is
/// their front.
struct Triangles {
    std::vector<glm::vec3> positions;
    std::vector<glm::uvec3> triangles;     ///< every index is less than positions.size()
    std::vector<glm::vec2> uvs;            ///< one for each position, or none; or what uv_triangles refer to
    std::vector<glm::uvec3> uv_triangles;  ///< places in uvs, one triple for each triangle; empty: those of positions
};

/// A triangle mesh in a file of its own, as a scene names it. Reading a scene from a file puts Triangles in its place;
/// until then it has no triangles, and cannot be drawn.
///
/// OBJ and PLY are told by the end of the name. Polygons become fans. Texture coordinates are the file's; where it has
/// none, they are those of the unit sphere round the origin, in the same direction.
struct MeshFile {
    std::string file;     ///< ends in ".obj" or ".ply"; relative to the scene's file, or absolute
    std::string package;  ///< of Debian, which the file comes with, for who misses it; empty: with none
    bool fit = false;     ///< moved and scaled evenly: its middle is the origin, its longest side from -1 to 1
};

/// The cube from (-1, -1, -1) to (1, 1, 1), closed; each face shows the whole unit square of (u, v), upright on the
/// four sides.
struct Box {};

/// Radius 1 round the y axis, from y = -1 to y = 1, closed; u goes round the side once, v up it. Its ends show the disc
/// that fits into the unit square.
struct Cylinder {
    int sectors = 64;
};

/// Its base has radius 1 and lies at y = -1, its apex at y = 1; closed. Texture coordinates are those of a cylinder.
struct Cone {
    int sectors = 64;
};

/// Radius 1, in the plane y = 0, facing +y; shows the disc that fits into the unit square.
struct Disc {
    int sectors = 64;
};

/// A profile turned once round the y axis: open, as a vase is. Its outside is to the right of one who walks along the
/// profile with the axis at the left. u goes round once, v along the profile by its length, from 0 to 1. A point that
/// is given twice makes an edge; otherwise normals are smooth.
struct Revolution {
    std::vector<glm::vec2> profile;  ///< distances from the axis, >= 0, and heights; two points or more
    int sectors = 64;
};

/// Newell's teapot: it stands on y = 0, its body has radius 1, its spout points along x, its knob is 1.575 high. Each
/// of its four parts shows the whole unit square: u goes round it, v up its side, or along handle and spout from the
/// body. As Newell left it, it is open: between lid and rim, and where handle and spout end.
struct Teapot {
    int subdivisions = 12;  ///< of each of its 32 patches, along both sides; 2 or more
};

/// Surfaces that are known by how far a place is from them; within the cube from -1 to 1.
enum class FieldKind {
    mandelbulb  ///< the set of z -> z^8 + c in three dimensions by White and Nylander, thickened a little
};

/// The triangles of such a surface, closed, on a grid over the cube. (u, v) are those of the unit sphere round the
/// origin, in the same direction.
struct DistanceField {
    FieldKind field = FieldKind::mandelbulb;
    int cells = 96;  ///< of the grid, along each side
};

using Shape = std::variant<Sphere, Torus, Plane, Wave, Triangles, Box, Cylinder, Cone, Disc, Revolution, Teapot,
                           DistanceField, MeshFile>;

struct Geometry {
    std::string name;
    Shape shape;
};

}

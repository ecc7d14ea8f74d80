// alternative: the matrix from conditions on points: what the corners of the near window and the two planes become
#include <stdexcept>
#include <umbral/projections/frustum.hpp>

namespace umbral::projections {
namespace {

struct Line {
    double slope;
    double shift;
};

// The line through (a, -1) and (b, 1), of coordinates per unit of depth.
Line through(double a, double b) { return {2 / (b - a), -(a + b) / (b - a)}; }

struct Lines {
    Line x;
    Line y;
    double depth_slope;
    double depth_shift;
};

Lines lines_of(const ViewVolume& v)
{
    const double n = v.near_plane;
    if (v.left == v.right || v.bottom == v.top || v.far_plane == v.near_plane || !(n > 0 && v.far_plane > 0))
        throw std::invalid_argument("lines_of: no frustum");
    // 1 / distance goes from 1 / n to 1 / f while depth goes from -1 to 1.
    const Line depth = through(1 / n, 1.0 / v.far_plane);
    return {through(v.left / n, v.right / n), through(v.bottom / n, v.top / n), -depth.shift, depth.slope};
}

}

glm::mat4 frustum_matrix(const ViewVolume& volume)
{
    const Lines lines = lines_of(volume);
    glm::dmat4 matrix(0.0);
    matrix[0] = {lines.x.slope, 0, 0, 0};
    matrix[1] = {0, lines.y.slope, 0, 0};
    matrix[2] = {-lines.x.shift, -lines.y.shift, lines.depth_slope, -1};
    matrix[3] = {0, 0, lines.depth_shift, 0};
    return glm::mat4(matrix);
}

FrustumFactors frustum_factors(const ViewVolume& volume)
{
    const Lines lines = lines_of(volume);
    FrustumFactors factors{glm::mat4(1), glm::mat4(1), glm::mat4(0)};
    factors.shear[2] = {-lines.x.shift / lines.x.slope, -lines.y.shift / lines.y.slope, 1, 0};
    factors.scaling[0][0] = static_cast<float>(lines.x.slope);
    factors.scaling[1][1] = static_cast<float>(lines.y.slope);
    factors.normalization[0][0] = factors.normalization[1][1] = 1;
    factors.normalization[2] = {0, 0, lines.depth_slope, -1};
    factors.normalization[3] = {0, 0, lines.depth_shift, 0};
    return factors;
}

std::optional<glm::vec3> project_point(const glm::mat4& projection, const glm::vec3& point)
{
    const glm::dvec4 p(point, 1.0);
    const glm::dmat4 rows = glm::transpose(glm::dmat4(projection));
    const double w = dot(rows[3], p);
    if (!(w > 0)) return std::nullopt;
    return glm::vec3(dot(rows[0], p) / w, dot(rows[1], p) / w, dot(rows[2], p) / w);
}

}

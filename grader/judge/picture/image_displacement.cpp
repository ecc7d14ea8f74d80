#include "judge/picture/image_displacement.hpp"

#include <algorithm>

namespace umbral::grader {
namespace {

/// Keeps the direction along which nothing is known (all edges parallel) at rest.
constexpr double damping = 0.01;
constexpr int part = 8192;

}

Displacement edge_displacement(const Picture& student, const Picture& expected, const std::vector<std::uint8_t>& smooth)
{
    double xx = 0;
    double xy = 0;
    double yy = 0;
    double right = 0;
    double down = 0;
    for (int c = 0; c < expected.colours(); ++c)
        for (int y = 0; y < expected.height; ++y) {
            const std::uint8_t* yours = student.row(c, y);
            const std::uint8_t* above = expected.row(c, y - 1);
            const std::uint8_t* here = expected.row(c, y);
            const std::uint8_t* below = expected.row(c, y + 1);
            const std::uint8_t* flat =
                smooth.data() + static_cast<std::size_t>(y) * static_cast<std::size_t>(expected.width);
            // In parts whose sums of squares stay below 2^31: whole numbers of 32 bits are added eight at a time.
            for (int begin = 0; begin < expected.width; begin += part) {
                int row_xx = 0;
                int row_xy = 0;
                int row_yy = 0;
                int row_right = 0;
                int row_down = 0;
                for (int x = begin; x < std::min(expected.width, begin + part); ++x) {
                    const int edge = 1 - flat[x];
                    const int across = (here[x + 1] - here[x - 1]) * edge;
                    const int along = (below[x] - above[x]) * edge;
                    const int difference = yours[x] - here[x];
                    row_xx += across * across;
                    row_xy += across * along;
                    row_yy += along * along;
                    row_right += across * difference;
                    row_down += along * difference;
                }
                xx += row_xx;
                xy += row_xy;
                yy += row_yy;
                right += row_right;
                down += row_down;
            }
        }
    // Central differences are twice the gradient.
    const double ridge = damping * (xx + yy);
    const double determinant = (xx + ridge) * (yy + ridge) - xy * xy;
    if (!(determinant > 0)) return {};
    return {-2 * (right * (yy + ridge) - down * xy) / determinant,
            -2 * (down * (xx + ridge) - right * xy) / determinant};
}

}

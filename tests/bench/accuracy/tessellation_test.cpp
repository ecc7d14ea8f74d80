#include <gtest/gtest.h>

#include <bench/accuracy/ball_painter.hpp>
#include <cmath>
#include <umbral/gl/context.hpp>

namespace umbral::bench {
namespace {

/// Pixels that show the ball rather than the black ground.
int covered(const Image& picture)
{
    int count = 0;
    for (const glm::u8vec4& pixel : picture.cells) count += pixel.r + pixel.g + pixel.b > 0 ? 1 : 0;
    return count;
}

class Painted : public testing::Test {
protected:
    Painted() { gl::forbid_driver_threads(); }
    Image picture(int sectors, int rings) const
    {
        const gl::OffscreenContext context;
        const BallPainter painter;
        const BallMesh ball = ball_mesh(sectors, rings);
        painter.draw(gl::Mesh(ball.positions, ball.positions, ball.indices));
        return painter.picture();
    }
};

// The measured picture shows what was computed: a fine mesh fills the disc, an octahedron less than it.
TEST_F(Painted, a_fine_mesh_fills_the_disc)
{
    const double disc = 3.141592653589793 * BallPainter::radius * BallPainter::radius;
    EXPECT_NEAR(covered(picture(256, 128)), disc, 0.001 * disc);
    EXPECT_LT(covered(picture(4, 4)), 0.9 * disc);
}

// The row through the centre is 2 * radius pixels wide but for the mesh's own error, which is computed without drawing.
TEST_F(Painted, no_silhouette_lies_farther_off_than_was_computed)
{
    for (const auto& [sectors, rings] : {std::pair{16, 8}, {64, 32}}) {
        const double allowed =
            BallPainter::radius * errors_of(ball_mesh(sectors, rings), BallPainter::towards_eye()).silhouette;
        const Image image = picture(sectors, rings);
        double least = BallPainter::radius;
        for (int y = 0; y < image.height; ++y) {
            for (int x = 0; x < image.width; ++x) {
                const double away = std::hypot(x + 0.5 - BallPainter::size / 2.0, y + 0.5 - BallPainter::size / 2.0);
                const glm::u8vec4 pixel = image.at(x, y);
                if (pixel.r + pixel.g + pixel.b == 0)
                    least = std::min(least, away);
                else
                    EXPECT_LT(away, BallPainter::radius + 0.01) << x << ", " << y;
            }
        }
        EXPECT_GE(least, BallPainter::radius - allowed - 0.01) << sectors;
        EXPECT_LE(least, BallPainter::radius - allowed + 1) << sectors;
    }
}

TEST_F(Painted, shows_a_lit_ball)
{
    const Image image = picture(64, 32);
    // The lamp stands on the upper left.
    EXPECT_GT(image.at(180, 140).r, image.at(330, 370).r + 60);
    EXPECT_EQ(image.at(2, 2), glm::u8vec4(0, 0, 0, 255));
}

}
}

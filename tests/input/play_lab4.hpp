#pragma once

#include <array>
#include <cstdio>
#include <string>
#include <texturing/can-and-pawns/artwork.hpp>
#include <texturing/can-and-pawns/earlier.hpp>
#include <vector>

/// What the two programs share that run lab 4, one in a real window and one without a screen: the keys, and the lines
/// that say what was seen after each.
namespace umbral::texturing {

/// One after the other, each pressed and released.
inline constexpr std::array lab4_keys = {GLFW_KEY_X, GLFW_KEY_4, GLFW_KEY_A,     GLFW_KEY_A, GLFW_KEY_X,
                                         GLFW_KEY_Z, GLFW_KEY_C, GLFW_KEY_RIGHT, GLFW_KEY_4, GLFW_KEY_4};

/// The mean colour of each of 16 x 12 parts of the frame that was just drawn, and where the first light stands.
inline void print_frame(const std::string& name)
{
    constexpr int cell = 40;
    std::vector<std::uint8_t> pixels(static_cast<std::size_t>(lab4::width) * lab4::height * 3);
    glPixelStorei(GL_PACK_ALIGNMENT, 1);
    glReadPixels(0, 0, lab4::width, lab4::height, GL_RGB, GL_UNSIGNED_BYTE, pixels.data());
    std::printf("%s light", name.c_str());
    std::array<GLfloat, 4> place{};
    glGetLightfv(GL_LIGHT0, GL_POSITION, place.data());
    for (const GLfloat number : place) std::printf(" %.3f", double{number} + 0.0);
    std::printf(" cells");
    for (int y = 0; y < lab4::height; y += cell)
        for (int x = 0; x < lab4::width; x += cell) {
            std::array<int, 3> sum{};
            for (int i = 0; i < cell * cell; ++i) {
                const auto pixel = static_cast<std::size_t>((y + i / cell) * lab4::width + x + i % cell);
                for (std::size_t channel = 0; channel < 3; ++channel) sum[channel] += pixels[3 * pixel + channel];
            }
            for (const int channel : sum) std::printf(" %.1f", channel / double{cell * cell});
        }
    std::printf("\n");
}

}

#pragma once

#include <array>
#include <kit/color.hpp>
#include <optional>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/texturing/can_and_pawns.hpp>

/// Which material is seen in each pixel of a frame, whatever its colours, textures and lights come out as.
namespace umbral::texturing {

/// The colour that stands for a material in the picture; `unknown` for numbers that are none of the lab's.
struct WornColor {
    glm::vec3 diffuse;
    float exponent;
    glm::u8vec4 shown;
};
inline constexpr glm::u8vec4 nothing_worn{30, 34, 44, 255};
inline constexpr glm::u8vec4 unknown_worn{255, 0, 255, 255};
inline constexpr std::array<WornColor, 5> worn_colors = {{{glm::vec3(0.80F), 40, {196, 64, 52, 255}},
                                                          {glm::vec3(0.34F), 24, {150, 160, 172, 255}},
                                                          {glm::vec3(0.75F), 30, {190, 140, 82, 255}},
                                                          {{0.74F, 0.72F, 0.68F}, 0, {240, 236, 226, 255}},
                                                          {glm::vec3(0.04F), 60, {84, 96, 150, 255}}}};

inline glm::u8vec4 worn_color(const glm::vec3& diffuse, float exponent)
{
    for (const WornColor& one : worn_colors)
        if (distance(one.diffuse, diffuse) < 1e-3F && std::abs(one.exponent - exponent) < 1e-3F) return one.shown;
    return unknown_worn;
}

/// The picture of one frame. What a draw changed in the depth buffer is seen when the next one begins: what came nearer
/// is of the material that was active.
class WornPicture {
public:
    explicit WornPicture(const gl::Framebuffer& target)
        : depths_(target.read_depth()), picture_(target.width(), target.height(), nothing_worn)
    {
    }

    /// To be called before each draw, with the material that it meets.
    void see_draw(const gl::Framebuffer& target, const glm::u8vec4& shown)
    {
        if (active_ == shown) return;
        settle(target);
        active_ = shown;
    }

    /// To be called at the end of the frame.
    [[nodiscard]] Image finished(const gl::Framebuffer& target)
    {
        settle(target);
        return picture_;
    }

private:
    void settle(const gl::Framebuffer& target)
    {
        Grid<float> now = target.read_depth();
        for (std::size_t i = 0; i < now.cells.size(); ++i)
            if (now.cells[i] != depths_.cells[i])
                picture_.cells[i] = active_ && now.cells[i] < 1 ? *active_ : nothing_worn;
        depths_ = std::move(now);
    }

    Grid<float> depths_;
    Image picture_;
    std::optional<glm::u8vec4> active_;
};

}

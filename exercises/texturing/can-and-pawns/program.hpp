#pragma once

#include <algorithm>
#include <functional>
#include <optional>
#include <set>
#include <umbral/gl/draw_watch.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/input/script.hpp>

#include "artwork.hpp"
#include "earlier.hpp"
#include "texels.hpp"

/// The program played through a script, and what is seen of its frames.
namespace umbral::texturing {

/// The material that a draw met, and where the origin of what is drawn lay: diffuse, specular, exponent, are
/// GL_TEXTURE_2D and GL_DEPTH_TEST enabled, eye coordinates, the first two numbers of the projection's diagonal.
using Look = std::array<float, 14>;

/// The lights that the last draw of a frame met: how many are directional, how many positional, the direction of the
/// first of those (eye coordinates, unit), the place of the first of these, and the colours of both.
using LightsSeen = std::array<float, 14>;

/// The texels that exist at level 0, and how often OpenGL was given some after the frame that first did.
using TexelsSeen = std::array<float, 2>;

/// What a frame showed.
struct Frame {
    double time = 0;
    bool earlier = false;  ///< EarlierLabs::draw was called
    std::set<Look> looks;
    LightsSeen lights{};
    TexelsSeen texels{};
    Image picture;
};

/// Numbers that are computed, cut to a grid, so that equal things are equal.
inline float rounded(float value) { return std::round(value * 4096) / 4096; }

inline Look look_now()
{
    Look look{};
    std::array<GLfloat, 4> color{};
    glGetMaterialfv(GL_FRONT, GL_DIFFUSE, color.data());
    std::copy_n(color.begin(), 3, look.begin());
    glGetMaterialfv(GL_FRONT, GL_SPECULAR, color.data());
    std::copy_n(color.begin(), 3, look.begin() + 3);
    glGetMaterialfv(GL_FRONT, GL_SHININESS, &look[6]);
    look[7] = glIsEnabled(GL_TEXTURE_2D) == GL_TRUE ? 1.0F : 0.0F;
    std::array<GLfloat, 16> matrix{};
    glGetFloatv(GL_MODELVIEW_MATRIX, matrix.data());
    look[8] = glIsEnabled(GL_DEPTH_TEST) == GL_TRUE ? 1.0F : 0.0F;
    for (std::size_t i = 0; i < 3; ++i) look[9 + i] = rounded(matrix[12 + i]);
    glGetFloatv(GL_PROJECTION_MATRIX, matrix.data());
    look[12] = rounded(matrix[0]);
    look[13] = rounded(matrix[5]);
    return look;
}

inline LightsSeen lights_now()
{
    LightsSeen seen{};
    for (GLenum light = GL_LIGHT0; light < GL_LIGHT0 + 8; ++light) {
        if (glIsEnabled(light) == GL_FALSE) continue;
        glm::vec4 place(0);
        glGetLightfv(light, GL_POSITION, value_ptr(place));
        const std::size_t kind = place.w == 0 ? 0 : 1;
        if (seen[kind]++ > 0) continue;
        const glm::vec3 told = kind == 0 ? normalize(glm::vec3(place)) : glm::vec3(place) / place.w;
        std::copy_n(&told.x, 3, seen.begin() + 2 + 3 * static_cast<std::ptrdiff_t>(kind));
        std::array<GLfloat, 4> color{};
        glGetLightfv(light, GL_DIFFUSE, color.data());
        std::copy_n(color.begin(), 3, seen.begin() + 8 + 3 * static_cast<std::ptrdiff_t>(kind));
    }
    return seen;
}

/// What of a session is looked at; pictures and traces take time.
struct Wanted {
    bool pictures = false;
    bool uploads = false;
    double pixels = 0.25;  ///< of the framebuffer for each screen coordinate
};

/// One session of the program: the script is played, and every frame looked at.
class Session {
public:
    Session(const char* script, const Wanted& wanted)
        : wanted_(wanted),
          target_(static_cast<int>(lab4::width * wanted.pixels), static_cast<int>(lab4::height * wanted.pixels))
    {
        glUseProgram(0);              // the fixed function, as in a new context
        target_.clear({1, 0, 1, 1});  // so that what a frame leaves out shows
        const float before = living_texels();
        const input::Headless headless(input::parse_script(script), {.content_scale = glm::dvec2(wanted.pixels),
                                                                     .frame_seconds = 0.1,
                                                                     .patience_seconds = 0.2,
                                                                     .on_frame = [&] { end_frame(before); }});
        const gl::DrawWatch watch([this] { see_draw(); });
        if (wanted_.uploads) gl::begin_trace();
        run_lab4(lab_files(), earlier_);
        if (wanted_.uploads) (void)gl::end_trace();
    }

    /// The last frame shown until then; an empty one if there was none.
    [[nodiscard]] Frame frame_at(double time) const
    {
        Frame last;
        for (const Frame& frame : frames_)
            if (frame.time <= time) last = frame;
        return last;
    }

    [[nodiscard]] const ColouredBoxes& earlier() const { return earlier_; }

private:
    void see_draw()
    {
        if (glIsEnabled(GL_LIGHTING) == GL_FALSE) return;
        now_.looks.insert(look_now());
        now_.lights = lights_now();
    }

    void end_frame(float texels_before)
    {
        now_.time = glfwGetTime();
        now_.earlier = earlier_.draws > draws_;
        draws_ = earlier_.draws;
        if (wanted_.pictures) now_.picture = target_.read_pixels();
        if (wanted_.uploads) {
            const std::uint64_t uploads = texture_uploads(gl::end_trace());
            if (uploaded_) later_uploads_ += uploads;
            uploaded_ = uploaded_ || uploads > 0;
            now_.texels = {living_texels() - texels_before, static_cast<float>(later_uploads_)};
            gl::begin_trace();
        }
        frames_.push_back(std::move(now_));
        now_ = {};
    }

    Wanted wanted_;
    gl::Framebuffer target_;
    ColouredBoxes earlier_;
    std::vector<Frame> frames_;
    Frame now_;
    int draws_ = 0;
    bool uploaded_ = false;
    std::uint64_t later_uploads_ = 0;
};

}

#pragma once

#include <algorithm>
#include <functional>
#include <limits>
#include <optional>
#include <set>
#include <umbral/core/student_error.hpp>
#include <umbral/gl/draw_watch.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/input/headless.hpp>
#include <umbral/input/script.hpp>

#include "artwork.hpp"
#include "earlier.hpp"
#include "texels.hpp"
#include "worn.hpp"

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
    Image worn;  ///< which material is seen where
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

/// What of a session is looked at; pixels that are read back and traces take time.
struct Wanted {
    std::vector<double> pictures{};  ///< moments whose frame's pixels are wanted
    std::vector<double> worn{};      ///< moments of which it is wanted which material is seen where
    bool uploads = false;
    double pixels = 0.25;             ///< of the framebuffer for each screen coordinate
    std::vector<TimedPose> motion{};  ///< of the camera
    CameraPose start{};               ///< … and how it stands before
};

/// Is a frame of that time the one that a moment's picture comes from? Scripts change something at most 0.18 s before.
inline bool is_wanted(const std::vector<double>& moments, double time)
{
    return std::ranges::any_of(moments, [&](double moment) { return moment - 0.2 < time && time <= moment; });
}

/// The window's sizes in a script until a moment, in pixels.
inline std::vector<glm::ivec2> sizes_until(const input::EventScript& script, double time, double pixels)
{
    std::vector<glm::ivec2> sizes = {glm::dvec2(lab4::width, lab4::height) * pixels};
    for (const input::TimedEvent& event : script)
        if (const auto* resize = std::get_if<input::Resize>(&event.event); resize != nullptr && event.time <= time)
            sizes.emplace_back(glm::dvec2(resize->size) * pixels);
    return sizes;
}

inline glm::ivec2 largest(const std::vector<glm::ivec2>& sizes)
{
    glm::ivec2 size{0};
    for (const glm::ivec2& one : sizes) size = max(size, one);
    return size;
}

/// The lower left corner of a picture.
inline Image lower_left(const Image& picture, glm::ivec2 size)
{
    Image part(size.x, size.y);
    for (int y = 0; y < size.y; ++y)
        for (int x = 0; x < size.x; ++x) part.at(x, y) = picture.at(x, picture.height - size.y + y);
    return part;
}

/// One session of the program: the script is played, and every frame looked at.
class Session {
public:
    Session(const std::string& script, const Wanted& wanted)
        : wanted_(wanted),
          script_(input::parse_script(script)),
          size_(largest(sizes_until(script_, std::numeric_limits<double>::infinity(), wanted.pixels))),
          target_(size_.x, size_.y),
          earlier_(wanted.motion, wanted.start)
    {
        glUseProgram(0);              // the fixed function, as in a new context
        target_.clear({1, 0, 1, 1});  // so that what a frame leaves out shows
        const float before = living_texels();
        // A program may draw all the time: it shows twenty frames a second then, and ten with glfwSwapInterval(1).
        const input::Headless headless(script_, {.content_scale = glm::dvec2(wanted.pixels),
                                                 .poll_seconds = 0.05,
                                                 .frame_seconds = 0.05,
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
        if (earlier_.drawing || glIsEnabled(GL_LIGHTING) == GL_FALSE) return;
        const Look look = look_now();
        now_.looks.insert(look);
        now_.lights = lights_now();
        if (!is_wanted(wanted_.worn, glfwGetTime())) return;
        if (!worn_) worn_.emplace(target_);
        worn_->see_draw(target_, worn_color({look[0], look[1], look[2]}, look[6]));
    }

    void end_frame(float texels_before)
    {
        if (glfwGetCurrentContext() == nullptr)
            throw StudentError(
                StudentError::Kind::interface_mismatch,
                "a frame is shown before glfwMakeContextCurrent(window) was called: without a current context, "
                "OpenGL's functions do nothing, or crash. Call it once, behind glfwCreateWindow");
        now_.time = glfwGetTime();
        now_.earlier = earlier_.draws > draws_;
        draws_ = earlier_.draws;
        const glm::ivec2 size = sizes_until(script_, now_.time, wanted_.pixels).back();
        if (is_wanted(wanted_.pictures, now_.time)) now_.picture = lower_left(target_.read_pixels(), size);
        if (worn_) now_.worn = lower_left(worn_->finished(target_), size);
        worn_.reset();
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
    input::EventScript script_;
    glm::ivec2 size_;
    gl::Framebuffer target_;
    ColouredBoxes earlier_;
    std::vector<Frame> frames_;
    Frame now_;
    std::optional<WornPicture> worn_;
    int draws_ = 0;
    bool uploaded_ = false;
    std::uint64_t later_uploads_ = 0;
};

/// What is done to the window until a moment.
inline void tell(Recorder& out, const std::string& script, double until)
{
    ask_in_words(out, [&] {
        input::EventScript all = input::parse_script(script);
        std::erase_if(all, [&](const input::TimedEvent& event) { return event.time > until; });
        return "run_lab4(files, earlier);\n" + input::to_text(all);
    });
}

}

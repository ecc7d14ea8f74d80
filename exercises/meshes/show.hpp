#pragma once

#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <kit/double_frame.hpp>
#include <kit/shading.hpp>
#include <span>
#include <umbral/core/grid.hpp>
#include <umbral/gl/mesh.hpp>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/program.hpp>
#include <umbral/meshes/mesh.hpp>
#include <vector>

/// Pictures of meshes by OpenGL: triangles lit flat in colours of their own, their edges over them, and lines and
/// points of any width.
namespace umbral::meshes {

inline constexpr const char* show_vertex_shader = R"(#version 330 core
in vec3 position;
in vec3 normal;  // of a triangle: its colour, since its normal follows from the places of its pixels
uniform mat4 view;
uniform mat4 projection;
out vec3 eye_position;
out vec3 corner;
flat out vec3 color;  // sRGB

void main()
{
    vec4 eye = view * vec4(position, 1.0);
    eye_position = eye.xyz;
    color = normal;
    int place = gl_VertexID % 3;
    corner = vec3(place == 0, place == 1, place == 2);
    gl_Position = projection * eye;
}
)";

inline constexpr const char* show_fragment_shader = R"(
in vec3 eye_position;
in vec3 corner;
flat in vec3 color;
uniform vec4 back;         // a colour for the back, and how much of it
uniform float edge_width;  // in pixels
out vec4 fragment_color;

void main()
{
    vec3 n = normalize(cross(dFdx(eye_position), dFdy(eye_position)));
    vec3 v = normalize(-eye_position);
    if (dot(n, v) < 0.0) n = -n;
    vec3 front = srgb_decoded(color);
    vec3 albedo = gl_FrontFacing ? front : mix(front, srgb_decoded(back.rgb), back.a);
    vec3 shade = lit(albedo, 0.12, n, v, normalize(vec3(-0.4, 0.75, 0.6)), 1.0);
    vec3 distance = corner / max(fwidth(corner), vec3(1e-9));
    float nearest = min(min(distance.x, distance.y), distance.z);
    shade *= mix(0.22, 1.0, smoothstep(0.5 * edge_width - 0.5, 0.5 * edge_width + 0.5, nearest));
    fragment_color = vec4(srgb_encoded(shade), 1.0);
}
)";

inline constexpr const char* show_plain_vertex_shader = R"(#version 330 core
in vec3 position;  // normalised device coordinates
in vec3 normal;    // the colour
flat out vec3 color;

void main()
{
    color = normal;
    gl_Position = vec4(position, 1.0);
}
)";

inline constexpr const char* show_plain_fragment_shader = R"(#version 330 core
flat in vec3 color;
out vec4 fragment_color;

void main() { fragment_color = vec4(color, 1.0); }
)";

/// From where a pane is seen, up +y. What is drawn lies between 1 and 40 from the eye.
struct Camera {
    glm::vec3 eye{2.4F, 2.0F, 4.2F};
    glm::vec3 target{0, 0, 0};
    float fovy_degrees = 30;
};

/// How a mesh looks beside the colours of its triangles (all sRGB).
struct Look {
    float edge_width = 1.2F;  ///< in pixels of the finished picture; 0 for no edges
    glm::vec3 back{0, 0, 0};  ///< what the backs of triangles are mixed with
    float back_amount = 0;    ///< how much: 0 shows backs like fronts
};

/// A picture of panes side by side, each with its own camera. A context must be current while it lives.
///
/// Triangles that name no vertex, and places that are not finite, are not drawn: a student's mesh must not stop a
/// picture.
class Show {
public:
    Show(int columns, int rows, int pane_width, int pane_height, const glm::vec3& background = ink::night)
        : width_(2 * pane_width),
          height_(2 * pane_height),
          rows_(rows),
          frame_(columns * pane_width, rows * pane_height, background),
          lit_({"show.vert", show_vertex_shader}, lit_fragment_shader("show.frag", show_fragment_shader)),
          plain_({"plain.vert", show_plain_vertex_shader}, {"plain.frag", show_plain_fragment_shader})
    {
        pane(0, 0, {});
    }

    /// What is drawn from now on goes into this pane; (0, 0) is at the top left.
    void pane(int column, int row, const Camera& camera)
    {
        frame_.large().bind();
        glEnable(GL_DEPTH_TEST);
        glDepthFunc(GL_LEQUAL);
        glViewport(column * width_, (rows_ - 1 - row) * height_, width_, height_);
        view_ = glm::lookAt(camera.eye, camera.target, glm::vec3(0, 1, 0));
        projection_ = glm::perspective(glm::radians(camera.fovy_degrees),
                                       static_cast<float>(width_) / static_cast<float>(height_), 1.0F, 40.0F);
    }

    /// One colour a triangle; the last one stands for those that are missing, white if there is none.
    void mesh(const IndexedMesh& mesh, std::span<const glm::vec3> colors, const Look& look = {}) const
    {
        std::vector<glm::vec3> places;
        std::vector<glm::vec3> shades;
        for (std::size_t i = 0; i < mesh.triangles.size(); ++i) {
            const glm::uvec3& t = mesh.triangles[i];
            const std::size_t count = mesh.positions.size();
            if (t.x >= count || t.y >= count || t.z >= count) continue;
            const glm::vec3 color = colors.empty() ? glm::vec3(0.9F) : colors[std::min(i, colors.size() - 1)];
            if (!is_finite(color) || !is_finite(mesh.positions[t.x]) || !is_finite(mesh.positions[t.y]) ||
                !is_finite(mesh.positions[t.z]))
                continue;
            for (int corner = 0; corner < 3; ++corner) {
                places.push_back(mesh.positions[t[corner]]);
                shades.push_back(clamp(color, 0.0F, 1.0F));
            }
        }
        lit_.set("view", view_);
        lit_.set("projection", projection_);
        lit_.set("edge_width", 2 * look.edge_width);
        lit_.set("back", glm::vec4(look.back, look.back_amount));
        draw(places, shades, lit_);
    }

    /// Lines between pairs of places, of a width in pixels; `lift` draws them that much nearer (in depth, 0 to 1), so
    /// that they lie on the surface.
    void lines(std::span<const std::array<glm::vec3, 2>> segments, const glm::vec3& color, float width,
               float lift = 2e-3F) const
    {
        std::vector<glm::vec3> places;
        for (const auto& [from, to] : segments) {
            const glm::vec3 a = projected(from, lift);
            const glm::vec3 b = projected(to, lift);
            if (!is_finite(a) || !is_finite(b)) continue;
            const glm::vec2 pixels(static_cast<float>(width_), static_cast<float>(height_));
            const glm::vec2 along = glm::vec2(b - a) * pixels;
            const float length = glm::length(along);
            if (!(length > 0)) continue;
            const glm::vec3 aside(2 * width * glm::vec2(-along.y, along.x) / length / pixels, 0);
            places.insert(places.end(), {a - aside, b - aside, b + aside, a - aside, b + aside, a + aside});
        }
        draw(places, std::vector<glm::vec3>(places.size(), color), plain_);
    }

    /// Discs of a radius in pixels.
    void points(std::span<const glm::vec3> positions, const glm::vec3& color, float radius, float lift = 3e-3F) const
    {
        constexpr int sides = 20;
        std::vector<glm::vec3> places;
        for (const glm::vec3& position : positions) {
            const glm::vec3 middle = projected(position, lift);
            if (!is_finite(middle)) continue;
            const auto rim = [&](int side) {
                const float angle = 6.2831853F * static_cast<float>(side) / sides;
                return middle + 4 * radius *
                                    glm::vec3(std::cos(angle) / static_cast<float>(width_),
                                              std::sin(angle) / static_cast<float>(height_), 0);
            };
            for (int side = 0; side < sides; ++side) places.insert(places.end(), {middle, rim(side), rim(side + 1)});
        }
        draw(places, std::vector<glm::vec3>(places.size(), color), plain_);
    }

    [[nodiscard]] Image picture() const { return frame_.picture(); }

private:
    static bool is_finite(const glm::vec3& v) { return std::isfinite(v.x) && std::isfinite(v.y) && std::isfinite(v.z); }

    /// In normalised device coordinates; NaN for what lies nearer than the near plane.
    [[nodiscard]] glm::vec3 projected(const glm::vec3& position, float lift) const
    {
        const glm::vec4 clip = projection_ * view_ * glm::vec4(position, 1);
        return clip.w > 1.0F ? glm::vec3(clip) / clip.w - glm::vec3(0, 0, lift) : glm::vec3(std::nanf(""));
    }

    static void draw(const std::vector<glm::vec3>& places, const std::vector<glm::vec3>& colors,
                     const gl::Program& program)
    {
        std::vector<std::uint32_t> indices(places.size());
        for (std::size_t i = 0; i < indices.size(); ++i) indices[i] = static_cast<std::uint32_t>(i);
        if (!places.empty()) gl::Mesh(places, colors, indices).draw(program);
    }

    int width_;
    int height_;
    int rows_;
    DoubleFrame frame_;
    gl::Program lit_;
    gl::Program plain_;
    glm::mat4 view_{1};
    glm::mat4 projection_{1};
};

}

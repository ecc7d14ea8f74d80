#pragma once

#include <glm/gtc/matrix_transform.hpp>
#include <kit/stage.hpp>

#include "../linear_frame.hpp"
#include "opengl_pipeline.hpp"

/// The goal picture: pawns on a board, drawn from one scene graph in which materials are entries.
namespace umbral::lighting {

inline constexpr glm::vec3 board_background(0.020F, 0.022F, 0.030F);

/// The objects of the graph, by their places in the list.
enum Object : std::uint32_t { square, body, head, collar, edge };

inline std::vector<TexturedShape> board_objects()
{
    const auto pawn = [](float u, float v) {
        const float narrow = v / 0.2F;
        const float ring = (v - 0.27F) / 0.035F;
        const float r = 0.13F + 0.26F * std::exp(-narrow * narrow) + 0.035F * std::exp(-ring * ring);
        return glm::vec3(r * std::sin(turn * u), v, r * std::cos(turn * u));
    };
    const auto flat = [](float u, float v) { return glm::vec3(u, 0, -v); };
    const auto strip = [](float u, float v) { return glm::vec3(u, 0, -v); };
    return {textured(surface(10, 10, flat), 10, 10, {1, 1}), textured(surface(48, 64, pawn), 48, 64, {2, 1}),
            textured(sphere(48, 32), 48, 32, {2, 1}), textured(torus(48, 16, 0.3F), 48, 16, {4, 1}),
            textured(surface(40, 4, strip), 40, 4, {6, 0.5F})};
}

inline std::shared_ptr<SharedTexture> wood()
{
    const auto paint = [](const glm::vec2& uv) {
        const float rings = 7 * uv.y + 1.6F * turbulence({uv.x, uv.y}, 11);
        const float grain = 0.5F + 0.5F * std::sin(turn * rings);
        return glm::mix(glm::vec3(0.20F, 0.075F, 0.025F), glm::vec3(0.42F, 0.19F, 0.07F), grain) *
               (0.8F + 0.4F * noise({uv.x, uv.y}, 32, 5));
    };
    return std::make_shared<PaintedTexture<decltype(paint)>>(paint);
}

inline std::shared_ptr<SharedTexture> marble()
{
    const auto paint = [](const glm::vec2& uv) {
        const float veins = std::abs(std::sin(turn * (uv.x + uv.y + 0.9F * turbulence(uv, 29))));
        return glm::mix(glm::vec3(0.22F, 0.24F, 0.28F), glm::vec3(0.74F, 0.72F, 0.68F), std::pow(veins, 0.4F));
    };
    return std::make_shared<PaintedTexture<decltype(paint)>>(paint);
}

/// The board with all that it needs; a context must be current while it lives.
class Board {
public:
    Board() : objects_(board_objects()), pipeline_(objects_)
    {
        const auto wooden = wood();
        const auto stone = marble();
        const auto add = [&](const glm::vec3& color, float specular, float e,
                             const std::shared_ptr<SharedTexture>& texture = nullptr,
                             const glm::vec3& glow = glm::vec3(0)) {
            graph_.materials.push_back(make_material({glow, 0.22F * color, color, glm::vec3(specular), e}, texture));
        };
        add(glm::vec3(1), 0.10F, 30, stone);                         // light squares
        add(glm::vec3(0.75F), 0.10F, 30, wooden);                    // dark squares, and the edge
        add({0.80F, 0.52F, 0.14F}, 0.8F, 50);                        // collars: gold
        add(glm::vec3(0), 0, 1, nullptr, {0.022F, 0.020F, 0.022F});  // shadows
        add({0.62F, 0.55F, 0.42F}, 0.5F, 60);                        // pawns: ivory,
        add({0.025F, 0.024F, 0.030F}, 0.6F, 70);                     // ebony,
        add(glm::vec3(1.1F), 0.35F, 40, wooden);                     // wood, in the same texture as the squares,
        add({0.05F, 0.28F, 0.16F}, 0.6F, 60);                        // jade,
        add({0.42F, 0.02F, 0.03F}, 0.6F, 60);                        // ruby
        standard_ = make_gray_material(0.2F, 0.8F, 0, 1, nullptr);
        build();
    }

    /// Did the unit make all materials?
    [[nodiscard]] bool complete() const
    {
        const auto is_there = [](const auto& material) { return material != nullptr; };
        return standard_ && std::all_of(graph_.materials.begin(), graph_.materials.end(), is_there);
    }

    /// As the camera sees it, and, between camera and board, turned.
    void draw(const glm::mat3& turned = glm::mat3(1)) const
    {
        glEnable(GL_DEPTH_TEST);
        glMatrixMode(GL_PROJECTION);
        const glm::mat4 projection = glm::perspective(glm::radians(33.0F), 1.0F, 0.5F, 40.0F);
        glLoadMatrixf(glm::value_ptr(projection));
        glMatrixMode(GL_MODELVIEW);
        const glm::mat4 view =
            glm::lookAt(glm::vec3(2.7F, 4.5F, 8.0F), glm::vec3(0.1F, 0.3F, 0.15F), {0, 1, 0}) * glm::mat4(turned);
        glLoadMatrixf(glm::value_ptr(view));
        FrameLighting lighting;
        lighting.lights = {{{glm::vec4(Stage::sun(), 0), {0.88F, 0.79F, 0.65F}}, LightFrame::world},
                           {{{3.5F, 2.5F, 2, 1}, {0.12F, 0.16F, 0.26F}}, LightFrame::world}};
        lighting.global_ambient = {0.16F, 0.20F, 0.30F};
        set_lighting(lighting, view);
        // Highlights keep the colour of the light on textures, too.
        glLightModeli(GL_LIGHT_MODEL_COLOR_CONTROL, GL_SEPARATE_SPECULAR_COLOR);
        for (const GLenum array : {GL_VERTEX_ARRAY, GL_NORMAL_ARRAY, GL_TEXTURE_COORD_ARRAY})
            glEnableClientState(array);
        standard_->activate(pipeline_);
        DrawingContext context{pipeline_, true, standard_.get()};
        draw_graph(graph_, context);
    }

private:
    std::uint32_t add_transformation(const glm::mat4& transformation)
    {
        graph_.transformations.push_back(transformation);
        return static_cast<std::uint32_t>(graph_.transformations.size() - 1);
    }
    std::uint32_t add_node(std::vector<GraphEntry> entries)
    {
        graph_.nodes.push_back(std::move(entries));
        return static_cast<std::uint32_t>(graph_.nodes.size() - 1);
    }
    static glm::mat4 moved(const glm::vec3& by, const glm::vec3& scale = glm::vec3(1))
    {
        return glm::scale(glm::translate(glm::mat4(1), by), scale);
    }

    void build()
    {
        using Kind = GraphEntry::Kind;
        const std::uint32_t to_head = add_transformation(moved({0, 1.17F, 0}, glm::vec3(0.25F)));
        const glm::mat4 lying = glm::rotate(moved({0, 0.95F, 0}, {0.19F, 0.12F, 0.19F}), turn / 4, glm::vec3(1, 0, 0));
        const std::uint32_t to_collar = add_transformation(lying);
        // The collar has a material of its own, which ends with its node: the head has the pawn's again.
        const std::uint32_t golden =
            add_node({{Kind::material, 2}, {Kind::transformation, to_collar}, {Kind::object, collar}});
        const std::uint32_t pawn = add_node(
            {{Kind::object, body}, {Kind::node, golden}, {Kind::transformation, to_head}, {Kind::object, head}});
        const std::uint32_t silhouette =
            add_node({{Kind::object, body}, {Kind::transformation, to_head}, {Kind::object, head}});
        const std::uint32_t fall = add_transformation(shadow_matrix(Stage::sun(), 0.004F));

        std::vector<GraphEntry> root;
        const std::uint32_t light_squares = squares(0);
        root.insert(root.end(), {{Kind::material, 0}, {Kind::node, light_squares}});
        const std::uint32_t dark_squares = squares(1);
        root.insert(root.end(), {{Kind::material, 1}, {Kind::node, dark_squares}, {Kind::node, edges()}});
        const glm::vec3 places[] = {
            {-1.5F, 0, -1.5F}, {0.5F, 0, -0.5F}, {-0.5F, 0, 1.5F}, {1.5F, 0, 1.5F}, {-1.5F, 0, 0.5F}};
        for (std::uint32_t i = 0; i < 5; ++i) {
            const std::uint32_t place = add_transformation(moved(places[i], glm::vec3(1.12F)));
            root.push_back({Kind::node, add_node({{Kind::material, 3},
                                                  {Kind::transformation, fall},
                                                  {Kind::transformation, place},
                                                  {Kind::node, silhouette}})});
            root.push_back(
                {Kind::node, add_node({{Kind::material, 4 + i}, {Kind::transformation, place}, {Kind::node, pawn}})});
        }
        graph_.root = add_node(root);
    }

    /// Every second square of six by six. The material is the one of whoever enters.
    std::uint32_t squares(int parity)
    {
        using Kind = GraphEntry::Kind;
        std::vector<GraphEntry> entries;
        for (int row = 0; row < 6; ++row)
            for (int column = 0; column < 6; ++column) {
                if ((row + column) % 2 != parity) continue;
                const std::uint32_t place = add_transformation(moved({column - 3, 0, 3 - row}));
                const std::uint32_t one = add_node({{Kind::transformation, place}, {Kind::object, square}});
                entries.push_back({Kind::node, one});
            }
        return add_node(entries);
    }

    /// Four strips round the board, each a quarter turn after the other.
    std::uint32_t edges()
    {
        using Kind = GraphEntry::Kind;
        const std::uint32_t place = add_transformation(moved({-3, 0, 3.35F}, {6.35F, 1, 0.35F}));
        const std::uint32_t quarter = add_transformation(glm::rotate(glm::mat4(1), turn / 4, glm::vec3(0, 1, 0)));
        const std::uint32_t strip = add_node({{Kind::transformation, place}, {Kind::object, edge}});
        std::vector<GraphEntry> entries;
        for (int i = 0; i < 4; ++i) {
            entries.push_back({Kind::node, strip});
            entries.push_back({Kind::transformation, quarter});
        }
        return add_node(entries);
    }

    std::vector<TexturedShape> objects_;
    mutable OpenGlPipeline pipeline_;
    MaterialGraph graph_;
    std::unique_ptr<SurfaceMaterial> standard_;
};

}

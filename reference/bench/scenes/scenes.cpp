#include "scenes.hpp"

#include <algorithm>
#include <glm/gtc/matrix_transform.hpp>
#include <utility>

#include "rearrange.hpp"
#include "spoil.hpp"

namespace umbral::bench::scenes {

glm::mat4 Pose::put(const glm::vec3& at, float degrees, const glm::vec3& axis, const glm::vec3& scale) const
{
    const float angle = glm::radians(flaw == Flaw::rotation_sign ? -degrees : degrees);
    const glm::mat4 moved = glm::translate(glm::mat4(1), at);
    const glm::mat4 turned = glm::rotate(glm::mat4(1), angle, axis);
    return (flaw == Flaw::transform_order ? turned * moved : moved * turned) * glm::scale(glm::mat4(1), scale);
}

namespace groups {
const std::vector<Flaw> any = {Flaw::half_pixel_centre, Flaw::shifted_one_pixel, Flaw::blank, Flaw::red_blue_swapped};
const std::vector<Flaw> placed = {Flaw::fov_3_percent_wrong, Flaw::camera_1_percent_off};
const std::vector<Flaw> meshes = {Flaw::missing_triangle, Flaw::cracks, Flaw::front_faces_culled};
const std::vector<Flaw> light = {Flaw::ambient_missing, Flaw::abs_cosine, Flaw::light_in_wrong_space,
                                 Flaw::brightness_3_percent, Flaw::brightness_5_percent};
const std::vector<Flaw> shine = {Flaw::phong_for_blinn, Flaw::shininess_halved, Flaw::specular_missing};
const std::vector<Flaw> textured = {Flaw::v_flipped, Flaw::u_mirrored, Flaw::uv_scale_missing};
const std::vector<Flaw> encoded = {Flaw::gamma_twice, Flaw::gamma_missing};
}

namespace {

/// What happens to a finished picture.
Image finished(Image image, Flaw flaw)
{
    const Image before = image;
    for (int y = 0; y < image.height; ++y)
        for (int x = 0; x < image.width; ++x) {
            glm::u8vec4& pixel = image.at(x, y);
            if (flaw == Flaw::shifted_one_pixel) pixel = before.at(x, std::max(y - 1, 0));
            if (flaw == Flaw::upside_down) pixel = before.at(x, image.height - 1 - y);
            if (flaw == Flaw::mirrored) pixel = before.at(image.width - 1 - x, y);
            if (flaw == Flaw::red_blue_swapped) std::swap(pixel.r, pixel.b);
        }
    return image;
}

std::vector<Way> usual_ways(Home home)
{
    std::vector<Way> ways = {Way::other_renderer,  Way::double_precision, Way::triangles_reordered,
                             Way::corners_rotated, Way::triangles_split,  Way::stepwise_matrices,
                             Way::equal_formulas};
    const std::vector<Way> own = home == Home::opengl ? std::vector<Way>{Way::other_gl_back_end, Way::indexed_mesh}
                                                      : std::vector<Way>{Way::fused_multiply_add, Way::other_compiler};
    ways.insert(ways.end(), own.begin(), own.end());
    return ways;
}

}

Scene finish(Scene scene)
{
    scene.draw = [draw = scene.draw](Painters& painters, Flaw flaw, Way way) {
        return finished(draw(painters, flaw, way), flaw);
    };
    return scene;
}

Scene model_scene(std::string name, std::string about, Home home, int size, Build build,
                  std::vector<std::vector<Flaw>> flaws, std::initializer_list<Way> more)
{
    Scene scene;
    scene.name = std::move(name);
    scene.about = std::move(about);
    for (const std::vector<Flaw>& some : flaws)
        for (const Flaw flaw : some)
            if (std::find(scene.flaws.begin(), scene.flaws.end(), flaw) == scene.flaws.end())
                scene.flaws.push_back(flaw);
    scene.ways = usual_ways(home);
    scene.ways.insert(scene.ways.end(), more);
    scene.draw = [home, size, build = std::move(build)](Painters& painters, Flaw flaw, Way way) {
        Model model = build({size, flaw});
        spoil(model, flaw);
        rearrange(model, way);
        const bool software = way == Way::double_precision || (home == Home::software) != (way == Way::other_renderer);
        return software ? Painters::software(way).paint(model, flaw, way) : painters.opengl(model, flaw, way);
    };
    return finish(scene);
}

std::vector<Scene> all_scenes(int size)
{
    std::vector<Scene> all;
    for (const auto& family : {lit_scenes, textured_scenes, layered_scenes, depth_scenes, line_scenes, polygon_scenes,
                               noisy_scenes, engine_scenes}) {
        std::vector<Scene> some = family(size);
        std::move(some.begin(), some.end(), std::back_inserter(all));
    }
    return all;
}

}

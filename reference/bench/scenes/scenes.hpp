#pragma once

#include <functional>
#include <initializer_list>
#include <string>
#include <vector>

#include "painters.hpp"

namespace umbral::bench::scenes {

/// A picture that can be drawn right, right in other ways, and wrong.
struct Scene {
    std::string name;
    std::string about;
    std::vector<Flaw> flaws;
    std::vector<Way> ways;
    std::function<Image(Painters&, Flaw, Way)> draw;
    bool noise = false;  ///< Monte Carlo
};

/// What a scene's builder may ask: the size, and where things stand at this step of the animation.
struct Pose {
    int size = 256;
    Flaw flaw = Flaw::none;

    /// In steps; 1 is what is shown.
    [[nodiscard]] float time() const { return flaw == Flaw::stale_frame ? 0.0F : 1.0F; }
    /// Scale first, then rotation, then translation.
    [[nodiscard]] glm::mat4 put(const glm::vec3& at, float degrees = 0, const glm::vec3& axis = {0, 1, 0},
                                const glm::vec3& scale = glm::vec3(1)) const;
};

/// The scene, with what happens to its finished pictures: shifts, flips, swapped channels.
[[nodiscard]] Scene finish(Scene scene);

using Build = std::function<Model(const Pose&)>;

/// Who draws the expected picture and the wrong ones; the other one is the way "other renderer".
enum class Home { opengl, software };

/// A scene of triangles. The usual ways of its home, and those in `more`, are added.
[[nodiscard]] Scene model_scene(std::string name, std::string about, Home home, int size, Build build,
                                std::vector<std::vector<Flaw>> flaws, std::initializer_list<Way> more = {});

/// Flaws that belong together; scenes name some of these groups, and flaws of their own.
namespace groups {
extern const std::vector<Flaw> any;       ///< of every picture
extern const std::vector<Flaw> placed;    ///< seen by a camera
extern const std::vector<Flaw> meshes;    ///< of solid meshes
extern const std::vector<Flaw> light;     ///< of everything lit
extern const std::vector<Flaw> shine;     ///< with highlights
extern const std::vector<Flaw> textured;  ///< of everything textured
extern const std::vector<Flaw> encoded;   ///< encoded with gamma
}

/// The families, one a file. `size` is that of most pictures, in pixels a side.
[[nodiscard]] std::vector<Scene> lit_scenes(int size);
[[nodiscard]] std::vector<Scene> textured_scenes(int size);
[[nodiscard]] std::vector<Scene> layered_scenes(int size);
[[nodiscard]] std::vector<Scene> depth_scenes(int size);
[[nodiscard]] std::vector<Scene> line_scenes(int size);
[[nodiscard]] std::vector<Scene> polygon_scenes(int size);
[[nodiscard]] std::vector<Scene> noisy_scenes(int size);
[[nodiscard]] std::vector<Scene> engine_scenes(int size);

/// All of them.
[[nodiscard]] std::vector<Scene> all_scenes(int size);

}

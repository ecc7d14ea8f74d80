#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <set>
#include <sstream>

#include "render/draw_list.hpp"
#include "render/film.hpp"
#include "render/picture.hpp"
#include "render/software.hpp"
#include "scene/motion.hpp"
#include "scene/scene_json.hpp"

namespace umbral::render::test {
namespace {

namespace fs = std::filesystem;

const fs::path source = UMBRAL_SOURCE_DIR;

std::vector<fs::path> scenes()
{
    std::vector<fs::path> files;
    for (const auto& entry : fs::directory_iterator(source / "reference/scenes"))
        if (entry.path().extension() == ".json") files.push_back(entry.path());
    return files;
}

Image small_picture(const scene::Scene& scene)
{
    const DrawList list = make_draw_list(scene, 48, 36);
    return make_picture(draw_in_software(list, derive_effects(list, scene).set, 48, 36).frame, scene);
}

TEST(Film, pictures_are_numbered_beside_each_other)
{
    EXPECT_EQ(numbered("walk.png", 7), "walk-0007.png");
    EXPECT_EQ(numbered("a.b/walk", 12345), "a.b/walk-12345");
}

TEST(Film, lasts_as_long_as_asked_or_as_the_scene_says)
{
    scene::Scene scene;
    EXPECT_THROW((void)film_seconds({24, 0, ""}, scene), std::runtime_error);
    scene.seconds = 3;
    EXPECT_EQ(film_seconds({24, 0, ""}, scene), 3);
    EXPECT_EQ(film_seconds({24, 1.5F, ""}, scene), 1.5F);
}

TEST(Film, progress_says_what_is_left)
{
    EXPECT_EQ(progress_text(0, 5), "0 %");
    EXPECT_EQ(progress_text(0.25, 10), "25 %, 30 s left");
    EXPECT_EQ(progress_text(1, 10), "100 %");
}

TEST(Film, of_each_scene_that_moves_ends_where_it_begins)
{
    int moving = 0;
    for (const fs::path& file : scenes()) {
        const scene::Scene scene = scene::read_scene(file);
        EXPECT_EQ(scene.seconds > 0, scene::moves(scene)) << file;
        if (!scene::moves(scene)) continue;
        ++moving;
        const Image first = small_picture(scene::at_time(scene, 0));
        EXPECT_TRUE(first.cells == small_picture(scene::at_time(scene, scene.seconds)).cells) << file;
        EXPECT_FALSE(first.cells == small_picture(scene::at_time(scene, 0.37 * scene.seconds)).cells) << file;
    }
    EXPECT_GE(moving, 2);
}

TEST(Gallery, shows_every_scene_and_the_command_that_draws_it)
{
    std::stringstream page;
    page << std::ifstream(source / "docs/gallery.md").rdbuf();
    for (const fs::path& file : scenes()) {
        const std::string name = file.stem().string();
        EXPECT_NE(page.str().find("pictures/scenes/" + name + ".png"), std::string::npos) << name;
        EXPECT_NE(page.str().find("umbral render reference/scenes/" + name + ".json"), std::string::npos) << name;
        EXPECT_TRUE(fs::exists(source / "docs/pictures/scenes" / (name + ".png"))) << name;
    }
}

TEST(Gallery, every_scene_can_be_drawn_by_triangles)
{
    for (const fs::path& file : scenes()) {
        const Image picture = small_picture(scene::read_scene(file));
        std::set<std::uint32_t> colours;
        for (std::size_t i = 0; i < picture.cells.size(); ++i) {
            const auto& p = picture.cells[i];
            colours.insert(static_cast<std::uint32_t>(p[0] << 16U | p[1] << 8U | p[2]));
        }
        EXPECT_GT(colours.size(), 60U) << file;
    }
}

}
}

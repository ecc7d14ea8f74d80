#include <gtest/gtest.h>

#include "scene/motion.hpp"
#include "scene_json_text.hpp"

// What moves in a scene, and what is in its groups.
namespace umbral::scene::test {
namespace {

using nlohmann::json;

TEST(Groups, are_replaced_by_what_is_in_them)
{
    const Scene scene = parse_scene(document().dump(), "s.json");
    std::vector<std::string> names;
    for (const Instance& instance : scene.instances) names.push_back(instance.name);
    EXPECT_EQ(names, (std::vector<std::string>{"first", "second", "train/front/left", "train/front/right",
                                               "train/back/left", "train/back/right"}));
    // Inner transforms act first: the wheel's own, its cart's, the train's.
    const std::vector<Transform>& left = scene.instances[4].transforms;
    ASSERT_EQ(left.size(), 6U);
    EXPECT_TRUE(std::holds_alternative<Spin>(left[0]));
    EXPECT_EQ(std::get<Translate>(left[1]).by, glm::vec3(-1, 0, 0));
    EXPECT_EQ(std::get<Translate>(left[2]).by, glm::vec3(0, 0, -2));
    EXPECT_EQ(std::get<Move>(left[3]).velocity, glm::vec3(1, 0, 0));
    EXPECT_TRUE(std::holds_alternative<Swing>(left[5]));
}

TEST(Groups, that_cannot_be_used_are_refused)
{
    const auto message = [](const char* pointer, const json& value) {
        json changed = document();
        changed[json::json_pointer(pointer)] = value;
        return message_of(changed.dump());
    };
    const json in_itself = json::array({{{"name", "loop"}, {"group", "train"}}});
    EXPECT_NE(message("/groups/cart", in_itself).find("none within itself"), std::string::npos)
        << message("/groups/cart", in_itself);
    EXPECT_NE(message("/instances/2/group", "ship").find("\"train\""), std::string::npos);
    EXPECT_NE(message("/instances/2/material", "dull").find("no material"), std::string::npos);
    EXPECT_NE(message("/groups/cart/1/name", "left").find("stands twice"), std::string::npos);
    EXPECT_NE(message("/groups/cart", json::array()).find("groups"), std::string::npos);
    // 17 groups, each of ten uses of the next: far more things than a file has bytes.
    json many = document();
    many["groups"]["level 0"] = json::array({{{"name", "wheel"}, {"geometry", "wheel"}, {"material", "dull"}}});
    for (int level = 1; level < 12; ++level)
        for (int use = 0; use < 10; ++use)
            many["groups"]["level " + std::to_string(level)].push_back(
                {{"name", std::to_string(use)}, {"group", "level " + std::to_string(level - 1)}});
    many["instances"].push_back({{"name", "all"}, {"group", "level 11"}});
    EXPECT_NE(message_of(many.dump()).find("at most 16384 instances"), std::string::npos) << message_of(many.dump());
}

TEST(Motion, is_still_at_one_moment)
{
    const auto turned = [](const Transform& transform, double seconds) {
        return std::get<Rotate>(at_time(transform, seconds)).degrees;
    };
    const auto moved = [](const Transform& transform, double seconds) {
        return std::get<Translate>(at_time(transform, seconds)).by;
    };
    EXPECT_EQ(turned(Spin{{0, 1, 0}, 90}, 0), 0);
    EXPECT_EQ(turned(Spin{{0, 1, 0}, 90}, 1), 90);
    EXPECT_NEAR(turned(Spin{{0, 1, 0}, 90}, 1e6 + 0.5), 45, 1e-3) << "a million seconds are whole turns";
    EXPECT_NEAR(turned(Swing{{1, 0, 0}, 20, 4, 0}, 1), 20, 1e-5);
    EXPECT_NEAR(turned(Swing{{1, 0, 0}, 20, 4, 0}, 2), 0, 1e-5);
    EXPECT_NEAR(turned(Swing{{1, 0, 0}, 20, 4, 0.5F}, 1), -20, 1e-5);
    EXPECT_EQ(moved(Move{{1, 2, 3}}, 2), glm::vec3(2, 4, 6));
    EXPECT_NEAR(moved(Bob{{0, 1, 0}, 2, 0.25F}, 0).y, 1, 1e-6);
    EXPECT_NEAR(moved(Bob{{0, 1, 0}, 2, 0.25F}, 1).y, -1, 1e-6);
    EXPECT_EQ(moved(Translate{{1, 0, 0}}, 7), glm::vec3(1, 0, 0));

    const Scene scene = parse_scene(document().dump(), "s.json");
    EXPECT_TRUE(moves(scene));
    EXPECT_FALSE(moves(at_time(scene, 1.5)));
    EXPECT_EQ(scene.seconds, 4);
}

}
}

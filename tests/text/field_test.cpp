#include "text/field.hpp"

#include <gtest/gtest.h>

#include <nlohmann/json.hpp>

namespace umbral {
namespace {

using nlohmann::json;

/// What the exception says that `read` throws, given a file's root.
template <class Read>
std::string complaint(const json& root, const Read& read)
{
    try {
        (void)read(Field(root, "f.json"));
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(Field, complaints_name_the_place)
{
    const json root = {{"checks", {{{"points", "many"}}}}, {"left wing", {1, 2}}, {"", 3}, {"a\"b", 4}};
    const auto of = [&](const auto& way) {
        return complaint(root, [&](const Field& field) { return way(field).boolean(); });
    };
    EXPECT_EQ(of([](const Field& f) { return f.member("checks").items(1, 9)[0].member("points"); }),
              "f.json: checks[0].points: expected true or false, got \"many\"");
    EXPECT_EQ(of([](const Field& f) { return f.member("left wing").items(2, 2)[1]; }),
              "f.json: [\"left wing\"][1]: expected true or false, got 2");
    EXPECT_EQ(of([](const Field& f) { return f.member(""); }), "f.json: [\"\"]: expected true or false, got 3");
    EXPECT_EQ(of([](const Field& f) { return f.member("a\"b"); }),
              "f.json: [\"a\\\"b\"]: expected true or false, got 4");
    EXPECT_EQ(of([](const Field& f) { return f.member("none"); }), "f.json: none: expected true or false, got nothing");
}

TEST(Field, complaints_are_short_and_harmless)
{
    const auto got = [](const json& value) {
        const std::string text = complaint(value, [](const Field& field) { return field.boolean(); });
        return text.substr(text.find("got ") + 4);
    };
    EXPECT_EQ(got({{"a", {1, nullptr}}}), "{\"a\":[1,null]}");
    EXPECT_EQ(got(json(std::vector<int>(1000, 7))), "a list of 1000 items");
    EXPECT_EQ(got({std::string(100, 'x')}), "a list of 1 items");
    EXPECT_EQ(got({{"a", std::string(100, 'x')}}), "an object with 1 fields");
    EXPECT_EQ(got(std::string(100, 'x')), "\"" + std::string(76, 'x') + "...");
    std::string two_bytes_each;
    for (int i = 0; i < 50; ++i) two_bytes_each += "é";
    EXPECT_EQ(got(two_bytes_each), "\"" + two_bytes_each.substr(0, 76) + "...");
    EXPECT_EQ(got("\u202Etxt.exe"), "\"\uFFFDtxt.exe\"");
    EXPECT_EQ(got("one\ntwo"), "\"one\\ntwo\"");
}

TEST(Field, reads_what_is_asked_for)
{
    const json root = {{"kind", "plane"}, {"size", 3}, {"rest", {{"b", 1}, {"a", 2}}}};
    const Field field(root, "f.json");
    EXPECT_EQ(field.member("kind").one_of({"sphere", "plane"}), 1U);
    EXPECT_EQ(field.member("size").integer(1, 3), 3);
    EXPECT_FALSE(field.member("none").given());
    const auto members = field.member("rest").members(2);
    ASSERT_EQ(members.size(), 2U);
    EXPECT_EQ(members[0].first, "a");
    EXPECT_EQ(members[0].second.number(0, 9), 2);
    EXPECT_EQ(complaint(root, [](const Field& f) { return f.member("rest").members(1); }),
              "f.json: rest: expected at most 1 fields, got {\"a\":2,\"b\":1}");
    EXPECT_EQ(complaint(root, [](const Field& f) { return f.member("kind").one_of({"ball"}); }),
              "f.json: kind: expected one of \"ball\", got \"plane\"");
    const std::vector<std::string> many(13, "ball");
    EXPECT_EQ(complaint(root, [&](const Field& f) { return f.member("kind").one_of(many); }),
              "f.json: kind: expected one of 13 names such as \"ball\", got \"plane\"");
    EXPECT_EQ(complaint(root, [](const Field& f) { return f.member("size").one_of(std::vector<std::string>()); }),
              "f.json: size: expected no name: none is defined, got 3");
}

}
}

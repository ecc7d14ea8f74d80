#include "text/json_file.hpp"

#include <gtest/gtest.h>
#include <sys/stat.h>

#include <nlohmann/json.hpp>

#include "support/temporary_folder.hpp"

namespace umbral {
namespace {

template <class Action>
std::string complaint(const Action& action)
{
    try {
        (void)action();
    } catch (const std::runtime_error& error) {
        return error.what();
    }
    return "nothing was thrown";
}

TEST(JsonFile, is_strict)
{
    const auto of = [](const std::string& text) { return complaint([&] { return parse_json(text, "f.json"); }); };
    for (const char* text : {"", "{", "[1,]", "{\"format\": nan}", "\xFF\xFE", "{} {}", "// f\n{}"})
        EXPECT_TRUE(of(text).starts_with("f.json: expected JSON, got text that is not: ")) << of(text);
    EXPECT_EQ(of(R"({"a": 1, "b": {"a": 2, "a": 3}})"), "f.json: expected each key once in an object, got \"a\" twice");
    EXPECT_EQ(of("[[[[[[[[[[[[[[[[1]]]]]]]]]]]]]]]]"), "nothing was thrown");
    EXPECT_EQ(of(std::string(100'000, '[')), "f.json: expected lists and objects at most 16 deep, got more");
}

TEST(JsonFile, must_be_a_regular_file_of_bounded_size)
{
    const umbral::test::TemporaryFolder folder;
    const auto of = [](const std::filesystem::path& file) { return complaint([&] { return read_json(file, 100); }); };
    EXPECT_TRUE(of(folder / "none.json")
                    .ends_with("none.json: expected a readable regular file, got nothing: there is none of this name"));
    EXPECT_TRUE(of(folder.path()).ends_with("expected a readable regular file, got something else"));
    ASSERT_EQ(::mkfifo((folder / "pipe").c_str(), 0600), 0);
    EXPECT_TRUE(of(folder / "pipe").ends_with("expected a readable regular file, got something else"))
        << "and does not wait for a writer";
    folder.write("large.json", "[" + std::string(100, ' ') + "]");
    EXPECT_TRUE(of(folder / "large.json").ends_with("large.json: expected at most 100 bytes, got more"));
    folder.write("good.json", "[1]");
    EXPECT_EQ(read_json(folder / "good.json", 3), nlohmann::json::array({1}));
}

}
}

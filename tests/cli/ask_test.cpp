#include <gtest/gtest.h>

#include <filesystem>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// Questions of one's own, with the real program.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

constexpr const char* question = "'intersect(Ray{{8, -3, 4}, {-1, 0, 0}}, Sphere{{0, 0, 0}, 13})'";

/// A workspace whose sphere.cpp is this one.
Printed ask(const TemporaryFolder& folder, const fs::path& sphere, const std::string& arguments)
{
    fs::create_directories(folder / "raytracing/sphere");
    fs::copy_file(sphere, folder / "raytracing/sphere/sphere.cpp", fs::copy_options::overwrite_existing);
    return umbral("ask sphere --dir '" + folder.path().string() + "' " + arguments);
}

const fs::path reference = fs::path(UMBRAL_SOURCE) / "reference/raytracing/sphere.cpp";

TEST(Ask, shows_what_everybody_answers_and_where_they_differ)
{
    const TemporaryFolder folder;
    const Printed equal = ask(folder, reference, question);
    EXPECT_EQ(equal.status, 0) << equal.text;
    for (const char* const part :
         {"yours      20", "reference  20", "oracle     20", "Yours and the oracle's are equal."})
        EXPECT_NE(equal.text.find(part), std::string::npos) << part << " in\n" << equal.text;

    const std::string text = read(reference);
    folder.write("wrong.cpp", std::string(text).replace(text.find("return t;"), 9, "return 2 * t;"));
    folder.write("question.txt", "intersect(Ray{{8, -3, 4}, {-1, 0, 0}},\n    Sphere{{0, 0, 0}, 13})\n");
    const Printed wrong = ask(folder, folder / "wrong.cpp", "--file '" + (folder / "question.txt").string() + "'");
    EXPECT_EQ(wrong.status, 0) << wrong.text;
    for (const char* const part : {"yours      40", "Yours and the reference's differ:", "40 and 20\n"})
        EXPECT_NE(wrong.text.find(part), std::string::npos) << part << " in\n" << wrong.text;
    // Steps of float are told where there are few of them.
    folder.write("close.txt", std::string(text).replace(text.find("return t;"), 9, "return t * 1.000001F;"));
    const Printed close = ask(folder, folder / "close.txt", question);
    EXPECT_NE(close.text.find("20.00002 and 20 ("), std::string::npos) << close.text;
    EXPECT_NE(close.text.find(" ulp)"), std::string::npos) << close.text;
}

TEST(Ask, ends_with_1_where_no_answer_comes)
{
    const TemporaryFolder folder;
    folder.write("stopped.cpp", read(reference).replace(read(reference).find("return t;"), 9, "std::abort();"));
    const Printed stopped = ask(folder, folder / "stopped.cpp", question);
    EXPECT_EQ(stopped.status, 1) << stopped.text;
    EXPECT_NE(stopped.text.find("reference  20"), std::string::npos) << stopped.text;
}

TEST(Ask, refuses_what_is_no_question_with_the_reason)
{
    const TemporaryFolder folder;
    const auto refused = [&](const std::string& arguments, const char* reason) {
        const Printed printed = ask(folder, reference, arguments);
        EXPECT_EQ(printed.status, 2) << printed.text;
        EXPECT_NE(printed.text.find(reason), std::string::npos) << reason << " in\n" << printed.text;
    };
    refused("", "expected a question");
    refused(std::string(question) + " --file question.txt", "expected a question");
    refused("--file no-such-file.txt", "no-such-file.txt");
    refused("--file /dev/zero", "expected a regular file");
    folder.write("endless.txt", "");
    fs::resize_file(folder / "endless.txt", std::uintmax_t{1} << 40U);
    refused("--file '" + (folder / "endless.txt").string() + "'", "expected at most");
    refused("'intersect(nothing)'", "question:1:");
    EXPECT_EQ(umbral("ask lighting/shaders 'main()'").status, 2);
    EXPECT_EQ(umbral("ask zzz 'main()'").status, 2);
}

}
}

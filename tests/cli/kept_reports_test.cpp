#include <gtest/gtest.h>

#include "graded_class.hpp"

// Folders of reports in which somebody deleted, added or changed something.
namespace umbral::test {
namespace {

class KeptReports : public GradedClass {};

// What was deleted comes back; what somebody put beside it stays; what was changed is not believed.
TEST_F(KeptReports, are_completed_and_not_believed)
{
    ASSERT_EQ(grade("out").status, 0);
    const json before = class_json(folder / "out");
    const auto is_as_before = [&] {
        const Printed again = grade("out");
        EXPECT_EQ(again.status, 0) << again.text;
        EXPECT_EQ(class_json(folder / "out"), before);
        for (const char* const file : {"report.html", "report.json", "report.student.json"})
            EXPECT_TRUE(fs::exists(folder / "out/bo" / file)) << file;
        EXPECT_TRUE(fs::exists(folder / "out/bo/pictures"));
    };
    ASSERT_TRUE(fs::exists(folder / "out/bo/pictures")) << "bo's picture is wrong";
    fs::remove(folder / "out/bo/report.html");
    is_as_before();
    fs::remove_all(folder / "out/bo/pictures");
    is_as_before();
    folder.write("out/bo/pictures/notes.txt", "mine");
    folder.write("out/bo/pictures/marked.png", "mine, too");
    EXPECT_EQ(grade("out", "--fresh").status, 0);
    EXPECT_EQ(read(folder / "out/bo/pictures/notes.txt"), "mine");
    EXPECT_EQ(read(folder / "out/bo/pictures/marked.png"), "mine, too");
    const std::string kept = read(folder / "out/ana/units/raytracing_sphere.unit");
    for (const char* const changed : {"\"score\":9999999,", "\"score\":9999999,\"max_score\":9999999,"}) {
        std::string text = kept;
        const std::size_t at = text.rfind("\"score\":10000,", text.find('\n'));
        ASSERT_NE(at, std::string::npos);
        text.replace(at, std::string("\"score\":10000,").size(), changed);
        folder.write("out/ana/units/raytracing_sphere.unit", text);
        is_as_before();
    }
}

}
}

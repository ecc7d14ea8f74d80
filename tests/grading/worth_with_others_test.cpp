#include <string>

#include "spoilt_reference.hpp"

// Calls that draw nothing of the picture are worth nothing, however few they are.
namespace umbral::grader::test {
namespace {

class WorthOfCalls : public SpoiltReference {
protected:
    WorthOfCalls() : SpoiltReference("pipeline/draw-deferred") {}

    UnitResult graded(const std::string& from, const std::string& to)
    {
        GradeOptions options;
        options.explain = options.questions = false;
        return grade(from, to, options);
    }

    static Millipoints of_calls(const UnitResult& result)
    {
        Millipoints points = 0;
        for (const CheckResult& check : result.checks)
            if (check.kind.name == "trace") points += check.score;
        return points;
    }
};

TEST_F(WorthOfCalls, is_nothing_where_they_draw_nothing)
{
    const UnitResult result = graded("feed(0);", "");
    EXPECT_EQ(of_calls(result), 0);
    EXPECT_LE(result.score, 2000) << "what is left is that OpenGL's state is as it was, and no object is alive";
    EXPECT_NE(check(result, "frames/later frames").message.find("these calls draw too little of the right picture"),
              std::string::npos)
        << check(result, "frames/later frames").message;
}

TEST_F(WorthOfCalls, is_all_where_only_colours_are_wrong)
{
    const Millipoints all = of_calls(graded("feed(0);", "feed(0);"));
    EXPECT_EQ(of_calls(graded("upload(GL_ARRAY_BUFFER, buffers_[1], mesh.colors)",
                              "upload(GL_ARRAY_BUFFER, buffers_[1], mesh.positions)")),
              all);
}

}
}

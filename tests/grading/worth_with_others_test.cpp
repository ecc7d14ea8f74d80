#include <string>

#include "spoilt_reference.hpp"

// Calls that draw nothing of the picture are worth half, however few they are.
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

    /// What traces that hang on a picture by themselves earned, and the most that they can.
    struct Calls {
        Millipoints score = 0;
        Millipoints most = 0;
    };

    Calls of_calls(const UnitResult& result) const
    {
        Calls calls;
        for (std::size_t i = 0; i < exercise.checks.size(); ++i) {
            if (exercise.checks[i].judge.name != "trace" || !exercise.checks[i].with.empty()) continue;
            calls.score += result.checks[i].score;
            calls.most += result.checks[i].max_score;
        }
        return calls;
    }
};

TEST_F(WorthOfCalls, is_half_where_they_draw_nothing)
{
    const UnitResult result = graded("feed(0);", "");
    const auto [score, most] = of_calls(result);
    EXPECT_NEAR(static_cast<double>(score), static_cast<double>(most) / 2, 3);
    EXPECT_TRUE(check(result, "frames/later frames").held_back);
    EXPECT_FALSE(check(result, "rosette/picture").held_back);
    EXPECT_NE(check(result, "frames/later frames").message.find("these calls draw too little of the right picture"),
              std::string::npos)
        << check(result, "frames/later frames").message;
    // So is what hangs on calls that hang on a picture.
    for (const char* const name : {"frames/end", "frames/alive", "state/state"})
        EXPECT_LE(2 * check(result, name).score, check(result, name).max_score + 2) << name;
}

TEST_F(WorthOfCalls, is_all_where_only_colours_are_wrong)
{
    const auto [score, most] = of_calls(graded("upload(GL_ARRAY_BUFFER, buffers_[1], mesh.colors)",
                                               "upload(GL_ARRAY_BUFFER, buffers_[1], mesh.positions)"));
    EXPECT_EQ(score, most);
}

}
}

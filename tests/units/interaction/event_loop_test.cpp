#include <gtest/gtest.h>

#include <interaction/event-loop/sessions.hpp>

namespace umbral::interaction {
namespace {

using Rows = std::vector<LoopRow>;

constexpr LoopRow drawn(float heard) { return {1, heard}; }
constexpr LoopRow shown(float heard) { return {2, heard}; }
constexpr LoopRow updated(float heard) { return {3, heard}; }
constexpr LoopRow returned(float heard) { return {4, heard}; }

/// Of the flags that are left, `finish` alone is set.
constexpr LoopRow finish_left{6, 1};

// The statement's example, and others worked by hand.
TEST(EventLoop, waiting_draws_at_need_and_sleeps_else)
{
    const LoopResult result =
        play(waiting_loop, session_of("1 key B press\n2 move 5 5\n2 move 6 5\n3 key ESCAPE press\n"));
    EXPECT_EQ(result.rows, (Rows{drawn(0), shown(0), drawn(3), shown(3), returned(4), finish_left}));
    EXPECT_EQ(result.usage.waits, 3U);
    EXPECT_EQ(result.usage.polls, 0U);
}

TEST(EventLoop, an_unfinished_picture_is_drawn_on_without_waiting)
{
    const LoopResult result = play(waiting_loop, session_of("9 key ESCAPE press\n", {}, {.unfinished_draws = 2}));
    EXPECT_EQ(result.rows,
              (Rows{drawn(0), shown(0), drawn(0), shown(0), drawn(0), shown(0), returned(1), finish_left}));
    EXPECT_EQ(result.usage.polls, 2U);
    EXPECT_EQ(result.usage.waits, 1U);
}

TEST(EventLoop, animated_updates_in_each_round)
{
    const LoopResult result = play(animated_loop, session_of("0.018 key R press\n0.035 key ESCAPE press\n"));
    // Each round takes 1/64 s for the frame and 1/1024 s for the poll.
    EXPECT_EQ(result.rows, (Rows{drawn(0), shown(0), updated(0), drawn(0), shown(0), updated(1), drawn(1), shown(1),
                                 returned(2), finish_left}));
    EXPECT_EQ(result.usage.waits, 0U);
}

TEST(EventLoop, a_minimised_window_sleeps_and_keeps_what_it_needs)
{
    for (const NamedLoop& loop : {waiting_loop, animated_loop, switching_loop}) {
        const LoopResult result = play(loop, session_of("0.01 iconify on\n1 key R press\n2 key R press\n3 iconify off\n"
                                                        "3 key ESCAPE press\n"));
        EXPECT_EQ(result.rows.at(result.rows.size() - 2), returned(5)) << loop.name;
        EXPECT_EQ(result.rows.back(), (LoopRow{6, 1 + 2})) << loop.name << ": what the window needs is not lost";
        EXPECT_LE(result.usage.waits, 4U) << loop.name;
        EXPECT_LE(result.usage.polls, 1U) << loop.name;
    }
}

bool is_seen(GLFWwindow* window)
{
    int width = 0;
    int height = 0;
    glfwGetFramebufferSize(window, &width, &height);
    return width > 0 && height > 0 && glfwGetWindowAttrib(window, GLFW_ICONIFIED) == GLFW_FALSE;
}

/// A program that holds the loop to its promises at every call that it gets. It knows nothing of the order of steps.
class Auditor final : public ScriptedProgram {
public:
    Auditor(const LoopSession& session, const NamedLoop& loop)
        : ScriptedProgram(session.flags), habits_(session.habits), loop_(loop), wanted_(session.flags.redraw)
    {
    }

    void begin(GLFWwindow* window, const input::Usage& usage)
    {
        window_ = window;
        usage_ = &usage;
        listen(window);
    }

    void draw() override
    {
        EXPECT_FALSE(flags.redraw) << "the flag is cleared before the draw";
        EXPECT_TRUE(wanted_ || needs > met_needs_) << "no draw without need";
        EXPECT_TRUE(is_seen(window_)) << "no draw of a minimised window";
        EXPECT_FALSE(is_over()) << "no draw when the loop is over";
        EXPECT_EQ(usage_->frames.size(), draws) << "each draw is shown before the next one";
        met_needs_ = needs;
        ++draws;
        flags.redraw = wanted_ = static_cast<int>(draws) <= habits_.unfinished_draws;
        if (static_cast<int>(draws) == habits_.waking_draw) flags.animate = true;
    }

    void update() override
    {
        EXPECT_TRUE(is_seen(window_)) << "a minimised scene stands still";
        EXPECT_FALSE(is_over()) << "no update when the loop is over";
        EXPECT_TRUE(is_moving()) << "no update of a scene at rest";
        ++updates;
        if (updates % 2 == 0) flags.redraw = wanted_ = true;
        if (updates == habits_.resting_update) flags.animate = false;
    }

    [[nodiscard]] bool is_over() const { return flags.finish || glfwWindowShouldClose(window_) == GLFW_TRUE; }

    std::size_t draws = 0;
    int updates = 0;

private:
    [[nodiscard]] bool is_moving() const
    {
        return loop_.run == run_animated_loop || (loop_.run == run_switching_loop && flags.animate);
    }

    /// The first event of a wait finds the flags as they were when the loop went to sleep.
    void hear() override
    {
        ScriptedProgram::hear();
        const bool has_work = was_seen_ && (flags.redraw || is_moving());
        if (usage_->waits > waits_) {
            EXPECT_FALSE(has_work) << "no sleep with work at hand";
        } else if (usage_->polls > polls_) {
            EXPECT_TRUE(has_work) << "no poll without work at hand";
        }
        waits_ = usage_->waits;
        polls_ = usage_->polls;
        was_seen_ = is_seen(window_);
    }

    Habits habits_;
    NamedLoop loop_;
    GLFWwindow* window_ = nullptr;
    const input::Usage* usage_ = nullptr;
    bool wanted_;
    int met_needs_ = 0;
    std::size_t waits_ = 0;
    std::size_t polls_ = 0;
    bool was_seen_ = true;
};

TEST(EventLoop, promises_hold_in_random_sessions)
{
    std::size_t draws = 0;
    int updates = 0;
    for (std::uint64_t seed = 1; seed <= 600; ++seed) {
        SCOPED_TRACE(testing::Message() << "seed " << seed);
        Random random(seed);
        const LoopSession session = random_loop_session(random);
        const NamedLoop loop = std::array{waiting_loop, animated_loop, switching_loop}[seed % 3];
        const input::Headless headless(session.script);
        glfwInit();
        Auditor program(session, loop);
        GLFWwindow* const window = glfwCreateWindow(320, 200, "test", nullptr, nullptr);
        program.begin(window, headless.usage());
        loop.run(window, program, program.flags);
        EXPECT_TRUE(program.is_over()) << "a loop returns only when it is over";
        EXPECT_EQ(headless.usage().frames.size(), program.draws) << "one frame for each draw";
        EXPECT_LE(headless.usage().waits, session.script.size()) << "every wait brings an event";
        draws += program.draws;
        updates += program.updates;
    }
    EXPECT_GT(draws, 2000U);
    EXPECT_GT(updates, 2000);
}

}
}

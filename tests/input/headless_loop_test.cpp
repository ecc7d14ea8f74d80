#include "session.hpp"

// The event loop, and time.
namespace umbral::input {
namespace {

using Lines = std::vector<std::string>;

void count_scrolls(const Session& session)
{
    glfwSetScrollCallback(session.window, [](GLFWwindow* w, double, double y) { Session::of(w).say(words(y)); });
}

TEST(HeadlessLoop, events_come_only_inside_poll_and_wait)
{
    Session session("0 scroll 0 1\n0.5 scroll 0 2\n0.5 scroll 0 3\n2 scroll 0 4");
    count_scrolls(session);
    EXPECT_TRUE(session.heard.empty());
    glfwWaitEvents();
    EXPECT_EQ(session.heard, (Lines{"1"}));
    glfwWaitEvents();
    EXPECT_EQ(session.heard, (Lines{"1", "2", "3"})) << "one wait delivers all that is due";
    EXPECT_EQ(glfwGetTime(), 0.5);
    glfwWaitEventsTimeout(0.25);
    EXPECT_EQ(glfwGetTime(), 0.75);
    EXPECT_EQ(session.heard.size(), 3U);
    glfwWaitEventsTimeout(10);
    EXPECT_EQ(glfwGetTime(), 2) << "the timeout ends with the event";
    EXPECT_EQ(session.heard.size(), 4U);
    EXPECT_EQ(session.headless.usage().waits, 4U);
}

TEST(HeadlessLoop, polls_and_frames_take_time)
{
    Session session("0.25 scroll 0 1\n0.5 close", {.poll_seconds = 0.125, .frame_seconds = 0.0625});
    count_scrolls(session);
    glfwPollEvents();
    EXPECT_EQ(glfwGetTime(), 0.125);
    EXPECT_TRUE(session.heard.empty());
    glfwPollEvents();
    EXPECT_EQ(session.heard, (Lines{"1"}));
    glfwMakeContextCurrent(session.window);
    glfwSwapBuffers(session.window);
    EXPECT_EQ(glfwGetTime(), 0.25) << "without a swap interval, a frame takes no time";
    glfwSwapInterval(1);
    glfwSwapBuffers(session.window);
    EXPECT_EQ(glfwGetTime(), 0.3125);
    glfwSetTime(100);
    EXPECT_EQ(glfwGetTime(), 100);
    EXPECT_EQ(session.headless.usage().frames, (std::vector<double>{0.25, 0.25}));
    EXPECT_EQ(session.headless.usage().polls, 2U);
    EXPECT_EQ(glfwGetTimerValue(), 312'500'000U) << "the raw timer is not set";
}

TEST(HeadlessLoop, whoever_wants_to_is_called_at_each_frame)
{
    std::vector<double> frames;
    Session session("0.25 scroll 0 1", {.on_frame = [&] { frames.push_back(glfwGetTime()); }});
    glfwSwapBuffers(session.window);
    glfwWaitEvents();
    glfwSwapBuffers(session.window);
    EXPECT_EQ(frames, (std::vector<double>{0, 0.25}));
}

TEST(HeadlessLoop, wait_returns_at_once_when_woken)
{
    Session session("5 scroll 0 1");
    count_scrolls(session);
    glfwPostEmptyEvent();
    glfwWaitEvents();
    EXPECT_TRUE(session.heard.empty());
    EXPECT_EQ(glfwGetTime(), 0);
    glfwWaitEvents();
    EXPECT_EQ(session.heard.size(), 1U);
}

TEST(HeadlessLoop, what_the_program_causes_comes_with_the_next_poll)
{
    Session session("1 scroll 0 1");
    glfwSetWindowSizeCallback(session.window, [](GLFWwindow* w, int x, int y) {
        Session::of(w).say(words(x, y));
        if (x == 300) glfwSetWindowSize(w, 100, 100);
    });
    glfwSetWindowSize(session.window, 300, 200);
    EXPECT_TRUE(session.heard.empty());
    glfwWaitEvents();
    EXPECT_EQ(session.heard, (Lines{"300 200"}));
    glfwWaitEvents();
    EXPECT_EQ(session.heard, (Lines{"300 200", "100 100"}));
    EXPECT_EQ(glfwGetTime(), 0) << "there was no need to wait for the script";
}

TEST(HeadlessLoop, a_waiting_program_is_asked_to_close_and_then_stopped)
{
    Session session("1 scroll 0 1");
    glfwWaitEvents();
    EXPECT_TRUE(session.headless.script_is_over());
    EXPECT_EQ(glfwWindowShouldClose(session.window), GLFW_FALSE);
    glfwWaitEvents();
    EXPECT_EQ(glfwWindowShouldClose(session.window), GLFW_TRUE);
    EXPECT_NE(stopped_by([] { glfwWaitEvents(); }).find("would wait for ever"), std::string::npos);
}

TEST(HeadlessLoop, a_polling_program_is_asked_to_close_and_then_stopped)
{
    Session session("1 scroll 0 1", {.poll_seconds = 0.25, .patience_seconds = 2, .polls_after_closing = 10});
    int polls = 0;
    while (glfwWindowShouldClose(session.window) == GLFW_FALSE && polls < 1000) {
        glfwPollEvents();
        ++polls;
    }
    EXPECT_EQ(polls, 13) << "the first moment after 3 s";
    for (int i = 0; i < 10; ++i) glfwPollEvents();
    EXPECT_NE(stopped_by([] { glfwPollEvents(); }).find("glfwWindowShouldClose"), std::string::npos);
}

TEST(HeadlessLoop, callbacks_must_not_poll)
{
    Session session("1 scroll 0 1\n2 scroll 0 1");
    glfwSetScrollCallback(session.window, [](GLFWwindow*, double, double) { glfwPollEvents(); });
    EXPECT_EQ(stopped_by([] { glfwWaitEvents(); }),
              "glfwPollEvents must not be called from a callback: GLFW's documentation forbids it");
    glfwSetScrollCallback(session.window, [](GLFWwindow* w, double, double) { glfwDestroyWindow(w); });
    EXPECT_NE(stopped_by([] { glfwWaitEvents(); }).find("glfwDestroyWindow must not"), std::string::npos)
        << "and the session goes on after an exception";
}

TEST(HeadlessLoop, sessions_are_apart)
{
    {
        Session first("1 press left 3 4");
        first.play();
        EXPECT_THROW(Headless(EventScript{}), std::logic_error);
    }
    Session second("1 scroll 0 1");
    EXPECT_EQ(glfwGetMouseButton(second.window, GLFW_MOUSE_BUTTON_LEFT), GLFW_RELEASE);
    EXPECT_EQ(glfwGetTime(), 0);
    EXPECT_TRUE(second.heard.empty());
}

TEST(HeadlessLoop, a_window_may_follow_another)
{
    Session session("1 press left 3 4\n2 move 5 6");
    glfwWaitEvents();
    glfwDestroyWindow(session.window);
    GLFWwindow* next = glfwCreateWindow(10, 10, "next", nullptr, nullptr);
    EXPECT_EQ(glfwGetMouseButton(next, GLFW_MOUSE_BUTTON_LEFT), GLFW_RELEASE);
    EXPECT_EQ(glfwGetWindowUserPointer(next), nullptr);
    glfwWaitEvents();
    double x = 0;
    glfwGetCursorPos(next, &x, nullptr);
    EXPECT_EQ(x, 5);
    glfwTerminate();
    EXPECT_EQ(glfwGetWindowAttrib(next, GLFW_FOCUSED), 0) << "not initialised: no window is looked at";
}

}
}

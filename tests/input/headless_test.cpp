#include "session.hpp"

// What GLFW 3.3's documentation says of input and of windows, word for word where it can be tested.
namespace umbral::input {
namespace {

using Lines = std::vector<std::string>;

void hear_everything(GLFWwindow* window)
{
    glfwSetMouseButtonCallback(window, [](GLFWwindow* w, int button, int action, int mods) {
        Session::of(w).say("button " + words(button, action, mods));
    });
    glfwSetCursorPosCallback(window,
                             [](GLFWwindow* w, double x, double y) { Session::of(w).say("cursor " + words(x, y)); });
    glfwSetScrollCallback(window,
                          [](GLFWwindow* w, double x, double y) { Session::of(w).say("scroll " + words(x, y)); });
    glfwSetKeyCallback(window, [](GLFWwindow* w, int key, int, int action, int mods) {
        Session::of(w).say("key " + words(key, action, mods));
    });
    glfwSetCharCallback(window, [](GLFWwindow* w, unsigned code) { Session::of(w).say("char " + words(code)); });
    glfwSetCharModsCallback(
        window, [](GLFWwindow* w, unsigned code, int mods) { Session::of(w).say("char with " + words(code, mods)); });
    glfwSetWindowSizeCallback(window, [](GLFWwindow* w, int x, int y) { Session::of(w).say("size " + words(x, y)); });
    glfwSetFramebufferSizeCallback(
        window, [](GLFWwindow* w, int x, int y) { Session::of(w).say("framebuffer " + words(x, y)); });
    glfwSetWindowFocusCallback(window,
                               [](GLFWwindow* w, int focused) { Session::of(w).say("focus " + words(focused)); });
    glfwSetWindowIconifyCallback(
        window, [](GLFWwindow* w, int iconified) { Session::of(w).say("iconify " + words(iconified)); });
    glfwSetCursorEnterCallback(window,
                               [](GLFWwindow* w, int entered) { Session::of(w).say("enter " + words(entered)); });
    glfwSetWindowRefreshCallback(window, [](GLFWwindow* w) { Session::of(w).say("refresh"); });
    glfwSetWindowCloseCallback(window,
                               [](GLFWwindow* w) { Session::of(w).say("close " + words(glfwWindowShouldClose(w))); });
}

Lines heard_from(const char* script, const HeadlessSettings& settings = {})
{
    Session session(script, settings);
    hear_everything(session.window);
    session.play();
    return session.heard;
}

TEST(Headless, mouse_callbacks)
{
    EXPECT_EQ(
        heard_from(
            "0 press left 12 8\n1 move 12 8\n2 move 13.5 -8\n3 release left\n4 press middle 1 1\n5 scroll 0.5 -2"),
        (Lines{"cursor 12 8", "button 0 1 0", "cursor 13.5 -8", "button 0 0 0", "cursor 1 1", "button 2 1 0",
               "scroll 0.5 -2"}));
}

// As under X11, modifier bits are those from before the event: Shift's own press has none, its release has its bit.
TEST(Headless, keys_with_modifiers_and_characters)
{
    EXPECT_EQ(heard_from("0 key LEFT_SHIFT press\n1 key 2 press\n2 press left\n3 key 2 release\n4 key LEFT_SHIFT "
                         "release\n5 key A press\n6 key A repeat\n7 key A press"),
              (Lines{"key 340 1 0", "key 50 1 1", "char with 64 1", "char 64", "button 0 1 1", "key 50 0 1",
                     "key 340 0 1", "key 65 1 0", "char with 97 0", "char 97", "key 65 2 0", "char with 97 0",
                     "char 97", "key 65 2 0", "char with 97 0", "char 97"}));
    EXPECT_EQ(
        heard_from(
            "0 key RIGHT_CONTROL press\n1 key R press\n2 key LEFT_SUPER press\n3 key LEFT_ALT press\n4 key F1 press"),
        (Lines{"key 345 1 0", "key 82 1 2", "char with 114 2", "key 343 1 2", "key 342 1 10", "key 290 1 14"}))
        << "with Control there is no plain character";
    EXPECT_EQ(heard_from("0 key R release\n1 char 241"), (Lines{"char with 241 0", "char 241"}))
        << "a key that was not down cannot go up";
}

TEST(Headless, sizes_in_pixels_come_first)
{
    EXPECT_EQ(
        heard_from("0 resize 640 480\n1 resize 300 200\n2 resize 300 200\n3 resize 0 0", {.content_scale = {2, 1.5}}),
        (Lines{"framebuffer 600 300", "size 300 200", "framebuffer 0 0", "size 0 0"}))
        << "and only where something changes";
}

// "glfwSetWindowFocusCallback: after the callback is called, synthetic key and mouse button release events will be
// generated".
TEST(Headless, losing_focus_releases_everything)
{
    EXPECT_EQ(heard_from("0 press right\n1 key R press\n2 focus off\n3 focus off\n4 key 1 press\n5 move 3 4\n6 focus "
                         "on\n7 key R press"),
              (Lines{"button 1 1 0", "key 82 1 0", "char with 114 0", "char 114", "focus 0", "key 82 0 0",
                     "button 1 0 0", "cursor 3 4", "focus 1", "key 82 1 0", "char with 114 0", "char 114"}));
}

TEST(Headless, window_events)
{
    EXPECT_EQ(heard_from("0 iconify on\n1 iconify off\n2 enter off\n3 refresh\n4 close"),
              (Lines{"iconify 1", "iconify 0", "enter 0", "refresh", "close 1"}))
        << "the close callback runs once the flag is set, so that it can take it back";
}

TEST(Headless, setters_return_the_one_before)
{
    Session session("0 scroll 0 1\n1 scroll 0 2");
    const GLFWscrollfun first = [](GLFWwindow* w, double, double y) { Session::of(w).say("first " + words(y)); };
    const GLFWscrollfun second = [](GLFWwindow* w, double, double y) { Session::of(w).say("second " + words(y)); };
    EXPECT_EQ(glfwSetScrollCallback(session.window, first), nullptr);
    EXPECT_EQ(glfwSetScrollCallback(session.window, second), first);
    glfwWaitEvents();
    EXPECT_EQ(glfwSetScrollCallback(session.window, nullptr), second);
    glfwWaitEvents();
    EXPECT_EQ(session.heard, (Lines{"second 1"}));
}

TEST(Headless, state_is_that_of_the_last_event_delivered)
{
    Session session("1 press left 5 6\n2 key R press\n3 release left 7 8\n4 key R release", {.pointer = {1, 2}});
    double x = 0;
    double y = 0;
    const auto cursor = [&] {
        glfwGetCursorPos(session.window, &x, &y);
        return words(x, y);
    };
    EXPECT_EQ(cursor(), "1 2");
    EXPECT_EQ(glfwGetMouseButton(session.window, GLFW_MOUSE_BUTTON_LEFT), GLFW_RELEASE);
    glfwWaitEvents();
    EXPECT_EQ(cursor(), "5 6");
    EXPECT_EQ(glfwGetMouseButton(session.window, GLFW_MOUSE_BUTTON_LEFT), GLFW_PRESS);
    glfwWaitEvents();
    EXPECT_EQ(glfwGetKey(session.window, GLFW_KEY_R), GLFW_PRESS);
    glfwWaitEvents();
    EXPECT_EQ(cursor(), "7 8");
    EXPECT_EQ(glfwGetMouseButton(session.window, GLFW_MOUSE_BUTTON_LEFT), GLFW_RELEASE);
    glfwWaitEvents();
    EXPECT_EQ(glfwGetKey(session.window, GLFW_KEY_R), GLFW_RELEASE);
    glfwGetCursorPos(session.window, nullptr, &y);
    EXPECT_EQ(y, 8);
}

// "If GLFW_STICKY_KEYS is enabled, a key press will ensure that glfwGetKey returns GLFW_PRESS the next time it is
// called".
TEST(Headless, sticky_keys_and_buttons)
{
    Session session("0 key R press\n0 key R release\n0 press right\n0 release right");
    glfwSetInputMode(session.window, GLFW_STICKY_KEYS, GLFW_TRUE);
    glfwSetInputMode(session.window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_TRUE);
    EXPECT_EQ(glfwGetInputMode(session.window, GLFW_STICKY_KEYS), GLFW_TRUE);
    glfwPollEvents();
    EXPECT_EQ(glfwGetKey(session.window, GLFW_KEY_R), GLFW_PRESS);
    EXPECT_EQ(glfwGetKey(session.window, GLFW_KEY_R), GLFW_RELEASE);
    glfwSetInputMode(session.window, GLFW_STICKY_MOUSE_BUTTONS, GLFW_FALSE);
    EXPECT_EQ(glfwGetMouseButton(session.window, GLFW_MOUSE_BUTTON_RIGHT), GLFW_RELEASE)
        << "switched off, it is forgotten";
}

TEST(Headless, the_window_is_what_was_asked_for)
{
    Session session("", {.content_scale = {2, 2}});
    int width = 0;
    int height = 0;
    glfwGetWindowSize(session.window, &width, &height);
    EXPECT_EQ(words(width, height), "640 480");
    glfwGetFramebufferSize(session.window, &width, nullptr);
    EXPECT_EQ(width, 1280);
    EXPECT_EQ(glfwGetWindowAttrib(session.window, GLFW_FOCUSED), GLFW_TRUE);
    EXPECT_EQ(glfwGetWindowAttrib(session.window, GLFW_RESIZABLE), GLFW_TRUE);
    EXPECT_STREQ(glfwGetKeyName(GLFW_KEY_Q, 0), "q");
    EXPECT_EQ(glfwGetKeyName(GLFW_KEY_ENTER, 0), nullptr);
    glfwSetClipboardString(session.window, "umbral");
    EXPECT_STREQ(glfwGetClipboardString(nullptr), "umbral");
}

void expect_error(int code)
{
    const char* text = nullptr;
    EXPECT_EQ(glfwGetError(&text), code);
    EXPECT_EQ(text == nullptr, code == GLFW_NO_ERROR);
}

TEST(Headless, errors_have_glfws_codes)
{
    const Headless session({});
    expect_error(GLFW_NO_ERROR);
    EXPECT_EQ(glfwCreateWindow(10, 10, "too early", nullptr, nullptr), nullptr);
    expect_error(GLFW_NOT_INITIALIZED);
    expect_error(GLFW_NO_ERROR);
    glfwPollEvents();
    EXPECT_EQ(glfwGetTime(), 0);
    expect_error(GLFW_NOT_INITIALIZED);
    static std::vector<int> told;
    told.clear();
    EXPECT_EQ(glfwSetErrorCallback([](int code, const char*) { told.push_back(code); }), nullptr)
        << "before glfwInit, as documented";
    glfwInit();
    EXPECT_EQ(glfwCreateWindow(0, 10, "flat", nullptr, nullptr), nullptr);
    GLFWwindow* window = glfwCreateWindow(10, 10, "small", nullptr, nullptr);
    glfwGetKey(window, 7);
    glfwGetMouseButton(window, 8);
    glfwSetInputMode(window, GLFW_CURSOR, 1);
    glfwWindowHint(1234, 0);
    glfwSwapInterval(1);
    glfwWaitEventsTimeout(-1);
    EXPECT_EQ(told, (std::vector{GLFW_INVALID_VALUE, GLFW_INVALID_ENUM, GLFW_INVALID_ENUM, GLFW_INVALID_ENUM,
                                 GLFW_INVALID_ENUM, GLFW_NO_CURRENT_CONTEXT, GLFW_INVALID_VALUE}));
}

TEST(Headless, of_two_windows_the_first_one_is_the_users)
{
    Session session("0 resize 300 200\n1 move 5 5\n2 resize 400 200");
    hear_everything(session.window);
    GLFWwindow* second = glfwCreateWindow(50, 40, "", nullptr, nullptr);
    std::vector<glm::ivec2> sizes;
    glfwSetWindowUserPointer(second, &sizes);
    glfwSetFramebufferSizeCallback(second, [](GLFWwindow* w, int x, int y) {
        static_cast<std::vector<glm::ivec2>*>(glfwGetWindowUserPointer(w))->emplace_back(x, y);
    });
    glfwSetWindowSize(second, 60, 45);
    session.play();
    EXPECT_EQ(session.heard,
              (Lines{"framebuffer 300 200", "size 300 200", "cursor 5 5", "framebuffer 400 200", "size 400 200"}));
    EXPECT_EQ(sizes, (std::vector{glm::ivec2(60, 45)}));
}

TEST(Headless, what_cannot_be_had_says_so)
{
    Session session("");
    EXPECT_EQ(stopped_by([&] {
                  (void)glfwCreateCursor(nullptr, 0, 0);
              }).find("glfwCreateCursor: headless GLFW does not have this; "),
              0U);
    EXPECT_EQ(stopped_by([&] { (void)glfwGetProcAddress("glClear"); }).find("glfwGetProcAddress: headless"), 0U);
    EXPECT_EQ(stopped_by([&] {
                  glfwSetWindowUserPointer(nullptr, nullptr);
              }).find("glfwSetWindowUserPointer: the window is NULL"),
              0U);
    int other = 0;
    EXPECT_NE(stopped_by([&] {
                  (void)glfwWindowShouldClose(reinterpret_cast<GLFWwindow*>(&other));
              }).find("not a window that exists"),
              std::string::npos);
    EXPECT_NE(glfwCreateWindow(1, 1, "", nullptr, nullptr), nullptr);
    EXPECT_NE(stopped_by([&] { (void)glfwCreateWindow(1, 1, "", nullptr, nullptr); }).find("two windows"),
              std::string::npos);
    EXPECT_EQ(glfwGetPrimaryMonitor(), nullptr);
    EXPECT_EQ(glfwJoystickPresent(GLFW_JOYSTICK_1), GLFW_FALSE);
}

}
}

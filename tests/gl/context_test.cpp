#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>

#include "fixture.hpp"

namespace umbral::gl {
namespace {

using Context = GlTest;

TEST_F(Context, is_open_gl45_compatibility)
{
    GLint major = 0;
    GLint minor = 0;
    GLint profile = 0;
    glGetIntegerv(GL_MAJOR_VERSION, &major);
    glGetIntegerv(GL_MINOR_VERSION, &minor);
    glGetIntegerv(GL_CONTEXT_PROFILE_MASK, &profile);
    EXPECT_EQ(major, 4);
    EXPECT_EQ(minor, 5);
    EXPECT_EQ(profile, GL_CONTEXT_COMPATIBILITY_PROFILE_BIT);
    EXPECT_NE(backend_description().find("4.5"), std::string::npos) << backend_description();
    EXPECT_NE(backend_description().find("llvmpipe"), std::string::npos) << backend_description();
}

TEST_F(Context, keeps_the_state_of_each_context_apart)
{
    glClearColor(0.25F, 0, 0, 1);
    {
        OffscreenContext second;
        EXPECT_TRUE(second.is_current());
        EXPECT_FALSE(context().is_current());
        glClearColor(0.75F, 0, 0, 1);
        context().make_current();
        float color[4] = {};
        glGetFloatv(GL_COLOR_CLEAR_VALUE, color);
        EXPECT_EQ(color[0], 0.25F);
    }
    // Destroying the one that is not current leaves the other current.
    EXPECT_TRUE(context().is_current());
    float color[4] = {};
    glGetFloatv(GL_COLOR_CLEAR_VALUE, color);
    EXPECT_EQ(color[0], 0.25F);
}

TEST_F(Context, survives_destruction_with_drawing_pending)
{
    for (int i = 0; i < 3; ++i) {
        OffscreenContext pending;
        glBegin(GL_TRIANGLES);
        for (int corner = 0; corner < 300; ++corner)
            glVertex3f(static_cast<float>(corner % 3), static_cast<float>(corner % 2), 0);
        glEnd();
    }
    SUCCEED();
}

TEST_F(Context, reports_errors_by_name)
{
    EXPECT_NO_THROW(check_errors("nothing"));
    glEnable(0xDEAD);
    try {
        check_errors("enabling nonsense");
        FAIL() << "no error was reported";
    } catch (const std::runtime_error& error) {
        EXPECT_STREQ(error.what(), "OpenGL reports GL_INVALID_ENUM after enabling nonsense");
    }
    EXPECT_NO_THROW(check_errors("nothing more"));
}

TEST(WithoutContext, calls_abort_and_say_which_and_why)
{
    EXPECT_FALSE(has_context());
    EXPECT_THROW((void)backend_description(), std::logic_error);
    EXPECT_DEATH(glClear(GL_COLOR_BUFFER_BIT), "glClear was called while no OpenGL context is current");
    EXPECT_DEATH((void)glGetError(), "glGetError was called while no OpenGL context is current");
}

TEST(WithoutContext, calls_abort_again_once_the_context_is_gone)
{
    {
        OffscreenContext context;
        EXPECT_TRUE(has_context());
    }
    EXPECT_FALSE(has_context());
    EXPECT_DEATH(glFinish(), "glFinish was called while no OpenGL context is current");
}

}
}

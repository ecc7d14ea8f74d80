#include <gtest/gtest.h>

#include <interaction/pick-buffer/sessions.hpp>
#include <umbral/gl/context.hpp>
#include <umbral/gl/opengl.hpp>

// The reference of interaction/pick-buffer against an independent oracle: OpenGL's own selection mode.

using namespace umbral;
using namespace umbral::interaction;
using Words = std::vector<std::uint32_t>;

namespace {

/// The same commands for OpenGL: a primitive is two points, one at each depth.
void carry_out_by_opengl(const NameCommand& command)
{
    switch (command.kind) {
        case NameCommand::Kind::init: glInitNames(); break;
        case NameCommand::Kind::load: glLoadName(command.name); break;
        case NameCommand::Kind::push: glPushName(command.name); break;
        case NameCommand::Kind::pop: glPopName(); break;
        case NameCommand::Kind::note:
            glBegin(GL_POINTS);
            glVertex3d(0, 0, 2 * command.min_depth - 1);
            glVertex3d(0, 0, 2 * command.max_depth - 1);
            glEnd();
    }
}

void carry_out(SelectionBuffer& buffer, const NameCommand& command)
{
    switch (command.kind) {
        case NameCommand::Kind::init: buffer.init_names(); break;
        case NameCommand::Kind::load: (void)buffer.load_name(command.name); break;
        case NameCommand::Kind::push: (void)buffer.push_name(command.name); break;
        case NameCommand::Kind::pop: (void)buffer.pop_name(); break;
        case NameCommand::Kind::note: buffer.note_primitive(command.min_depth, command.max_depth);
    }
}

std::vector<NameCommand> commands_for_mesa(Random& random, int count)
{
    std::vector<NameCommand> kept;
    for (NameCommand command : random_commands(random, count)) {
        // Mesa scales in float, where the ends of the range have no room.
        command.min_depth = 0.05 + 0.9 * command.min_depth;
        command.max_depth = 0.05 + 0.9 * command.max_depth;
        kept.push_back(command);
    }
    return kept;
}

}

TEST(SelectionMode, buffers_are_those_of_opengl)
{
    constexpr std::uint64_t seed = 45003;
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    glMatrixMode(GL_PROJECTION);
    glLoadIdentity();
    glMatrixMode(GL_MODELVIEW);
    glLoadIdentity();
    Random random(seed);
    int overflows = 0;
    for (int i = 0; i < 400; ++i) {
        SCOPED_TRACE("seed " + std::to_string(seed) + ", session " + std::to_string(i));
        const std::vector<NameCommand> commands = commands_for_mesa(random, 30);
        const std::size_t room = 20 + random.below(80);
        const auto buffer = make_selection_buffer(room);
        Words theirs(room);
        glSelectBuffer(static_cast<GLsizei>(room), theirs.data());
        glRenderMode(GL_SELECT);
        for (const NameCommand& command : commands) {
            carry_out(*buffer, command);
            carry_out_by_opengl(command);
        }
        const int expected = glRenderMode(GL_RENDER);
        (void)glGetError();
        const int count = buffer->finish();
        ASSERT_EQ(count, expected);
        if (count < 0) {
            ++overflows;
            continue;
        }
        const auto mine = parse_selection(buffer->words(), count);
        const auto other = parse_selection(theirs, count);
        ASSERT_TRUE(mine && other);
        for (std::size_t k = 0; k < mine->size(); ++k) {
            ASSERT_EQ((*mine)[k].names, (*other)[k].names);
            ASSERT_NEAR((*mine)[k].min_depth, static_cast<double>((*other)[k].min_depth), 2048);
            ASSERT_NEAR((*mine)[k].max_depth, static_cast<double>((*other)[k].max_depth), 2048);
        }
    }
    EXPECT_GT(overflows, 20);
    EXPECT_LT(overflows, 380);
}

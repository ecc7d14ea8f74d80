// play-lab4-headless: lab 4's program without a screen; prints what each frame shows after a key, for comparison with a
// real window.

#include <umbral/gl/context.hpp>
#include <umbral/gl/framebuffer.hpp>
#include <umbral/input/headless.hpp>

#include "play_lab4.hpp"

int main()
{
    using namespace umbral;
    gl::forbid_driver_threads();
    const gl::OffscreenContext context;
    const gl::Framebuffer target(texturing::lab4::width, texturing::lab4::height);
    texturing::ColouredBoxes earlier;
    input::EventScript script;
    for (const int key : texturing::lab4_keys)
        for (const auto action : {input::Key::Action::press, input::Key::Action::release})
            script.push_back({static_cast<double>(script.size() + 1), input::Key{key, action}});
    std::size_t frames = 0;
    // A frame at the beginning, and one for each event: those after a release are told.
    const auto tell = [&] {
        if (frames % 2 == 0) texturing::print_frame(std::to_string(frames / 2));
        ++frames;
    };
    const input::Headless session(script, {.on_frame = tell});
    texturing::run_lab4(texturing::lab_files(), earlier);
    return 0;
}

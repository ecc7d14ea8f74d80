#pragma once

#include <stdexcept>
#include <string_view>
#include <umbral/record/recorder.hpp>

namespace umbral {

/// Records whether a call refuses: 0 if it gives an answer, 1 if it refuses as the interfaces say, 2 if in another way.
/// What it says of its reason is shown where it should have answered.
template <class Call>
void record_refusal(Recorder& out, std::string_view name, Call call)
{
    out.columns(name, "what came of it (0: an answer; 1: std::invalid_argument; 2: another exception)");
    float came_of_it = 0;
    try {
        (void)call();
    } catch (const std::invalid_argument& refusal) {
        out.refused(name, refusal.what());
        came_of_it = 1;
    } catch (...) {
        came_of_it = 2;
    }
    out.append(name, came_of_it);
}

}

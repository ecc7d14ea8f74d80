#pragma once

#include <umbral/core/random.hpp>
#include <umbral/input/events.hpp>

namespace umbral::input {

/// What a random user does.
struct RandomScriptSettings {
    int gestures = 40;            ///< drags, turns of the wheel, keys, changes of the window
    glm::ivec2 window{640, 480};  ///< size at the beginning
    bool resizes = true;          ///< with now and then a minimised window of 0 x 0
    bool focus_losses = true;
    bool fractions = true;  ///< places and wheel steps of fractions, as touchpads and scaled desktops give; multiples
                            ///< of 1/64 and 1/16
};

/// A session as a user might have it: drags with any button (with Shift, across the window's border, with a second
/// button in between), wheel and touchpad, keys with repetition and with modifiers, and motion without a button. Ends
/// with everything released and a request to close.
[[nodiscard]] EventScript random_script(Random& random, const RandomScriptSettings& settings = {});

}

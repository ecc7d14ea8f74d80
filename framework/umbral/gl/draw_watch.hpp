#pragma once

#include <functional>

namespace umbral::gl {

/// Calls a function right before each call of OpenGL that draws, while it lives: the state that a draw meets can be
/// looked at, whatever the program changes before the frame is over. One at a time.
///
/// Of what stands between glBegin and glEnd, before glBegin; not where a display list is recorded and nothing is drawn,
/// but before it is called. The function may call OpenGL: neither traces nor watches see that. Throws std::logic_error
/// if there is a watch already.
class DrawWatch {
public:
    explicit DrawWatch(std::function<void()> look);
    DrawWatch(const DrawWatch&) = delete;
    DrawWatch& operator=(const DrawWatch&) = delete;
    ~DrawWatch();
};

}

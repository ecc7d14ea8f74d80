#pragma once

#include <cstdint>

namespace umbral::lighting {

/// The frame that a light is placed in, and with which it moves.
enum class LightFrame : std::uint32_t {
    world,  ///< like the sun: the light stays where it is in the scene when the camera moves
    camera  ///< like a miner's lamp: it stays where it is in the picture
};

}

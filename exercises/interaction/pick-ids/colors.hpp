#pragma once

#include <kit/refusal.hpp>
#include <umbral/interaction/pick_ids.hpp>
#include <umbral/record/ask.hpp>

#include "scenes.hpp"

/// Ids as colours, and back.
namespace umbral::interaction {

inline void record_colors(Recorder& out, Random& random)
{
    out.columns("color", "red, green, blue");
    const auto record_color = [&](std::uint32_t id) { out.append("color", glm::vec3(ask<color_of_id>(out, id))); };
    for (const std::uint32_t id : {123456U, 0U, 1U, 255U, 256U, 65535U, 65536U, 0xFFFFFFU, 0x010203U, 0x804000U})
        record_color(id);
    for (int i = 0; i < 100; ++i) record_color(random.below(1U << (1 + random.below(24))));

    const auto record_id = [&](const glm::u8vec3& color) {
        out.append("id", static_cast<float>(ask<id_of_color>(out, color)));
    };
    for (const glm::u8vec3& color : {glm::u8vec3(64, 226, 1), {0, 0, 0}, {255, 255, 255}, {1, 2, 3}, {0, 0, 200}})
        record_id(color);
    for (int i = 0; i < 100; ++i) record_id(glm::u8vec3(128.0F + 127.9F * random.in_cube()));
    // Bytes that change alone, that are 0, and that are equal.
    for (int i = 0; i < 8; ++i) {
        glm::u8vec3 color(128.0F + 127.9F * random.in_cube());
        for (const int channel : {i % 3, (i + 1) % 3, (i + 2) % 3}) {
            color[channel] = i < 4 ? 0 : color[(channel + 1) % 3];
            record_id(color);
            color[channel] = static_cast<glm::u8>(1 + random.below(255));
            record_id(color);
        }
    }

    for (int i = 0; i < 24; ++i) {
        const std::uint32_t too_large = i == 1 ? ~0U : (1U << 24U) + (i == 0 ? 0 : random.bits() >> 1U);
        const bool first = random.below(2) == 0;
        for (const bool fits : {first, !first}) {
            record_refusal(out, "refused",
                           [&] { return ask<color_of_id>(out, fits ? too_large % (1U << 24U) : too_large); });
        }
    }
}

}

#include <array>
#include <kit/channels.hpp>
#include <kit/color.hpp>
#include <limits>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "lamps_and_pixels.hpp"
#include "shadows.hpp"

namespace umbral {
namespace {

using namespace lighting;

constexpr float not_a_number = std::numeric_limits<float>::quiet_NaN();

void record_pixel(Recorder& out, const glm::vec3& light) { out.append("pixels", glm::vec3(ask<to_pixel>(out, light))); }

void record_mean(Recorder& out, const std::vector<glm::u8vec3>& pixels)
{
    out.append("means", glm::vec3(ask<mean_pixel>(out, pixels)));
}

// Light other than that which is written, about as bright, whose code lies at least 0.1 away from the border to the
// next one. None and all of it remain.
float other_light(Variation& vary, float light)
{
    if (!vary || light == 0 || light == 1) return light;
    const double code = std::round(std::min(254.0, vary.scaled(255 * srgb_encoded(light), 1.3F)));
    return static_cast<float>(srgb_decoded((code + vary.near(0.0, 0.4)) / 255));
}

// Numbers that a student can check with a pocket calculator.
void by_hand(Variation& vary, Recorder& out)
{
    constexpr glm::vec3 red(1, 0, 0);
    constexpr glm::vec3 green(0, 1, 0);
    constexpr glm::vec3 blue(0, 0, 1);
    const std::vector<Lamp> mixes[] = {{{red, 1}, {green, 1}},       {{green, 1}, {blue, 1}},
                                       {{red, 1}, {blue, 1}},        {{red, 1}, {green, 1}, {blue, 1}},
                                       {{red, 0.5F}, {blue, 0.25F}}, {{{0.5F, 0.25F, 1}, 2}, {{1, 0.5F, 0.25F}, 4}},
                                       {{red, 0}, {green, 3}}};
    for (std::vector<Lamp> lamps : mixes) {
        for (Lamp& lamp : lamps) lamp.amount *= vary.one_of(1.0F, std::array{0.5F, 0.75F, 1.25F, 1.5F});
        out.append("sums", ask<add_lights>(out, lamps));
    }
    // 0 and 1 remain, and what lies on the line.
    const auto beside = [&](float number) { return number < 1 ? vary.scaled(number, 1.1F) : number; };
    for (const float light : {0.0F, 0.001F, 0.002F, 0.01F, 0.18F, 0.2F, 0.5F, 0.8F, 1.0F})
        out.append("encoded", ask<encode_srgb>(out, beside(light)));
    for (const float value : {0.0F, 0.01F, 0.03F, 0.1F, 0.25F, 0.5F, 0.75F, 0.9F, 1.0F})
        out.append("decoded", ask<decode_srgb>(out, beside(value)));
    for (const glm::vec3& light :
         {glm::vec3(0, 0.5F, 1), {0.18F, 0.18F, 0.18F}, {0.002F, 0.02F, 0.2F}, {0.9F, 0, 0.1F}})
        record_pixel(out, {other_light(vary, light.r), other_light(vary, light.g), other_light(vary, light.b)});
    const std::vector<glm::u8vec3> sets[] = {{{0, 0, 0}, {255, 255, 255}},
                                             {{255, 0, 0}, {0, 255, 0}},
                                             {vary.near(glm::ivec3(10, 100, 200), 9)},
                                             {{0, 0, 0}, {0, 0, 0}, {0, 0, 0}, {255, 128, 64}}};
    for (std::vector<glm::u8vec3> pixels : sets) {
        // So many black ones more that no mean comes near the border between two codes.
        const std::size_t more = vary.one_of(0, std::array{1, 3, 5, 6});
        if (pixels.size() > 1) pixels.resize(pixels.size() + more);
        record_mean(out, pixels);
    }
    // Black and white in turns, more of them than a byte can count; and as many white ones as a picture of 265 x 265
    // has, more than 16 bits can.
    const std::size_t step = vary.one_of(2, std::array{3, 4, 5, 7});
    for (const std::size_t white : {150U, 70'000U}) {
        std::vector<glm::u8vec3> many(white * step);
        for (std::size_t i = 0; i < many.size(); i += step) many[i] = glm::u8vec3(255);
        record_mean(out, many);
    }
}

// All codes, and back again. The channels run against each other; varied, each of them begins elsewhere. Then pixels of
// which each differs from the one before in a single channel.
void all_codes(Variation& vary, Random& random, Recorder& out)
{
    const glm::ivec3 first = vary.near(glm::ivec3(0), 127);
    const auto pixel = [&](int code) { return glm::u8vec3((first + glm::ivec3(code, 255 - code, code * 7)) & 255); };
    for (int code = 0; code < 256; ++code) out.append("light", ask<to_light>(out, pixel(code)));
    glm::u8vec3 changing(random_code(random));
    for (int i = 0; i < 256; ++i) {
        // Of eight, one becomes 0.
        const bool is_off = i % 8 == 7 && changing[i % 3] != 0;
        changing[i % 3] = is_off ? std::uint8_t{0} : static_cast<std::uint8_t>(changing[i % 3] + 1 + random.below(255));
        out.append("light", ask<to_light>(out, changing));
    }
    for (int code = 0; code < 256; ++code) {
        const glm::vec3 light = to_light(pixel(code));
        out.append("back", glm::vec3(ask<to_pixel>(out, light)));
    }
}

// The same lamps but for one channel, which is off; then one of them is there twice, alone at last.
void record_other_lamps(Random& random, Recorder& out, std::vector<Lamp> lamps)
{
    lamps.back().color = without_a_channel(random, lamps.back().color);
    out.append("sums", ask<add_lights>(out, lamps));
    lamps.push_back(lamps.back());
    out.append("sums", ask<add_lights>(out, lamps));
    lamps = {lamps.back(), lamps.back()};
    out.append("sums", ask<add_lights>(out, lamps));
}

void at_random(Random& random, Recorder& out)
{
    for (int i = 0; i < 150; ++i) {
        const std::vector<Lamp> lamps = lamps_of_kind(random, i);
        out.append("sums", ask<add_lights>(out, lamps));
        if (i % 5 == 0) record_other_lamps(random, out, lamps);
        // Half of them dark, where the line is.
        const float size = i % 2 == 0 ? 1.0F : 0.02F;
        out.append("encoded", ask<encode_srgb>(out, random.uniform(0, size)));
        out.append("decoded", ask<decode_srgb>(out, random.uniform(0, 5 * std::min(size, 0.2F))));
        glm::vec3 color = clear_color(random);
        record_pixel(out, color);
        // The same but for one channel.
        color[i % 3] = clear_light(random);
        record_pixel(out, color);
        if (i % 5 == 0) record_pixel(out, without_a_channel(random, color));
        std::vector<glm::u8vec3> pixels = pixels_of_kind(random, i);
        record_mean(out, pixels);
        if (i % 2 != 0) continue;
        // As many pixels with the same first one; and, mostly, more of them than a byte can count.
        pixels.back() = glm::u8vec3(255) - pixels.back();
        record_mean(out, pixels);
        pixels.resize(200 + random.below(400));
        for (glm::u8vec3& pixel : pixels) pixel = random_pixel(random) / std::uint8_t{2};
        record_mean(out, pixels);
    }
}

// Each channel may be dark or too bright on its own.
void out_of_range(Random& random, Recorder& out)
{
    for (int i = 0; i < 24; ++i) {
        out.append("encoded", ask<encode_srgb>(out, out_of_range_of_kind(random, i % 8)));
        out.append("decoded", ask<decode_srgb>(out, out_of_range_of_kind(random, i % 8)));
        glm::vec3 color = clear_color(random);
        color[i / 8] = out_of_range_of_kind(random, i % 8);
        record_pixel(out, color);
    }
}

void not_numbers(Random& random, Recorder& out)
{
    for (int i = 0; i < 12; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool strange : {first, !first}) {
            out.append("encoded", ask<encode_srgb>(out, strange ? not_a_number : random.uniform(0.1F, 0.9F)));
            out.append("decoded", ask<decode_srgb>(out, strange ? not_a_number : random.uniform(0.1F, 0.9F)));
            glm::vec3 light = clear_color(random);
            if (strange) light[i % 3] = not_a_number;
            record_pixel(out, light);
        }
    }
}

// No lamp, no pixel, and in pairs with them a few.
void nothing(Random& random, Recorder& out)
{
    for (int i = 0; i < 8; ++i) {
        const bool first = random.below(2) == 0;
        for (const bool empty : {first, !first}) {
            const std::vector<Lamp> lamps = random_lamps(random, 3);
            out.append("sums", ask<add_lights>(out, empty ? std::vector<Lamp>() : lamps));
            const std::vector<glm::u8vec3> alike(2, random_pixel(random));
            record_mean(out, empty ? std::vector<glm::u8vec3>() : alike);
        }
    }
}

// Light that no screen shows: it must not be cut off before the end.
void bright(Random& random, Recorder& out)
{
    for (int i = 0; i < 40; ++i) {
        std::vector<Lamp> lamps = random_lamps(random, 3);
        // Each lamp by a factor of its own, or all of them by one: after a bright sum comes a dim one.
        float factor = 1;
        const bool in_one_channel = i % 5 == 4;
        for (std::size_t k = 0; k < lamps.size() && !in_one_channel; ++k) {
            if (k == 0 || i % 2 == 0)
                factor = std::pow(10.0F, i % 4 == 3 ? 0.0F : random.uniform(0, i % 3 == 0 ? 30.0F : 7.0F));
            lamps[k].color *= factor;
        }
        // One channel alone: what is lost in it is lost in no other.
        if (in_one_channel) lamps.front().color[i % 3] *= 1e25F;
        out.append("sums", ask<add_lights>(out, lamps));
    }
}

// One bright lamp, and very many dim ones, each of them less than the last digit of the sum in float. A thousand of
// them, or more than 16 bits can count.
void many_lamps(Random& random, Recorder& out)
{
    for (int i = 0; i < 8; ++i) {
        const float many = i == 5 ? 70'000.0F : 1000 * std::pow(20.0F, random.uniform());
        std::vector<Lamp> lamps = random_lamps(random, static_cast<std::uint32_t>(many));
        for (Lamp& lamp : lamps) lamp.amount *= 1e-4F;
        glm::vec3 bright = glm::vec3(8000) + 500.0F * random.in_cube();
        // Or in one channel alone: what is lost in it is lost in no other.
        if (i % 2 == 1)
            for (int channel = 0; channel < 3; ++channel)
                if (channel != i / 2 % 3) bright[channel] = random.uniform(0.5F, 1);
        lamps[i % 2 == 0 ? 0 : random.below(100)] = {bright, 1};
        out.append("sums", ask<add_lights>(out, lamps));
    }
}

// The floats on both sides of the border between each two codes, and of the ends of the line. Varied, the first border
// is another one.
void beside_borders(Variation& vary, Recorder& out)
{
    const int first = vary.near(0, 127);
    for (int i = 0; i < 255; ++i) {
        const int code = (i + first + 255) % 255;
        const auto border = static_cast<float>(srgb_decoded((code + 0.5) / 255));
        record_pixel(out, {std::nextafter(border, 0.0F), border, std::nextafter(border, 1.0F)});
    }
}

void to_the_last_digit(Random& random, Recorder& out)
{
    for (int i = 0; i < 200; ++i) {
        // Every second is dark, down to where no picture tells it from 0.
        const float dark = i % 2 == 0 ? std::exp2(random.uniform(-60, -12)) : 1.0F;
        const float light = std::exp2(random.uniform(-8, 0));
        out.append("encoded", ask<encode_srgb>(out, dark * light));
        out.append("decoded", ask<decode_srgb>(out, dark * random.uniform(0.05F, 1)));
        // Close to where the line ends: the curve beside it is another one, by a thousandth and less.
        const float aside = (i % 2 == 0 ? 0.1F : -0.1F) * std::exp2(random.uniform(-10, 0));
        out.append("encoded", ask<encode_srgb>(out, 0.0031308F * (1 + aside)));
        out.append("decoded", ask<decode_srgb>(out, 0.04045F * (1 + aside)));
    }
}

// Twice the light of every lamp, and lamps in another order with other light.
void record_laws(Random& random, Recorder& out)
{
    for (int i = 0; i < 20; ++i) {
        std::vector<Lamp> lamps = random_lamps(random, 4);
        out.append("once", ask<add_lights>(out, lamps));
        for (Lamp& lamp : lamps) lamp.amount *= 2;
        out.append("twice", ask<add_lights>(out, lamps));
    }
}

}

const Driver driver = {
    {"by hand", [](Case& c, Recorder& out) { by_hand(c.vary, out); }},
    {"codes", [](Case& c, Recorder& out) { all_codes(c.vary, c.random, out); }},
    {"random", [](Case& c, Recorder& out) { at_random(c.random, out); }},
    {"out of range", [](Case& c, Recorder& out) { out_of_range(c.random, out); }},
    {"not numbers", [](Case& c, Recorder& out) { not_numbers(c.random, out); }},
    {"nothing", [](Case& c, Recorder& out) { nothing(c.random, out); }},
    {"bright", [](Case& c, Recorder& out) { bright(c.random, out); }},
    {"laws", [](Case& c, Recorder& out) { record_laws(c.random, out); }},
    {"many lamps", [](Case& c, Recorder& out) { many_lamps(c.random, out); }},
    {"beside borders", [](Case& c, Recorder& out) { beside_borders(c.vary, out); }},
    {"to the last digit", [](Case& c, Recorder& out) { to_the_last_digit(c.random, out); }},
    {"picture", [](Case& c, Recorder& out) { out.image("shadows", colored_shadows(320, 240, c.vary)); }},
};

}

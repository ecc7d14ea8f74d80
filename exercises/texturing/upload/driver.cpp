#include <span>
#include <string>
#include <umbral/gl/trace.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "probe.hpp"
#include "scene.hpp"
#include "state.hpp"

namespace umbral {
namespace {

using namespace texturing;
using Made = std::unique_ptr<Texture>;

void activate(Recorder& out, const Made& texture, int unit)
{
    if (texture) ask<&Texture::activate>(out, *texture, unit);
}

void record_cells(Recorder& out, std::string_view name, const Probe& probe, int unit, const Window& window)
{
    for (const glm::vec4& cell : probe.read(unit, window)) out.append(name, cell);
}

// Every texel, read at its centre, wherever rows are said to begin. The pictures have gone when they are uploaded.
void texels(Case& c, Recorder& out)
{
    const Probe probe;
    for (const int alignment : {4, 8}) {
        for (const glm::ivec2 size :
             {glm::ivec2(4, 1), {1, 1}, {4, 4}, {2, 3}, {3, 2}, {5, 4}, {7, 3}, {1, 6}, {17, 9}, {12, 2}}) {
            glPixelStorei(GL_UNPACK_ALIGNMENT, alignment);
            const Made texture =
                ask_new<make_texture>(out, "texture", random_picture(c.random, size.x, size.y), Sampler{}, false);
            activate(out, texture, 0);
            record_cells(out, "texels", probe, 0, {{0, 0}, {1, 1}, size.x, size.y});
        }
    }
    glPixelStorei(GL_UNPACK_ALIGNMENT, 4);
}

/// Every way to sample a texture.
template <class Work>
void for_each_sampler(const Work& work)
{
    for (const bool mipmaps : {false, true})
        for (const Filter filter : both_filters)
            for (const Wrap u : both_wraps)
                for (const Wrap v : both_wraps) work(Sampler{filter, u, v}, mipmaps);
}

// Magnified, from a texture and a half below 0 to one and a half above 1. Cells have their centres off the borders
// between texels.
void outside(Case& c, Recorder& out)
{
    const Probe probe;
    for_each_sampler([&](const Sampler& sampler, bool mipmaps) {
        const Made texture = ask_new<make_texture>(out, "texture", random_picture(c.random, 3, 2), sampler, mipmaps);
        activate(out, texture, 1);
        record_cells(out, "cells", probe, 1, {{-1.53F, -1.48F}, {2.51F, 2.54F}, 17, 13});
    });
}

/// Much longer than high, or the other way round.
Grid<glm::u8vec3> random_strip(Random& random)
{
    const int length = 260 + static_cast<int>(random.below(140));
    const int across = 1 + static_cast<int>(random.below(6));
    return random.below(2) == 0 ? random_picture(random, length, across) : random_picture(random, across, length);
}

// Eight texels a cell along both axes: without mipmaps, a few of them; with them, the mean of 64. Then less of the
// pyramid and more, to its last level, of a picture whose sides are no powers of two, and of a strip, whose longer side
// has more levels than the other.
void minified(Case& c, Recorder& out)
{
    const Probe probe;
    for_each_sampler([&](const Sampler& sampler, bool mipmaps) {
        const Made texture = ask_new<make_texture>(out, "texture", random_picture(c.random, 32, 64), sampler, mipmaps);
        activate(out, texture, 0);
        record_cells(out, "cells", probe, 0, {glm::vec2(0.003F, 0.001F), {1.003F, 1.001F}, 4, 8});
        for (const Grid<glm::u8vec3>& picture : {random_picture(c.random, 75, 44), random_strip(c.random)}) {
            const Made odd = ask_new<make_texture>(out, "texture", picture, sampler, mipmaps);
            activate(out, odd, 0);
            for (const int cells : {1, 2, 4, 13})
                record_cells(out, "cells", probe, 0, {glm::vec2(0.003F, 0.001F), {1.003F, 1.001F}, cells, cells});
        }
    });
}

/// Makes a texture, and says how many calls of OpenGL that took.
Made made(Recorder& out, std::string_view name, const Grid<glm::u8vec3>& picture, bool mipmaps, float& calls)
{
    gl::begin_trace();
    Made texture = ask_new<make_texture>(out, name, picture, Sampler{}, mipmaps);
    calls = static_cast<float>(gl::end_trace().calls.size());
    return texture;
}

// Counts what lives, not what is made and deleted: deleting the name 0 deletes nothing, and what an upload needs for a
// moment may come and go.
void life(Case& c, Recorder& out)
{
    float calls = 0;
    out.columns("alive", "texture objects, other objects, calls of OpenGL when the last texture was made");
    const auto alive = [&, textures = living_textures(), others = living_others()] {
        out.append("alive", glm::vec3(living_textures() - textures, living_others() - others, calls));
    };
    Made texture = made(out, "texture", random_picture(c.random, 12, 9), true, calls);
    alive();
    activate(out, texture, 2);
    alive();
    for (const int unit : {2, 0, 5}) activate(out, texture, unit);
    alive();
    ask_in_words(out, [] { return "texture.reset();  // made and activated before"; });
    texture.reset();
    alive();
    for (int i = 0; i < 4; ++i) {
        made(out, "texture", random_picture(c.random, 2, 2), i % 2 == 0, calls).reset();
        alive();
        const Made other = made(out, "other", random_picture(c.random, 3, 3), i % 2 == 1, calls);
        alive();
        activate(out, other, i);
        alive();
    }
}

void unbind(int unit)
{
    glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
    glBindTexture(GL_TEXTURE_2D, 0);
    glActiveTexture(GL_TEXTURE0);
}

// Frames of a scene, from the second one on. Others use the same units in between. What is seen belongs to the row: who
// binds nothing uploads nothing either.
void frames(Case& c, Recorder& out)
{
    const Probe probe;
    std::array<Made, 3> textures;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        textures[i] = ask_new<make_texture>(out, "texture" + std::to_string(i), random_picture(c.random, 12, 9),
                                            random_sampler(c.random), i == 1);
        activate(out, textures[i], 0);
    }
    out.columns("work", "bytes uploaded, parameters set, texture objects, texel seen/3");
    for (int frame = 0; frame < 24; ++frame) {
        const Made& texture = textures[c.random.below(3)];
        const auto unit = static_cast<int>(c.random.below(3));
        if (c.random.below(2) == 0) unbind(unit);
        gl::begin_trace();
        activate(out, texture, unit);
        const gl::Trace trace = gl::end_trace();
        std::uint64_t parameters = 0;
        for (const auto& [name, count] : trace.counts)
            if (name.find("Parameter") != std::string::npos && !name.starts_with("glGet")) parameters += count;
        const glm::vec4 seen = probe.read(unit, {glm::vec2(0.125F, 0.5F), {0.125F, 0.5F}})[0];
        const std::array row{static_cast<float>(trace.uploaded_bytes),
                             static_cast<float>(parameters),
                             static_cast<float>(living_textures()),
                             seen.r,
                             seen.g,
                             seen.b};
        out.append("work", std::span<const float>(row));
    }
}

/// Does what may change state, and records what that left.
template <class Work>
void record_state(Recorder& out, const Decoys& decoys, const Work& work)
{
    const Snapshot before;
    work();
    std::vector<float> row = {static_cast<float>(integer(GL_ACTIVE_TEXTURE) - GL_TEXTURE0)};
    for (const GLenum name : {GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS,
                              GL_PIXEL_UNPACK_BUFFER_BINDING})
        row.push_back(static_cast<float>(integer(name)));
    row.push_back(static_cast<float>(glGetError()));
    const std::vector<float> bound = decoys.bound();
    row.insert(row.end(), bound.begin(), bound.end());
    Snapshot().append_changes(row, before);
    out.columns("left",
                "active unit, GL_UNPACK_ALIGNMENT, GL_UNPACK_ROW_LENGTH, GL_UNPACK_SKIP_ROWS, GL_UNPACK_SKIP_PIXELS, "
                "GL_PIXEL_UNPACK_BUFFER_BINDING, glGetError, bound to each unit/16" +
                    Snapshot::columns());
    out.append("left", std::span<const float>(row));
}

void choose_state(Random& random)
{
    constexpr std::array alignments = {1, 2, 4, 8};
    glPixelStorei(GL_UNPACK_ALIGNMENT, alignments[random.below(4)]);
    glActiveTexture(GL_TEXTURE0 + random.below(units));
}

// What the unit shows belongs to the case: who binds nothing leaves all state alone.
void state(Case& c, Recorder& out)
{
    const Probe probe;
    for (int round = 0; round < 6; ++round) {
        const Decoys decoys;
        choose_state(c.random);
        Made texture;
        record_state(out, decoys, [&] {
            texture = ask_new<make_texture>(out, "texture", random_picture(c.random, 5, 3), Sampler{}, round % 2 == 1);
        });
        for (int frame = 0; frame < 3; ++frame) {
            choose_state(c.random);
            const auto unit = static_cast<int>(c.random.below(units));
            record_state(out, decoys, [&] { activate(out, texture, unit); });
            record_cells(out, "seen", probe, unit, {{0, 0}, {1, 1}, 5, 3});
        }
        choose_state(c.random);
        record_state(out, decoys, [&] {
            ask_in_words(out, [] { return "texture.reset();  // activated three times before"; });
            texture.reset();
        });
    }
}

// Textures that live at once, three of the same picture and two of these with the same sampler, at several units and
// one of them at two; some go.
void several(Case& c, Recorder& out)
{
    const Probe probe;
    const Grid<glm::u8vec3> shared = random_picture(c.random, 3, 3);
    std::array<Made, 5> textures;
    for (std::size_t i = 0; i < textures.size(); ++i) {
        const Grid<glm::u8vec3> own = random_picture(c.random, 2 + static_cast<int>(i), 3);
        textures[i] = ask_new<make_texture>(out, "texture" + std::to_string(i), i == 1 || i >= 3 ? shared : own,
                                            Sampler{i == 3 ? Filter::bilinear : Filter::nearest}, false);
    }
    const auto record = [&](int unit) {
        record_cells(out, "seen", probe, unit, {{0.01F, 0.01F}, {1.01F, 1.01F}, 4, 4});
    };
    for (const int i : {2, 0, 4, 1, 3}) {
        activate(out, textures[static_cast<std::size_t>(i)], i);
        for (int unit = 0; unit < 5; ++unit) record(unit);
    }
    activate(out, textures[0], 9);
    activate(out, textures[3], 1);
    for (const int unit : {0, 9, 1, 3}) record(unit);
    textures[3].reset();
    textures[0].reset();
    activate(out, textures[1], 0);
    for (const int unit : {0, 1, 2, 4}) record(unit);
    // Of two that are the same but for their names one goes, and another comes.
    textures[1].reset();
    activate(out, textures[4], 3);
    textures[1] = ask_new<make_texture>(out, "texture1", random_picture(c.random, 3, 3), Sampler{}, false);
    activate(out, textures[1], 1);
    for (const int unit : {1, 3, 4}) record(unit);
}

/// From 1 to 256, as often below 16 as above.
int random_side(Random& random) { return 1 + static_cast<int>(random.below(2U << random.below(8))); }

void random(Case& c, Recorder& out)
{
    const Probe probe;
    for (int i = 0; i < 24; ++i) {
        const int width = random_side(c.random);
        const int height = random_side(c.random);
        const Sampler sampler = random_sampler(c.random);
        const bool mipmaps = c.random.below(2) == 1;
        const Made texture =
            ask_new<make_texture>(out, "texture", random_picture(c.random, width, height), sampler, mipmaps);
        choose_state(c.random);
        const auto unit = static_cast<int>(c.random.below(units));
        activate(out, texture, unit);
        record_cells(out, "cells", probe, unit, {{-0.311F, -0.293F}, {1.417F, 1.381F}, 9, 9});
    }
    glActiveTexture(GL_TEXTURE0);
}

}

const Driver driver = {
    {"gallery", [](Case& c, Recorder& out) { out.image("picture", gallery(out, 480, 360, c.vary)); }},
    {"texels", texels},
    {"outside", outside},
    {"minified", minified},
    {"life", life},
    {"frames", frames},
    {"state", state},
    {"several", several},
    {"random", random},
};

}

#pragma once

#include <array>
#include <memory>
#include <stdexcept>
#include <umbral/core/random.hpp>
#include <umbral/lighting/materials.hpp>
#include <umbral/record/ask.hpp>
#include <vector>

/// A pipeline without a screen: it takes down what is drawn, and how the pipeline stands then.
namespace umbral::lighting {

/// What decides how a thing looks, and where it is.
struct Standing {
    glm::dmat4 modelview{1};
    Material reflection;
    std::uint32_t texture = 0;
};

struct Drawn {
    std::uint32_t object = 0;
    Standing standing;
};

class RecordingPipeline final : public LitPipeline {
public:
    static constexpr std::size_t maximum_calls = 50'000;

    /// Begins as somebody else has left it.
    explicit RecordingPipeline(Random& random)
    {
        for (int i = 0; i < 3; ++i) now.modelview[3][i] = random.uniform(-3, 3);
        now.reflection.diffuse = {0.125F, 0.25F, random.uniform()};
        now.texture = 900 + random.below(99);
        stack.resize(1 + random.below(3), glm::dmat4(2.0));
    }

    void set_reflection(const Material& reflection) override
    {
        count();
        ++reflections_set;
        now.reflection = reflection;
    }
    void set_texture(std::uint32_t texture) override
    {
        count();
        ++textures_set;
        now.texture = texture;
    }
    void compose(const glm::mat4& transformation) override
    {
        count();
        now.modelview = now.modelview * glm::dmat4(transformation);
    }
    void push() override
    {
        count();
        stack.push_back(now.modelview);
    }
    void pop() override
    {
        count();
        if (stack.empty()) throw std::logic_error("pop: the stack is empty; each pop needs a push before it");
        now.modelview = stack.back();
        stack.pop_back();
    }
    void draw(std::uint32_t object) override
    {
        count();
        drawn.push_back({object, now});
    }

    Standing now;
    std::vector<glm::dmat4> stack;
    std::vector<Drawn> drawn;
    std::uint32_t reflections_set = 0;
    std::uint32_t textures_set = 0;

private:
    void count()
    {
        if (++calls_ > maximum_calls)
            throw std::length_error("more than 50,000 calls of the pipeline: does the drawing come to an end?");
    }

    std::size_t calls_ = 0;
};

/// A texture that knows its name only.
class NamedTexture final : public SharedTexture {
public:
    explicit NamedTexture(std::uint32_t name) : name_(name) {}
    void activate(LitPipeline& pipeline) override { pipeline.set_texture(name_); }

private:
    std::uint32_t name_;
};

/// A code, and up to 28 numbers.
using Row = std::vector<float>;

inline void append(Row& row, const glm::vec3& color) { row.insert(row.end(), {color.r, color.g, color.b}); }

inline void append(Row& row, const Material& material)
{
    append(row, material.emission);
    append(row, material.ambient);
    append(row, material.diffuse);
    append(row, material.specular);
    row.push_back(material.shininess);
}

inline constexpr const char* event_names =
    "1 an object: name, x axis/3, y axis/3, z axis/3, origin/3, emission/3, ambient/3, diffuse/3, specular/3, "
    "shininess, texture\n"
    "2 afterwards: depth of the stack, x axis/3, y axis/3, z axis/3, origin/3, emission/3, ambient/3, diffuse/3, "
    "specular/3, shininess, texture\n";

inline Row event_row(float code, float first, const Standing& standing)
{
    Row row = {code, first};
    for (int column = 0; column < 4; ++column) append(row, glm::vec3(standing.modelview[column]));
    append(row, standing.reflection);
    row.push_back(static_cast<float>(standing.texture));
    return row;
}

inline void record_drawn(Recorder& out, const RecordingPipeline& pipeline)
{
    const auto add = [&](const Row& row) { out.append("drawn", std::span<const float>(row)); };
    for (const Drawn& drawn : pipeline.drawn) add(event_row(1, static_cast<float>(drawn.object), drawn.standing));
    add(event_row(2, static_cast<float>(pipeline.stack.size()), pipeline.now));
}

}

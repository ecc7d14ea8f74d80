#pragma once

#include <glm/glm.hpp>
#include <glm/gtc/matrix_transform.hpp>
#include <umbral/core/random.hpp>
#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>
#include <umbral/transforms/matrix_stack.hpp>
#include <vector>

#include "../support.hpp"

/// What is done to a matrix stack.
namespace umbral::transforms {

struct Step {
    /// The last one is asked where nothing is on the stack: it must throw, and nothing must come of it.
    enum class Kind { set_view, compose, push, pop, pop_of_nothing };
    Kind kind = Kind::compose;
    glm::mat4 matrix{1};
};

/// 0 if a pop goes well, 1 if it throws EmptyStack, 2 if it throws anything else.
inline float thrown_by_pop(Recorder& out, MatrixStack& stack)
{
    try {
        ask<&MatrixStack::pop>(out, stack);
        return 0;
    } catch (const EmptyStack&) {
        return 1;
    } catch (...) {
        return 2;
    }
}

inline void apply(Recorder& out, MatrixStack& stack, const Step& step)
{
    switch (step.kind) {
        case Step::Kind::set_view: return ask<&MatrixStack::set_view>(out, stack, step.matrix);
        case Step::Kind::compose: return ask<&MatrixStack::compose>(out, stack, step.matrix);
        case Step::Kind::push: return ask<&MatrixStack::push>(out, stack);
        case Step::Kind::pop: return ask<&MatrixStack::pop>(out, stack);
        case Step::Kind::pop_of_nothing: (void)thrown_by_pop(out, stack); return;
    }
}

inline Step set_view(const glm::mat4& matrix) { return {Step::Kind::set_view, matrix}; }
inline Step compose(const glm::mat4& matrix) { return {Step::Kind::compose, matrix}; }
inline Step push() { return {Step::Kind::push, {}}; }
inline Step pop() { return {Step::Kind::pop, {}}; }
inline Step pop_of_nothing() { return {Step::Kind::pop_of_nothing, {}}; }

/// Only the direction of normals counts: the same matrix, its largest entry 1 or -1.
inline glm::mat3 up_to_scale(const glm::mat3& matrix)
{
    double largest = 0;
    for (int column = 0; column < 3; ++column)
        for (int row = 0; row < 3; ++row) largest = std::max(largest, std::abs(double{matrix[column][row]}));
    return largest > 0 ? glm::mat3(glm::dmat3(matrix) / largest) : matrix;
}

/// A quarter turn about x, y or z, exact.
inline glm::mat4 quarter_turn(int axis)
{
    glm::mat4 turn(0);
    turn[axis][axis] = 1;
    turn[(axis + 1) % 3][(axis + 2) % 3] = 1;
    turn[(axis + 2) % 3][(axis + 1) % 3] = -1;
    turn[3][3] = 1;
    return turn;
}

inline glm::mat4 rigid(Random& random)
{
    const glm::vec3 place = 3.0F * random.in_cube();
    const float angle = random.uniform(-3, 3);
    return glm::rotate(glm::translate(glm::mat4(1), place), angle, random.unit_vector());
}

/// What a map does to volumes.
enum class Volume { any, kept };

/// Moves, turns, and stretches by half to double, or so that volumes stay; every other one is a mirror.
inline glm::mat4 random_map(Random& random, Volume volume = Volume::any)
{
    const glm::mat4 moved = rigid(random);
    glm::vec3 size;
    for (int i = 0; i < 3; ++i) size[i] = volume == Volume::any ? random.uniform(0.5F, 2) : random.uniform(0.7F, 1.4F);
    if (volume == Volume::kept) size.z = 1 / (size.x * size.y);
    size.z *= random.below(2) == 0 ? 1.0F : -1.0F;
    return glm::scale(moved, size);
}

/// Makes slanted bricks of cubes, whose edges all have the same length: columns as long as a rotation's, and not
/// perpendicular. Every other one is a mirror.
inline glm::mat4 slant(Random& random)
{
    glm::mat4 map(1);
    const float size = random.uniform(0.5F, 2);
    for (int column = 0; column < 3; ++column) {
        glm::vec3 edge = 0.4F * random.in_cube();
        edge[column] = 1;
        map[column] = glm::vec4(size * normalize(edge), 0);
    }
    if (random.below(2) == 1) map[2] = -map[2];
    return map;
}

/// Frames that show one slanted brick each: the model is slanted, or else the view, and the model turned by a quarter.
inline std::vector<Step> slanted_frames(Random& random, int count)
{
    std::vector<Step> steps;
    for (int i = 0; i < count; ++i) {
        const glm::mat4 view = rigid(random);
        const glm::mat4 brick = slant(random);
        if (i % 3 == 2)
            steps.insert(steps.end(), {set_view(view * brick), compose(quarter_turn(i % 2))});
        else
            steps.insert(steps.end(), {set_view(view), compose(brick)});
    }
    return steps;
}

/// With the numbers of the course's example: M = V · Tra[5,6,7] · Rot[90°,x], copies on the stack, another frame.
inline std::vector<Step> known_session(Variation& vary)
{
    const glm::mat4 one(1);
    const glm::mat4 away = glm::translate(one, by_quarters(vary, {0, 0, -10}));
    return {push(),
            compose(glm::translate(one, by_quarters(vary, {1, 2, 3}))),
            pop(),
            set_view(away),
            compose(glm::translate(one, by_quarters(vary, {5, 6, 7}))),
            compose(quarter_turn(0)),
            push(),
            compose(glm::scale(one, {by_quarters(vary, 2), 1, 1})),
            push(),
            compose(glm::scale(one, {1, by_quarters(vary, 3), 1})),
            pop(),
            compose(glm::scale(one, {1, 1, -1})),
            pop(),
            compose(quarter_turn(1)),
            push(),
            push(),
            set_view(glm::scale(one, {1, by_quarters(vary, 4), 1})),
            compose(quarter_turn(2)),
            push(),
            pop()};
}

/// About `count` steps: matrices, pushes, pops that have something to pop, and now and then another frame; in every
/// other frame the camera has not moved. At most twelve matrices in a row.
inline std::vector<Step> random_session(Random& random, int count, Volume volume = Volume::any)
{
    std::vector<Step> steps;
    glm::mat4 view(1);
    int pushed = 0;
    int composed = 0;
    for (int i = 0; i < count; ++i) {
        const std::uint32_t kind = random.below(20);
        const glm::mat4 matrix = random_map(random, volume);
        const bool camera_moves = random.below(2) == 0;
        if (kind == 0 || composed == 12) {
            if (camera_moves) view = matrix;
            steps.push_back(set_view(view));
            pushed = 0;
            composed = 0;
        } else if (kind < 9) {
            steps.push_back(compose(matrix));
            ++composed;
        } else if (kind < 15) {
            steps.push_back(push());
            ++pushed;
        } else if (pushed > 0) {
            steps.push_back(pop());
            --pushed;
        }
    }
    return steps;
}

/// Something that leaves a matrix on the stack, or nothing: because nothing was pushed, because all was popped, or
/// because a frame began, of which in every other the camera stays where it was. One time in two a pop has failed
/// before.
inline std::vector<Step> steps_before_a_pop(Random& random, bool works)
{
    const glm::mat4 view = random.below(4) == 0 ? glm::mat4(1) : random_map(random);
    const glm::mat4 before = random.below(2) == 0 ? view : random_map(random);
    std::vector<Step> steps{compose(random_map(random))};
    if (random.below(2) == 0) steps.insert(steps.begin(), set_view(before));
    if (random.below(2) == 0) steps.insert(steps.begin() + random.below(2), pop_of_nothing());
    const std::uint32_t pushes = 1 + random.below(3);
    const std::uint32_t way = random.below(3);
    for (std::uint32_t i = 0; i < pushes; ++i) {
        steps.push_back(push());
        steps.push_back(compose(random_map(random)));
    }
    if (way == 0) {
        steps.push_back(set_view(view));
        if (works) steps.insert(steps.end(), {push(), compose(before)});
    } else {
        for (std::uint32_t i = works ? 1 : 0; i < pushes; ++i) steps.push_back(pop());
    }
    return steps;
}

}

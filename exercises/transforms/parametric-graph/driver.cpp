#include <array>
#include <umbral/record/ask.hpp>
#include <umbral/record/driver.hpp>

#include "../support.hpp"
#include "android_graphs.hpp"
#include "motion.hpp"
#include "parts.hpp"
#include "refusals.hpp"

namespace umbral {
namespace {

using namespace transforms;

void record_names(Recorder& out)
{
    out.text("drawn.names",
             "1 an object: its number, x axis/4, y axis/4, z axis/4, origin/4\n"
             "2 afterwards: depth of the stack, x axis/4, y axis/4, z axis/4, origin/4\n"
             "3 an exception went on: its number, -/16\n");
}

/// Code 1, or 2 afterwards; a number; and a matrix, column by column.
void append_matrix(Recorder& out, float code, float number, const glm::dmat4& m)
{
    std::array<float, 18> row{code, number};
    for (int column = 0; column < 4; ++column)
        for (int k = 0; k < 4; ++k)
            row[static_cast<std::size_t>(2 + 4 * column + k)] = static_cast<float>(m[column][k]);
    out.append("drawn", std::span<const float>(row));
}

/// The numbered objects that came out, and how the pipeline stands afterwards.
void record_drawn(Recorder& out, const RecordingPipeline& drawn)
{
    for (const Call& call : drawn.calls())
        if (call.kind == Call::Kind::primitive) append_matrix(out, 1, call.color.x, call.modelview);
    append_matrix(out, 2, static_cast<float>(drawn.depth()), drawn.modelview());
}

void draw(Recorder& out, const GraphNode& node, const Start& start = {.depth = 1})
{
    RecordingPipeline drawn(start);
    introduce(out, drawn, start);
    try {
        ask<&GraphNode::draw>(out, node, drawn);
    } catch (const Torn& torn) {
        append_matrix(out, 3, static_cast<float>(torn.number), glm::dmat4(0));
    }
    record_drawn(out, drawn);
}

std::size_t add(Recorder& out, GraphNode& node, const glm::mat4& matrix)
{
    const std::size_t index = ask<&GraphNode::add_transformation>(out, node, matrix);
    out.append("index", static_cast<std::uint32_t>(index));
    return index;
}

void add(Recorder& out, GraphNode& node, const std::shared_ptr<const Drawable>& object)
{
    out.append("index", static_cast<std::uint32_t>(ask<&GraphNode::add_object>(out, node, object)));
}

// Order, scope, sharing, an empty node, a transformation that nothing follows; a node that grows after it was shared;
// matrices that are not affine, and one of zeros; and forty nodes deep.
void record_node(Variation& vary, Recorder& out)
{
    record_names(out);
    const auto q = [&](float number) { return by_quarters(vary, number); };
    const std::shared_ptr<GraphNode> inner = ask_new<make_graph_node>(out, "inner");
    const std::shared_ptr<GraphNode> outer = ask_new<make_graph_node>(out, "outer");
    const std::shared_ptr<GraphNode> empty = ask_new<make_graph_node>(out, "empty");
    if (!inner || !outer || !empty) return;
    draw(out, *inner);
    add(out, *inner, numbered(1));
    add(out, *inner, move(q(1), q(2)));
    add(out, *inner, numbered(2));
    add(out, *inner, empty);
    add(out, *inner, scale(q(3), q(3)));
    add(out, *outer, scale(q(2), q(5)));
    add(out, *outer, inner);
    add(out, *outer, numbered(3));
    add(out, *outer, move(q(10), q(20), q(30)));
    add(out, *outer, inner);
    draw(out, *inner);
    draw(out, *outer, {.modelview = move(0, 0, q(7)), .depth = 2});
    // The same object twice in a row, and a matrix that changes nothing.
    const std::shared_ptr<const Drawable> twice = numbered(4);
    add(out, *inner, twice);
    add(out, *inner, twice);
    add(out, *inner, move(0, 0));
    add(out, *inner, move(0, 0));
    draw(out, *outer);
    draw(out, *empty);
    const std::shared_ptr<GraphNode> seen = ask_new<make_graph_node>(out, "seen");
    if (!seen) return;
    for (const int number : {6, 7}) {
        add(out, *seen, projective(q(1), q(2), q(static_cast<float>(number))));
        add(out, *seen, numbered(number));
    }
    add(out, *seen, glm::mat4(0));
    add(out, *seen, numbered(8));
    draw(out, *seen, {.modelview = projective(q(3), q(2), q(1)), .depth = 2});
    std::shared_ptr<const Drawable> deep = numbered(5);
    for (int level = 1; level <= 40; ++level) {
        const std::shared_ptr<GraphNode> around = ask_new<make_graph_node>(out, "around");
        if (!around) return;
        add(out, *around, move(q(1), 0));
        add(out, *around, deep);
        deep = around;
        if (level == 40) draw(out, *around);
    }
}

// A part that throws, one node and two deep.
void record_torn(Variation& vary, Recorder& out)
{
    record_names(out);
    const auto q = [&](float number) { return by_quarters(vary, number); };
    const std::shared_ptr<GraphNode> inner = ask_new<make_graph_node>(out, "inner");
    const std::shared_ptr<GraphNode> outer = ask_new<make_graph_node>(out, "outer");
    if (!inner || !outer) return;
    for (GraphNode* const node : {inner.get(), outer.get()}) {
        ask<&GraphNode::add_object>(out, *node, numbered(1));
        ask<&GraphNode::add_transformation>(out, *node, move(q(1), q(2), q(3)));
    }
    ask<&GraphNode::add_object>(out, *inner, painted([](Pipeline&) { throw Torn{7}; }));
    ask<&GraphNode::add_object>(out, *outer, inner);
    draw(out, *inner, {.depth = 2});
    draw(out, *outer, {.modelview = scale(q(2), q(2)), .depth = 3});
}

// Pointers to the same matrices while the node grows tenfold, some equal to the one before, and matrices that are
// written to afterwards. A pointer is recorded as the number of the different ones that came before it.
void record_pointers(Recorder& out, Random& random)
{
    record_names(out);
    const std::shared_ptr<GraphNode> node = ask_new<make_graph_node>(out, "node");
    if (!node) return;
    std::vector<const glm::mat4*> seen;
    const auto append_pointer = [&](const glm::mat4* pointer) {
        const auto found = std::find(seen.begin(), seen.end(), pointer);
        out.append("pointer", pointer == nullptr ? -1 : static_cast<std::int32_t>(found - seen.begin()));
        if (found == seen.end()) seen.push_back(pointer);
    };
    std::vector<std::size_t> indices;
    const std::shared_ptr<const Drawable> object = numbered(1);
    float step = 0;
    const auto grow = [&] {
        if (random.below(3) != 0) step = random.uniform(-1, 1);
        indices.push_back(ask<&GraphNode::add_transformation>(out, *node, move(step, 1)));
        ask<&GraphNode::add_object>(out, *node, object);
    };
    constexpr std::size_t watched = 12;
    while (indices.size() < 400) {
        for (int i = 0; i < 40; ++i) grow();
        for (std::size_t i = 0; i < watched; ++i) append_pointer(ask<&GraphNode::matrix_at>(out, *node, indices[i]));
    }
    for (int i = 0; i < 40; ++i) {
        const std::size_t index = indices[random.below(static_cast<std::uint32_t>(indices.size()))];
        glm::mat4* const pointer = ask<&GraphNode::matrix_at>(out, *node, index);
        out.append("matrix", pointer == nullptr ? glm::mat4(0) : *pointer);
        const float by = random.uniform(-3, 3);
        const float bent = random.uniform(-3, 3);
        if (pointer != nullptr) *pointer = projective(by, bent, 1);
        const glm::mat4* const again = ask<&GraphNode::matrix_at>(out, *node, index);
        out.append("matrix", again == nullptr ? glm::mat4(0) : *again);
        if (pointer != nullptr) *pointer = move(by, 0, 1);
    }
    draw(out, *node);
}

/// Questions to its root begin with this line and all that moved it since.
FacadeGraph new_facade(Recorder& out, const std::string& name, const FacadeParts& parts, float height, float angle)
{
    FacadeGraph facade = ask<make_facade>(out, parts, height, angle);
    if (Questions* const questions = out.questions(); questions != nullptr && facade.root)
        questions->set_object(facade.root.get(), name + ".root",
                              "const FacadeGraph " + name + " = make_facade(parts, " +
                                  literal::of_value(height, true, {}) + ", " + literal::of_value(angle, true, {}) +
                                  ");");
    return facade;
}

/// A line of what was done to it.
void note(Recorder& out, const FacadeGraph& facade, const std::string& before, const auto& value,
          const std::string& after)
{
    if (Questions* const questions = out.questions())
        questions->add_line(facade.root.get(), before + literal::of_value(value, true, {}) + after);
}

/// False, with nothing recorded, if there is no facade to draw.
bool draw(Recorder& out, const FacadeGraph& facade, const Start& start = {.depth = 1})
{
    if (!facade.root || facade.rotation == nullptr || facade.stretch == nullptr) return false;
    draw(out, *facade.root, start);
    return true;
}

void record_facade(Variation& vary, Recorder& out)
{
    record_names(out);
    // Each of parts of its own.
    int part = 1;
    for (const auto& [height, angle] :
         {std::pair{1.5F, 0.0F}, {3.0F, 0.0F}, {1.5F, 1.5F}, {0.75F, -0.25F}, {0.0F, 0.5F}}) {
        const FacadeGraph facade =
            new_facade(out, "facade", numbered_facade(part), vary.scaled(height, 1.3F), vary.near(angle, 0.2F));
        part += 3;
        draw(out, facade);
    }
}

/// From 0.03 to 40, one in four upside down, and one in eight none.
float some_height(Random& random)
{
    const float size = std::pow(10.0F, random.uniform(-1.5F, 1.6F));
    const float signs[] = {1, 1, 1, 1, 1, -1, -1, 0};
    return signs[random.below(8)] * size;
}

// Three facades, two of them of the same parts, whose parameters are set again and again, by the setters and through
// the pointers.
void record_facade_moves(Recorder& out, Random& random)
{
    record_names(out);
    const FacadeParts parts = numbered_facade(1);
    const FacadeGraph facades[] = {new_facade(out, "first", parts, 1.5F, 0), new_facade(out, "second", parts, 2, 0.5F),
                                   new_facade(out, "third", numbered_facade(4), 1, 0.25F)};
    const char* const names[] = {"first", "second", "third"};
    for (int i = 0; i < 24; ++i) {
        const std::uint32_t which = random.below(3);
        const FacadeGraph& facade = facades[which];
        const std::string name = names[which];
        const float height = some_height(random);
        const float angle = random.uniform(-3, 3) * (random.below(4) == 0 ? 8.0F : 1.0F);
        if (!facade.root || facade.rotation == nullptr || facade.stretch == nullptr) return;
        if (i % 4 != 1) {
            ask<set_facade_height>(out, facade, height);
            note(out, facade, "set_facade_height(" + name + ", ", height, ");");
        }
        if (i % 4 != 2) {
            ask<set_facade_angle>(out, facade, angle);
            note(out, facade, "set_facade_angle(" + name + ", ", angle, ");");
        }
        if (i % 4 == 3) {
            *facade.rotation = move(0.5F, -1, 2) * turn(angle, {0, 0, 1}) * scale(2, 2, 2);
            note(out, facade, "*" + name + ".rotation = ", *facade.rotation, ";");
        }
        if (i % 8 == 7) {
            *facade.stretch = scale(0.5F, height);
            note(out, facade, "*" + name + ".stretch = ", *facade.stretch, ";");
        }
        for (const FacadeGraph& each : facades) draw(out, each, random_start(random));
    }
}

}

const Driver driver = {
    {"node", [](Case& c, Recorder& out) { record_node(c.vary, out); }},
    {"torn", [](Case& c, Recorder& out) { record_torn(c.vary, out); }},
    {"pointers", [](Case& c, Recorder& out) { record_pointers(out, c.random); }},
    {"refused", [](Case& c, Recorder& out) { record_refused(out, c.random); }},
    {"facade", [](Case& c, Recorder& out) { record_facade(c.vary, out); }},
    {"facade moves", [](Case& c, Recorder& out) { record_facade_moves(out, c.random); }},
    {"android", [](Case& c, Recorder& out) { record_android(c.vary, out); }},
    {"android moves", [](Case& c, Recorder& out) { record_android_moves(out, c.random); }},
    {"picture", [](Case& c, Recorder& out) { out.image("colours", draw_motion(c.vary, out)); }},
};

}

#pragma once

#include <umbral/record/ask.hpp>
#include <umbral/record/variation.hpp>

#include "../solid_rows.hpp"
#include "parts.hpp"

/// What androids that are graphs draw, at rest and moved by their matrices.
namespace umbral::transforms {

/// An android's solids in an order of their own, and if it has a name the order in which they came.
inline void record_solids(Recorder& out, const AndroidGraph& android, const Start& start, const char* order = nullptr)
{
    RecordingPipeline drawn(start);
    introduce(out, drawn, start);
    ask<&GraphNode::draw>(out, *android.root, drawn);
    for (const DrawnSolid& solid : sorted_solids(drawn, start)) {
        out.append("solids", std::span<const float>(solid.row));
        if (order != nullptr) out.append(order, solid.place);
    }
}

inline void record_solid_names(Recorder& out)
{
    out.text("solids.names",
             "1 half sphere: middle, axis as x 0 0 y z 0, square of the radius as xx yy zz xy xz yz, colour\n"
             "2 cylinder: middle, product of the axis with its direction as xx yy zz xy xz yz, square of the radius "
             "likewise, colour\n");
}

inline bool is_complete(const AndroidGraph& android)
{
    return android.root && android.left_arm != nullptr && android.right_arm != nullptr && android.head != nullptr &&
           android.limb != nullptr;
}

inline Start standing() { return {.color = {0.2F, 0.7F, 0.3F}}; }

/// Questions to its root begin with this line and all that moved it since.
inline AndroidGraph new_android(Recorder& out, const std::string& name, const AndroidParts& parts)
{
    AndroidGraph android = ask<make_android_graph>(out, parts);
    if (Questions* const questions = out.questions(); questions != nullptr && android.root)
        questions->set_object(android.root.get(), name + ".root",
                              "const AndroidGraph " + name + " = make_android_graph(parts);");
    return android;
}

/// Writes to one of its matrices, by the name that questions call it by.
inline void pose(Recorder& out, const AndroidGraph& android, glm::mat4* matrix, const std::string& name,
                 const glm::mat4& motion)
{
    *matrix = motion;
    if (Questions* const questions = out.questions())
        questions->add_line(android.root.get(), "*" + name + " = " + literal::of_value(motion, true, {}) + ";");
}

// At rest; again while another one moves, and that one.
inline void record_android(Variation& vary, Recorder& out)
{
    record_solid_names(out);
    const AndroidGraph android = new_android(out, "android", android_parts());
    if (!is_complete(android)) return;
    Start start = standing();
    start.color = vary.near(start.color, 0.15F);
    start.modelview[3] += glm::vec4(vary.near(glm::vec3(0), 0.5F), 0);
    record_solids(out, android, start, "order");
    const AndroidGraph other = new_android(out, "other", other_android_parts());
    if (!is_complete(other)) return;
    pose(out, other, other.limb, "other.limb", glm::scale(glm::mat4(1), {1, vary.near(0.5F, 0.2F), 1}));
    pose(out, other, other.left_arm, "other.left_arm",
         glm::rotate(glm::mat4(1), vary.near(-1.25F, 0.4F), glm::vec3(1, 0, 0)));
    record_solids(out, android, start);
    record_solids(out, other, start);
}

// One matrix at a time, then all of them, of two androids; what else moves with it?
inline void record_android_moves(Recorder& out, Random& random)
{
    record_solid_names(out);
    const AndroidGraph one = new_android(out, "one", android_parts());
    const AndroidGraph other = new_android(out, "other", other_android_parts());
    if (!is_complete(one) || !is_complete(other)) return;
    glm::mat4* const matrices[] = {one.left_arm, one.right_arm, one.head, one.limb};
    const char* const names[] = {"one.left_arm", "one.right_arm", "one.head", "one.limb"};
    // About any axis: about a joint's own one, a turn before its place and one behind it may come to the same.
    const auto motion = [&](int i) {
        const float angle = random.uniform(0.3F, 1.5F);
        const glm::mat4 turned = glm::rotate(glm::mat4(1), angle, random.unit_vector());
        return i == 3 ? glm::scale(turned, {1, random.uniform(0.6F, 1.4F), 1}) : turned;
    };
    for (int i = 0; i < 4; ++i) {
        pose(out, one, matrices[i], names[i], motion(i));
        record_solids(out, one, standing());
        pose(out, one, matrices[i], names[i], glm::mat4(1));
    }
    for (int round = 0; round < 8; ++round) {
        for (int i = 0; i < 4; ++i) pose(out, one, matrices[i], names[i], motion(i));
        record_solids(out, one, standing());
        record_solids(out, other, standing());
    }
}

}

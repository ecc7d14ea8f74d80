#pragma once

#include <limits>
#include <stdexcept>
#include <umbral/record/ask.hpp>

#include "parts.hpp"

/// What a node must not take, and which of its entries are no matrices.
namespace umbral::transforms {

/// 0: a pointer, 1: null, 2: std::out_of_range, 3: std::invalid_argument, 4: something else.
inline std::int32_t came_of_matrix_at(Recorder& out, GraphNode& node, std::size_t index)
{
    try {
        return ask<&GraphNode::matrix_at>(out, node, index) == nullptr ? 1 : 0;
    } catch (const std::out_of_range&) {
        return 2;
    } catch (const std::invalid_argument&) {
        return 3;
    } catch (...) {
        return 4;
    }
}

inline std::int32_t came_of_adding(Recorder& out, GraphNode& node, const std::shared_ptr<const Drawable>& object)
{
    try {
        ask<&GraphNode::add_object>(out, node, object);
        return 0;
    } catch (const std::invalid_argument&) {
        return 3;
    } catch (...) {
        return 4;
    }
}

// In pairs: what is in order, and what is not.
inline void record_refused(Recorder& out, Random& random)
{
    const std::shared_ptr<GraphNode> node = ask_new<make_graph_node>(out, "node");
    if (!node) return;
    out.columns("refused", "what came of it (0: taken; 1: null; 2: out_of_range; 3: invalid_argument; 4: other)");
    std::size_t size = 0;
    for (int i = 0; i < 20; ++i) {
        const std::size_t transformation = ask<&GraphNode::add_transformation>(out, *node, move(1, 1));
        const std::size_t object = transformation + 1;
        const bool bad_first = random.below(2) == 1;
        const std::size_t beyonds[] = {object + 1, object + 1 + random.below(1'000'000),
                                       (std::size_t{1 + random.below(1000)} << 32U) + transformation,
                                       std::numeric_limits<std::size_t>::max() - random.below(3)};
        const std::size_t beyond = beyonds[i % 4];
        for (const bool is_bad : {bad_first, !bad_first})
            out.append("refused", came_of_adding(out, *node, is_bad ? nullptr : numbered(1)));
        for (const bool is_bad : {bad_first, !bad_first})
            out.append("refused", came_of_matrix_at(out, *node, is_bad ? object : transformation));
        for (const bool is_bad : {!bad_first, bad_first})
            out.append("refused", came_of_matrix_at(out, *node, is_bad ? beyond : transformation));
        size = beyond;
    }
    out.append("refused", came_of_matrix_at(out, *node, size));
    out.append("refused", came_of_matrix_at(out, *node, 0));
}

}

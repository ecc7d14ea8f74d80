#pragma once

#include <algorithm>
#include <cmath>
#include <glm/glm.hpp>
#include <numeric>
#include <vector>

/// The trunks of a tree in one order, in whichever it was drawn.
namespace umbral::transforms {

/// `order` holds a tree that was drawn without another one in between: its trunk first, last or between its two trees,
/// and these in any order. Afterwards it holds trunk, left tree, right tree; what is no such tree stays as it is.
inline void sort_tree(const std::vector<glm::dmat4>& places, std::span<std::size_t> order)
{
    const auto count = static_cast<std::ptrdiff_t>(order.size());
    if (count < 3 || (count & (count + 1)) != 0) return;
    const auto area = [&](std::size_t i) { return std::abs(determinant(glm::dmat2(places[i]))); };
    // A trunk is larger than all that grows on it.
    const auto bring_trunk_to_front = [&](std::span<std::size_t> tree) {
        std::size_t trunk = 0;
        for (const std::size_t i : {tree.size() / 2, tree.size() - 1})
            if (area(tree[i]) > area(tree[trunk])) trunk = i;
        const auto place = tree.begin() + static_cast<std::ptrdiff_t>(trunk);
        std::rotate(tree.begin(), place, place + 1);
    };
    bring_trunk_to_front(order);
    const std::span<std::size_t> trees = order.subspan(1);
    const std::span<std::size_t> first = trees.first(trees.size() / 2);
    const std::span<std::size_t> second = trees.subspan(trees.size() / 2);
    for (const std::span<std::size_t> tree : {first, second}) bring_trunk_to_front(tree);
    const glm::dmat4 to_trunk = inverse(places[order.front()]);
    const auto x = [&](std::size_t i) { return (to_trunk * places[i][3]).x; };
    if (x(first.front()) > x(second.front())) std::swap_ranges(first.begin(), first.end(), second.begin());
    for (const std::span<std::size_t> tree : {first, second}) sort_tree(places, tree);
}

/// The numbers of the trunks in the order trunk, left tree, right tree.
inline std::vector<std::size_t> tree_order(const std::vector<glm::dmat4>& places)
{
    std::vector<std::size_t> order(places.size());
    std::iota(order.begin(), order.end(), std::size_t{0});
    sort_tree(places, order);
    return order;
}

}

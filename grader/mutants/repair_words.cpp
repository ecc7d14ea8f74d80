#include "mutants/repair_words.hpp"

#include <algorithm>
#include <array>
#include <string_view>
#include <utility>

namespace umbral::grader {
namespace {

/// By the kind of a mutant.
constexpr std::array<std::pair<std::string_view, std::string_view>, 29> sentences{{
    {"comparison", "Look at this comparison: which way round is it, and what of values that are equal?"},
    {"tolerance", "Look at how exactly these are compared."},
    {"condition", "Look at this condition: is it asked at all, and the right way round?"},
    {"logic", "Look at how these conditions are joined, and which is negated."},
    {"bits", "Look at this operator on bits."},
    {"arithmetic", "Look at this operator."},
    {"sign", "Look at the sign of this."},
    {"function", "Look at which function is called here."},
    {"term left out", "Look at the parts of this: does each belong here?"},
    {"factor left out", "Look at the factors here: does each belong?"},
    {"factor", "Look at whether a factor is missing here."},
    {"call left out", "Look at whether this call belongs here."},
    {"statement left out", "Look at whether this statement belongs here."},
    {"arguments exchanged", "Look at the order of these arguments."},
    {"order", "Look at the order of these statements."},
    {"constant", "Look at this number."},
    {"index", "Look at this index."},
    {"one more or less", "Look at this number: is it one too many, or one too few?"},
    {"last left out", "Look at where this loop ends."},
    {"component", "Look at which component is taken here."},
    {"field", "Look at which field is taken here."},
    {"variable", "Look at which variable is used here."},
    {"normalised", "Look at the length of this vector: what follows may need a unit vector."},
    {"limited", "Look at the range of this value: what of negative ones, and of large ones?"},
    {"root", "Look at whether this should be a square or its root."},
    {"matrix", "Look at which form of this matrix is needed: itself, its transpose or its inverse."},
    {"angle", "Look at this angle: its unit, and whether it is half or twice of what is meant."},
    {"rounding", "Look at how this is rounded, of negative values too."},
    {"half", "Look at whether this is an edge or a centre, half a step away."},
}};

}

std::string words_of_repair(const Mutant& change)
{
    const auto* const found = std::ranges::find(sentences, std::string_view(change.kind),
                                                &std::pair<std::string_view, std::string_view>::first);
    return found == sentences.end() ? "Look at this." : std::string(found->second);
}

}

#pragma once

#include <cstddef>
#include <string>
#include <vector>

namespace umbral::grader {

/// How many elements a list in a student's answer has, and in the right one.
struct SizePair {
    double yours = 0;
    double right = 0;
};

/// What is wrong with the numbers of elements of one list in the answers to several questions, in words that follow its
/// name: "has 1 element too few in 6 of 9 calls", "has half as many elements as it should in 9 of 9 calls", "is empty
/// in 2 of 9 calls", "has 3 elements where 6 are right in 1 of 4 calls". Empty if all are right.
[[nodiscard]] std::string sentence_of_sizes(const std::vector<SizePair>& calls);

}

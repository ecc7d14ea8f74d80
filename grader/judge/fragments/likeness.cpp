#include "judge/fragments/fragments.hpp"

namespace umbral::grader {
namespace {

/// Of fewer places chance gives too many in common.
constexpr std::size_t least_places = 32;

}

std::optional<double> common_places(const Tensor& student, const Tensor& reference)
{
    const FragmentTable expected(reference);
    if (expected.sorted().size() < least_places) return std::nullopt;
    if (student.cells() == 0) return 0.0;
    const FragmentTable yours(student);
    std::size_t either = yours.unplaced();
    std::size_t both = 0;
    for_each_place(yours.sorted(), expected.sorted(), [&](const Place&, Fragments here, Fragments there) {
        ++either;
        both += here.empty() || there.empty() ? 0 : 1;
    });
    return either == 0 ? 0.0 : static_cast<double>(both) / static_cast<double>(either);
}

}

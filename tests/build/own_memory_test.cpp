#include <gtest/gtest.h>

#include "support/workbench.hpp"

// Work that has nowhere to keep anything is not asked beside itself (unit/beside_itself.hpp).
namespace umbral::grader::test {
namespace {

struct Keeper {
    const char* name;
    const char* before;
    const char* first;
    bool keeps_nothing;
};

class OwnMemory : public testing::TestWithParam<Keeper> {};

TEST_P(OwnMemory, is_found_in_the_library)
{
    const Workbench bench;
    const auto& [name, before, first, keeps_nothing] = GetParam();
    const Built built = bench.build_sphere(sphere_with(before, first));
    ASSERT_EQ(to_string(built.verdict), "ok") << built.message;
    EXPECT_EQ(built.keeps_nothing, keeps_nothing);
    // As it was kept.
    EXPECT_EQ(bench.build_sphere(sphere_with(before, first)).keeps_nothing, keeps_nothing);
}

INSTANTIATE_TEST_SUITE_P(
    Of, OwnMemory,
    testing::Values(
        Keeper{"nothing", "", "", true}, Keeper{"a_constant", "constexpr float eps = 1e-6F;", "(void)eps;", true},
        Keeper{"a_table_of_constants", "static const float table[] = {1, 2, 3, 4};",
               "if (sphere.radius < 0) return table[static_cast<int>(ray.t_min) & 3];", true},
        Keeper{"a_container", "#include <vector>",
               "std::vector<float> roots; roots.push_back(ray.t_min); if (roots.size() > 3) return roots[0];", true},
        Keeper{"an_exception", "#include <stdexcept>",
               "if (sphere.radius < -1e30F) throw std::invalid_argument(\"radius\");", true},
        Keeper{"text_printed", "#include <iostream>", "if (sphere.radius < -1e30F) std::cout << 1;", false},
        Keeper{"a_header_of_streams", "#include <iostream>", "", true},
        Keeper{"a_word_of_a_stream", "#include <iostream>", "if (++std::cout.iword(7) < 0) return std::nullopt;",
               false},
        Keeper{"an_error_code", "#include <cerrno>", "if (errno == 7) return std::nullopt;", false},
        Keeper{"a_byte", "static bool asked = false;",
               "if (sphere.radius < -1e30F) return asked ? 1.F : 2.F; asked = true;", false},
        Keeper{"a_byte_that_is_set", "static bool first = true;",
               "if (sphere.radius < -1e30F) return first ? 1.F : 2.F; first = false;", false},
        Keeper{"a_variable_of_a_function", "", "static int calls = 0; if (++calls < 0) return std::nullopt;", false},
        Keeper{"a_variable_of_a_thread", "thread_local int calls = 0;", "if (++calls < 0) return std::nullopt;", false},
        Keeper{"a_global_container", "#include <vector>\nstatic std::vector<float> seen;", "seen.push_back(ray.t_min);",
               false},
        Keeper{"random_numbers", "#include <cstdlib>", "if (std::rand() < 0) return std::nullopt;", false}),
    [](const auto& info) { return std::string(info.param.name); });

}
}

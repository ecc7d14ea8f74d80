#include <gtest/gtest.h>

#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

/// A view_matrix.cpp that gets the matrix from somewhere.
std::string view(const std::string& before, const std::string& answer)
{
    return before +
           "\nnamespace umbral::projections {\n\nglm::mat4 view_matrix(const glm::vec3& eye, const glm::vec3& target, "
           "const glm::vec3& up)\n{\n    " +
           answer + "\n}\n\n}\n";
}

struct Case {
    const char* name;
    Sources files;
};

class ForbiddenNames : public testing::TestWithParam<Case> {};

TEST_P(ForbiddenNames, are_found)
{
    const Workbench bench;
    const Built built = build(bench.tools(), bench.exercise("projections/view-matrix"), GetParam().files);
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_NE(built.message.find("glm::lookAt"), std::string::npos) << built.message;
    EXPECT_TRUE(built.library.empty());
}

const std::vector<Case> looks = {
    {"called", {{"view_matrix.cpp", view("", "return glm::lookAt(eye, target, up);")}}},
    {"right_handed", {{"view_matrix.cpp", view("", "return glm::lookAtRH(eye, target, up);")}}},
    {"in_double",
     {{"view_matrix.cpp",
       view("", "return glm::mat4(glm::lookAt(glm::dvec3(eye), glm::dvec3(target), glm::dvec3(up)));")}}},
    {"using_declaration", {{"view_matrix.cpp", view("using glm::lookAt;", "return lookAt(eye, target, up);")}}},
    {"argument_dependent", {{"view_matrix.cpp", view("", "return lookAt(eye, target, up);")}}},
    {"namespace_alias", {{"view_matrix.cpp", view("namespace g = glm;", "return g::lookAt(eye, target, up);")}}},
    {"macro", {{"view_matrix.cpp", view("#define GLUE(a, b) a##b", "return glm::GLUE(look, At)(eye, target, up);")}}},
    {"template_wrapper",
     {{"view_matrix.cpp", view("template <class V> auto camera(V e, V t, V u) { return glm::lookAt(e, t, u); }",
                               "return camera(eye, target, up);")}}},
    {"function_pointer",
     {{"view_matrix.cpp", view("static glm::mat4 (*const volatile look)(const glm::vec3&, const glm::vec3&, const "
                               "glm::vec3&) = &glm::lookAt<float, glm::defaultp>;",
                               "return look(eye, target, up);")}}},
    {"always_inline",
     {{"view_matrix.cpp", view("[[gnu::always_inline, gnu::flatten]] static inline glm::mat4 mine(glm::vec3 e, "
                               "glm::vec3 t, glm::vec3 u) { return glm::lookAt(e, t, u); }",
                               "return mine(eye, target, up);")}}},
    {"helper_header",
     {{"view_matrix.cpp", view("#include \"mine.hpp\"", "return mine(eye, target, up);")},
      {"mine.hpp",
       "#pragma once\ninline glm::mat4 mine(glm::vec3 e, glm::vec3 t, glm::vec3 u) { return glm::lookAt(e, t, u); "
       "}\n"}}},
    {"helper_source",
     {{"view_matrix.cpp",
       view("glm::mat4 mine(glm::vec3 e, glm::vec3 t, glm::vec3 u);", "return mine(eye, target, up);")},
      {"mine.cpp", "glm::mat4 mine(glm::vec3 e, glm::vec3 t, glm::vec3 u) { return glm::lookAt(e, t, u); }\n"}}},
    {"other_optimisation",
     {{"view_matrix.cpp", view("#pragma GCC optimize(\"O3\")", "return glm::lookAt(eye, target, up);")}}},
};
INSTANTIATE_TEST_SUITE_P(LookAt, ForbiddenNames, testing::ValuesIn(looks),
                         [](const auto& one) { return std::string(one.param.name); });

class NamesOfTheSystem : public testing::TestWithParam<std::pair<const char*, const char*>> {};

TEST_P(NamesOfTheSystem, are_forbidden_and_named)
{
    const Workbench bench;
    const auto& [name, code] = GetParam();
    const std::string includes =
        "#include <cstdlib>\n#include <dlfcn.h>\n#include <fstream>\n#include <pthread.h>\n#include "
        "<sys/mman.h>\n#include <sys/socket.h>\n#include <umbral/input/glfw.hpp>\n#include <unistd.h>\n";
    const Built built = bench.build_sphere(sphere_with(includes, std::string("    ") + code));
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_NE(built.message.find(name), std::string::npos) << built.message;
}

using NameAndCode = std::pair<const char*, const char*>;
INSTANTIATE_TEST_SUITE_P(
    All, NamesOfTheSystem,
    testing::Values(NameAndCode{"dlopen", "if (dlopen(\"libm.so.6\", RTLD_LAZY) == nullptr) return std::nullopt;"},
                    NameAndCode{"dlsym", "if (dlsym(RTLD_DEFAULT, \"system\") == nullptr) return std::nullopt;"},
                    NameAndCode{"system", "if (std::system(\"id\") != 0) return std::nullopt;"},
                    NameAndCode{"fork", "if (fork() != 0) return std::nullopt;"},
                    NameAndCode{
                        "pthread_create",
                        "pthread_t id; if (pthread_create(&id, nullptr, nullptr, nullptr) != 0) return std::nullopt;"},
                    NameAndCode{"fopen", "if (std::fopen(\"/etc/passwd\", \"r\") == nullptr) return std::nullopt;"},
                    NameAndCode{"socket", "if (socket(2, 1, 0) < 0) return std::nullopt;"},
                    NameAndCode{"mmap", "if (mmap(0, 1, 0, 0, 0, 0) == nullptr) return std::nullopt;"},
                    NameAndCode{"syscall", "if (syscall(57) < 0) return std::nullopt;"},
                    NameAndCode{"execl", "execl(\"/bin/sh\", \"sh\", nullptr);"},
                    NameAndCode{"getenv", "if (std::getenv(\"HOME\") == nullptr) return std::nullopt;"},
                    NameAndCode{"_exit", "_exit(0);"},
                    NameAndCode{"glfwGetTime", "if (glfwGetTime() < 0) return std::nullopt;"}),
    [](const auto& one) { return std::string(one.param.first); });

struct Forbidden {
    const char* name;
    const char* unit;
    const char* file;
    std::string text;
    const char* found;  ///< the function that the message must name
};

class ForbiddenFamilies : public testing::TestWithParam<Forbidden> {};

// Whatever does what the unit is about is forbidden, by whatever name.
TEST_P(ForbiddenFamilies, are_found_by_what_declares_them)
{
    const Workbench bench;
    const Built built = build(bench.tools(), bench.exercise(GetParam().unit), {{GetParam().file, GetParam().text}});
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_NE(built.message.find(GetParam().found), std::string::npos) << built.message;
}

/// An axis_rotation.cpp that gets the matrix from somewhere.
std::string rotation(const std::string& before, const std::string& answer)
{
    return "#define GLM_ENABLE_EXPERIMENTAL\n" + before + "\nglm::mat4 mine(float angle, glm::vec3 axis)\n{\n    " +
           answer + "\n}\n";
}

const std::vector<Forbidden> families = {
    {"rotate", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("", "return glm::rotate(glm::mat4(1), angle, axis);"), "glm::rotate"},
    {"rotate_slow", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("", "return glm::rotate_slow(glm::mat4(1), angle, axis);"), "glm::rotate_slow"},
    {"scale_slow", "transforms/basic-matrices", "basic_matrices.cpp",
     rotation("", "return glm::scale_slow(glm::mat4(1), axis * angle);"), "glm::scale_slow"},
    {"rotate_normalized_axis", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("#include <glm/gtx/rotate_normalized_axis.hpp>",
              "return glm::rotateNormalizedAxis(glm::mat4(1), angle, axis);"),
     "glm::rotateNormalizedAxis"},
    {"quaternion", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("#include <glm/gtc/quaternion.hpp>", "return glm::mat4_cast(glm::angleAxis(angle, axis));"), "glm::"},
    {"quaternion_product", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("#include <glm/gtc/quaternion.hpp>",
              "return glm::mat4(glm::mat3(glm::quat(angle, axis) * axis, axis, axis));"),
     "glm::"},
    {"in_double", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("", "return glm::mat4(glm::rotate(glm::dmat4(1), double(angle), glm::dvec3(axis)));"), "glm::rotate"},
    {"renamed_by_macros", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("#define rotate turn\n#define GLM_EXT_INCLUDED_AGAIN\nnamespace again {\nusing namespace glm;\n#include "
              "<glm/ext/matrix_transform.inl>\n}\n#undef rotate",
              "return again::glm::turn(glm::mat4(1), angle, axis);"),
     "turn"},
    {"rotate_by_opengl", "transforms/axis-rotation", "axis_rotation.cpp",
     rotation("extern \"C\" void glRotated(double, double, double, double);",
              "glRotated(angle, axis.x, axis.y, axis.z); return glm::mat4(1);"),
     "glRotated"},
    {"translate_by_opengl", "transforms/basic-matrices", "basic_matrices.cpp",
     rotation("extern \"C\" void glTranslatef(float, float, float);",
              "glTranslatef(axis.x, axis.y, axis.z); return glm::mat4(angle);"),
     "glTranslatef"},
    {"quat_look_at", "projections/view-matrix", "view_matrix.cpp",
     rotation("#include <glm/gtc/quaternion.hpp>", "return glm::mat4_cast(glm::quatLookAt(axis, axis));"),
     "glm::quatLookAt"},
    {"diagonal", "transforms/basic-matrices", "basic_matrices.cpp",
     rotation("#include <glm/gtx/matrix_operation.hpp>", "return glm::diagonal4x4(glm::vec4(axis, angle));"),
     "glm::diagonal4x4"},
    {"dot_product", "transforms/vectors", "vectors.cpp", rotation("", "return glm::mat4(glm::dot(axis, axis));"),
     "glm::dot"},
    {"norm", "transforms/vectors", "vectors.cpp",
     rotation("#include <glm/gtx/norm.hpp>", "return glm::mat4(glm::l2Norm(axis));"), "glm::"},
};
INSTANTIATE_TEST_SUITE_P(All, ForbiddenFamilies, testing::ValuesIn(families),
                         [](const auto& one) { return std::string(one.param.name); });

// Of units that draw, only those that are about OpenGL may call it: it can compute, too.
TEST(Names, opengl_is_for_units_about_it)
{
    const Workbench bench;
    const std::string text =
        "extern \"C\" void glGetFloatv(unsigned, float*);\n" +
        view("", "glm::mat4 m; glGetFloatv(2982, &m[0][0]); return m * (eye.x + target.x + up.x);");
    const Built built = build(bench.tools(), bench.exercise("projections/view-matrix"), {{"view_matrix.cpp", text}});
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_NE(built.message.find("glGetFloatv"), std::string::npos) << built.message;
}

TEST(Names, what_only_shares_a_header_is_allowed)
{
    const Workbench bench;
    const Built built =
        build(bench.tools(), bench.exercise("transforms/axis-rotation"),
              {{"axis_rotation.cpp", rotation("", "return glm::identity<glm::mat4>() * glm::mat4(angle) * axis.x;")}});
    // It defines nothing of the interface; but nothing in it is forbidden.
    EXPECT_EQ(to_string(built.verdict), "interface_mismatch") << built.message;
}

// A name of 400 letters can stand for gigabytes of text.
TEST(Names, doubling_template_arguments_cost_nothing)
{
    const Workbench bench;
    std::string text = "template <class A, class B> struct P {};\nusing T0 = int;\n";
    for (int i = 1; i <= 18; ++i)
        text +=
            "using T" + std::to_string(i) + " = P<T" + std::to_string(i - 1) + ", T" + std::to_string(i - 1) + ">;\n";
    const Built built = bench.build_sphere(sphere_with(text + "void gone(T18*);\n", "gone(nullptr);"));
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
    EXPECT_TRUE(built.message.starts_with("gone(P<")) << built.message;
    EXPECT_LT(built.message.size(), 1000U);
}

TEST(Names, a_message_names_some_and_counts_the_rest)
{
    const Workbench bench;
    std::string declarations;
    std::string calls;
    for (int i = 0; i < 500; ++i) {
        declarations += "void gone" + std::to_string(i) + "();\n";
        calls += "gone" + std::to_string(i) + "();\n";
    }
    const Built built = bench.build_sphere(sphere_with(declarations, calls));
    EXPECT_EQ(to_string(built.verdict), "forbidden");
    EXPECT_NE(built.message.find("and 488 more"), std::string::npos) << built.message;
    EXPECT_LT(built.message.size(), 1000U);
}

// A weak reference is resolved like any other when the library is loaded.
TEST(Names, weak_references_are_no_way_round)
{
    const Workbench bench;
    const Built built = bench.build_sphere(sphere_with("extern \"C\" int system(const char*) __attribute__((weak));\n",
                                                       "    if (system(\"id\") != 0) return std::nullopt;"));
    EXPECT_EQ(to_string(built.verdict), "forbidden") << built.message;
}

TEST(Names, the_standard_library_is_allowed)
{
    const Workbench bench;
    const Built built =
        bench.build_sphere(sphere_with("#include <complex>\n#include <map>\n#include <numeric>\n#include "
                                       "<random>\n#include <regex>\n#include <set>\n#include "
                                       "<sstream>\n#include <unordered_map>\n",
                                       R"(
    static std::map<int, std::string> names{{1, "one"}};
    std::unordered_map<std::string, double> table{{"pi", std::acos(-1.0)}};
    std::ostringstream text;
    text << names[1] << table["pi"] << std::sin(ray.t_min) << std::lround(2.5);
    std::mt19937 engine(7);
    std::function<double()> draw = [&] { return std::uniform_real_distribution<double>(0, 1)(engine); };
    const std::complex<double> product = std::complex<double>(ray.t_min, 1) * std::complex<double>(1, ray.t_min)
                                         / std::complex<double>(2, ray.t_min);
    const __float128 sum = static_cast<__float128>(ray.t_min) * product.real() + 1;
    const unsigned __int128 big = static_cast<unsigned __int128>(table.size()) * table.size() / names.size();
    if (sum < 0 && big % 7 == 8) return static_cast<float>(sum);
    std::vector<double> values(10);
    std::generate(values.begin(), values.end(), draw);
    std::sort(values.begin(), values.end());
    auto shared = std::make_shared<int>(3);
    try { if (values[0] > 2) throw std::runtime_error("no"); }
    catch (const std::exception& error) { std::cerr << error.what(); }
    if (text.str().empty() || *shared == 4 || std::strtol("5", nullptr, 10) == 6 ||
        std::rand() == -1) return std::nullopt;)"));
    EXPECT_EQ(to_string(built.verdict), "ok") << built.message;
}

TEST(Names, an_interface_mismatch_names_both)
{
    const Workbench bench;
    Built built = bench.build_sphere(
        "namespace umbral::raytracing {\nstd::optional<float> intersect(Ray ray, Sphere sphere) { return ray.t_min + "
        "sphere.radius; }\n}\n");
    EXPECT_EQ(to_string(built.verdict), "interface_mismatch");
    EXPECT_NE(built.message.find("umbral::raytracing::intersect(umbral::Ray, umbral::raytracing::Sphere)"),
              std::string::npos)
        << built.message;
    EXPECT_NE(
        built.message.find("umbral::raytracing::intersect(umbral::Ray const&, umbral::raytracing::Sphere const&)"),
        std::string::npos)
        << built.message;
    built = bench.build_sphere(
        "std::optional<float> intersect(const umbral::Ray& ray, const umbral::raytracing::Sphere&) { return ray.t_min; "
        "}\n");
    EXPECT_EQ(to_string(built.verdict), "interface_mismatch");
    EXPECT_NE(built.message.find("you wrote intersect("), std::string::npos) << built.message;
    built = bench.build_sphere("static int nothing = 0;\n");
    EXPECT_EQ(to_string(built.verdict), "interface_mismatch");
    EXPECT_NE(built.message.find("does not define"), std::string::npos) << built.message;
}

}
}

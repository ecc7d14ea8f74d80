#include <gtest/gtest.h>

#include "forging.hpp"
#include "grading/planted.hpp"
#include "raw_calls.hpp"
#include "support/workbench.hpp"
#include "unit/grade_unit.hpp"

namespace umbral::grader::test {
namespace {

struct Forgery {
    const char* name;
    const char* code;  ///< `h` is the recording's header
};

const std::vector<Forgery> forgeries = {
    {"finished_with_nothing", "h->tensors_size = 0; h->tensor_count = 0; finish(h);"},
    {"finished_with_zeros",
     "put(h, \"t\", {1, 14, 1, 1, 0, 1}, 56, 0); put(h, \"ids\", {3, 256, 256, 1, 0, 0}, 256 * 256 * 4, 0); "
     "put(h, \"normals\", {1, 256, 256, 3, 0, 0}, 256 * 256 * 12, 0); finish(h);"},
    {"finished_with_ones", "put(h, \"t\", {1, 14, 1, 1, 0, 1}, 56, 1); finish(h);"},
    {"finished_with_nan", "put(h, \"t\", {1, 14, 1, 1, 0, 1}, 56, 255); finish(h);"},
    {"margins_of_its_own",
     "put(h, \"t\", {1, 14, 1, 1, 0, 1}, 56, 0); put(h, \"t.margin\", {2, 14, 1, 1, 0, 0}, 112, 0); finish(h);"},
    {"verdict_in_the_recording",
     "put(h, \"score\", {2, 1, 1, 1, 0, 0}, 8, 255); put(h, \"verdict\", {4, 1, 1, 1, 0, 0}, 4, 0); finish(h);"},
    {"blames_the_driver", "h->note = 7; std::strcpy(h->text, \"the driver failed\"); leave();"},
    {"blames_the_loading",
     "h->note = 8; std::strcpy(h->text, \"driver.so: cannot open shared object file\"); leave();"},
    {"never_reached_the_sandbox", "h->stage = 0; leave();"},
    {"never_reached_it_and_crashed", "h->stage = 0; h->note = 7; asm volatile(\".byte 0x0f, 0x0b\");"},
    {"compile_error_of_its_own", "h->note = 5; std::memset(h->text, 'x', sizeof h->text); leave();"},
    {"text_without_end", "h->note = 1; std::memset(h->text, 0xff, sizeof h->text); leave();"},
    {"escape_sequences", "h->note = 1; std::strcpy(h->text, \"\\033[2J\\033]0;owned\\007\"); leave();"},
    {"no_magic", "h->magic = 0; finish(h);"},
    {"huge_size", "h->tensors_size = ~0ULL; h->tensor_count = 1; finish(h);"},
    {"size_of_the_file", "h->tensors_size = umbral::wire::maximum_size; h->tensor_count = 1; finish(h);"},
    {"huge_count", "h->tensors_size = 0; h->tensor_count = ~0ULL; finish(h);"},
    {"huge_rows", "put(h, \"t\", {1, 0xffffffffU, 1, 1, 0, 1}, 8, 0); h->tensors_size = 64; finish(h);"},
    {"product_that_wraps", "put(h, \"t\", {1, 65536, 65536, 1, 0, 0}, 8, 0); finish(h);"},
    {"huge_components", "put(h, \"t\", {1, 1, 1, 0xffffffffU, 0, 0}, 8, 0); finish(h);"},
    {"unknown_element", "put(h, \"t\", {77, 14, 1, 1, 0, 0}, 56, 0); finish(h);"},
    {"counts_of_the_notes", "h->refused_count = ~0U; h->frame_count = ~0U; leave();"},
    {"wild_frames",
     "h->frame_count = 32; h->note = 3; h->signal = 11; std::memset(h->frames, 0xab, sizeof h->frames); leave();"},
    {"wild_signal", "h->note = 3; h->signal = ~0U; leave();"},
    {"all_ones", "std::memset(h, 0xff, 1 << 20); leave();"},
    {"all_zeros", "std::memset(h, 0, 1 << 20); leave();"},
    {"random_bytes", "raw(SYS_getrandom, h, 1 << 16, 0); leave();"},
    {"random_behind_the_magic", "raw(SYS_getrandom, reinterpret_cast<char*>(h) + 8, 1 << 16, 0); leave();"},
    {"random_tensors",
     "raw(SYS_getrandom, reinterpret_cast<char*>(h) + umbral::wire::tensors_offset, 4096, 0); h->tensors_size = 4096; "
     "h->tensor_count = 3; finish(h);"},
    {"unmapped", "raw(SYS_munmap, h, umbral::wire::maximum_size);"},
    {"read_only", "raw(SYS_mprotect, h, umbral::wire::maximum_size, PROT_READ);"},
    {"many_stubs", "h->not_implemented = ~0U; finish(h);"},
};

class Forgeries : public testing::TestWithParam<Forgery> {};

TEST_P(Forgeries, earn_nothing_and_are_no_fault_of_the_grader)
{
    const Workbench bench;
    const std::string attack = std::string(
                                   "void attack()\n{\n    Header* h = find();\n    if (h == nullptr) { "
                                   "std::printf(\"no recording found\\n\"); return; }\n    "
                                   "std::printf(\"found it\\n\");\n    std::fflush(stdout);\n    ") +
                               GetParam().code + "\n}\n";
    const std::string text = sphere_with(raw_calls + find_recording + "namespace {\n" + attack + "}\n",
                                         "    static const bool done = (attack(), true);\n    (void)done;");
    Worker worker(bench.tools());
    const Exercise exercise = bench.exercise("raytracing/sphere");
    GradeOptions options;
    options.explain = false;

    const UnitResult result = grade_unit(worker, exercise, {planted(bench, text), {}, ""}, options);
    EXPECT_NE(result.output.find("found it"), std::string::npos)
        << to_string(result.verdict) << ": " << result.message << result.output;
    EXPECT_NE(result.verdict, Verdict::grader_fault) << result.message;
    EXPECT_EQ(result.max_score, 10000);
    EXPECT_EQ(result.score, 0) << result.message;
    EXPECT_EQ(result.message.find('\033'), std::string::npos);

    const UnitResult after = grade_unit(
        worker, exercise, {{{"sphere.cpp", project_file("reference/raytracing/sphere.cpp")}}, {}, ""}, options);
    EXPECT_EQ(after.score, 10000) << after.message;
}

INSTANTIATE_TEST_SUITE_P(All, Forgeries, testing::ValuesIn(forgeries),
                         [](const auto& one) { return std::string(one.param.name); });

}
}

#include <gtest/gtest.h>

#include <fstream>
#include <regex>
#include <set>
#include <sstream>

#include "explaining.hpp"
#include "judge/trace/gl_calls.hpp"
#include "judge/trace/trace_counts.hpp"

namespace umbral::grader::test {
namespace {

// What a frame from buffers looks like: 34962 is GL_ARRAY_BUFFER, 34963 GL_ELEMENT_ARRAY_BUFFER, 5125 GL_UNSIGNED_INT,
// 5126 GL_FLOAT.
const std::string first_frame =
    "glGenVertexArrays 1 1\nglBindVertexArray 1\nglGenBuffers 2 1\nglBindBuffer 34962 1\nglBufferData 34962 1536 1 "
    "35044 | 1536\n"
    "glEnableVertexAttribArray 0\nglVertexAttribPointer 0 3 5126 0 0 0\nglBindBuffer 34963 2\nglBufferData 34963 24 1 "
    "35044 | 24\n"
    "glDrawElements 4 6 5125 0\nglBindVertexArray 0\n";
const std::string later_frame = "glBindVertexArray 1\nglDrawElements 4 6 5125 0\nglBindVertexArray 0\n";

Check check_with(std::vector<std::string> rules)
{
    Check check = check_of(JudgeKind{"trace"});
    check.own = TraceParameters{std::move(rules)};
    return check;
}
Check all_rules() { return check_with({trace_rules.begin(), trace_rules.end()}); }

Judgement judged(const std::string& yours, const std::string& expected, const Check& check = all_rules())
{
    return judge(check, text(yours), text(expected), nullptr);
}

TEST(Traces, equal_ones_keep_every_rule)
{
    const Judgement found = judged(first_frame, first_frame);
    EXPECT_EQ(found.right, 1);
    EXPECT_EQ(found.message, "");
    EXPECT_FALSE(found.first_difference);
    EXPECT_EQ(found.metrics.at("draw_calls"), 1);
    EXPECT_EQ(found.metrics.at("vertices"), 6);
    EXPECT_EQ(found.metrics.at("uploaded_bytes"), 1560);
    EXPECT_EQ(found.metrics.at("objects_created"), 3);
    EXPECT_EQ(found.metrics.at("objects_deleted"), 0);
    EXPECT_EQ(found.metrics.at("deprecated_calls"), 0);
    EXPECT_EQ(found.metrics.at("state_changes"), 6);
}

TEST(Traces, two_draw_calls_where_one_is_possible)
{
    const Judgement found =
        judged("glBindVertexArray 7\nglDrawElements 4 3 5125 0\nglDrawElements 4 3 5125 1\nglBindVertexArray 0\n",
               later_frame);
    EXPECT_DOUBLE_EQ(found.right, 6.0 / 7);
    EXPECT_EQ(found.message, "2 draw calls, 1 is possible");
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->where, "draw calls: call 2 of your 4");
    EXPECT_EQ(found.first_difference->yours, "glDrawElements(GL_TRIANGLES, 3, GL_UNSIGNED_INT, 0)");
    EXPECT_EQ(found.first_difference->expected, "glDrawElements(GL_TRIANGLES, 6, GL_UNSIGNED_INT, 0)");
}

TEST(Traces, uploading_again_is_said_with_its_bytes)
{
    const Judgement found = judged(
        "glBindVertexArray 1\nglBufferData 34962 1536 1 35044 | 1536\nglDrawElements 4 6 5125 0\nglBindVertexArray 0\n",
        later_frame);
    EXPECT_EQ(found.message, "data is uploaded again: 1,536 bytes, 0 are needed");
    EXPECT_EQ(found.first_difference->yours, "glBufferData(GL_ARRAY_BUFFER, 1536, pointer, GL_STATIC_DRAW)");
    EXPECT_EQ(found.first_difference->expected, "nothing");
}

TEST(Traces, tables_that_stay_in_memory_are_missed)
{
    const std::string bare = "glDrawElements 4 6 5125 1\n";
    const Check check = check_with({"uploaded bytes"});
    EXPECT_EQ(judged(bare, first_frame, check).right, 0);
    EXPECT_EQ(judged(bare, first_frame, check).message, "0 bytes are uploaded, of the 1,560 that are needed");
    const auto uploading = [](int bytes) {
        return "glBufferData 34962 1 1 35044 | " + std::to_string(bytes) + "\nglDrawElements 4 6 5125 0\n";
    };
    EXPECT_EQ(judged(uploading(519), first_frame, check).right, 0);
    EXPECT_EQ(judged(uploading(520), first_frame, check).right, 1) << "smaller types";
    EXPECT_EQ(judged(uploading(1560), first_frame, check).right, 1);
    EXPECT_EQ(judged(uploading(1561), first_frame, check).right, 0);
    EXPECT_EQ(judged(later_frame, later_frame, check).right, 1) << "nothing is needed";
}

TEST(Traces, immediate_mode_is_deprecated_and_its_vertices_count)
{
    const std::string immediate = "glBegin 4\nglVertex3f 0 0 0\nglVertex3f 1 0 0\nglVertex3f 0 1 0\nglEnd\n";
    const Judgement found = judged(immediate, "glDrawArrays 4 0 3\n");
    EXPECT_EQ(found.metrics.at("vertices"), 3);
    EXPECT_EQ(found.metrics.at("draw_calls"), 1);
    EXPECT_EQ(found.metrics.at("deprecated_calls"), 5);
    EXPECT_EQ(
        found.message,
        "glBegin is deprecated: keep the vertices in a buffer, and draw them with glDrawArrays or glDrawElements");
    EXPECT_EQ(found.first_difference->yours, "glBegin(GL_TRIANGLES)");
}

// Of two deprecated calls the expected ones have one too: the other is told.
TEST(Traces, the_deprecated_call_that_is_too_many_is_told)
{
    const std::string expected = "glPushAttrib 1\nglDrawArrays 4 0 3\nglPopAttrib\n";
    const Judgement found = judged("glPushAttrib 1\nglDrawArrays 4 0 3\nglMatrixMode 5888\nglPopAttrib\n", expected);
    EXPECT_TRUE(found.message.starts_with("glMatrixMode is deprecated")) << found.message;
}

// Where immediate mode is what is asked for, nobody is told to do without; and the pair that has one vertex too many is
// the one to look at.
TEST(Traces, of_calls_that_are_asked_for_only_their_number_is_told)
{
    const std::string vertex = "glVertex2f 0 0\n";
    const std::string fill = "glBegin 6\n" + vertex + vertex + vertex + "glEnd\n";
    const std::string edges = "glBegin 2\n" + vertex + vertex + vertex;
    const Judgement found = judged("glBegin 9" + fill.substr(9) + edges + vertex + "glEnd\n", fill + edges + "glEnd\n");
    EXPECT_EQ(found.message.find("deprecated"), std::string::npos) << found.message;
    ASSERT_TRUE(found.first_difference);
    EXPECT_EQ(found.first_difference->yours, "glBegin(GL_LINE_LOOP): 4 vertices");
    EXPECT_EQ(found.first_difference->expected, "glBegin(GL_LINE_LOOP): 3 vertices");
}

TEST(Traces, drawing_nothing_earns_nothing)
{
    EXPECT_EQ(judged("glBindVertexArray 1\nglBindVertexArray 0\n", later_frame).right, 0);
    EXPECT_EQ(judged("glBindVertexArray 1\nglBindVertexArray 0\n", later_frame).message,
              "nothing is drawn; 0 vertices are drawn, expected 6");
    EXPECT_EQ(judged("", later_frame).right, 0);
    EXPECT_EQ(judge(all_rules(), Tensor{}, text(later_frame), nullptr).right, 0) << "no trace at all";
    // Selecting where to draw is no drawing.
    EXPECT_EQ(judged("glDrawBuffer 1029\nglDrawBuffers 1 1\n", later_frame).metrics.at("draw_calls"), 0);
}

TEST(Traces, objects_are_counted_by_the_number_given)
{
    const Check check = check_with({"objects created", "objects deleted"});
    const std::string both =
        "glGenBuffers 3 1\nglGenLists 2\nglCreateTextures 3553 4 1\nglCreateShader "
        "35633\nglCreateProgram\nglGenerateMipmap 3553\nglCreateVertexArrays 1 1\n"
        "glDeleteBuffers 3 1\nglDeleteLists 1 2\nglDeleteProgram 5\nglDeleteShader 0\n";
    const Judgement found = judged(both, both, check);
    EXPECT_EQ(found.metrics.at("objects_created"), 3 + 2 + 4 + 1 + 1 + 1);
    EXPECT_EQ(found.metrics.at("objects_deleted"), 3 + 2 + 1);
    const Judgement leak =
        judged("glDeleteVertexArrays 1 1\n", "glDeleteVertexArrays 1 1\nglDeleteBuffers 3 1\n", check);
    EXPECT_EQ(leak.right, 0.5);
    EXPECT_EQ(leak.message, "1 object is deleted, expected 4");
    EXPECT_EQ(leak.first_difference->where, "objects deleted: after your last such call");
    EXPECT_EQ(leak.first_difference->expected, "glDeleteBuffers(3, pointer)");
    EXPECT_EQ(judged("", "glDeleteVertexArrays 1 1\n", check).first_difference->where,
              "objects deleted: you make no such call");
}

TEST(Traces, fewer_calls_than_the_reference_are_fine)
{
    EXPECT_EQ(judged("glDrawElements 4 6 5125 0\n", later_frame).right, 1) << "state changes are an upper bound";
    EXPECT_EQ(judged("glDrawArraysInstanced 4 0 3 2\n", later_frame).right, 1) << "3 vertices twice are 6";
}

TEST(Traces, only_the_declared_rules_count)
{
    const std::string wasteful = "glBufferData 34962 10 1 35044 | 10\nglDrawElements 4 6 5125 0\n";
    EXPECT_EQ(judged(wasteful, later_frame, check_with({"draw calls", "vertices"})).right, 1);
    EXPECT_EQ(judged(wasteful, later_frame, check_with({"uploaded bytes"})).right, 0);
    EXPECT_THROW((void)judged(later_frame, later_frame, check_with({})), std::invalid_argument);
    EXPECT_THROW((void)judged(later_frame, later_frame, check_with({"colour"})), std::invalid_argument);
}

TEST(Traces, hostile_ones_are_damaged)
{
    for (const char* bad : {"glDrawArrays 4 0 x\n", "system(\"rm\")\n", "glDrawArrays  4\n", "gl\n", "\n\n",
                            "glDrawArrays 4 0 3 | -1\n", "glDrawArrays | \n", "glDrawArrays 4 0 3 | 1 2\n",
                            "...\nglDrawArrays 4 0 3\n", "glDrawArrays 0x4 0 3\n", "GLDrawArrays 4 0 3\n"})
        EXPECT_EQ(judged(bad, later_frame).message, "the recorded calls are damaged: the run was disturbed") << bad;
    EXPECT_EQ(judged(std::string(100, 'g'), later_frame).right, 0);
    std::string many = "glDrawArrays";
    for (int i = 0; i < 40; ++i) many += " 1";
    EXPECT_FALSE(parse_gl_trace(many));
    EXPECT_EQ(
        judged("glDrawElements 4 nan 5125 0\nglDrawElements 4 inf 5125 0\nglDrawElements 4 -9 5125 0\nglDrawElements\n",
               later_frame)
                .right < 1,
        true);
    for (const auto& [name, value] :
         judged("glDrawElements 4 inf 5125 0\nglDrawArraysInstanced 4 0 1e308 1e308\nglGenBuffers inf 1\n", later_frame)
             .metrics)
        EXPECT_TRUE(std::isfinite(value)) << name;
    std::string flood;
    for (int i = 0; i < 20'000'000; ++i) flood += "ga\n";
    EXPECT_FALSE(parse_gl_trace(flood));
    std::string long_one;
    for (int i = 0; i < 70'000; ++i) long_one += "glEnd\n";
    EXPECT_FALSE(parse_gl_trace(long_one)) << "more calls than a trace holds";
    EXPECT_THROW((void)judged(later_frame, "nonsense"), std::invalid_argument);
}

TEST(Traces, counts_are_of_what_is_there)
{
    EXPECT_EQ(judged("glDrawElements 4 -9 5125 0\nglDrawElements 4 6 5125 0\n", later_frame).metrics.at("vertices"), 6);
    EXPECT_EQ(judged("glBindAttribLocation 1 0\nglBindFragDataLocation 1 0\nglBindBuffer 34962 1\n", later_frame)
                  .metrics.at("state_changes"),
              1);
}

TEST(Traces, of_several_broken_rules_the_first_is_shown)
{
    const Judgement found = judged("glBufferData 34962 8 1 35044 | 8\n" + later_frame + later_frame, later_frame,
                                   check_with({"draw calls", "uploaded bytes"}));
    EXPECT_EQ(found.right, 0);
    EXPECT_EQ(found.first_difference->where, "draw calls: call 6 of your 7");
}

TEST(Traces, a_truncated_one_earns_nothing)
{
    const Judgement found = judged(later_frame + "...\n", later_frame);
    EXPECT_EQ(found.right, 0);
    EXPECT_EQ(found.message, "more than 3 calls, 3 are enough");
    EXPECT_THROW((void)judged(later_frame, later_frame + "...\n"), std::invalid_argument);
}

TEST(Traces, controls_and_mistakes)
{
    const Check check = all_rules();
    EXPECT_EQ(best_control(check, text(later_frame), nullptr, 1).right, 0);
    // Where nothing is drawn, doing nothing keeps every rule but one: rescaling takes that away.
    const std::string cleanup = "glDeleteBuffers 3 1\n";
    const BestControl best = best_control(check, text(cleanup), nullptr, 1);
    EXPECT_DOUBLE_EQ(best.right, 6.0 / 7);
    EXPECT_EQ(points_for(check, judged("", cleanup).right, best.right), 0);

    const auto same = [&](const std::string& yours, const std::string& mistake) {
        const Tensor a = text(yours);
        const Tensor b = text(later_frame);
        return resemblance(FailingCheck{&check, &a, &b, nullptr}, text(mistake)).says == Says::for_it;
    };
    const std::string twice = later_frame + later_frame;
    const std::string uploads = "glBufferData 34962 8 1 35044 | 8\n" + later_frame;
    EXPECT_TRUE(same(twice, twice));
    EXPECT_TRUE(same(
        uploads,
        "glBindVertexArray 3\nglBufferData 34962 8 1 35044 | 8\nglDrawElements 4 6 5125 0\nglBindVertexArray 0\n"));
    EXPECT_FALSE(same(twice, uploads));
    EXPECT_FALSE(same(later_frame, uploads));
    EXPECT_FALSE(same("nonsense", uploads));
}

TEST(GlCalls, are_written_as_in_cpp)
{
    const auto written = [](const std::string& line) { return in_cpp(parse_gl_trace(line)->calls.front()); };
    EXPECT_EQ(written("glDrawArrays 4 0 3\n"), "glDrawArrays(GL_TRIANGLES, 0, 3)");
    EXPECT_EQ(written("glDrawArrays 99 0 3\n"), "glDrawArrays(99, 0, 3)");
    EXPECT_EQ(written("glVertexAttribPointer 1 3 5126 0 24 1\n"),
              "glVertexAttribPointer(1, 3, GL_FLOAT, GL_FALSE, 24, pointer)");
    EXPECT_EQ(written("glBufferData 34962 5126 0 35044\n"), "glBufferData(GL_ARRAY_BUFFER, 5126, 0, GL_STATIC_DRAW)")
        << "a size is no enumerant";
    EXPECT_EQ(written("glClearColor 0.25 0 0 1\n"), "glClearColor(0.25, 0, 0, 1)");
    EXPECT_EQ(written("glEnd\n"), "glEnd()");
    EXPECT_EQ(written("glNobodyKnows 34962 nan\n"), "glNobodyKnows(34962, nan)");
}

/// Functions that a header of OpenGL declares, of its core versions only.
std::set<std::string> declared(const std::string& header)
{
    std::ifstream file("/usr/include/GL/" + header);
    std::set<std::string> names;
    bool counts = true;
    const std::regex section(R"(#ifndef (GL_[A-Z]\w+))");
    const std::regex function(R"(APIENTRY (gl[A-Z]\w+))");
    std::smatch found;
    for (std::string line; std::getline(file, line);) {
        if (std::regex_search(line, found, section))
            counts = header == "gl.h" || found[1].str().starts_with("GL_VERSION_");
        if (counts && std::regex_search(line, found, function)) names.insert(found[1]);
    }
    return names;
}

TEST(GlCalls, deprecated_is_what_the_core_header_lacks)
{
    std::set<std::string> all = declared("gl.h");
    all.merge(declared("glext.h"));
    const std::set<std::string> core = declared("glcorearb.h");
    if (core.empty()) GTEST_SKIP() << "there is no glcorearb.h here";
    ASSERT_GT(all.size(), 1000U);
    std::size_t removed = 0;
    for (const std::string& name : all) {
        if (name.ends_with("ARB") || name.ends_with("ATI") || name.ends_with("OES")) continue;
        EXPECT_EQ(instead_of_deprecated(name) != nullptr, !core.contains(name)) << name;
        removed += core.contains(name) ? 0 : 1;
    }
    EXPECT_GT(removed, 400U);
}

}
}

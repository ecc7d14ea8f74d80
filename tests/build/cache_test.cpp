#include <gtest/gtest.h>

#include <fstream>
#include <thread>

#include "build/build_cache.hpp"
#include "support/workbench.hpp"

namespace umbral::grader::test {
namespace {

namespace fs = std::filesystem;

class Cache : public testing::Test {
protected:
    Workbench bench;
    std::string text = sphere_with("", "");

    [[nodiscard]] Built built() const { return bench.build_sphere(text); }
    [[nodiscard]] std::size_t entries() const
    {
        std::size_t count = 0;
        for (const auto& entry : fs::recursive_directory_iterator(bench.tools().cache))
            count += entry.path().filename() == "result.json" ? 1 : 0;
        return count;
    }
    [[nodiscard]] Toolchain without_time() const
    {
        Toolchain tools = bench.tools();
        tools.budget = std::make_shared<UnitBudget>(std::make_shared<TimeBudget>(0, 0));
        return tools;
    }
    [[nodiscard]] bool runs(const Built& result) const
    {
        Spawner spawner(bench.spawner());
        return spawner.run(bench.sphere_run(result.library)).verdict == Verdict::ok;
    }
};

TEST_F(Cache, the_second_build_is_the_first)
{
    const Built first = built();
    ASSERT_EQ(to_string(first.verdict), "ok") << first.message;
    const auto when = fs::last_write_time(first.library);
    // Without time to compile only a kept result can come.
    const Built second = build(without_time(), bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}});
    EXPECT_EQ(second.library, first.library);
    EXPECT_EQ(fs::last_write_time(second.library), when);
    EXPECT_EQ(entries(), 1U);
    for (const auto& entry : fs::directory_iterator(bench.tools().cache))
        EXPECT_EQ(entry.path().filename(), "builds") << "left behind: " << entry.path();
}

// What an older assembler or inspector let through, or refused, says nothing of what this one does.
TEST_F(Cache, what_other_programs_made_is_not_taken)
{
    ASSERT_EQ(to_string(built().verdict), "ok");
    Toolchain tools = bench.tools();
    tools.programs = "/nowhere";
    EXPECT_THROW((void)build(tools, bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}}), std::runtime_error);
}

TEST_F(Cache, errors_are_kept_as_well)
{
    text = "nonsense\n";
    const Built first = built();
    const Built second = build(without_time(), bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}});
    EXPECT_EQ(to_string(second.verdict), "compile_error");
    EXPECT_EQ(second.message, first.message);
}

// A machine on which nothing at all compiles in time is in trouble, and no student is.
TEST_F(Cache, a_busy_machine_is_our_fault_and_is_not_kept)
{
    Toolchain tools = bench.tools();
    tools.compile_seconds = 0.005;
    EXPECT_THROW((void)build(tools, bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}}), std::runtime_error);
    EXPECT_EQ(entries(), 0U);
    EXPECT_EQ(to_string(built().verdict), "ok");
}

/// A compiler that does what `script` says, with the real one as $REAL.
class BrokenCompiler : public Cache {
protected:
    [[nodiscard]] Toolchain tools_with(const std::string& script) const
    {
        Toolchain tools = bench.tools();
        const fs::path program =
            bench.write("compiler/c++", "#!/bin/sh\nREAL=" + tools.compiler + "\n" + script + "\n");
        fs::permissions(program, fs::perms::owner_all);
        tools.compiler = program.string();
        return tools;
    }
};

// Each of these was a compile error once, and stayed one when the trouble was over.
TEST_F(BrokenCompiler, is_nobodys_compile_error_and_heals)
{
    const Exercise exercise = bench.exercise("raytracing/sphere");
    const std::string question = "case \"$*\" in -print*) exec $REAL \"$@\";; esac; ";
    for (const char* trouble :
         {"echo 'sphere.cpp:1:1: fatal error: error writing to /tmp/x.s: No space left on device'; exit 1",
          "echo 'c++: fatal error: cannot execute cc1plus: vfork: Resource temporarily unavailable'; exit 1",
          "echo 'c++: fatal error: Killed signal terminated program cc1plus'; exit 1", "kill -9 $$", "exit 1",
          "echo 'sphere.cpp:1:1: fatal error: umbral_student.hpp: Too many open files'; exit 1"}) {
        const Toolchain tools = tools_with(question + trouble);
        EXPECT_THROW((void)build(tools, exercise, {{"sphere.cpp", text}}), std::runtime_error) << trouble;
        EXPECT_EQ(entries(), 0U) << trouble;
    }
    EXPECT_EQ(to_string(built().verdict), "ok");
}

// A text with line feeds can hold lines that begin as those of the compiler's own.
TEST_F(Cache, what_the_files_make_the_compiler_say_is_no_trouble_of_the_machine)
{
    for (const char* const words :
         {"cc1plus: fatal error: error writing to /tmp/x.s: No space left on device", "  what():  Too many open files",
          "g++: fatal error: cannot execute cc1plus: vfork: Resource temporarily unavailable"}) {
        const std::string failing = text + "static_assert(sizeof(int) == 5, \"no\\n" + words + "\");\n";
        const Built refused = build(bench.tools(), bench.exercise("raytracing/sphere"), {{"sphere.cpp", failing}});
        EXPECT_EQ(to_string(refused.verdict), "compile_error") << words;
    }
}

TEST_F(Cache, endless_templates_are_stopped_by_processor_time)
{
    Toolchain tools = bench.tools();
    tools.compile_seconds = 1;
    const std::string endless =
        "template <int D, int I> struct B : B<D - 1, 2 * I>, B<D - 1, 2 * I + 1> {};\n"
        "template <int I> struct B<0, I> {};\nB<24, 0> all;\n";
    const Built stopped = build(tools, bench.exercise("raytracing/sphere"), {{"sphere.cpp", text + endless}});
    EXPECT_EQ(to_string(stopped.verdict), "compile_error");
    EXPECT_NE(stopped.message.find("was stopped after 1 s"), std::string::npos) << stopped.message;
    EXPECT_EQ(entries(), 0U);
}

TEST_F(Cache, another_text_flag_or_name_is_another_build)
{
    const Built first = built();
    const Exercise exercise = bench.exercise("raytracing/sphere");
    EXPECT_NE(build(bench.tools(), exercise, {{"sphere.cpp", text + "\n"}}).library, first.library);
    EXPECT_NE(build(bench.tools(), exercise, {{"sphere.cpp", text}, {"empty.hpp", ""}}).library, first.library);
    Exercise stricter = exercise;
    stricter.forbid = {"glm::cross"};
    EXPECT_NE(build(bench.tools(), stricter, {{"sphere.cpp", text}}).library, first.library);
}

TEST_F(Cache, the_same_files_at_the_same_time)
{
    std::vector<Built> results(4);
    std::vector<std::jthread> threads;
    for (Built& result : results) threads.emplace_back([&] { result = built(); });
    threads.clear();
    for (const Built& result : results) {
        EXPECT_EQ(to_string(result.verdict), "ok") << result.message;
        EXPECT_EQ(result.library, results.front().library);
    }
    EXPECT_EQ(entries(), 1U);
    EXPECT_TRUE(runs(results.front()));
}

TEST_F(Cache, damage_is_repaired)
{
    const Built first = built();
    ASSERT_EQ(to_string(first.verdict), "ok") << first.message;
    const fs::path folder = first.library.parent_path();
    const std::vector<std::function<void()>> damages = {
        [&] { fs::resize_file(folder / "result.json", 5); },
        [&] { fs::resize_file(folder / "result.json", 0); },
        [&] { fs::remove(folder / "result.json"); },
        [&] { fs::remove(folder / "student.so"); },
        [&] { fs::resize_file(folder / "student.so", 100); },
        [&] { std::ofstream(folder / "result.json") << R"({"verdict": "splendid", "message": ""})"; },
        [&] { std::ofstream(folder / "result.json") << R"({"verdict": 7})"; },
        [&] { std::ofstream(folder / "result.json") << "[]"; },
    };
    for (std::size_t i = 0; i < damages.size(); ++i) {
        damages[i]();
        const Built again = built();
        EXPECT_EQ(to_string(again.verdict), "ok") << "damage " << i << ": " << again.message;
        EXPECT_EQ(again.library, first.library);
        EXPECT_TRUE(runs(again)) << "damage " << i;
    }
    for (const auto& entry : fs::directory_iterator(bench.tools().cache))
        EXPECT_EQ(entry.path().filename(), "builds") << "left behind: " << entry.path();
}

// Nothing is run that was not looked through for assembler: not even if only the look fails, and compiling works.
TEST_F(BrokenCompiler, that_only_fails_to_preprocess_lets_nothing_through)
{
    const Toolchain tools = tools_with("case \" $* \" in *\" -E \"*) exit 1;; esac; exec $REAL \"$@\"");
    EXPECT_THROW((void)build(tools, bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}}), std::runtime_error);
    EXPECT_EQ(entries(), 0U);
}

TEST_F(Cache, drops_what_was_not_used_for_longest)
{
    const auto hours_ago = [](int hours) { return fs::file_time_type::clock::now() - std::chrono::hours(hours); };
    const auto entry = [&](const std::string& name, int hours) {
        const fs::path file = bench.write("small/builds/aa/" + name + "/student.so", std::string(1000, 'x'));
        fs::last_write_time(file.parent_path(), hours_ago(hours));
        return file;
    };
    const fs::path cache = bench.folder() / "small";
    const std::vector<fs::path> files{entry("a", 50), entry("b", 3), entry("c", 20), entry("d", 0), entry("e", 0)};
    const auto left = [&] {
        std::string names;
        for (const fs::path& file : files)
            if (fs::exists(file)) names += file.parent_path().filename().string();
        return names;
    };
    prune_builds(cache, 5000);
    EXPECT_EQ(left(), "abcde");
    mark_used(files[0].parent_path());
    prune_builds(cache, 4999);
    EXPECT_EQ(left(), "ade") << "until four fifths are left";
    prune_builds(cache, 1);
    EXPECT_EQ(left(), "ade") << "what was used within the hour stays";
}

TEST_F(Cache, a_link_in_its_place_is_not_followed)
{
    const fs::path elsewhere = bench.write("elsewhere/aa/key/precious.txt", "x");
    fs::last_write_time(elsewhere.parent_path(), fs::file_time_type::clock::now() - std::chrono::hours(50));
    fs::create_directory(bench.folder() / "small");
    fs::create_directory_symlink(bench.folder() / "elsewhere", bench.folder() / "small" / "builds");
    prune_builds(bench.folder() / "small", 0);
    EXPECT_TRUE(fs::exists(elsewhere));
}

TEST_F(Cache, old_scratch_goes_and_new_stays)
{
    const fs::path cache = bench.folder() / "small";
    const fs::path old = bench.write("small/work-AbCdEf/x.cpp", "x").parent_path();
    const fs::path fresh = bench.write("small/work-AbCdEg/x.cpp", "x").parent_path();
    const fs::path other = bench.write("small/work-of-mine/x.cpp", "x").parent_path();
    for (const fs::path& folder : {old, other})
        fs::last_write_time(folder, fs::file_time_type::clock::now() - std::chrono::hours(25));
    prune_builds(cache, 1 << 20);
    EXPECT_FALSE(fs::exists(old));
    EXPECT_TRUE(fs::exists(fresh));
    EXPECT_TRUE(fs::exists(other));
}

// What cannot be compiled because of us is nobody's compile error.
TEST_F(Cache, a_compiler_that_is_not_there_is_our_fault)
{
    Toolchain tools = bench.tools();
    tools.compiler = "/usr/bin/no-such-compiler";
    EXPECT_THROW((void)build(tools, bench.exercise("raytracing/sphere"), {{"sphere.cpp", text}}), std::runtime_error);
}

}
}

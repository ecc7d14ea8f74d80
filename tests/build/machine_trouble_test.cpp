#include "build/machine_trouble.hpp"

#include <gtest/gtest.h>

#include "build/compiler_text.hpp"

namespace umbral::grader::test {
namespace {

// On a busy machine the clock counts less than the limit by which a process was stopped.
TEST(ProcessorTime, that_ran_out_is_told_by_the_compiler_itself)
{
    const std::string words = "CPU time limit exceeded signal terminated program cc1plus\nPlease submit a report.\n";
    EXPECT_TRUE(tells_of_processor_time("g++: fatal error: " + words, "g++"));
    EXPECT_TRUE(tells_of_processor_time("warning\nc++: internal compiler error: " + words, "c++"));
    EXPECT_FALSE(tells_of_processor_time("g++: fatal error: " + words, "c++")) << "not that compiler";
    EXPECT_FALSE(tells_of_processor_time("sphere.cpp:1:2: error: #error g++: fatal error: " + words, "g++"));
    EXPECT_FALSE(tells_of_processor_time("g++: fatal error: Killed signal terminated program cc1plus\n", "g++"));
}

TEST(MachineTrouble, what_a_tool_says_of_itself_is_believed)
{
    for (const char* const output :
         {"terminate called after throwing an instance of 'std::runtime_error'\n"
          "  what():  pthread_create has failed: Resource temporarily unavailable\n"
          "collect2: fatal error: ld terminated with signal 6 [Aborted]\ncompilation terminated.\n",
          "g++: fatal error: cannot execute '/usr/lib/gcc/cc1plus': vfork: Resource temporarily unavailable\n",
          "mold: fatal: cannot write to an output file: Input/output error",
          "/tmp/ccbNoDhr.s: Fatal error: can't write 41 bytes to section: 'No space left on device'\n",
          "ccbNoDhr.s: Fatal error: can't write 41 bytes to section: 'No space left on device'\n"}) {
        EXPECT_TRUE(tools_are_in_trouble(output)) << output;
        EXPECT_TRUE(mentions_machine_trouble(output)) << output;
    }
}

TEST(MachineTrouble, what_a_student_can_write_is_no_proof)
{
    for (const char* const output :
         {"sphere.cpp:1:2: error: #error Resource temporarily unavailable\n",
          "sphere.cpp:1:2: error: expected ';'\n    1 | collect2: Resource temporarily unavailable\n",
          "sphere.cpp:3:1: fatal error: cannot open x.h: Too many open files\n"}) {
        EXPECT_FALSE(tools_are_in_trouble(output)) << output;
        EXPECT_TRUE(mentions_machine_trouble(output)) << output;
    }
    // Names, which the linker prints as they are, or as C++ writes them.
    for (const char* const output :
         {"mold: error: duplicate symbol: a.o: b.o: Cannot fork<int>(int)\n",
          "mold: error: duplicate symbol: a.o: b.o: x: No space left on device\n",
          "mold: error: undefined symbol: x\nmold: fatal: No space left on device\n",
          "mold: warning: symbol type mismatch: typeinfo for int No space left on device\n>>> defined in a.o as X\n",
          "collect2: error: Cannot fork<No space left on device>(int)\n",
          "as: cannot write: No space left on device\nccbNoDhr.s: Assembler messages:\nccbNoDhr.s:9: Error: .err\n",
          "/tmp/ccbNoDhr.s:12: Error: changed attributes of a: Fatal error: No space left on device\n"})
        EXPECT_FALSE(tools_are_in_trouble(output)) << output;
    EXPECT_TRUE(
        outgrew_the_file_limit("collect2: fatal error: ld terminated with signal 25 [File size limit exceeded]\n"));
    EXPECT_FALSE(
        outgrew_the_file_limit("sphere.cpp:1:2: error: collect2: fatal error: ld terminated with signal 25\n"));
    EXPECT_TRUE(linker_refuses_files("sphere.cpp:1:2: warning: …\nmold: error: undefined symbol: x\n"));
    EXPECT_FALSE(linker_refuses_files("sphere.cpp:1:2: error: mold: error: undefined symbol: x\n"));
    // Templates that take all the memory end the compiler, too.
    EXPECT_FALSE(tools_are_in_trouble("g++: fatal error: Killed signal terminated program cc1plus\n"));
    EXPECT_TRUE(mentions_machine_trouble("g++: fatal error: Killed signal terminated program cc1plus\n"));
    EXPECT_FALSE(mentions_machine_trouble("sphere.cpp:1:2: error: expected ';'\n"));
    EXPECT_FALSE(tools_are_in_trouble(""));
}

}
}

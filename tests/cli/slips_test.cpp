#include <gtest/gtest.h>
#include <sys/stat.h>

#include <filesystem>
#include <set>

#include "program.hpp"
#include "support/temporary_folder.hpp"

// What people mistype, with the real program: they are told what to do, and it is never a fault of Umbral's own.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

const std::string source = UMBRAL_SOURCE;

/// Runs a command line in `folder`.
Printed in(const TemporaryFolder& folder, const std::string& arguments)
{
    return umbral(arguments, "cd '" + folder.path().string() + "' &&");
}

/// A class of one, with an empty file of one unit: quickly graded.
void write_class(const TemporaryFolder& folder) { folder.write("class/ana/raytracing/sphere/sphere.cpp", ""); }

Printed grade(const TemporaryFolder& folder, const std::string& arguments)
{
    return in(folder, "grade class --unit sphere --out out --jobs 1 " + arguments);
}

mode_t mode_of(const fs::path& file)
{
    struct stat status {};
    EXPECT_EQ(stat(file.c_str(), &status), 0) << file;
    return status.st_mode & 0777U;
}

TEST(Secret, a_bare_new_name_is_made_for_its_owner_and_announced)
{
    const TemporaryFolder folder;
    write_class(folder);
    const Printed first = grade(folder, "--secret-file secret");
    EXPECT_EQ(first.status, 0) << first.text;
    EXPECT_NE(first.text.find("made a new secret for the hidden cases: " + (folder / "secret").string()),
              std::string::npos)
        << first.text;
    EXPECT_EQ(mode_of(folder / "secret"), 0600U);
    const std::string secret = read(folder / "secret");
    EXPECT_EQ(secret.size(), 64U);
    const Printed second = grade(folder, "--secret-file secret");
    EXPECT_EQ(second.text.find("made a new secret"), std::string::npos) << second.text;
    EXPECT_EQ(read(folder / "secret"), secret);
    for (const auto& entry : fs::directory_iterator(folder.path()))
        EXPECT_FALSE(entry.path().filename().string().starts_with("secret.")) << "a draft stays";
}

TEST(Secret, a_mistyped_folder_is_not_made)
{
    const TemporaryFolder folder;
    write_class(folder);
    fs::create_directories(folder / "mine");
    const Printed printed = grade(folder, "--secret-file mine/kyes/umbral/secret");
    EXPECT_EQ(printed.status, 2) << printed.text;
    EXPECT_NE(printed.text.find("there is only " + (folder / "mine").string() + "."), std::string::npos)
        << printed.text;
    EXPECT_TRUE(fs::is_empty(folder / "mine"));
}

TEST(Secret, one_that_others_can_read_is_warned_of)
{
    const TemporaryFolder folder;
    write_class(folder);
    folder.write("secret", "sixteen characters or more");
    fs::permissions(folder / "secret", fs::perms(0644));
    EXPECT_NE(grade(folder, "--secret-file secret").text.find("chmod 600 " + (folder / "secret").string()),
              std::string::npos);
    fs::permissions(folder / "secret", fs::perms(0600));
    EXPECT_EQ(grade(folder, "--secret-file secret").text.find("warning"), std::string::npos);
}

TEST(Secret, what_is_no_secret_is_refused)
{
    const TemporaryFolder folder;
    write_class(folder);
    folder.write("short", "fifteen charact");
    folder.write("long", std::string(4097, 'x'));
    for (const char* file : {"short", "long", "class", "/dev/zero", "/dev/full/secret"}) {
        const Printed printed = grade(folder, std::string("--secret-file ") + file);
        EXPECT_EQ(printed.status, 2) << file << "\n" << printed.text;
        EXPECT_FALSE(fs::exists(folder / "out/class.json")) << file;
    }
}

TEST(Secret, a_full_disk_leaves_no_half_one)
{
    const TemporaryFolder folder;
    write_class(folder);
    // No file may grow beyond nothing: what a full disk does, without filling one.
    const Printed printed = umbral("grade class --unit sphere --out out --secret-file secret",
                                   "cd '" + folder.path().string() + "' && trap '' XFSZ; ulimit -f 0;");
    EXPECT_NE(printed.status, 0) << printed.text;
    EXPECT_FALSE(fs::exists(folder / "secret"));
}

struct NearMiss {
    const char* arguments;
    const char* advice;
};

TEST(NearMisses, are_told_the_nearest_name)
{
    for (const NearMiss& one :
         {NearMiss{"validate spher", "did you mean `sphere`?"}, NearMiss{"hint sphree", "did you mean `sphere`?"},
          NearMiss{"validate raytracing/spere", "did you mean `raytracing/sphere`?"},
          NearMiss{"validate raytracng", "did you mean `raytracing`?"},
          NearMiss{"validate raytracing", "is a topic, not a unit; its units: raytracing/"},
          NearMiss{"validate raytracng/sphere", "`raytracing/sphere`"}, NearMiss{"hint matrix", "`normal-matrix`"},
          NearMiss{"hint sphere --seed 2", "hint has no option '--seed'; `umbral hint --help`"},
          NearMiss{"check --dri w", "did you mean `--dir`?"}, NearMiss{"chekc", "did you mean `check`?"},
          NearMiss{"gradee", "did you mean `grade`?"}}) {
        const Printed printed = umbral(one.arguments);
        EXPECT_EQ(printed.status, 2) << one.arguments;
        EXPECT_NE(printed.text.find(one.advice), std::string::npos) << one.arguments << "\n" << printed.text;
        EXPECT_LT(printed.text.size(), 400U) << printed.text;
    }
    EXPECT_EQ(umbral("validate zzzzzzzz").text.find("did you mean"), std::string::npos);
}

/// Command lines that cannot be carried out, whoever calls them, root included. `$F` is a file, `$D` a folder, `$W` a
/// workspace.
const char* const impossible[] = {
    "list --language fr",
    "list --language",
    "list --html $D",
    "list --html $D/no/page.html",
    "list --html /dev/null",
    "list --html $F/page.html",
    "list extra",
    "new",
    "new $F",
    "new $F/below",
    "new /proc/no",
    "new $D/new zzz",
    "new ''",
    "new $L/x sphere",  //
    "check sphere --dir $L/x",
    "debug sphere --dir $L/x",
    "grade $L/x",
    "grade $C --out $L/x",
    "check --dir $F",
    "check --dir $D/no",
    "check --dir $D",
    "check --dir ''",
    "check --dir=",
    "check --dir $L",
    "check zzz --dir $W",
    "check '' --dir $W",
    "check --attempt -1 --dir $W",
    "check --attempt x --dir $W",
    "check --attempt 99999999999 --dir $W",
    "check --attempt 1.5 --dir $W",
    "check --html $D --dir $W",
    "check --html /dev/null --dir $W",
    "check --html $F/page.html --dir $W",
    "check --html $D/no/page.html --dir $W",
    "hint",
    "hint zzz",
    "hint sphere 0",
    "hint sphere 99",
    "hint sphere -1",
    "hint sphere x",
    "hint sphere --language fr",  //
    "reset",
    "reset zzz",
    "reset sphere --dir $D/no",
    "reset sphere --dir $F",
    "reset sphere --dir ''",  //
    "ask",
    "debug",
    "debug zzz",
    "debug sphere zzz --dir $W",
    "debug sphere --dir $D",
    "debug sphere --dir $D/no",
    "debug sphere --dir $F",
    "compare",
    "compare $P",
    "compare $P $D",
    "compare $P $F",
    "compare $D/no.png $P",
    "compare $P $P --html $D",
    "compare $P $P --html $D/no/page.html",
    "compare $P $P --html /dev/null",
    "compare '' $P",  //
    "grade",
    "grade $D/no --out $D/out",
    "grade $F --out $D/out",
    "grade $C",
    "grade $C --out ''",
    "grade $C --out $F",
    "grade $C --out $F/out",
    "grade $C --out $D/out --jobs -1",
    "grade $C --out $D/out --jobs x",
    "grade $C --out $D/out --jobs 100000",
    "grade $C --out $D/out --attempt -1",
    "grade $C --out $D/out --unit zzz",
    "grade $C --out $D/out --unit ''",
    "grade $C --out /proc/no",
    "grade '' --out $D/out",
    "grade $C --out $D/out --secret-file ''",
    "grade $C --out $D/out --roster $D/no",
    "grade $C --out $D/out --roster $F",
    "grade $C --out $D/out --roster $D",
    "grade $C --out $D/out --only zzz",
    "grade $C --out $C",
    "grade $C --out $C/out",  //
    "demo --out $F",
    "demo --out ''",
    "demo --out /proc/no",
    "demo extra",  //
    "validate zzz",
    "validate sphere --seeds 0",
    "validate sphere --seeds -1",
    "validate sphere --seeds x",
    "validate sphere --seeds 4000000000",
    "validate sphere --jobs 0",
    "validate sphere --jobs 100000",
    "validate sphere --table $D",
    "validate sphere --table $F/page.md",
    "validate ''",  //
    "bench zzz",
    "bench explanations zzz",
    "bench explanations --seeds 0",
    "bench explanations sphere --json $D",
    "bench explanations --jobs -1",
    "bench judge zzz --no-scenes",
    "bench judge --scenes $D/no",
    "bench judge --markdown $D",
    "bench judge --json $F/page",
    "bench judge --seeds x",
    "bench judges --seeds x",
    "bench outcomes --quick",
    "doctor extra",
    "doctor --json=x",
    "--zzz",
    "''",
    "zzz",
};

TEST(BadArguments, are_usage_errors_of_every_command)
{
    const TemporaryFolder folder;
    folder.write("file", "text");
    folder.write("workspace/raytracing/sphere/sphere.cpp", "");
    folder.write("class/ana/raytracing/sphere/sphere.cpp", "");
    fs::create_directories(folder / "folder");
    fs::create_symlink("loop", folder / "loop");
    fs::copy_file(source + "/docs/pictures/units-raytracing.png", folder / "picture.png");
    const std::string here = folder.path().string();
    const std::string variables = "F=" + here + "/file D=" + here + "/folder W=" + here + "/workspace C=" + here +
                                  "/class L=" + here + "/loop P=" + here + "/picture.png; cd " + here + " &&";
    std::set<std::string> commands;
    for (const std::string arguments : impossible) {
        const Printed printed = umbral(arguments, variables);
        EXPECT_EQ(printed.status, 2) << "umbral " << arguments << "\n" << printed.text;
        EXPECT_EQ(printed.text.find("a fault of Umbral's own"), std::string::npos) << "umbral " << arguments << "\n"
                                                                                   << printed.text;
        EXPECT_FALSE(printed.text.empty()) << arguments;
        commands.insert(arguments.substr(0, arguments.find(' ')));
    }
    for (const char* command : {"list", "new", "check", "hint", "reset", "ask", "debug", "compare", "grade", "demo",
                                "validate", "bench", "doctor"})
        EXPECT_TRUE(commands.contains(command)) << "the table has no line of " << command;
    EXPECT_TRUE(fs::is_character_file("/dev/null"));
}

TEST(Terminal, names_of_folders_cannot_command_it)
{
    const TemporaryFolder folder;
    const std::string hostile = "bell\a \x1b]0;owned\x1b\\ \x1b[2J";
    fs::create_directories(folder / hostile);
    write_class(folder);
    fs::create_directory_symlink(folder / "class/ana", folder / "class" / hostile);
    for (const std::string& arguments :
         {"new '" + hostile + "' sphere", "reset sphere --dir '" + hostile + "'",
          "check sphere --dir '" + hostile + "'", "check --dir '" + hostile + "/no'", "check '" + hostile + "'",
          "hint '" + hostile + "'", "'" + hostile + "'",
          "check --dir '" + hostile + "' --html '" + hostile + "/page.html'",
          "list --html '" + hostile + "/no/page.html'", "list '" + hostile + "'", "compare '" + hostile + "' x",
          "debug sphere '" + hostile + "' --dir '" + hostile + "'",
          "grade class --unit sphere --out '" + hostile + "' --secret-file '" + hostile + "/secret'"}) {
        const Printed printed = in(folder, arguments);
        EXPECT_EQ(printed.text.find_first_of("\x1b\a"), std::string::npos) << arguments << "\n" << printed.text;
        EXPECT_FALSE(printed.text.empty()) << arguments;
    }
}

}
}

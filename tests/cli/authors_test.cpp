#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>

#include "cli/authors/commands.hpp"
#include "program.hpp"
#include "support/temporary_folder.hpp"

// Commands of authors are in a program of their own, and nobody need know: they are called, and complain, as all
// others.
namespace umbral::test {
namespace {

namespace fs = std::filesystem;

/// A folder with the program in a checkout or an installation of its own, where umbral-authors was never built.
class Elsewhere {
public:
    enum class Kind { checkout, installation };

    explicit Elsewhere(Kind kind)
    {
        const fs::path program = UMBRAL_PROGRAM;
        fs::create_directories(folder_ / "lib/umbral/bin");
        fs::copy_file(program, folder_ / "lib/umbral/bin/umbral");
        fs::create_directory_symlink(program.parent_path().parent_path() / "lib", folder_ / "lib/umbral/lib");
        fs::create_directories(folder_ / "share/umbral/exercises");
        if (kind == Kind::checkout) folder_.write("lib/umbral/checkout.txt", UMBRAL_SOURCE "\n");
        // What is built repeats its words, and ends with a status that no command has.
        folder_.write("path/cmake",
                      "#!/bin/sh\n[ \"$1 $3 $4\" = '--build --target umbral-authors' ] || exit 1\n"
                      "printf '#!/bin/sh\\necho \"got: $*\"\\nexit 7\\n' >\"$2/bin/umbral-authors\"\n"
                      "chmod +x \"$2/bin/umbral-authors\"\n");
        fs::permissions(folder_ / "path/cmake", fs::perms::owner_all);
    }

    [[nodiscard]] Printed umbral(const std::string& arguments) const
    {
        return run("PATH='" + (folder_ / "path").string() + "':\"$PATH\" UMBRAL_CACHE='" +
                   (folder_ / "cache").string() + "' exec '" + (folder_ / "lib/umbral/bin/umbral").string() + "' " +
                   arguments);
    }

private:
    TemporaryFolder folder_;
};

TEST(AuthorsCommands, are_all_there_and_listed_once)
{
    for (const grader::ListedCommand& one : grader::all_commands) {
        const bool handed_over = one.add == nullptr;
        const bool taken = std::ranges::find(grader::authors_commands, std::string_view(one.name),
                                             &grader::ListedCommand::name) != grader::authors_commands.end();
        // Of doctor each program has a part.
        EXPECT_TRUE(handed_over == taken || one.name == std::string_view("doctor")) << one.name;
    }
}

TEST(AuthorsCommands, are_in_the_help_in_their_order)
{
    const std::string help = umbral("--help").text;
    std::size_t at = help.find("Subcommands:");
    ASSERT_NE(at, std::string::npos) << help;
    for (const grader::ListedCommand& one : grader::all_commands) {
        at = help.find("\n  " + std::string(one.name) + " ", at);
        ASSERT_NE(at, std::string::npos) << one.name << " is missing, or stands before another:\n" << help;
        const std::string line = help.substr(at + 1, help.find('\n', at + 1) - at - 1);
        EXPECT_TRUE(line.ends_with(std::string(" ") + one.summary)) << line;
    }
}

TEST(AuthorsCommands, have_their_help_under_the_name_of_umbral)
{
    for (const char* const call : {"validate --help", "--help validate", "validate -h"}) {
        const Printed printed = umbral(call);
        EXPECT_EQ(printed.status, 0) << call << printed.text;
        EXPECT_NE(printed.text.find("umbral validate [OPTIONS]"), std::string::npos) << call << printed.text;
        EXPECT_NE(printed.text.find("--slips"), std::string::npos) << call << printed.text;
    }
    EXPECT_NE(umbral("bench judges --help").text.find("--scenes"), std::string::npos);
}

TEST(AuthorsCommands, complain_as_others_do)
{
    struct Call {
        const char* arguments;
        const char* complaint;
    };
    for (const Call& one :
         {Call{"validate --sedes 3",
               "umbral: validate has no option '--sedes'; did you mean `--seeds`? `umbral validate "
               "--help` shows all it has\n"},
          Call{"validate zzzzzzzz", "umbral: there is no unit 'zzzzzzzz'; `umbral list` shows them all\n"},
          Call{"validate sphere ''", "umbral: the argument after 'sphere' is empty\n"},
          Call{"new-unit sphere --table=", "umbral: '--table=' gives no value\n"},
          Call{"validat sphere",
               "umbral: there is no command 'validat'; did you mean `validate`? `umbral --help` shows them all\n"},
          Call{"locat", "umbral: there is no command 'locat'; did you mean `locate`? `umbral --help` shows them all\n"},
          Call{"doctor --atack",
               "umbral: doctor has no option '--atack'; did you mean `--attack`? `umbral doctor "
               "--help` shows all it has\n"}}) {
        const Printed printed = umbral(one.arguments);
        EXPECT_EQ(printed.status, 2) << one.arguments;
        EXPECT_EQ(printed.text, one.complaint) << one.arguments;
    }
}

TEST(AuthorsCommands, are_built_when_one_is_named_and_given_its_words)
{
    const Elsewhere checkout(Elsewhere::Kind::checkout);
    const Printed first = checkout.umbral("validate --zzz 'two words' --help");
    EXPECT_EQ(first.status, 7) << first.text;
    EXPECT_EQ(first.text, "umbral: building umbral-authors for the first time\ngot: validate --zzz two words --help\n");
    const Printed second = checkout.umbral("--version bench");
    EXPECT_EQ(second.status, 7) << second.text;
    EXPECT_EQ(second.text, "got: --version bench\n");
    EXPECT_EQ(checkout.umbral("doctor --attack").text, "got: doctor --attack\n");
    EXPECT_EQ(checkout.umbral("hint validate").status, 2) << "a unit's name, of which there is none";
    EXPECT_EQ(checkout.umbral("--version").status, 0);
}

TEST(AuthorsCommands, are_not_in_every_installation)
{
    const Elsewhere installation(Elsewhere::Kind::installation);
    for (const char* const call : {"validate sphere", "validate --help", "bench", "doctor --attack"}) {
        const Printed printed = installation.umbral(call);
        EXPECT_EQ(printed.status, 2) << call;
        EXPECT_EQ(printed.text,
                  "umbral: this needs the program umbral-authors, which students' packages do not hold; "
                  "install umbral-instructor\n")
            << call;
    }
}

}
}

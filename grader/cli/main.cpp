#include <CLI/CLI.hpp>
#include <cstdio>

#include "cli/application.hpp"
#include "cli/config.hpp"

int main(int count, char** words)
{
    using namespace umbral::grader;
    try {
        Application application = make_application();
        CLI::App parser("Umbral: exercises in computer graphics, checked against a reference that runs beside your code.", "umbral");
        parser.set_version_flag("--version", std::string("umbral ") + config::version);
        parser.require_subcommand(1);
        parser.footer("Exit status: 0 all right; 1 the work falls short; 2 the command cannot be carried out as given; 3 a fault of Umbral's own.");
        add_list(parser, application);
        add_new(parser, application);
        add_check(parser, application);
        add_hint(parser, application);
        add_reset(parser, application);
        add_debug(parser, application);
        add_render(parser, application);
        add_compare(parser, application);
        add_grade(parser, application);
        add_demo(parser, application);
        add_validate(parser, application);
        add_bench(parser, application);
        add_doctor(parser, application);
        try {
            parser.parse(count, words);
        } catch (const CLI::ParseError& error) {
            return parser.exit(error) == 0 ? exit_ok : exit_usage;
        }
        return application.exit_status;
    } catch (const UsageError& error) {
        (void)std::fprintf(stderr, "umbral: %s\n", error.what());
        return exit_usage;
    } catch (const std::exception& error) {
        (void)std::fprintf(stderr, "umbral: a fault of Umbral's own: %s\n", error.what());
        return exit_fault;
    }
}

// umbral-mutate [--slips] FILE FLAG…: the mutants of a C++ file, compiled with these flags, as JSON. It reads the
// project's own references, and links libclang, which nothing else needs.

#include <iostream>
#include <nlohmann/json.hpp>
#include <string_view>

#include "mutants/find_mutants.hpp"

int main(int count, char** words)
try {
    using namespace umbral::grader;
    const bool slips = count > 1 && std::string_view(words[1]) == "--slips";
    const int file = slips ? 2 : 1;
    if (count <= file) throw std::runtime_error("usage: umbral-mutate [--slips] FILE FLAG…");
    const Syntax syntax = parse(words[file], {words + file + 1, words + count});
    nlohmann::json list = nlohmann::json::array();
    for (const Mutant& mutant : slips ? find_slips(syntax) : find_mutants(syntax))
        list.push_back({{"number", mutant.number},
                        {"form", static_cast<int>(mutant.form)},
                        {"begin", mutant.begin},
                        {"end", mutant.end},
                        {"line", mutant.line},
                        {"replacement", mutant.replacement},
                        {"kind", mutant.kind},
                        {"change", mutant.change},
                        {"gives_nothing", mutant.gives_nothing}});
    std::cout << list.dump() << '\n';
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

// umbral-mutate FILE FLAG…: the mutants of a C++ file, compiled with these flags, as JSON. It reads the project's own
// references, and links libclang, which nothing else needs.

#include <iostream>
#include <nlohmann/json.hpp>

#include "mutants/find_mutants.hpp"

int main(int count, char** words)
try {
    using namespace umbral::grader;
    if (count < 2) throw std::runtime_error("usage: umbral-mutate FILE FLAG…");
    nlohmann::json list = nlohmann::json::array();
    for (const Mutant& mutant : find_mutants(parse(words[1], {words + 2, words + count})))
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

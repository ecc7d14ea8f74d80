// umbral-mutate [--slips | --repairs | --idle | --echo] FILE FLAG…: the mutants of a C++ file, compiled with these
// flags, as JSON. It links libclang, which nothing else needs, and reads students' files too: it runs confined.

#include <iostream>
#include <map>
#include <nlohmann/json.hpp>
#include <string_view>
#include <vector>

#include "mutants/find_mutants.hpp"

int main(int count, char** words)
try {
    using namespace umbral::grader;
    const std::string_view family = count > 1 && std::string_view(words[1]).starts_with("--") ? words[1] : "";
    const std::map<std::string_view, std::vector<Mutant> (*)(const Syntax&)> finders{{"", find_mutants},
                                                                                     {"--slips", find_slips},
                                                                                     {"--repairs", find_repairs},
                                                                                     {"--idle", find_idle},
                                                                                     {"--echo", find_echo}};
    const auto find = finders.find(family);
    const int file = family.empty() ? 1 : 2;
    if (count <= file || find == finders.end())
        throw std::runtime_error("usage: umbral-mutate [--slips | --repairs | --idle | --echo] FILE FLAG…");
    const Syntax syntax = parse(words[file], {words + file + 1, words + count});
    nlohmann::json list = nlohmann::json::array();
    for (const Mutant& mutant : find->second(syntax))
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

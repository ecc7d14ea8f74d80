#pragma once

#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <string>
#include <vector>

#include "mutants/find_mutants.hpp"
#include "support/temporary_folder.hpp"

namespace umbral::grader::test {

/// A piece of C++ and changes that must be found in it, among others: "sign: -a → a".
struct ExpectedChanges {
    const char* name;
    const char* source;
    std::vector<const char*> changes;
};

/// What `find`, find_mutants or find_slips, finds in a source: "kind: change".
template <class Find>
std::set<std::string> changes_of(const Find& find, const std::string& source)
{
    const umbral::test::TemporaryFolder folder;
    const std::string file = folder.path() / "source.cpp";
    std::ofstream(file) << source;
    std::set<std::string> changes;
    for (const Mutant& mutant : find(parse(file, {"-std=c++20"}))) changes.insert(mutant.kind + ": " + mutant.change);
    return changes;
}

inline void expect_found(const std::set<std::string>& found, const ExpectedChanges& expected)
{
    std::string all;
    for (const std::string& change : found) all += change + '\n';
    for (const char* change : expected.changes) EXPECT_TRUE(found.contains(change)) << change << " of\n" << all;
}

}

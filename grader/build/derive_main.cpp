// umbral-derive CHANGE BASE OUTPUT: writes the solution that a .change file describes, so that it can be compiled when
// the project is built.

#include <exception>
#include <filesystem>
#include <fstream>
#include <iostream>
#include <iterator>
#include <stdexcept>

#include "model/change.hpp"

namespace {

std::string read(const std::filesystem::path& file)
{
    std::ifstream stream(file);
    if (!stream) throw std::runtime_error("umbral-derive: cannot read '" + file.string() + "'");
    return {std::istreambuf_iterator<char>(stream), std::istreambuf_iterator<char>()};
}

}

int main(int count, char** arguments)
try {
    if (count != 4) throw std::runtime_error("usage: umbral-derive CHANGE BASE OUTPUT");
    const std::filesystem::path file = arguments[1];
    const umbral::grader::Change change = umbral::grader::parse_change(read(file), file.string());
    const auto from = change.header.find("from");
    const std::filesystem::path base = from == change.header.end() ? std::filesystem::path(arguments[2])
                                                                   : file.parent_path().parent_path() / from->second;
    std::ofstream stream(arguments[3]);
    stream << umbral::grader::apply_change(change, read(base), file.string());
    if (!stream.flush()) throw std::runtime_error("umbral-derive: cannot write '" + std::string(arguments[3]) + "'");
    return 0;
} catch (const std::exception& error) {
    std::cerr << error.what() << '\n';
    return 1;
}

#pragma once

#include <limits>
#include <sstream>
#include <string>
#include <utility>
#include <vector>

#include "dialect.hpp"

/// Files of one vertex, whose x is a number that hardly is a float; y is 0, and z is 1.
namespace umbral::meshes {

inline std::string one_vertex_header(const char* format, const char* type)
{
    return std::string("ply\nformat ") + format + " 1.0\nelement vertex 1\nproperty " + type +
           " x\nproperty float y\nproperty float z\nend_header\n";
}

/// In binary data: tiny, too large, between two floats, not finite; as floats and as doubles, in both orders of bytes.
inline std::vector<std::string> binary_number_files()
{
    constexpr double infinity = std::numeric_limits<double>::infinity();
    constexpr double not_a_number = std::numeric_limits<double>::quiet_NaN();
    const double values[] = {1e-40,
                             1.401298464324817e-45,
                             1.1754943508222875e-38,
                             3e-39,
                             -1e-44,
                             0.1,
                             16777217,
                             -16777219,
                             1.0000000596046449,
                             1e39,
                             -1e300,
                             1e-60,
                             -0.0,
                             infinity,
                             -infinity,
                             not_a_number,
                             3.4028235677973366e38};
    std::vector<std::string> files;
    for (const auto& [format, words] : {std::pair(PlyFormat::little_endian, "binary_little_endian"),
                                        std::pair(PlyFormat::big_endian, "binary_big_endian")})
        for (const PlyType type : {PlyType::float32, PlyType::float64})
            for (const double value : values) {
                NumberWriter numbers(format);
                numbers.put(type, value);
                numbers.put(PlyType::float32, 0);
                numbers.put(PlyType::float32, 1);
                files.push_back(one_vertex_header(words, type == PlyType::float32 ? "float" : "double") +
                                numbers.data());
            }
    // Data whose first bytes would end a line or part words, right behind a header with either end of lines.
    const std::string starts[] = {"\n\r\n\r", "\r\n \t", " \t\n ", "\t\r\r\n"};
    for (const std::string& start : starts)
        for (const char* const words : {"binary_little_endian", "binary_big_endian"}) {
            const bool is_double = words[7] == 'l' && start[0] != '\t';  // in the other order it would be tiny
            std::string header = one_vertex_header(words, is_double ? "double" : "float");
            NumberWriter others(words[7] == 'l' ? PlyFormat::little_endian : PlyFormat::big_endian);
            others.put(PlyType::float32, 0);
            others.put(PlyType::float32, 1);
            if (start[0] == '\n')
                for (std::size_t end = 0; (end = header.find('\n', end)) != std::string::npos; end += 2)
                    header.insert(end, 1, '\r');
            files.push_back(header + start + (is_double ? "\1\2\30@" : "") + others.data());
        }
    return files;
}

/// Decimals that are hard to read: just beside the middle of two floats, in long and odd forms, or hardly a float at
/// all. Each word with its file.
inline std::vector<std::pair<std::string, std::string>> decimal_files()
{
    const std::string all =
        "1.00000005960464477540 1.00000005960464477538 1.00000017881393432618 16777217.0000000001 0.1 "
        "0.30000001192092896 +1.5 -.5 5. 1E3 1e+3 -0 1e-40 1.17549435e-38 1.4e-45 7.1e-46 1e-60 -1e-400 "
        "3.4028235e38 inf 0.000000000000000000000000000000000000000000001 "
        "100000000000000000000000000000000000000e-38 0.01e-5000 1e-99999999999999999999 -inf +inf nan "
        "-nan 8.589973e9";
    // Too small without an exponent, or with one that does not make up for the zeros; and one that does.
    const std::string zeros(400, '0');
    const std::string many = " ." + zeros + "1 -" + zeros + "." + zeros + "7e5 0." + zeros + "25e400";
    std::vector<std::pair<std::string, std::string>> files;
    for (const char* const type : {"float", "double"}) {
        std::istringstream words(all + many);
        for (std::string word; words >> word;)
            files.emplace_back(word, one_vertex_header("ascii", type) + word + " 0 1\n");
    }
    return files;
}

}

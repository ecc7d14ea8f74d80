#include "render/buffers.hpp"

#include <algorithm>
#include <stdexcept>
#include <umbral/core/png.hpp>

#include "render/picture.hpp"

namespace umbral::render {

std::vector<std::byte> npy_bytes(const std::string& type, const std::vector<int>& shape,
                                 std::span<const std::byte> data)
{
    std::string sides;
    for (const int side : shape) sides += std::to_string(side) + ", ";
    std::string header = "{'descr': '" + type + "', 'fortran_order': False, 'shape': (" + sides + "), }";
    // Magic, version and length take 10 bytes; the data begin at a multiple of 64, after a newline.
    constexpr std::size_t before = 10;
    header.append(63 - (before + header.size()) % 64, ' ');
    header += '\n';
    const std::string magic = std::string("\x93NUMPY\x01\x00", 8) + static_cast<char>(header.size() & 0xFFU) +
                              static_cast<char>(header.size() >> 8U);
    std::vector<std::byte> bytes;
    bytes.reserve(magic.size() + header.size() + data.size());
    for (const std::string& text : {magic, header})
        std::transform(text.begin(), text.end(), std::back_inserter(bytes),
                       [](char letter) { return static_cast<std::byte>(letter); });
    bytes.insert(bytes.end(), data.begin(), data.end());
    return bytes;
}

void write_buffers(const std::filesystem::path& folder, const Frame& frame)
{
    std::error_code error;
    std::filesystem::create_directories(folder, error);
    if (error) throw std::runtime_error(folder.string() + ": cannot make this folder: " + error.message());

    const int width = frame.width();
    const int height = frame.height();
    std::vector<std::uint8_t> coverage(frame.ids.cells.size());
    std::transform(frame.ids.cells.begin(), frame.ids.cells.end(), coverage.begin(),
                   [](std::uint32_t id) { return id != 0 ? std::uint8_t{1} : std::uint8_t{0}; });
    const auto write = [&](const char* name, const char* type, const std::vector<int>& shape,
                           std::span<const std::byte> data) {
        write_file_atomically(folder / name, npy_bytes(type, shape, data));
    };
    write("color.npy", "<f4", {height, width, 4}, std::as_bytes(std::span(frame.color.cells)));
    write("depth.npy", "<f4", {height, width}, std::as_bytes(std::span(frame.depth.cells)));
    write("ids.npy", "<u4", {height, width}, std::as_bytes(std::span(frame.ids.cells)));
    write("coverage.npy", "|u1", {height, width}, std::as_bytes(std::span(coverage)));
    write_png(folder / "depth.png", picture_of_depth(frame));
    write_png(folder / "ids.png", picture_of_ids(frame));
    write_png(folder / "coverage.png", picture_of_coverage(frame));
}

}

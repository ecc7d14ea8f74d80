#include "report/html/picture.hpp"

#include <png.h>

#include <algorithm>
#include <optional>
#include <stdexcept>
#include <unordered_map>
#include <vector>

#include "report/html/base64.hpp"

namespace umbral::grader::html {
namespace {

/// Pixels as libpng takes them: numbers of colours in a palette, or channels.
struct Encoding {
    png_uint_32 format = PNG_FORMAT_RGBA;
    std::vector<png_byte> palette;
    std::vector<png_byte> bytes;
};

std::uint32_t key_of(glm::u8vec4 colour)
{
    return std::uint32_t{colour.r} << 24U | std::uint32_t{colour.g} << 16U | std::uint32_t{colour.b} << 8U | colour.a;
}

bool is_opaque(const Image& image)
{
    return std::all_of(image.cells.begin(), image.cells.end(), [](glm::u8vec4 cell) { return cell.a == 255; });
}

/// The picture by numbers of colours, if it has at most 256.
std::optional<Encoding> with_palette(const Image& image)
{
    Encoding result{PNG_FORMAT_RGB_COLORMAP, {}, {}};
    std::unordered_map<std::uint32_t, png_byte> index;
    result.bytes.reserve(image.cells.size());
    for (const glm::u8vec4 cell : image.cells) {
        const auto found = index.find(key_of(cell));
        if (found != index.end()) {
            result.bytes.push_back(found->second);
            continue;
        }
        if (index.size() == 256) return std::nullopt;
        const auto number = static_cast<png_byte>(index.size());
        index.emplace(key_of(cell), number);
        result.palette.insert(result.palette.end(), {cell.r, cell.g, cell.b});
        result.bytes.push_back(number);
    }
    return result;
}

Encoding with_channels(const Image& image, bool opaque)
{
    Encoding result{
        opaque ? static_cast<png_uint_32>(PNG_FORMAT_RGB) : static_cast<png_uint_32>(PNG_FORMAT_RGBA), {}, {}};
    const int channels = opaque ? 3 : 4;
    result.bytes.reserve(image.cells.size() * static_cast<std::size_t>(channels));
    for (const glm::u8vec4 cell : image.cells)
        for (int c = 0; c < channels; ++c) result.bytes.push_back(cell[c]);
    return result;
}

/// libpng's simplified interface, freed at the end of the scope.
struct PngImage : png_image {
    PngImage() : png_image{} { version = PNG_IMAGE_VERSION; }
    PngImage(const PngImage&) = delete;
    PngImage& operator=(const PngImage&) = delete;
    ~PngImage() { png_image_free(this); }
};

}

Picture encode(const Image& image)
{
    if (image.cells.empty()) return {};
    const bool opaque = is_opaque(image);
    std::optional<Encoding> encoding = opaque ? with_palette(image) : std::nullopt;
    if (!encoding) encoding = with_channels(image, opaque);

    PngImage png;
    png.width = static_cast<png_uint_32>(image.width);
    png.height = static_cast<png_uint_32>(image.height);
    png.format = encoding->format;
    png.colormap_entries = static_cast<png_uint_32>(encoding->palette.size() / 3);
    png_alloc_size_t size = PNG_IMAGE_PNG_SIZE_MAX(png);
    std::string bytes(size, '\0');
    if (png_image_write_to_memory(&png, bytes.data(), &size, 0, encoding->bytes.data(), 0, encoding->palette.data()) ==
        0)
        throw std::runtime_error(std::string("a picture cannot be encoded: ") + png.message);
    bytes.resize(size);
    return {image.width, image.height, std::move(bytes)};
}

Markup data_url(const Picture& picture) { return of_our_own("data:image/png;base64," + base64(picture.png)); }

}

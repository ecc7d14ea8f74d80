#include <algorithm>
#include <array>
#include <umbral/gl/opengl.hpp>
#include <umbral/gl/trace.hpp>

namespace umbral::gl {
namespace {

/// Where a buffer upload has its size in bytes and its pointer, by position.
struct BufferUpload {
    std::string_view name;
    std::size_t size;
    std::size_t pointer;
};
constexpr std::array buffer_uploads = {BufferUpload{"glBufferData", 1, 2},          BufferUpload{"glBufferSubData", 2, 3},
                                       BufferUpload{"glBufferStorage", 1, 2},       BufferUpload{"glNamedBufferData", 1, 2},
                                       BufferUpload{"glNamedBufferSubData", 2, 3},  BufferUpload{"glNamedBufferStorage", 1, 2},
                                       BufferUpload{"glCompressedTexImage2D", 6, 7}};

/// Where a picture upload has its first extent, how many extents there are, and its format, by position; type and pointer follow the format.
struct PictureUpload {
    std::string_view name;
    std::size_t extent;
    std::size_t dimensions;
    std::size_t format;
};
constexpr std::array picture_uploads = {PictureUpload{"glTexImage1D", 3, 1, 5},        PictureUpload{"glTexImage2D", 3, 2, 6},
                                        PictureUpload{"glTexImage3D", 3, 3, 7},        PictureUpload{"glTexSubImage1D", 3, 1, 4},
                                        PictureUpload{"glTexSubImage2D", 4, 2, 6},     PictureUpload{"glTexSubImage3D", 5, 3, 8},
                                        PictureUpload{"glTextureSubImage1D", 3, 1, 4}, PictureUpload{"glTextureSubImage2D", 4, 2, 6},
                                        PictureUpload{"glTextureSubImage3D", 5, 3, 8}, PictureUpload{"glDrawPixels", 0, 2, 2}};

unsigned components(GLenum format)
{
    switch (format) {
        case GL_RED:
        case GL_GREEN:
        case GL_BLUE:
        case GL_ALPHA:
        case GL_LUMINANCE:
        case GL_RED_INTEGER:
        case GL_DEPTH_COMPONENT:
        case GL_STENCIL_INDEX: return 1;
        case GL_RG:
        case GL_RG_INTEGER:
        case GL_LUMINANCE_ALPHA: return 2;
        case GL_RGB:
        case GL_BGR:
        case GL_RGB_INTEGER: return 3;
        case GL_RGBA:
        case GL_BGRA:
        case GL_RGBA_INTEGER: return 4;
        default: return 0;
    }
}

/// Bytes of one pixel; packed types hold all components at once.
unsigned pixel_size(GLenum format, GLenum type)
{
    switch (type) {
        case GL_UNSIGNED_BYTE:
        case GL_BYTE: return components(format);
        case GL_UNSIGNED_SHORT:
        case GL_SHORT:
        case GL_HALF_FLOAT: return 2 * components(format);
        case GL_UNSIGNED_INT:
        case GL_INT:
        case GL_FLOAT: return 4 * components(format);
        case GL_UNSIGNED_BYTE_3_3_2:
        case GL_UNSIGNED_BYTE_2_3_3_REV: return 1;
        case GL_UNSIGNED_SHORT_5_6_5:
        case GL_UNSIGNED_SHORT_5_6_5_REV:
        case GL_UNSIGNED_SHORT_4_4_4_4:
        case GL_UNSIGNED_SHORT_5_5_5_1: return 2;
        case GL_UNSIGNED_INT_8_8_8_8:
        case GL_UNSIGNED_INT_8_8_8_8_REV:
        case GL_UNSIGNED_INT_10_10_10_2:
        case GL_UNSIGNED_INT_24_8: return 4;
        default: return 0;
    }
}

std::uint64_t whole(double number) { return number > 0 ? static_cast<std::uint64_t>(number) : 0; }

}

std::uint64_t upload_size(std::string_view name, const std::vector<double>& arguments)
{
    const auto named = [&](const auto& upload) { return upload.name == name; };
    if (const auto found = std::find_if(buffer_uploads.begin(), buffer_uploads.end(), named); found != buffer_uploads.end())
        return found->pointer < arguments.size() && arguments[found->pointer] != 0 ? whole(arguments[found->size]) : 0;
    const auto found = std::find_if(picture_uploads.begin(), picture_uploads.end(), named);
    if (found == picture_uploads.end() || found->format + 2 >= arguments.size() || arguments[found->format + 2] == 0) return 0;
    std::uint64_t pixels = 1;
    for (std::size_t i = 0; i < found->dimensions; ++i) pixels *= whole(arguments[found->extent + i]);
    return pixels * pixel_size(static_cast<GLenum>(arguments[found->format]), static_cast<GLenum>(arguments[found->format + 1]));
}

}

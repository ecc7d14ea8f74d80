#pragma once

#include <array>
#include <kit/gl_state.hpp>
#include <string>
#include <vector>

/// What state OpenGL is in, and which objects there are.
namespace umbral::texturing {

inline constexpr int units = 16;

inline int living_textures() { return living(glIsTexture); }

/// Buffers, samplers, framebuffers, vertex arrays and programs. What an upload needs for a moment must be gone after
/// it.
inline int living_others()
{
    return living(glIsBuffer) + living(glIsSampler) + living(glIsFramebuffer) + living(glIsVertexArray) +
           living(glIsProgram);
}

/// State that nobody asked to change, each with the name that reports give it.
struct Watched {
    const char* name;
    GLenum what;
    bool is_switch = false;
};

inline constexpr std::array watched_state = {
    Watched{"GL_UNPACK_SWAP_BYTES", GL_UNPACK_SWAP_BYTES},
    Watched{"GL_UNPACK_IMAGE_HEIGHT", GL_UNPACK_IMAGE_HEIGHT},
    Watched{"GL_UNPACK_SKIP_IMAGES", GL_UNPACK_SKIP_IMAGES},
    Watched{"GL_PACK_ALIGNMENT", GL_PACK_ALIGNMENT},
    Watched{"GL_ARRAY_BUFFER_BINDING", GL_ARRAY_BUFFER_BINDING},
    Watched{"GL_PIXEL_PACK_BUFFER_BINDING", GL_PIXEL_PACK_BUFFER_BINDING},
    Watched{"GL_DRAW_FRAMEBUFFER_BINDING", GL_DRAW_FRAMEBUFFER_BINDING},
    Watched{"GL_READ_FRAMEBUFFER_BINDING", GL_READ_FRAMEBUFFER_BINDING},
    Watched{"GL_CURRENT_PROGRAM", GL_CURRENT_PROGRAM},
    Watched{"GL_MATRIX_MODE", GL_MATRIX_MODE},
    Watched{"GL_BLEND", GL_BLEND, true},
    Watched{"GL_DEPTH_TEST", GL_DEPTH_TEST, true},
    Watched{"GL_CULL_FACE", GL_CULL_FACE, true},
    Watched{"GL_FRAMEBUFFER_SRGB", GL_FRAMEBUFFER_SRGB, true},
};

/// The same for each unit.
inline constexpr std::array watched_of_units = {
    Watched{"GL_TEXTURE_2D switched", GL_TEXTURE_2D, true},
    Watched{"GL_SAMPLER_BINDING", GL_SAMPLER_BINDING},
    Watched{"GL_TEXTURE_BINDING_1D", GL_TEXTURE_BINDING_1D},
    Watched{"GL_TEXTURE_BINDING_3D", GL_TEXTURE_BINDING_3D},
    Watched{"GL_TEXTURE_BINDING_CUBE_MAP", GL_TEXTURE_BINDING_CUBE_MAP},
};

inline GLint value_of(const Watched& watched)
{
    return watched.is_switch ? glIsEnabled(watched.what) : integer(watched.what);
}

/// All watched state at one time. Leaves the active unit alone.
class Snapshot {
public:
    Snapshot()
    {
        for (const Watched& watched : watched_state) values_.push_back(value_of(watched));
        const auto active = static_cast<GLenum>(integer(GL_ACTIVE_TEXTURE));
        for (const Watched& watched : watched_of_units) {
            for (int unit = 0; unit < units; ++unit) {
                glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
                of_units_.push_back(value_of(watched));
            }
        }
        glActiveTexture(active);
    }

    static std::string columns()
    {
        std::string names;
        for (const Watched& watched : watched_state) names += ", changed: " + std::string(watched.name);
        for (const Watched& watched : watched_of_units)
            names += ", units whose " + std::string(watched.name) + " changed";
        return names;
    }

    /// Of each whether it is another one than before, or at how many units; names of objects are no numbers to compare.
    void append_changes(std::vector<float>& row, const Snapshot& before) const
    {
        for (std::size_t i = 0; i < values_.size(); ++i) row.push_back(values_[i] != before.values_[i] ? 1.0F : 0.0F);
        for (std::size_t first = 0; first < of_units_.size(); first += units) {
            int changed = 0;
            for (std::size_t i = first; i < first + units; ++i) changed += of_units_[i] != before.of_units_[i] ? 1 : 0;
            row.push_back(static_cast<float>(changed));
        }
    }

private:
    std::vector<GLint> values_;
    std::vector<GLint> of_units_;
};

/// A texture of one grey texel for every unit, the driver's own: bound before the student's code runs, so that a
/// binding that goes to a wrong unit shows. The active unit is 0 afterwards.
class Decoys {
public:
    Decoys()
    {
        glGenTextures(units, names_.data());
        constexpr std::array<GLubyte, 4> grey = {77, 77, 77, 255};
        for (int unit = units - 1; unit >= 0; --unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            glBindTexture(GL_TEXTURE_2D, names_[static_cast<std::size_t>(unit)]);
            glTexImage2D(GL_TEXTURE_2D, 0, GL_RGBA8, 1, 1, 0, GL_RGBA, GL_UNSIGNED_BYTE, grey.data());
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, GL_NEAREST);
            glTexParameteri(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, GL_MIRRORED_REPEAT);
        }
    }
    Decoys(const Decoys&) = delete;
    Decoys& operator=(const Decoys&) = delete;
    ~Decoys() { glDeleteTextures(units, names_.data()); }

    /// What each unit has: 0 nothing, 1 its own decoy as it was, 2 another texture. Leaves the active unit alone.
    [[nodiscard]] std::vector<float> bound() const
    {
        const auto active = static_cast<GLenum>(integer(GL_ACTIVE_TEXTURE));
        std::vector<float> row;
        for (std::size_t unit = 0; unit < names_.size(); ++unit) {
            glActiveTexture(GL_TEXTURE0 + static_cast<GLenum>(unit));
            const auto name = static_cast<GLuint>(integer(GL_TEXTURE_BINDING_2D));
            row.push_back(name == 0 ? 0.0F : name == names_[unit] && is_untouched() ? 1.0F : 2.0F);
        }
        glActiveTexture(active);
        return row;
    }

private:
    /// The texture that is bound.
    static bool is_untouched()
    {
        GLint width = 0;
        GLint wrap = 0;
        GLint filter = 0;
        glGetTexLevelParameteriv(GL_TEXTURE_2D, 0, GL_TEXTURE_WIDTH, &width);
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_WRAP_S, &wrap);
        glGetTexParameteriv(GL_TEXTURE_2D, GL_TEXTURE_MIN_FILTER, &filter);
        return width == 1 && wrap == GL_MIRRORED_REPEAT && filter == GL_NEAREST;
    }

    std::array<GLuint, units> names_{};
};

}

#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace umbral::gl {

/// Who draws when there is no window.
/// Both are Mesa's, drawn by the processor (llvmpipe), and give the same pixels bit by bit.
enum class BackendKind {
    osmesa,  ///< Mesa's off-screen library; gone from Mesa 25.1 on
    egl,     ///< EGL without display and surface: such a context has no framebuffer of its own
};

/// The back end of that name, "osmesa" or "egl"; none for any other word.
[[nodiscard]] inline std::optional<BackendKind> backend_named(std::string_view name)
{
    if (name == "osmesa") return BackendKind::osmesa;
    if (name == "egl") return BackendKind::egl;
    return std::nullopt;
}

/// What the environment variable UMBRAL_GL names ("osmesa" or "egl"); where it is not set, OSMesa if it can be loaded,
/// else EGL. Throws std::runtime_error if the variable holds something else, or if neither can be loaded.
[[nodiscard]] BackendKind default_backend();

/// Sets what keeps Mesa from starting threads: LP_NUM_THREADS=0 (raster threads) and MESA_SHADER_CACHE_DISABLE=true
/// (the thread that writes compiled shaders to disk; drawing after a fork waits for it for ever, but only where the
/// cache is still empty).
///
/// To be called before the first context is made, while the process has one thread.
void forbid_driver_threads();

/// An OpenGL 4.5 context, compatibility profile, without a window.
///
/// One context is current at a time, for the whole process; OpenGL is called from one thread only. Draw into a
/// gl::Framebuffer: the context's own framebuffer is a stub of 64 x 64 pixels, or missing. A process may make a
/// context, fork, and draw in the children, each for itself, if it called forbid_driver_threads before.
class OffscreenContext {
public:
    /// Loads the back end and makes a context, current from now on. Throws std::runtime_error that says what could not
    /// be loaded.
    explicit OffscreenContext(BackendKind kind = default_backend());
    OffscreenContext(const OffscreenContext&) = delete;
    OffscreenContext& operator=(const OffscreenContext&) = delete;
    /// Finishes what was drawn; if this context was current, none is afterwards.
    ~OffscreenContext();

    void make_current();
    [[nodiscard]] bool is_current() const noexcept;

private:
    const struct Backend* backend_;
    void* handle_;
};

/// Is any context current? Where it is not, every call of OpenGL aborts.
[[nodiscard]] bool has_context() noexcept;

/// Back end, version and renderer of the current context, as "OSMesa: 4.5 (Compatibility Profile) Mesa …; llvmpipe
/// (…)", for fingerprints. Throws std::logic_error if no context is current.
[[nodiscard]] std::string backend_description();

/// Throws std::runtime_error if OpenGL has noted errors since it was last asked; `where` says what was being done.
/// Clears them.
void check_errors(const std::string& where);

}
